# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The tables of `ltp gap` on the terminal."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

from .output import console, narrow_table, remark

if TYPE_CHECKING:
    from ltp.evaluation.gap.rows import GapRow

_TITLES = ("planner", "found", "Eq. 5", "gap", "worst", "near", "gain", "ms", "95 %", "sure")


def print_gaps(rows: Sequence["GapRow"]) -> None:
    """Print a table for each map, band and ratio."""
    from ltp.evaluation.contenders import contender_title
    from ltp.evaluation.gap.tables import (
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
        grid = narrow_table(f"{case.title}: {mine[0].queries} queries", _TITLES)
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
        console().print(grid)
        if note := unproved_note([row for row in rows if row.case == case]):
            remark(note)
    remark(
        "gap: to the optimum, in units of Eq. 5; near: share of gaps <= 0.01; gain: over\n"
        "LP-Dijkstra, 1 being what that gains on the shortest path; sure: share of plans\n"
        "proved within 0.01 of the optimum; in brackets: a mean over fewer queries",
    )
