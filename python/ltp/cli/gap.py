# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp gap`: how far every planner is from the exact optimum, on queries recorded in flight."""

import hashlib
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

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
    names,
    numbers,
    open_config,
    open_world,
    scenario_options,
    tell,
)

if TYPE_CHECKING:
    from ltp.config import MissionConfig
    from ltp.evaluation.gap import GapRow
    from ltp.evaluation.queries import QuerySet
    from ltp.evaluation.scenarios import ScenarioOptions
    from ltp.world import World

QUERIES = "queries.npz"
TABLES = "gap.md"
OVERVIEW = "overview.md"


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("gap")(gap)


def gap(
    world: WorldArgument = "city",
    queries: Annotated[
        int, typer.Option(help="How many to record, spread evenly over the flights.")
    ] = 100,
    paths: Annotated[int, typer.Option(help="Global paths to fly for them.")] = 10,
    planners: Annotated[
        str,
        typer.Option(
            help="Planners to compare, with commas between; `NAME+refine` is one with its paths "
            "refined, `shortest` is LP-Dijkstra with W_P = 0 (default: all, unrefined)."
        ),
    ] = "",
    ratios: Annotated[str, typer.Option(help="W_P / W_L, with commas between.")] = "0.5,1,2,5",
    maps: Annotated[str, typer.Option(help="Priority maps, with commas between.")] = "binary,lpf",
    bands: Annotated[
        str,
        typer.Option(
            help="`planar`: at the altitudes of start and goal; `open`: all levels of the window."
        ),
    ] = "planar,open",
    optimum: Annotated[
        str,
        typer.Option(
            "--reference-planner",
            help="Whose answer is the optimum, where it proves it.",
        ),
    ] = "pareto",
    memory: Annotated[
        float, typer.Option(help="That the reference planner may use, if it is pareto [MB].")
    ] = 2048.0,
    expansions: Annotated[
        int, typer.Option(help="The reference planner gives up after so many; 0: no limit.")
    ] = 0,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    config: Config = None,
    out: Annotated[
        Path, typer.Option(help="Folder; if it holds such a comparison, it is gone on with.")
    ] = Path("out/gap"),
) -> None:
    """Measure every planner's gap to the exact optimum of Eq. 5.

    Flies the global paths with the planner of the settings (`--config`) and keeps what it was
    asked: the map as sensed so far, start, goal. Then every planner answers every query
    under each ratio, map and band; its penalty is held against the optimum, its lower bound too.
    Times are of one plan at a time on one core. Writes queries.npz, gap.csv, gap.md and
    overview.md. Stopped in any way, it goes on where it was when the same command is given again.
    """
    from ltp.evaluation.gap import TABLE, GapOptions, run_gap
    from ltp.evaluation.gap_overview import markdown_overview
    from ltp.evaluation.gap_tables import markdown_gaps, summarise_gaps
    from ltp.files import atomic_write

    from .progress import GapProgress

    chosen: dict[str, Any] = {"planners": names(planners)} if planners else {}
    options = GapOptions(
        ratios=numbers("--ratios", ratios),
        maps=names(maps),
        bands=names(bands),
        reference=optimum,
        expansions=expansions,
        memory=memory,
        **chosen,
    )
    place, settings = open_world(world), open_config(config)
    lines = scenario_options(
        paths, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    recorded = _recorded(place, lines, settings, queries, out)
    try:
        rows = run_gap(recorded, options, out, [GapProgress(console)])
    except KeyboardInterrupt:
        console.print(f"stopped; what was planned is kept in {out}: the same command goes on")
        raise
    for name, text in (
        (TABLES, markdown_gaps(rows)),
        (OVERVIEW, markdown_overview(summarise_gaps(rows)) + "\n"),
    ):
        with atomic_write(out / name) as file:
            file.write(text.encode())
    _print_tables(rows)
    kept = (("queries", QUERIES), ("plans", TABLE), ("tables", TABLES), ("overview", OVERVIEW))
    for name, path in kept:
        tell(name, out / path)


def _recorded(
    world: "World", lines: "ScenarioOptions", config: "MissionConfig", count: int, folder: Path
) -> "QuerySet":
    """The folder's queries if they were recorded just so; else they are recorded."""
    from ltp._core import __version__
    from ltp.evaluation.flights import world_digest
    from ltp.evaluation.queries import QuerySet, record_queries
    from ltp.evaluation.scenarios import make_scenarios

    facts = [__version__, world_digest(world), asdict(lines), config.to_dict(), count]
    source = hashlib.sha256(json.dumps(facts).encode()).hexdigest()
    path = folder / QUERIES
    if path.exists() and (kept := QuerySet.load(path)).source == source:
        console.print(f"{len(kept.queries)} queries were recorded before", markup=False)
        return kept
    scenarios = make_scenarios(world, lines)
    with console.status("flying") as status:
        found = record_queries(
            world,
            scenarios,
            config,
            count,
            source,
            lambda done: status.update(f"flying: {done} of {len(scenarios)} flights"),
        )
    folder.mkdir(parents=True, exist_ok=True)
    found.save(path)
    console.print(
        f"{found.world}: {len(found.queries)} queries of {len(scenarios)} flights", markup=False
    )
    return found


def _print_tables(rows: Sequence["GapRow"]) -> None:
    from rich import box
    from rich.table import Table

    from ltp.evaluation.gap_tables import (
        case_title,
        contender_title,
        mean_penalty,
        milliseconds,
        number,
        share,
        summarise_gaps,
        unproved_note,
    )

    summaries = summarise_gaps(rows)
    for case in dict.fromkeys(summary.case for summary in summaries):
        mine = [summary for summary in summaries if summary.case == case]
        grid = Table(
            title=f"{case_title(case)}: {mine[0].queries} queries",
            title_justify="left",
            box=box.SIMPLE_HEAD,
            padding=0,
        )
        for index, name in enumerate(_TITLES):
            grid.add_column(name, justify="right" if index else "left", no_wrap=True)
        for s in mine:
            grid.add_row(
                contender_title(s.planner),
                str(s.found),
                mean_penalty(s),
                number(s.gap_mean),
                number(s.gap_worst),
                share(s.close),
                number(s.gain, 2),
                milliseconds(s.time_median),
                milliseconds(s.time_p95),
                share(s.certified),
            )
        console.print(grid)
        if note := unproved_note([row for row in rows if row.case == case]):
            console.print(note, style="bright_black", markup=False)
    console.print(
        "gap: to the optimum, in units of Eq. 5; near: share of gaps <= 0.01; gain: over\n"
        "LP-Dijkstra, 1 being what that gains on the shortest path; sure: share of plans\n"
        "proved within 0.01 of the optimum; in brackets: a mean over fewer queries",
        style="bright_black",
        markup=False,
    )


_TITLES = ("planner", "found", "Eq. 5", "gap", "worst", "near", "gain", "ms", "95 %", "sure")
