# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp compare`: planners over the same flown scenarios, pair by pair."""

import math
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from .inputs import map_names, planner_names, read_flights
from .naming import naming
from .options import FlightsArgument, Ratio
from .output import say, tell, write_text

if TYPE_CHECKING:
    from ltp.evaluation.campaign.compare import Comparison
    from ltp.evaluation.campaign.rows import FlightRow


def register(app: typer.Typer) -> None:
    """Add the command."""
    app.command("compare")(compare)


def compare(
    flights: FlightsArgument,
    planners: Annotated[
        str,
        typer.Option(
            help="Planners to compare, with commas between: the baseline, then one or more to hold "
            "against it; `NAME+refine` is one with its paths refined. By default all that were "
            "flown, the baseline being LP-Dijkstra, or else the first."
        ),
    ] = "",
    against: Annotated[
        Path | None,
        typer.Option(
            help="Another campaign's folder, the baseline: each planner is then held against "
            "itself there, flown with other settings over the same global paths.",
            show_default=False,
        ),
    ] = None,
    ratio: Ratio = 2.0,
    maps: Annotated[
        str,
        typer.Option(
            help="Priority maps, with commas between; by default all that they were flown over."
        ),
    ] = "",
    out: Annotated[Path | None, typer.Option(help="Markdown file to write too.")] = None,
) -> None:
    """Compare planners, or settings, closed loop, paired by global path.

    Prints the mean difference (second less first) of the flown Eq. 5, of the length ratio, of the
    mean priority and of the mean distance from the global path with 95 % confidence intervals (BCa
    bootstrap, 10,000 seeded resamples).
    """
    from ltp.evaluation.campaign.compare import markdown_comparisons

    rows, wanted, kinds = (
        read_flights(flights),
        planner_names("--planners", planners),
        map_names(maps),
    )
    if against is None:
        found = _of_planners(flights, rows, wanted, ratio, kinds)
    else:
        found = _of_settings(flights, rows, against, wanted, ratio, kinds)
    for comparison in found:
        _tell(comparison)
    if out is not None:
        write_text(markdown_comparisons(found), out)
        tell("table", out)


def _of_settings(
    flights: Path,
    rows: "list[FlightRow]",
    against: Path,
    wanted: list[str],
    ratio: float,
    kinds: list[str],
) -> "list[Comparison]":
    """Each planner against itself in the other campaign."""
    from ltp.evaluation.campaign.compare import compare_campaigns, flown_maps

    baseline = read_flights(against)
    with naming(ratio="--ratio", planner="--planners"):
        if not wanted:
            both = {row.variant for row in rows} & {row.variant for row in baseline}
            names = [
                variant.contender.name
                for variant in dict.fromkeys(row.variant for row in rows)
                if variant in both and math.isclose(variant.ratio, ratio)
            ]
            wanted = list(dict.fromkeys(names))
        common = [
            kind
            for kind in flown_maps(rows, wanted, ratio)
            if kind in flown_maps(baseline, wanted, ratio)
        ]
        kinds = kinds or common
    if not wanted or not kinds:
        raise ValueError(
            f"{flights} and {against} hold no planner that both flew over one map at --ratio "
            f"{ratio:g}"
        )
    named = [path.resolve().name for path in (against, flights)]
    if named[0] == named[1]:
        named = [str(against), str(flights)]
    return compare_campaigns({named[0]: baseline}, {named[1]: rows}, wanted, ratio, kinds)


def _of_planners(
    flights: Path, rows: "list[FlightRow]", wanted: list[str], ratio: float, kinds: list[str]
) -> "list[Comparison]":
    """The first planner against the others."""
    from ltp.evaluation.campaign.compare import compare_all, flown_maps, flown_planners

    with naming(ratio="--ratio", planner="--planners"):
        if not wanted:
            wanted = flown_planners(rows, ratio, kinds)
            if len(wanted) < 2:
                raise ValueError(_nothing_to_compare(flights, rows, ratio))
        elif len(wanted) < 2:
            raise ValueError(f"--planners must name two planners or more, not {wanted[0]!r}")
        kinds = kinds or flown_maps(rows, wanted, ratio)
    if not kinds:
        raise ValueError(
            f"{flights} holds no map flown by all of --planners {','.join(wanted)} at --ratio "
            f"{ratio:g}"
        )
    return compare_all(rows, wanted, ratio, kinds)


def _nothing_to_compare(flights: Path, rows: "list[FlightRow]", ratio: float) -> str:
    flown = sorted({row.variant.ratio for row in rows})
    return (
        f"{flights} holds no two planners over one map at --ratio {ratio:g}; its flights have "
        f"ratios {', '.join(f'{value:g}' for value in flown)}. To fly two: ltp evaluate WORLD "
        f"--rows none --planners lp-dijkstra,sweep --ratios {ratio:g} --out FOLDER"
    )


def _tell(comparison: "Comparison") -> None:
    from ltp.evaluation.campaign.compare import MEASURES, interval_text

    a, b = comparison.baseline, comparison.challenger
    say(
        f"{b.title} less {a.title}, {b.variant.priority_map} map, "
        f"W_P/W_L = {b.variant.ratio:g}: {comparison.pairs} pairs of {comparison.flown}",
        style="bold",
    )
    for name, title in MEASURES.items():
        interval = comparison.differences[name]
        sure = "" if interval.excludes_zero else "  (zero is in the interval)"
        if math.isnan(interval.mean):
            continue  # flown before it was measured
        say(f"  {title:<15} {interval_text(interval)}{sure}")
    say(
        f"  Eq. 5 lower in {comparison.better}, higher in {comparison.worse} pairs; collisions: "
        f"{b.collisions} and {a.collisions}",
    )
