# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tables I and II of the paper from the rows of a campaign, the paper's own numbers beside ours."""

import csv
import io
import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass

from ..conditions import PRIORITY_MAPS, map_title
from .paper import PaperRow
from .rows import FlightRow
from .summary import Spread, Summary
from .variants import TABLE_I, TABLE_II, Variant, with_refined


def table_variants(rows: Iterable[FlightRow]) -> dict[str, list[Variant]]:
    """The tables that the rows can fill: title -> variants, in the paper's order.

    What was flown with refinement follows what was flown without. Variants that are in neither
    table of the paper gather by their map.
    """
    flown = list(dict.fromkeys(row.variant for row in rows))
    first, second = with_refined(TABLE_I), with_refined(TABLE_II)
    tables = {
        "Table I: binary priority map": [variant for variant in first if variant in flown],
        "Table II: low-pass priority map": [variant for variant in second if variant in flown],
    }
    others = [variant for variant in flown if variant not in first + second]
    for kind in PRIORITY_MAPS:
        mine = [variant for variant in others if variant.priority_map == kind]
        tables[f"Not in the paper's tables: {map_title(kind)}"] = mine
    return {title: variants for title, variants in tables.items() if variants}


def table_cells(summaries: Sequence[Summary]) -> tuple[list[str], list[list[tuple[str, bool]]]]:
    """The titles of the columns, and a line a row: texts, and which are the best of a column.

    The paper marks the best in red. All rows whose rounded value is the best are marked.
    """
    marks = [column.marks(summaries) for column in _COLUMNS]
    lines = [
        [(column.show(summary), mark[i]) for column, mark in zip(_COLUMNS, marks, strict=True)]
        for i, summary in enumerate(summaries)
    ]
    return [column.title for column in _COLUMNS], lines


def markdown_table(summaries: Sequence[Summary]) -> str:
    """One table in Markdown; the best values are bold."""
    titles, lines = table_cells(summaries)
    rules = [" --- " if column.text else " ---: " for column in _COLUMNS]
    text = ["| " + " | ".join(titles) + " |", "|" + "|".join(rules) + "|"]
    for line in lines:
        cells = [f"**{cell}**" if best else cell for cell, best in line]
        text.append("| " + " | ".join(cells) + " |")
    return "\n".join(text) + f"\n\n{averaged_over(summaries)} {_OFF_PATH}\n"


def averaged_over(summaries: Sequence[Summary]) -> str:
    """Which flights the means of a table are over, and how many waypoints were too far."""
    whole = [summary for summary in summaries if not summary.timed_out_only]
    common, most = whole[0].common, max(summary.flights for summary in whole)
    what = (
        "flights that came to their end"
        if len(whole) == 1
        else "paths that all rows flew to the end"
    )
    text = f"P and L are means over the {common} of {most} {what}."
    too_far = sum(summary.too_far for summary in whole)
    return text + (f" Waypoints skipped as too far: {too_far}." if too_far else "")


def brief_cells(
    summaries: Sequence[Summary],
) -> tuple[list[str], list[tuple[list[tuple[str, bool]], list[str] | None]]]:
    """As `table_cells`, for 80 columns: a line of ours, and one of the paper's where it has one."""
    titles, lines = table_cells(summaries)
    ours = [titles.index(title) for title in _BRIEF]
    paper = [titles.index(title) if title else None for title in _BRIEF_PAPER]
    pairs = []
    for summary, line in zip(summaries, lines, strict=True):
        theirs = ["" if index is None else line[index][0] for index in paper]
        theirs[0] = "  paper"
        mine = [line[index] for index in ours]
        if summary.timed_out_only:
            mine[0] = ("  timed out", False)
        pairs.append((mine, theirs if summary.paper else None))
    return list(_BRIEF.values()), pairs


