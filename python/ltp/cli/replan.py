# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp replan`: what it saves to repair the last search instead of starting again."""

from typing import TYPE_CHECKING, Annotated

import typer

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
    open_config,
    open_world,
    scenario_options,
)

if TYPE_CHECKING:
    from ltp.evaluation.replanning import ReplanningSummary, Spread


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("replan")(replan)


def replan(
    world: WorldArgument = "city",
    planner: Annotated[str, typer.Option(help="That flies and is judged.")] = "incremental",
    against: Annotated[str, typer.Option(help="That it is judged by.")] = "additive",
    alpha: Annotated[
        float, typer.Option(help="Of both planners' cost alpha L - P, at every scan the same.")
    ] = 1.3,
    scenario: Annotated[int, typer.Option(help="Which of the seeded global paths, from 0.")] = 0,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    config: Config = None,
) -> None:
    """Fly one global path and ask two planners at every scan; compare work, time and cost."""
    from ltp.evaluation.replanning import compare_replanning, summarise_replanning
    from ltp.evaluation.scenarios import make_scenario

    if scenario < 0:
        raise ValueError(f"--scenario must be >= 0, not {scenario}")
    base = open_config(config)
    place = open_world(world)
    options = scenario_options(
        scenario + 1, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    path = make_scenario(place, options, scenario).global_path
    scans = compare_replanning(place, base, path, planner, against, alpha)
    _print(summarise_replanning(scans), planner, against)


def _print(summary: "ReplanningSummary", planner: str, against: str) -> None:
    from rich import box
    from rich.table import Table

    grid = Table(box=box.SIMPLE_HEAD)
    grid.add_column("a scan", no_wrap=True)
    for title in ("median", "mean", "95 %"):
        grid.add_column(title, justify="right")

    def row(title: str, spread: "Spread") -> None:
        grid.add_row(title, *[f"{v:.4g}" for v in (spread.median, spread.mean, spread.p95)])

    for index, name in enumerate((planner, against)):
        row(f"{name}, cells", summary.expanded[index])
    row("times fewer", summary.ratio)
    for index, name in enumerate((planner, against)):
        row(f"{name}, ms", summary.milliseconds[index])
    console.print(grid)
    agree = "always" if summary.same_status else "NOT always"
    console.print(
        f"{summary.scans} scans, {summary.found} with a path; the same answer {agree}; the same "
        f"cost in {100 * summary.same_cost:.4g} %, at most {summary.largest_difference:.1e} apart",
        markup=False,
    )
