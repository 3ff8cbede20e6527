# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp gap`: how far every planner is from the exact optimum, on queries recorded in flight."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from .gap_queries import queries_file, recorded_queries
from .gap_report import print_gaps
from .global_paths import GlobalPaths
from .inputs import names, numbers, open_world, planner_name, planner_names
from .naming import naming
from .options import Memory, PriorityMaps, ResumedFolder, WorldArgument
from .output import console, resumable, tell, write_text
from .settings import Settings
from .spread import spread

if TYPE_CHECKING:
    from ltp.evaluation.gap.rows import GapRow

_TABLES = "gap.md"
_OVERVIEW = "overview.md"


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("gap")(gap)


@spread
def gap(
    *,
    world: WorldArgument = "city",
    queries: Annotated[
        int, typer.Option(help="Number of queries to record, spread evenly over the flights.")
    ] = 100,
    paths: Annotated[int, typer.Option(help="Number of global paths to fly for them.")] = 10,
    planners: Annotated[
        str,
        typer.Option(
            help="Planners to compare, with commas between; `NAME+refine` is one with its paths "
            "refined, `shortest` is the shortest path; by default all, unrefined."
        ),
    ] = "",
    ratios: Annotated[
        str, typer.Option(help="Ratios of the weights, W_P / W_L, with commas between.")
    ] = "0.5,1,2,5",
    maps: PriorityMaps = "binary,lpf",
    bands: Annotated[
        str,
        typer.Option(
            help="Altitude bands, with commas between: `planar` at the altitudes of start and "
            "goal, `open` over all levels of the window."
        ),
    ] = "planar,open",
    optimum: Annotated[
        str,
        typer.Option(
            "--reference-planner",
            help="Planner whose answer is the optimum, where it proves it.",
        ),
    ] = "exact",
    memory: Memory = 2048.0,
    expansions: Annotated[
        int,
        typer.Option(help="Number of expansions that the reference planner may make; 0: no limit."),
    ] = 0,
    global_paths: GlobalPaths,
    settings: Settings,
    out: ResumedFolder = Path("out/gap"),
) -> None:
    """Measure every planner's gap to the exact optimum.

    Flies the global paths with the planner of the settings (`--config`) and keeps what it was
    asked: the map as sensed so far, start, goal; settings with gates or a horizon are refused, as
    a query goes from a point to a point. Then every planner answers every query
    under each ratio, map and band; its penalty, Eq. 5, is held against the optimum, its lower bound
    too. Times are of one plan at a time on one core. Writes queries.npz, gap.csv, gap.md and
    overview.md. Stopped in any way, it goes on where it was when the same command is given again.
    """
    from ltp.evaluation.gap import TABLE, GapOptions, run_gap

    from .progress import GapProgress

    chosen: dict[str, Any] = {"planners": planner_names("--planners", planners)} if planners else {}
    with naming(
        *("planners", "maps", "bands", "expansions", "memory"),
        planner="--planners",
        ratio="--ratios",
        reference="--reference-planner",
    ):
        options = GapOptions(
            ratios=numbers("--ratios", ratios),
            maps=names(maps),
            bands=names(bands),
            reference=planner_name("--reference-planner", optimum),
            expansions=expansions,
            memory=memory,
            **chosen,
        )
    place = open_world(world)
    recorded = recorded_queries(place, global_paths, paths, settings.open(), queries, out)
    with resumable(out, "planned"):
        rows = run_gap(recorded, options, out, [GapProgress(console())])
    _write_tables(rows, out)
    print_gaps(rows)
    tell("queries", queries_file(out))
    for name, file in (("plans", TABLE), ("tables", _TABLES), ("overview", _OVERVIEW)):
        tell(name, out / file)


def _write_tables(rows: Sequence["GapRow"], folder: Path) -> None:
    from ltp.evaluation.gap.overview import markdown_overview
    from ltp.evaluation.gap.tables import markdown_gaps, summarise_gaps

    write_text(markdown_gaps(rows), folder / _TABLES)
    write_text(markdown_overview(summarise_gaps(rows)) + "\n", folder / _OVERVIEW)
