# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure`: the paper's figures and ours, flown or drawn anew."""

import dataclasses
from pathlib import Path
from typing import Annotated

import typer

from . import gap_figures
from .app import PoliteGroup
from .common import (
    Altitude,
    Config,
    Length,
    Margin,
    Reference,
    Seed,
    Spacing,
    ThroughBuildings,
    WorldArgument,
    console,
    numbers,
    open_config,
    open_world,
    scenario_options,
    write_figure,
)

Out = Annotated[Path, typer.Option("--out", "-o", help="Picture to write: .png, .pdf or .svg.")]
Map = Annotated[str, typer.Option("--map", help="Priority map: `binary` or `lpf`.")]
Which = Annotated[int, typer.Option("--scenario", help="Which of the seeded global paths, from 0.")]
Planner = Annotated[str, typer.Option(help="Name of the planner.")]


def register(app: typer.Typer) -> None:
    """Add the commands."""
    group = typer.Typer(cls=PoliteGroup, help="Draw the figures.", no_args_is_help=True)
    group.command("paths")(paths)
    group.command("sweep")(sweep)
    group.command("scenarios")(scenarios)
    group.command("sensing")(sensing)
    group.command("traps")(traps)
    group.command("summary")(summary)
    gap_figures.register(group)
    app.add_typer(group, name="figure")


def paths(
    world: WorldArgument = "city",
    ratios: Annotated[str, typer.Option(help="W_P / W_L of the flights.")] = "0,2,5",
    planner: Planner = "lp-dijkstra",
    priority_map: Map = "lpf",
    scenario: Which = 0,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    config: Config = None,
    out: Out = Path("out/paths.png"),
) -> None:
    """Fly one global path under several weights; draw it over surface and priority map."""
    from ltp.evaluation.figures import flown_paths_figure
    from ltp.evaluation.flights import mission_config
    from ltp.evaluation.scenarios import make_scenario
    from ltp.evaluation.variants import at_ratio
    from ltp.sim.mission import Mission

    place, base = open_world(world), open_config(config)
    options = scenario_options(
        1, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    path = make_scenario(place, options, scenario).global_path
    variants = [at_ratio(r, planner, priority_map) for r in numbers("--ratios", ratios)]
    missions = [Mission(place, mission_config(base, variant), path) for variant in variants]
    records = []
    for mission, variant in zip(missions, variants, strict=True):
        with console.status(f"flying W_P/W_L = {variant.ratio:g}"):
            records.append(mission.fly())
    write_figure(flown_paths_figure(place, records, missions[0].priority), out)


def sweep(
    flights: Annotated[
        Path, typer.Argument(help="flights.csv of a campaign, or the campaign's folder.")
    ],
    world: WorldArgument = "city",
    out: Out = Path("out/sweep.png"),
) -> None:
    """Draw mean priority and length ratio over W_P / W_L from a campaign with --ratios."""
    from ltp.evaluation.figures import sweep_figure

    from .evaluate import read_flights

    rows, place = read_flights(flights), open_world(world)
    if rows[0].world != place.name:
        raise ValueError(f"{flights} was flown over {rows[0].world}, not over {place.name}")
    write_figure(sweep_figure(rows, place.attribution), out)


def scenarios(
    world: WorldArgument = "city",
    count: Annotated[int, typer.Option("--paths", help="Number of global paths.")] = 50,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    config: Config = None,
    out: Out = Path("out/scenarios.png"),
) -> None:
    """Draw the global paths over the surface and both priority maps."""
    from ltp.evaluation.figures import global_paths_figure
    from ltp.evaluation.scenarios import make_scenarios
    from ltp.sim.mission import Mission

    place, base = open_world(world), open_config(config)
    options = scenario_options(
        count, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    drawn = make_scenarios(place, options)
    binary, lowpass = (
        Mission(place, dataclasses.replace(base, priority_map=kind), drawn[0].global_path).priority
        for kind in ("binary", "lpf")
    )
    write_figure(global_paths_figure(place, drawn, binary, lowpass), out)


def sensing(
    world: WorldArgument = "city",
    planner: Planner = "lp-dijkstra",
    scenario: Which = 0,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    config: Config = None,
    out: Out = Path("out/sensing.png"),
) -> None:
    """Draw a slice of the obstacle map in flight: volume against surface sensing."""
    from ltp.evaluation.scenarios import make_scenario
    from ltp.evaluation.sensed import SnapshotTaker
    from ltp.evaluation.sensing_figure import sensing_figure
    from ltp.sim import fly

    place = open_world(world)
    settings = dataclasses.replace(open_config(config), planner=planner)
    options = scenario_options(
        1, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    taker = SnapshotTaker()
    with console.status("flying"):
        fly(place, settings, make_scenario(place, options, scenario).global_path, [taker])
    write_figure(sensing_figure(place, taker.snapshots, settings.lidar.max_range), out)


def traps(out: Out = Path("out/traps.png")) -> None:
    """Fly GGWP into a bug trap and to a goal inside a building; draw the telling moments."""
    from ltp.evaluation.trap_figure import trap_figure

    with console.status("flying"):
        figure = trap_figure()
    write_figure(figure, out)


def summary(
    world: WorldArgument = "city",
    planners: Annotated[
        str, typer.Option(help="Planners to fly, with commas between.")
    ] = "lp-dijkstra,lp-a-star,wlp-a-star,ggwp",
    scenario: Which = 0,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    config: Config = None,
    out: Out = Path("out/summary.png"),
) -> None:
    """Fly one global path with several planners; draw them over the city."""
    from ltp.evaluation.scenarios import make_scenario
    from ltp.evaluation.sensed import SensedTrace
    from ltp.evaluation.summary_figure import summary_figure
    from ltp.sim import fly

    place, base = open_world(world), open_config(config)
    options = scenario_options(
        1, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    path = make_scenario(place, options, scenario).global_path
    records, sensed = [], SensedTrace()
    for name in planners.split(","):
        settings = dataclasses.replace(base, planner=name.strip())
        with console.status(f"flying {settings.planner}"):
            records.append(fly(place, settings, path, [sensed]))
    write_figure(summary_figure(place, records, sensed), out)
