# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far planners are from the optimum of Eq. 5: statistics of gaps, and their tables."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..contenders import BASELINE, SHORTEST, contender_title
from .cases import Case
from .rows import GapRow

#: A gap, and the width of a certificate, that is as good as none; of Eq. 5.
CLOSE = 0.01
_ROUNDING = 1e-9  # by which a bound may pass the optimum


@dataclass(frozen=True)
class GapSummary:
    """One planner's plans under one case, over the queries that have an optimum.

    Gaps, penalties and times are over the plans found; nan where there are none.
    """

    case: Case
    planner: str
    queries: int
    proved: int  # of these: the optimum is proved, not only the best known
    found: int
    penalty: float  # mean of Eq. 5
    gap_mean: float
    gap_p95: float
    gap_worst: float
    close: float  # share of the plans with a gap <= `CLOSE`
    gain: float  # see `gain_over`
    time_median: float  # [ms]
    time_p95: float  # [ms]
    expanded: float  # median
    bounded: float  # share of the plans that have a bound
    valid: float  # share of the bounds that are not above the optimum
    width_mean: float  # penalty - bound
    width_p95: float
    certified: float  # share of the plans with penalty - bound <= `CLOSE`


def summarise_gaps(rows: Sequence[GapRow]) -> list[GapSummary]:
    """A summary for each case and planner, in the order of the rows."""
    groups: dict[tuple[Case, str], list[GapRow]] = {}
    for row in rows:
        groups.setdefault((row.case, row.planner), []).append(row)
    return [
        _summary(case, planner, mine, groups.get((case, SHORTEST)), groups.get((case, BASELINE)))
        for (case, planner), mine in groups.items()
    ]


def gain_over(
    rows: Sequence[GapRow], shortest: Sequence[GapRow] | None, baseline: Sequence[GapRow] | None
) -> float:
    """By how much a planner goes beyond LP-Dijkstra, in units of what that gains.

    Over the queries that all three found a path for: (mean penalty of LP-Dijkstra - of the planner)
    / (of the shortest path - of LP-Dijkstra). 0 is LP-Dijkstra, 1 gains as much again; nan where
    LP-Dijkstra gains nothing or one of them is missing.
    """
    table = [_penalties(part or ()) for part in (rows, baseline, shortest)]
    common = sorted(set(table[0]) & set(table[1]) & set(table[2]))
    if not common:
        return math.nan
    mine, other, short = (float(np.mean([part[i] for i in common])) for part in table)
    return (other - mine) / (short - other) if short - other > _ROUNDING else math.nan


def markdown_gaps(rows: Sequence[GapRow]) -> str:
    """All tables in Markdown, one a case, with what their columns mean."""
    summaries = summarise_gaps(rows)
    scenarios = len({row.scenario for row in rows})
    queries = len({row.query for row in rows})
    parts = [
        f"# Gap to the optimum: {rows[0].world}\n",
        f"{queries} queries recorded on {scenarios} flights.\n",
        _LEGEND,
    ]
    for case in dict.fromkeys(summary.case for summary in summaries):
        mine = [summary for summary in summaries if summary.case == case]
        titles = [column.title for column in COLUMNS]
        lines = ["| " + " | ".join(titles) + " |"]
        lines.append("|" + "|".join([" --- "] + [" ---: "] * (len(titles) - 1)) + "|")
        lines += [
            "| " + " | ".join(column.show(summary) for column in COLUMNS) + " |" for summary in mine
        ]
        parts.append(f"## {case.title}\n")
        parts.append("\n".join(lines) + "\n")
        if note := unproved_note([row for row in rows if row.case == case]):
            parts.append(note + "\n")
    return "\n".join(parts)


def unproved_note(rows: Sequence[GapRow]) -> str:
    """What is not known of one case's optima: empty if all are proved."""
    queries = {row.query: row for row in rows}
    solved = [row for row in queries.values() if row.optimum is not None]
    parts = []
    if open_ := [row for row in solved if not row.proved]:
        parts.append(
            f"In {len(open_)} of {len(solved)} queries the optimum is not proved: the gap there is "
            "to the best penalty known"
        )
        room = [
            row.optimum - row.optimum_bound
            for row in open_
            if row.optimum is not None and row.optimum_bound is not None
        ]
        if len(room) == len(open_):
            parts[-1] += (
                f", which is above the optimum by at most {max(room):.4f} (on average by at most "
                f"{np.mean(room):.4f})"
            )
        parts[-1] += "."
    if len(solved) < len(queries):
        missing = len(queries) - len(solved)
        parts.append(f"Queries that no planner found a path for do not count: {missing}.")
    return " ".join(parts)


@dataclass(frozen=True)
class Column:
    """Of the tables."""

    title: str
    show: Callable[[GapSummary], str]


