# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp evaluate` flies a campaign, `ltp table` prints its tables."""

from collections.abc import Sequence
from pathlib import Path
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
    names,
    numbers,
    open_config,
    open_world,
    scenario_options,
    tell,
    workers,
)

if TYPE_CHECKING:
    from ltp.evaluation.rows import FlightRow
    from ltp.evaluation.variants import Variant

_ROWS = ("tables", "1", "2", "none")


def register(app: typer.Typer) -> None:
    """Add the commands."""
    app.command("evaluate")(evaluate)
    app.command("table")(table)


def evaluate(
    world: WorldArgument = "city",
    paths: Annotated[int, typer.Option(help="Number of global paths.")] = 50,
    altitude: Altitude = 50.0,
    reference: Reference = "ground",
    seed: Seed = 1,
    length: Length = 500.0,
    spacing: Spacing = 50.0,
    margin: Margin = 20.0,
    through_buildings: ThroughBuildings = 1.0,
    rows: Annotated[
        str,
        typer.Option(
            help="Rows of the paper's tables to fly: `tables` (all ten), `1` (Table I), `2` "
            "(Table II) or `none`."
        ),
    ] = "tables",
    planners: Annotated[
        str,
        typer.Option(help="Fly only these planners, with commas between (default: all)."),
    ] = "",
    ratios: Annotated[
        str,
        typer.Option(
            help="Also sweep W_P / W_L with the --planners (LP-Dijkstra if none is named): numbers "
            "with commas between, or `default` for 0 ... 20."
        ),
    ] = "",
    maps: Annotated[
        str, typer.Option(help="Fly only over these priority maps: `binary`, `lpf` or both.")
    ] = "binary,lpf",
    refine: Annotated[
        bool,
        typer.Option("--refine", help="Fly each of these with refined paths too."),
    ] = False,
    processes: Annotated[int, typer.Option(help="To fly in; 0: one per processor.")] = 0,
    out: Annotated[
        Path, typer.Option(help="Folder of the campaign; if it holds one, it is gone on with.")
    ] = Path("out/evaluate"),
    records: Annotated[
        bool, typer.Option("--records", help="Keep each flight's record too, for replays.")
    ] = False,
    config: Config = None,
) -> None:
    """Fly planners, weights and maps over many global paths; print the paper's tables.

    A campaign that was stopped in any way goes on where it was when the same command is given
    again. The same command gives the same flights.csv, but for the columns time_*.
    """
    from ltp.evaluation.campaign import TABLE, Campaign, run_campaign
    from ltp.evaluation.scenarios import make_scenarios

    from .progress import CampaignProgress

    variants = _variants(rows, planners, ratios, maps, refine)
    base = open_config(config)
    place = open_world(world)
    options = scenario_options(
        paths, altitude, reference, seed, length, spacing, margin, through_buildings
    )
    scenarios = make_scenarios(place, options)
    crossing = sum(scenario.crosses_building for scenario in scenarios)
    console.print(
        f"{place.name}: {len(scenarios)} global paths at {altitude:g} m above {reference}, "
        f"{crossing} through buildings; {len(variants)} variants",
        markup=False,
    )
    try:
        flown = run_campaign(
            Campaign(place, variants, scenarios, base),
            out,
            processes=workers(processes),
            keep_records=records,
            observers=[CampaignProgress(console)],
        )
    except KeyboardInterrupt:
        console.print(f"stopped; what was flown is kept in {out}: the same command goes on")
        raise
    write_tables(flown, out)
    tell("flights", out / TABLE)


def table(
    flights: Annotated[
        Path, typer.Argument(help="flights.csv of a campaign, or the campaign's folder.")
    ],
    style: Annotated[str, typer.Option("--format", help="`markdown` or `csv`.")] = "markdown",
    out: Annotated[Path | None, typer.Option(help="File to write instead of printing.")] = None,
) -> None:
    """Print Table I and Table II from a campaign's flights, the paper's numbers beside ours."""
    from ltp.files import atomic_write

    if style not in ("markdown", "csv"):
        raise ValueError(f"--format must be markdown or csv, not {style!r}")
    rows = read_flights(flights)
    text = _markdown(rows) if style == "markdown" else _csv(rows)
    if out is None:
        print(text, end="")
        return
    with atomic_write(out) as file:
        file.write(text.encode())
    tell("table", out)


