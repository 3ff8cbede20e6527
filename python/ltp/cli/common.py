# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What several commands share: options, and turning their text into values."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from rich.console import Console

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from ltp.config import MissionConfig
    from ltp.evaluation.scenarios import ScenarioOptions
    from ltp.world import World

WorldArgument = Annotated[
    str,
    typer.Argument(
        metavar="WORLD",
        help="A world file (.npz, see `ltp world import`), or `city` for the built-in one; "
        "`city:7` is the one of seed 7.",
    ),
]
Config = Annotated[
    Path | None,
    typer.Option("--config", help="TOML file with mission settings; `ltp config` prints them all."),
]
Altitude = Annotated[float, typer.Option(help="Of the global paths [m].")]
Reference = Annotated[
    str,
    typer.Option(help="What altitude counts from: `ground` beneath each waypoint, or `datum`."),
]
Seed = Annotated[int, typer.Option(help="Of the set of global paths.")]
Length = Annotated[float, typer.Option(help="Of a global path, over the ground [m].")]
Spacing = Annotated[float, typer.Option(help="Between its waypoints [m].")]
Margin = Annotated[float, typer.Option(help="Between a path and the world's edge [m].")]
ThroughBuildings = Annotated[
    float, typer.Option(help="Share of the global paths that must cross a building, 0...1.")
]

console = Console(highlight=False)


def open_world(source: str) -> "World":
    """The world that an argument names."""
    from ltp.world import World

    name, _, seed = source.partition(":")
    if name == "city" and not Path(source).exists():
        from ltp.world.city import make_city

        if seed and not seed.isdigit():
            raise ValueError(f"{source}: the seed of the city must be a whole number >= 0")
        return make_city(seed=int(seed) if seed else 1)
    if not Path(source).exists():
        raise ValueError(f"{source}: no such world file (the built-in world is called `city`)")
    return World.load(source)


def open_config(path: Path | None) -> "MissionConfig":
    """The settings in a file, or the defaults."""
    from ltp.config import MissionConfig

    return MissionConfig() if path is None else MissionConfig.load(path)


def scenario_options(
    count: int,
    altitude: float,
    reference: str,
    seed: int,
    length: float,
    spacing: float,
    margin: float,
    through_buildings: float,
) -> "ScenarioOptions":
    """The set of global paths that the options describe."""
    from ltp.evaluation.scenarios import ScenarioOptions

    return ScenarioOptions(
        count=count,
        altitude=altitude,
        reference=reference,
        seed=seed,
        length=length,
        spacing=spacing,
        margin=margin,
        through_buildings=through_buildings,
    )


def numbers(name: str, text: str) -> list[float]:
    """The numbers in a text with commas between."""
    try:
        return [float(part) for part in text.split(",")]
    except ValueError:
        raise ValueError(f"{name}: expected numbers with commas between, not {text!r}") from None


def names(text: str) -> list[str]:
    """The names in a text with commas between."""
    return [part.strip() for part in text.split(",") if part.strip()]


def workers(processes: int) -> int:
    """The number of processes that is meant: 0 is one per processor."""
    return processes if processes > 0 else len(os.sched_getaffinity(0))


def tell(what: str, path: Path) -> None:
    """Say where a file was written."""
    console.print(f"{what:<12} {path}", markup=False, soft_wrap=True)


def write_figure(figure: "Figure", out: Path) -> None:
    """Write a picture, its folder too, and say where."""
    from ltp.evaluation.backdrop import save_figure

    out.parent.mkdir(parents=True, exist_ok=True)
    save_figure(figure, out)
    tell("figure", out)
