# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""All cases of a comparison at a glance: mean gaps, and what certificates are worth."""

import math
from collections.abc import Sequence

from ..conditions import MAP_NAMES
from ..contenders import OPTIMUM, contender_title, is_refined
from .cases import Case
from .tables import GapSummary, milliseconds, number, share


def markdown_overview(summaries: Sequence[GapSummary]) -> str:
    """Two tables in Markdown: mean gaps, a row a case; certificates, a row a case and planner."""
    return f"{_gaps(summaries)}\n\n{_certificates(summaries)}"


def _gaps(summaries: Sequence[GapSummary]) -> str:
    planners = [name for name in _names(summaries) if name != OPTIMUM]
    by_case = _by_case(summaries)
    head = [*_CASE, "proved", *(contender_title(name) for name in planners)]
    body = []
    for case, mine in by_case.items():
        some = next(iter(mine.values()))
        gaps = [_gap(mine.get(name)) for name in planners]
        body.append([*_case(case), f"{some.proved}/{some.queries}", *gaps])
    return _table(head, body, text=2)


def _gap(summary: GapSummary | None) -> str:
    if summary is None:
        return "–"
    mean = number(summary.gap_mean)
    return mean if summary.found in (0, summary.queries) else f"({mean})"


def _certificates(summaries: Sequence[GapSummary]) -> str:
    """Of the planners whose every path has a bound that is about the path itself."""
    head = [*_CASE, "planner", "gap ≤ 0.01", "gain (of the optimum)", "ms (95 %)", "bound valid"]
    head += ["width ≤ 0.01", "mean width"]
    body = []
    for case, mine in _by_case(summaries).items():
        best = mine.get(OPTIMUM)
        for summary in mine.values():
            refined = is_refined(summary.planner)
            if summary.planner == OPTIMUM or refined or summary.bounded != 1.0:
                continue
            gain = number(summary.gain, 2)
            if best is not None and not math.isnan(best.gain):
                gain += f" ({number(best.gain, 2)})"
            body.append(
                [
                    *_case(case),
                    contender_title(summary.planner),
                    share(summary.close),
                    gain,
                    f"{milliseconds(summary.time_median)} ({milliseconds(summary.time_p95)})",
                    share(summary.valid),
                    share(summary.certified),
                    number(summary.width_mean),
                ]
            )
    return _table(head, body, text=2)


_CASE = ("map", "band", "W_P/W_L")


def _case(case: Case) -> list[str]:
    return [MAP_NAMES[case.priority_map], case.band, f"{case.ratio:g}"]


def _names(summaries: Sequence[GapSummary]) -> list[str]:
    return list(dict.fromkeys(summary.planner for summary in summaries))


def _by_case(summaries: Sequence[GapSummary]) -> dict[Case, dict[str, GapSummary]]:
    cases: dict[Case, dict[str, GapSummary]] = {}
    for summary in summaries:
        cases.setdefault(summary.case, {})[summary.planner] = summary
    return cases


def _table(head: Sequence[str], body: Sequence[Sequence[str]], text: int) -> str:
    """The first `text` columns to the left, the others to the right."""
    rule = ["---"] * text + ["---:"] * (len(head) - text)
    return "\n".join("| " + " | ".join(line) + " |" for line in (head, rule, *body))
