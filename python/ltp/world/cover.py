# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a world is covered with: cells of each land class, and which lists may land on them."""

from dataclasses import dataclass

import numpy as np

from .classes import LANDABLE_PRESETS, LandClass
from .world import World


@dataclass(frozen=True)
class Cover:
    """One land class in a world."""

    kind: LandClass
    cells: int
    share: float  # of all cells of the world, 0 ... 1
    landable: tuple[str, ...]  # names in `LANDABLE_PRESETS` that allow it


def land_cover(world: World) -> tuple[Cover, ...]:
    """Each land class that `world` has, the commonest first."""
    counts = np.bincount(world.classes.ravel(), minlength=max(LandClass) + 1)
    found = [
        Cover(
            kind=kind,
            cells=int(counts[kind]),
            share=float(counts[kind] / world.classes.size),
            landable=tuple(name for name, kinds in LANDABLE_PRESETS.items() if kind in kinds),
        )
        for kind in LandClass
        if counts[kind]
    ]
    return tuple(sorted(found, key=lambda cover: (-cover.cells, cover.kind)))
