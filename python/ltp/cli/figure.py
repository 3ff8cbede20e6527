# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure`: the paper's figures and ours; here those that are flown or drawn anew."""

import dataclasses
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .app import make_group
from .campaign_figures import curve, sweep
from .gap_figures import front, gap
from .global_paths import GlobalPaths
from .inputs import numbers, open_world, planner_names, telling_old_names
from .naming import naming
from .options import PictureFile, Planner, PriorityMap, ScenarioIndex, WorldArgument
from .output import console, write_figure
from .regret_figure import regret
from .settings import Settings
from .spread import spread

if TYPE_CHECKING:
    from ltp.config import MissionConfig


def register(app: typer.Typer) -> None:
    """Add the commands."""
    group = make_group("figure", "Draw the figures.")
    for command in (paths, sweep, scenarios, sensing, traps, summary, front, gap, curve, regret):
        group.command(command.__name__)(command)
    app.add_typer(group)


@spread
def paths(
    *,
    world: WorldArgument = "city",
    ratios: Annotated[
        str, typer.Option(help="Ratios of the weights, W_P / W_L, with commas between.")
    ] = "0,2,5",
    planner: Planner = "lp-dijkstra",
    priority_map: PriorityMap = "lpf",
    scenario: ScenarioIndex = 0,
    global_paths: GlobalPaths,
    settings: Settings,
    out: PictureFile = Path("out/paths.png"),
) -> None:
    """Fly one global path under several weights and draw it.

    It is drawn over the surface and the priority map.
    """
    from ltp.evaluation.campaign.flights import mission_config
    from ltp.evaluation.campaign.variants import at_ratio
    from ltp.evaluation.figures.flights import flown_paths_figure
    from ltp.sim.mission import Mission

    place, base = open_world(world), settings.open()
    with naming("planner", ratio="--ratios", priority_map="--map"):
        variants = [at_ratio(r, planner, priority_map) for r in numbers("--ratios", ratios)]
    path = global_paths.one(place, scenario)
    missions = [Mission(place, mission_config(base, variant), path) for variant in variants]
    records = []
    for mission, variant in zip(missions, variants, strict=True):
        with console().status(f"flying W_P/W_L = {variant.ratio:g}"):
            records.append(mission.fly())
    write_figure(flown_paths_figure(place, records, missions[0].setup.priority), out)


@spread
def scenarios(
    *,
    world: WorldArgument = "city",
    count: Annotated[int, typer.Option("--paths", help="Number of global paths.")] = 50,
    global_paths: GlobalPaths,
    settings: Settings,
    out: PictureFile = Path("out/scenarios.png"),
) -> None:
    """Draw the global paths over the surface and both priority maps."""
    from ltp.evaluation.figures.flights import global_paths_figure
    from ltp.sim import MissionSetup

    place, base = open_world(world), settings.open()
    drawn = global_paths.over(place, count)
    binary, lowpass = (
        MissionSetup.of(
            place, dataclasses.replace(base, priority_map=kind), drawn[0].global_path
        ).priority
        for kind in ("binary", "lpf")
    )
    write_figure(global_paths_figure(place, drawn, binary, lowpass), out)


@spread
def sensing(
    *,
    world: WorldArgument = "city",
    planner: Planner = "lp-dijkstra",
    scenario: ScenarioIndex = 0,
    global_paths: GlobalPaths,
    settings: Settings,
    out: PictureFile = Path("out/sensing.png"),
) -> None:
    """Draw a slice of the map in flight: volume and surface sensing."""
    from ltp.evaluation.figures.sensing import sensing_figure
    from ltp.evaluation.sensed import SnapshotTaker
    from ltp.sim import fly

    place = open_world(world)
    config = _with_planner(settings.open(), planner, "--planner")
    path = global_paths.one(place, scenario)
    taker = SnapshotTaker()
    with console().status("flying"):
        fly(place, config, path, [taker])
    write_figure(sensing_figure(place, taker.snapshots, config.lidar.max_range), out)


def traps(out: PictureFile = Path("out/traps.png")) -> None:
    """Fly GGWP into a bug trap and to a goal inside a building.

    The telling moments are drawn.
    """
    from ltp.evaluation.figures.traps import trap_figure

    with console().status("flying"):
        figure = trap_figure()
    write_figure(figure, out)


@spread
def summary(
    *,
    world: WorldArgument = "city",
    planners: Annotated[
        str, typer.Option(help="Planners to fly, with commas between.")
    ] = "lp-dijkstra,lp-a-star,wlp-a-star,ggwp",
    scenario: ScenarioIndex = 0,
    global_paths: GlobalPaths,
    settings: Settings,
    out: PictureFile = Path("out/summary.png"),
) -> None:
    """Fly one global path with several planners and draw them."""
    from ltp.evaluation.figures.summary import summary_figure
    from ltp.evaluation.sensed import SensedTrace
    from ltp.sim import fly

    place, base = open_world(world), settings.open()
    wanted = [
        _with_planner(base, name, "--planners") for name in planner_names("--planners", planners)
    ]
    if not wanted:
        raise ValueError(f"--planners must name one planner or more, not {planners!r}")
    path = global_paths.one(place, scenario)
    records, sensed = [], SensedTrace()
    for config in wanted:
        with console().status(f"flying {config.planner}"):
            records.append(fly(place, config, path, [sensed]))
    write_figure(summary_figure(place, records, sensed), out)


def _with_planner(config: "MissionConfig", planner: str, option: str) -> "MissionConfig":
    with naming(planner=option), telling_old_names(option):
        return dataclasses.replace(config, planner=planner)