def read_flights(path: Path) -> list["FlightRow"]:
    """The rows of a campaign, by its folder or its CSV."""
    from ltp.evaluation.campaign import TABLE
    from ltp.evaluation.rows import read_rows

    rows = read_rows(path / TABLE if path.is_dir() else path)
    if not rows:
        raise ValueError(f"{path} holds no flights")
    return rows


def write_tables(rows: Sequence["FlightRow"], folder: Path) -> None:
    """Print the tables and write them into a folder."""
    from ltp.files import atomic_write

    for name, text in (("tables.md", _markdown(rows)), ("tables.csv", _csv(rows))):
        with atomic_write(folder / name) as file:
            file.write(text.encode())
    _print_tables(rows)
    tell("tables", folder / "tables.md")


def _print_tables(rows: Sequence["FlightRow"]) -> None:
    """Narrow tables for the terminal: under each row, in grey, the paper's."""
    from rich import box
    from rich.table import Table

    from ltp.evaluation.tables import brief_cells, summarise, table_variants

    for title, variants in table_variants(rows).items():
        titles, lines = brief_cells([summarise(variant, rows) for variant in variants])
        grid = Table(title=title, title_justify="left", box=box.SIMPLE_HEAD, padding=0)
        for index, name in enumerate(titles):
            grid.add_column(name, justify="left" if index == 0 else "right", no_wrap=True)
        for ours, paper in lines:
            grid.add_row(*[f"[bold green]{cell}[/]" if best else cell for cell, best in ours])
            if paper is not None:
                grid.add_row(*paper, style="bright_black")
        console.print(grid)
    console.print(
        "P mean priority, L length flown over global path's (SD); time per plan; dropped "
        "waypoints (wrongly);\nclear: smallest clearance [m]; grey: the paper",
        style="bright_black",
        markup=False,
    )


def _markdown(rows: Sequence["FlightRow"]) -> str:
    from ltp.evaluation.tables import markdown_table, summarise, table_variants

    parts = [f"# {rows[0].world}\n"]
    for title, variants in table_variants(rows).items():
        summaries = [summarise(variant, rows) for variant in variants]
        parts.append(f"## {title}\n\n{markdown_table(summaries)}")
    return "\n".join(parts)


def _csv(rows: Sequence["FlightRow"]) -> str:
    from ltp.evaluation.tables import csv_table, summarise, table_variants

    variants = [variant for group in table_variants(rows).values() for variant in group]
    return csv_table([summarise(variant, rows) for variant in variants])


def _variants(rows: str, planners: str, ratios: str, maps: str, refine: bool) -> list["Variant"]:
    from ltp.evaluation.variants import (
        PRIORITY_MAPS,
        SWEEP_RATIOS,
        TABLE_I,
        TABLE_II,
        rows_of,
        sweep,
        unique,
        with_refined,
    )
    from ltp.planners import PLANNERS

    if rows not in _ROWS:
        raise ValueError(f"--rows must be one of {', '.join(_ROWS)}, not {rows!r}")
    kinds = names(maps)
    if not kinds or (strange := [kind for kind in kinds if kind not in PRIORITY_MAPS]):
        wrong = strange[0] if kinds else maps
        raise ValueError(f"--maps: {wrong!r} is none of {', '.join(PRIORITY_MAPS)}")
    wanted = names(planners)
    if unknown := [name for name in wanted if name not in PLANNERS]:
        raise ValueError(f"--planners: {unknown[0]!r} is none of {', '.join(PLANNERS)}")
    variants = list({"tables": TABLE_I + TABLE_II, "1": TABLE_I, "2": TABLE_II, "none": ()}[rows])
    if wanted:
        variants = [variant for name in wanted for variant in rows_of(name, variants)]
    if ratios:
        values = SWEEP_RATIOS if ratios == "default" else numbers("--ratios", ratios)
        for name in wanted or ["lp-dijkstra"]:
            variants += sweep(values, name)
    variants = [variant for variant in variants if variant.priority_map in kinds]
    if not variants:
        raise ValueError("nothing to fly: --rows, --planners, --ratios, --maps leave no variant")
    return unique(with_refined(variants) if refine else variants)
