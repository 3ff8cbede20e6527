# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regret, a line a planner: what was flown, what could have been, and how surely they differ."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from ..campaign.bootstrap import Interval, mean_interval
from ..campaign.compare import interval_text
from ..campaign.variants import Variant
from ..conditions import map_title
from .gating import Gating
from .rows import RegretRow


@dataclass(frozen=True)
class RegretSummary:
    """The flights of one variant with one gating; means over those that count, nan without any."""

    variant: Variant
    gating: Gating
    flights: int
    counted: int  # of these: see `RegretRow.counts`
    flown: float  # mean of Eq. 5
    flown_length: float  # mean, over that of the global path
    flown_priority: float
    legs: float
    joint: float
    joint_bound: float
    joint_length: float
    joint_priority: float
    over_legs: Interval  # flown - legs
    over_joint: Interval  # flown - joint

    @property
    def case(self) -> str:
        """What is the same for all lines of a table, in words."""
        title = map_title(self.variant.priority_map).capitalize()
        return f"{title}, W_P/W_L = {self.variant.ratio:g}, {self.gating.title}"


def summarise_regrets(rows: Sequence[RegretRow]) -> list[RegretSummary]:
    """A summary for each variant and gating, in the order of the rows.

    Raises:
        ValueError: if the rows are of several worlds.
    """
    worlds = {row.world for row in rows}
    if len(worlds) > 1:
        raise ValueError(f"rows of several worlds in one table: {', '.join(sorted(worlds))}")
    groups: dict[tuple[Variant, Gating], list[RegretRow]] = {}
    for row in rows:
        groups.setdefault((row.variant, row.gating), []).append(row)
    return [_summary(variant, gating, mine) for (variant, gating), mine in groups.items()]


def by_case(summaries: Sequence[RegretSummary]) -> dict[str, list[RegretSummary]]:
    """The tables: title -> lines."""
    tables: dict[str, list[RegretSummary]] = {}
    for summary in summaries:
        tables.setdefault(summary.case, []).append(summary)
    return tables


def signed(value: float) -> str:
    """A penalty for a table; a dash where there is none."""
    return "–" if math.isnan(value) else f"{value:+.3f}".replace("-", "−")


def markdown_regrets(rows: Sequence[RegretRow]) -> str:
    """All tables in Markdown, with what their columns mean."""
    parts = [f"# Regret: {rows[0].world}\n", _LEGEND]
    for title, lines in by_case(summarise_regrets(rows)).items():
        text = ["| " + " | ".join(_TITLES) + " |"]
        text.append("|" + "|".join([" --- "] + [" ---: "] * (len(_TITLES) - 1)) + "|")
        text += ["| " + " | ".join(_cells(line)) + " |" for line in lines]
        parts.append(f"## {title}\n\n" + "\n".join(text) + "\n")
    return "\n".join(parts)


_TITLES = (
    "planner",
    "flights",
    "flown Eq. 5",
    "leg by leg",
    "regret",
    "jointly",
    "no less than",
    "regret",
    "L/L_GP flown, jointly",
    "P flown, jointly",
)

_LEGEND = """\
Eq. 5 of whole routes, L_direct being the length of the global path. Leg by leg, jointly: the best
routes through the true world's own cells that serve the waypoints which the flight served, within
the same distance of them (gates); no route over the planners' graph is below the bound. Regret:
flown less that, with its 95 % confidence interval (BCa bootstrap, 10,000 resamples); flights that
came to their end count. It can be negative: a flight cuts corners between cells, and may pass where
the map's cells, had it seen all, would be blocked; one that plans several gates jointly (a horizon)
can be better than the best leg by leg.
"""


def _cells(s: RegretSummary) -> list[str]:
    return [
        s.variant.contender.title,
        f"{s.counted}/{s.flights}",
        signed(s.flown),
        signed(s.legs),
        interval_text(s.over_legs),
        signed(s.joint),
        signed(s.joint_bound),
        interval_text(s.over_joint),
        f"{s.flown_length:.2f}, {s.joint_length:.2f}",
        f"{s.flown_priority:.2f}, {s.joint_priority:.2f}",
    ]


def _summary(variant: Variant, gating: Gating, mine: Sequence[RegretRow]) -> RegretSummary:
    counted = [row for row in mine if row.counts]

    def column(name: str) -> np.ndarray:
        return np.array([getattr(row, name) for row in counted], dtype=np.float64)

    flown, legs, joint = (column(name) for name in ("flown", "legs", "joint"))
    return RegretSummary(
        variant=variant,
        gating=gating,
        flights=len(mine),
        counted=len(counted),
        flown=_mean(flown),
        flown_length=_mean(column("flown_length") / column("global_length")),
        flown_priority=_mean(column("flown_priority")),
        legs=_mean(legs),
        joint=_mean(joint),
        joint_bound=_mean(column("joint_bound")),
        joint_length=_mean(column("joint_length") / column("global_length")),
        joint_priority=_mean(column("joint_priority")),
        over_legs=mean_interval(list(flown - legs)),
        over_joint=mean_interval(list(flown - joint)),
    )


def _mean(values: np.ndarray) -> float:
    return float(values.mean()) if len(values) else math.nan
