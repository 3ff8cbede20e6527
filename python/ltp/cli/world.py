# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp world`: write the built-in city, show a world; below it, import real ones."""

from pathlib import Path
from typing import Annotated

import typer

from . import world_import
from .app import make_group
from .inputs import open_world
from .naming import naming
from .options import PictureFile, WorldArgument
from .output import tell, tell_report
from .saved_world import Cell, WorldFile, save_world
from .world_cover import print_cover


def register(app: typer.Typer) -> None:
    """Add the commands."""
    group = make_group("world", "Import, show and write worlds.")
    world_import.register(group)
    group.command("show")(show)
    group.command("city")(city)
    app.add_typer(group)


def show(
    world: WorldArgument = "city",
    out: PictureFile = Path("out/world.png"),
    altitude: Annotated[
        float,
        typer.Option(
            help="Altitude of the flight above ground, which sets the camera's footprint [m]."
        ),
    ] = 50.0,
) -> None:
    """Draw a world, and tell its land classes and what its import found.

    The picture holds height, land classes and both priority maps.
    """
    from ltp.drawing.picture import world_picture

    place = open_world(world)
    out.parent.mkdir(parents=True, exist_ok=True)
    with naming("altitude"):
        world_picture(place, out, altitude)
    print_cover(place)
    tell_report(place)
    tell("picture", out)


def city(
    out: WorldFile = Path("out/city.npz"),
    seed: Annotated[int, typer.Option(help="Seed of the city: the same gives the same.")] = 1,
    size: Annotated[float, typer.Option(help="Edge of the square map [m].")] = 1000.0,
    cell: Cell = 1.0,
) -> None:
    """Write the built-in city to a world file."""
    from ltp.world.city import make_city

    with naming("seed", "size", "cell"):
        made = make_city(seed=seed, size=size, cell=cell)
    save_world(made, out)
