# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The table of what a world is covered with, and how much of it may be landed on."""

from typing import TYPE_CHECKING

from .output import console, narrow_table, say

if TYPE_CHECKING:
    from ltp.world import World


def print_cover(world: "World") -> None:
    """Print cells and share of each land class, and of what each list of classes may land on."""
    from ltp.world import LANDABLE_PRESETS, LandingLimits, land_cover, landable_mask

    table = narrow_table("Land classes", ["class", "cells", "share", "landable"])
    for cover in land_cover(world):
        lists = ", ".join(cover.landable) or "-"
        table.add_row(cover.kind.name, f"{cover.cells:,}", f"{100.0 * cover.share:.2f} %", lists)
    console().print(table)
    limits = LandingLimits()
    for name in LANDABLE_PRESETS:
        mask = landable_mask(world, **limits.rules(name))
        share = 100.0 * float(mask.mean())
        say(f"landable, {name}: {mask.sum():,} cells ({share:.1f} %)")
    say(f"(landable is {limits})")