def number(value: float, digits: int = 3) -> str:
    """For a table; a dash where there is none."""
    if math.isnan(value):
        return "–"
    return f"{round(value, digits) + 0.0:.{digits}f}".replace("-", "−")  # no minus before 0.000


def mean_penalty(summary: GapSummary) -> str:
    """In brackets where it is over fewer queries than the others', which are no match then."""
    text = number(summary.penalty)
    return text if summary.found in (0, summary.queries) else f"({text})"


def share(value: float) -> str:
    """In per cent; 100 only if it is all of them."""
    if math.isnan(value):
        return "–"
    shown = f"{100.0 * value:.0f} %"
    return f"{100.0 * value:.1f} %" if shown == "100 %" and value < 1.0 else shown


def milliseconds(value: float) -> str:
    """Two significant digits."""
    return "–" if math.isnan(value) else f"{value:.1f}" if value >= 10.0 else f"{value:.2g}"


COLUMNS = (
    Column("planner", lambda s: contender_title(s.planner)),
    Column("found", lambda s: f"{s.found}/{s.queries}"),
    Column("mean Eq. 5", lambda s: mean_penalty(s)),
    Column("mean gap", lambda s: number(s.gap_mean, 4)),
    Column("95 % gap", lambda s: number(s.gap_p95)),
    Column("worst gap", lambda s: number(s.gap_worst)),
    Column("gap ≤ 0.01", lambda s: share(s.close)),
    Column("gain", lambda s: number(s.gain, 2)),
    Column("ms", lambda s: milliseconds(s.time_median)),
    Column("95 % ms", lambda s: milliseconds(s.time_p95)),
    Column("cells", lambda s: "–" if math.isnan(s.expanded) else f"{s.expanded:.0f}"),
    Column("bounded", lambda s: share(s.bounded)),
    Column("valid", lambda s: share(s.valid)),
    Column("mean width", lambda s: number(s.width_mean, 4)),
    Column("95 % width", lambda s: number(s.width_p95)),
    Column("width ≤ 0.01", lambda s: share(s.certified)),
)

_LEGEND = """\
In brackets: a mean over fewer queries than the other rows'. Optimum: the reference planner. Gap:
Eq. 5 of the path less that of the best path of the grid, in units of Eq. 5 (W_L = 0.5). It is
below zero where a path that is not bound to the grid's 26 steps (Bézier, Hermite, refined) beats
them all. Gain: what the planner gains on LP-Dijkstra, over what LP-Dijkstra gains on the shortest
path; 0 is LP-Dijkstra. Time and cells: per plan, median (and 95th percentile). Certificate: share
of the paths that come with a lower bound on Eq. 5, share of the bounds that are valid, and the
width, penalty less bound.
"""


def _summary(
    case: Case,
    planner: str,
    rows: Sequence[GapRow],
    shortest: Sequence[GapRow] | None,
    baseline: Sequence[GapRow] | None,
) -> GapSummary:
    solved = [row for row in rows if row.optimum is not None]
    found = [row for row in solved if row.penalty is not None]
    gaps = np.array([row.gap for row in found if row.gap is not None])
    bounded = [row for row in found if row.bound is not None]
    widths = np.array([row.penalty - row.bound for row in bounded])  # type: ignore[operator]
    valid = [row.bound <= row.optimum + _ROUNDING for row in bounded]  # type: ignore[operator]
    times = np.array([row.time_plan for row in rows])
    return GapSummary(
        case=case,
        planner=planner,
        queries=len(solved),
        proved=sum(row.proved for row in solved),
        found=len(found),
        penalty=_of(np.mean, np.array([row.penalty for row in found])),
        gap_mean=_of(np.mean, gaps),
        gap_p95=_p95(gaps),
        gap_worst=_of(np.max, gaps),
        close=_of(np.mean, gaps <= CLOSE + _ROUNDING),
        gain=gain_over(rows, shortest, baseline),
        time_median=_of(np.median, times),
        time_p95=_p95(times),
        expanded=_of(np.median, np.array([row.expanded for row in rows])),
        bounded=len(bounded) / len(found) if found else math.nan,
        valid=_of(np.mean, np.array(valid)),
        width_mean=_of(np.mean, widths),
        width_p95=_p95(widths),
        certified=float(np.sum(widths <= CLOSE + _ROUNDING)) / len(found) if found else math.nan,
    )


def _penalties(rows: Sequence[GapRow]) -> dict[int, float]:
    return {row.query: row.penalty for row in rows if row.penalty is not None}


def _of(statistic: Callable[..., np.floating], values: np.ndarray) -> float:
    return float(statistic(values)) if len(values) else math.nan


def _p95(values: np.ndarray) -> float:
    return float(np.percentile(values, 95)) if len(values) else math.nan