def csv_table(summaries: Iterable[Summary]) -> str:
    """The same numbers, unrounded, as CSV."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(_CSV_COLUMNS)
    for summary in summaries:
        values = [get(summary) for get in _CSV_COLUMNS.values()]
        writer.writerow(["" if value is None or value != value else value for value in values])
    return text.getvalue()


@dataclass(frozen=True)
class _Column:
    title: str
    show: Callable[[Summary], str]
    rank: Callable[[Summary], float] | None = None  # the smallest is the best; None marks none
    text: bool = False

    def marks(self, summaries: Sequence[Summary]) -> list[bool]:
        """Which are the best, to three significant digits: rounding makes them equal."""
        if self.rank is None or len(summaries) < 2:
            return [False] * len(summaries)
        ranks = [
            math.nan if summary.timed_out_only else float(f"{self.rank(summary):.3g}")
            for summary in summaries
        ]
        best = min((rank for rank in ranks if not math.isnan(rank)), default=math.nan)
        return [rank == best for rank in ranks]


def _spread(spread: Spread) -> str:
    if math.isnan(spread.mean):
        return "–"
    return f"{spread.mean:.2f}" + ("" if math.isnan(spread.sd) else f" ({spread.sd:.2f})")


def _time(value: float | None) -> str:
    if value is None or math.isnan(value):
        return "–"
    return f"{value:.1f}" if value >= 10.0 else f"{value:.2f}"


def _metres(value: float | None) -> str:
    return "–" if value is None or math.isnan(value) else f"{value:.0f}"


def _off_path(summary: Summary) -> str:
    away = summary.path_distance
    if away is None or math.isnan(away.mean):
        return "–"
    return f"{away.mean:.1f}" + ("" if math.isnan(away.sd) else f" ({away.sd:.1f})")


def _off_path_rank(summary: Summary) -> float:
    return math.nan if summary.path_distance is None else summary.path_distance.mean


def _paper(show: Callable[[PaperRow], str]) -> Callable[[Summary], str]:
    return lambda summary: show(summary.paper) if summary.paper else "–"


def _title(summary: Summary) -> str:
    title = summary.variant.contender.title
    return f"{title}: timed out" if summary.timed_out_only else title


def _dropped(summary: Summary) -> str:
    fine = summary.wrongly_dropped_fine
    return f"{summary.dropped} ({summary.wrongly_dropped}, {'–' if fine is None else fine})"


_COLUMNS = (
    _Column("algorithm", _title, text=True),
    _Column("W_L", lambda s: f"{s.variant.length_weight:g}"),
    _Column("W_P", lambda s: f"{s.variant.priority_weight:g}"),
    _Column("mean P (SD)", lambda s: _spread(s.mean_priority), lambda s: -s.mean_priority.mean),
    _Column("paper: P", _paper(lambda p: f"{p.mean_priority:.2f} ({p.mean_priority_sd:.2f})")),
    _Column("L_LP/L_GP (SD)", lambda s: _spread(s.length_ratio), lambda s: s.length_ratio.mean),
    _Column("paper: L", _paper(lambda p: f"{p.length_ratio:.2f} ({p.length_ratio_sd:.2f})")),
    _Column("mean m off path (SD)", _off_path, _off_path_rank),
    _Column("largest", lambda s: _metres(s.path_distance_max)),
    _Column("ms per plan", lambda s: _time(s.time_mean), lambda s: s.time_mean),
    _Column("paper: ms", _paper(lambda p: "–" if p.time_plan is None else f"{p.time_plan:g}")),
    _Column("median ms", lambda s: _time(s.time_median)),
    _Column("95 % ms", lambda s: _time(s.time_p95)),
    _Column("completed", lambda s: f"{s.completed}/{s.flights}"),
    _Column("waypoints dropped (wrongly, at 0.5 m)", _dropped),
    _Column("too far", lambda s: str(s.too_far)),
    _Column("collisions", lambda s: str(s.collisions)),
    _Column("smallest clearance [m]", lambda s: _spread(Spread(s.min_clearance, math.nan))),
)

_OFF_PATH = (
    "Off path: horizontal distance of what was flown from the global path, its mean over the "
    "length flown, and the largest of the same flights."
)

#: Columns of the brief table, their short titles, and the paper's columns below them.
_BRIEF = {
    "algorithm": "algorithm",
    "W_L": "W_L",
    "W_P": "W_P",
    "mean P (SD)": "P",
    "L_LP/L_GP (SD)": "L",
    "ms per plan": "ms",
    "completed": "done",
    "waypoints dropped (wrongly, at 0.5 m)": "dropped",
    "collisions": "hits",
    "smallest clearance [m]": "clear",
}
_BRIEF_PAPER = ("", "", "", "paper: P", "paper: L", "paper: ms", "", "", "", "")

_CSV_COLUMNS: dict[str, Callable[[Summary], object]] = {
    "world": lambda s: s.world,
    "planner": lambda s: s.variant.planner,
    "length_weight": lambda s: s.variant.length_weight,
    "priority_weight": lambda s: s.variant.priority_weight,
    "priority_map": lambda s: s.variant.priority_map,
    "refine": lambda s: "yes" if s.variant.refine else "no",
    "timed_out_only": lambda s: "yes" if s.timed_out_only else "no",
    "mean_priority": lambda s: s.mean_priority.mean,
    "mean_priority_sd": lambda s: s.mean_priority.sd,
    "paper_mean_priority": lambda s: s.paper and s.paper.mean_priority,
    "paper_mean_priority_sd": lambda s: s.paper and s.paper.mean_priority_sd,
    "length_ratio": lambda s: s.length_ratio.mean,
    "length_ratio_sd": lambda s: s.length_ratio.sd,
    "paper_length_ratio": lambda s: s.paper and s.paper.length_ratio,
    "paper_length_ratio_sd": lambda s: s.paper and s.paper.length_ratio_sd,
    "path_distance_mean": lambda s: s.path_distance and s.path_distance.mean,
    "path_distance_sd": lambda s: s.path_distance and s.path_distance.sd,
    "path_distance_max": lambda s: s.path_distance_max,
    "flights": lambda s: s.flights,
    "completed": lambda s: s.completed,
    "common": lambda s: s.common,
    "timed_out": lambda s: s.timed_out,
    "collisions": lambda s: s.collisions,
    "dropped": lambda s: s.dropped,
    "wrongly_dropped": lambda s: s.wrongly_dropped,
    "wrongly_dropped_fine": lambda s: s.wrongly_dropped_fine,
    "too_far": lambda s: s.too_far,
    "min_clearance": lambda s: s.min_clearance,
    "plans": lambda s: s.plans,
    "time_plan_mean_ms": lambda s: s.time_mean,
    "time_plan_median_ms": lambda s: s.time_median,
    "time_plan_p95_ms": lambda s: s.time_p95,
    "paper_time_plan_ms": lambda s: s.paper and s.paper.time_plan,
}
