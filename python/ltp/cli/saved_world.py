# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world file that a command writes, and the options of it."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .output import console, tell, tell_report

if TYPE_CHECKING:
    from ltp.world import World

WorldFile = Annotated[Path, typer.Option("--out", "-o", help="World file to write, .npz.")]
Cell = Annotated[float, typer.Option(help="Cell size [m].")]


def save_world(world: "World", out: Path) -> None:
    """Write a world, its folder too, and say what it is, what its import found, and where."""
    out.parent.mkdir(parents=True, exist_ok=True)
    world.save(out)
    x_min, y_min, x_max, y_max = world.extent
    console().print(
        f"{world.name}: {x_max - x_min:g} m x {y_max - y_min:g} m at {world.cell:g} m, ground at "
        f"{world.ground.min():.1f} ... {world.ground.max():.1f} m, top at "
        f"{world.surface.max():.1f} m",
        markup=False,
        soft_wrap=True,
    )
    tell_report(world)
    tell("world", out)
