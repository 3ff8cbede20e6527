# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp evaluate`: a campaign of planners, weights and maps over many global paths."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .campaign_tables import write_tables
from .global_paths import GlobalPaths
from .inputs import (
    map_names,
    numbers,
    open_priority,
    open_world,
    planner_names,
    read_flights,
    workers,
)
from .naming import naming
from .options import PriorityFile, PriorityMaps, Processes, ResumedFolder, WorldArgument
from .output import console, resumable, say, tell
from .settings import Settings
from .spread import spread

if TYPE_CHECKING:
    from ltp.evaluation.campaign.variants import Variant

_ROWS = ("tables", "1", "2", "none")


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("evaluate")(evaluate)


@spread
def evaluate(
    *,
    world: WorldArgument = "city",
    paths: Annotated[int, typer.Option(help="Number of global paths.")] = 50,
    global_paths: GlobalPaths,
    rows: Annotated[
        str,
        typer.Option(
            help="Rows of the paper's tables to fly: `tables` (all ten), `1` (Table I), `2` "
            "(Table II) or `none`."
        ),
    ] = "tables",
    planners: Annotated[
        str,
        typer.Option(help="Planners to fly, with commas between; by default all of the rows."),
    ] = "",
    ratios: Annotated[
        str,
        typer.Option(
            help="Ratios W_P / W_L to sweep too, with the --planners (LP-Dijkstra if none is "
            "named): numbers with commas between, or `default` for 0 ... 20."
        ),
    ] = "",
    maps: PriorityMaps = "binary,lpf",
    priority: PriorityFile = None,
    refine: Annotated[
        bool,
        typer.Option("--refine", help="Fly each of these with refined paths too."),
    ] = False,
    processes: Processes = 0,
    out: ResumedFolder = Path("out/evaluate"),
    records: Annotated[
        bool, typer.Option("--records", help="Keep each flight's record too, for replays.")
    ] = False,
    settings: Settings,
) -> None:
    """Fly planners, weights and maps over many paths; print tables.

    A campaign that was stopped in any way goes on where it was when the same command is given
    again. The same command gives the same flights.csv, but for the columns time_*. Another command
    with the same world, settings and paths adds its rows to the folder's; any other is refused.
    """
    from ltp.evaluation.campaign import TABLE, Campaign, run_campaign

    from .progress import CampaignProgress

    variants = _variants(rows, planners, ratios, maps, refine)
    base = settings.open()
    place = open_world(world)
    scenarios = global_paths.over(place, paths)
    crossing = sum(scenario.crosses_building for scenario in scenarios)
    say(
        f"{place.name}: {len(scenarios)} global paths at {global_paths.altitude:g} m above "
        f"{global_paths.reference}, {crossing} through buildings; {len(variants)} variants"
    )
    with resumable(out, "flown"):
        run_campaign(
            Campaign(place, variants, scenarios, base, open_priority(priority, place)),
            out,
            processes=workers(processes),
            keep_records=records,
            observers=[CampaignProgress(console())],
        )
    write_tables(read_flights(out), out)
    tell("flights", out / TABLE)


def _variants(rows: str, planners: str, ratios: str, maps: str, refine: bool) -> list["Variant"]:
    from ltp.evaluation.campaign.variants import (
        SWEEP_RATIOS,
        TABLE_I,
        TABLE_II,
        rows_of,
        sweep,
        unique,
        with_refined,
    )
    from ltp.evaluation.conditions import PRIORITY_MAPS
    from ltp.registry import PLANNERS

    if rows not in _ROWS:
        raise ValueError(f"--rows must be one of {', '.join(_ROWS)}, not {rows!r}")
    if not (kinds := map_names(maps)):
        raise ValueError(f"--maps: {maps!r} is none of {', '.join(PRIORITY_MAPS)}")
    wanted = planner_names("--planners", planners)
    if unknown := [name for name in wanted if name not in PLANNERS]:
        raise ValueError(f"--planners: {unknown[0]!r} is none of {', '.join(PLANNERS)}")
    variants = list({"tables": TABLE_I + TABLE_II, "1": TABLE_I, "2": TABLE_II, "none": ()}[rows])
    if wanted:
        variants = [variant for name in wanted for variant in rows_of(name, variants)]
    if ratios:
        values = SWEEP_RATIOS if ratios == "default" else numbers("--ratios", ratios)
        with naming(ratio="--ratios"):
            for name in wanted or ["lp-dijkstra"]:
                variants += sweep(values, name)
    variants = [variant for variant in variants if variant.priority_map in kinds]
    if not variants:
        raise ValueError("nothing to fly: --rows, --planners, --ratios, --maps leave no variant")
    return unique(with_refined(variants) if refine else variants)
