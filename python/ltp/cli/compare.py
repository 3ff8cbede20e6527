# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp compare`: planners over the same flown scenarios, pair by pair."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .common import console, names, tell
from .evaluate import read_flights

if TYPE_CHECKING:
    from ltp.evaluation.compare import Comparison


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("compare")(compare)


def compare(
    flights: Annotated[
        Path, typer.Argument(help="flights.csv of a campaign, or the campaign's folder.")
    ],
    planners: Annotated[
        str,
        typer.Option(
            help="The baseline, then one or more to hold against it, commas between; `NAME+refine` "
            "is one with its paths refined."
        ),
    ] = "lp-dijkstra,sweep",
    ratio: Annotated[float, typer.Option(help="W_P / W_L that they were flown at.")] = 2.0,
    maps: Annotated[
        str,
        typer.Option(help="Priority maps, commas between (default: all that they were flown over)"),
    ] = "",
    out: Annotated[Path | None, typer.Option(help="Markdown file to write too.")] = None,
) -> None:
    """Compare planners closed loop, paired by global path.

    Prints the mean difference (second less first) of the flown Eq. 5, of the length ratio and of
    the mean priority with 95 % confidence intervals (BCa bootstrap, 10,000 seeded resamples).
    """
    from ltp.evaluation.compare import compare_all, flown_maps, markdown_comparisons
    from ltp.files import atomic_write

    rows, wanted = read_flights(flights), names(planners)
    kinds = names(maps) or flown_maps(rows, wanted, ratio)
    if not kinds:
        raise ValueError(f"{flights} holds no map flown by all of {planners} at ratio {ratio:g}")
    found = compare_all(rows, wanted, ratio, kinds)
    for comparison in found:
        _tell(comparison)
    if out is not None:
        with atomic_write(out) as file:
            file.write(markdown_comparisons(found).encode())
        tell("table", out)


def _tell(comparison: "Comparison") -> None:
    from ltp.evaluation.compare import MEASURES, interval_text
    from ltp.evaluation.tables import named_title

    a, b = comparison.baseline, comparison.challenger
    console.print(
        f"{named_title(b.planner)} less {named_title(a.planner)}, {b.priority_map} map, "
        f"W_P/W_L = {b.ratio:g}: {comparison.pairs} pairs of {comparison.flown}",
        style="bold",
        markup=False,
    )
    for name, title in MEASURES.items():
        interval = comparison.differences[name]
        sure = "" if interval.excludes_zero else "  (zero is in the interval)"
        console.print(f"  {title:<15} {interval_text(interval)}{sure}", markup=False)
    console.print(
        f"  Eq. 5 lower in {comparison.better}, higher in {comparison.worse} pairs; collisions: "
        f"{b.collisions} and {a.collisions}",
        markup=False,
    )
