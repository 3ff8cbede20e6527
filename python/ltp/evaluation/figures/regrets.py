# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figure of regret: what was flown, what could have been, and how flights differ in it.

It returns a matplotlib figure and writes nothing; see `backdrop.save_figure`.
"""

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..conditions import MAP_NAMES
from ..regret.rows import RegretRow
from ..regret.tables import RegretSummary, summarise_regrets
from .backdrop import FAINT, INK, caption, plain_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_FLOWN, _LEGS, _JOINT = "#e0409a", "#1f8be0", "#18b07b"
_LEGEND: dict[str, Any] = {"frameon": False, "fontsize": 9, "labelcolor": INK}


def regret_figure(rows: Sequence[RegretRow], attribution: str) -> "Figure":
    """A line a variant: at the left means of Eq. 5, at the right the regret of every flight.

    Args:
        rows: of one world.
        attribution: of the world.

    Raises:
        ValueError: if no flight has a regret, or the rows are of several worlds.
    """
    from matplotlib.figure import Figure

    summaries = [summary for summary in summarise_regrets(rows) if summary.counted]
    if not summaries:
        raise ValueError("the rows hold no flight that came to its end and has routes to compare")
    width, height = 11.4, 2.5 + 0.72 * len(summaries)
    figure = Figure(figsize=(width, height), facecolor="white")
    left, right = figure.subplots(1, 2, sharey=True)
    figure.subplots_adjust(
        left=2.7 / width, right=0.975, bottom=0.95 / height, top=1.0 - 1.05 / height, wspace=0.07
    )
    for line, summary in enumerate(summaries):
        means = (summary.flown, summary.legs, summary.joint)
        left.plot(means, [line] * 3, color="#c9ced6", lw=2.0, zorder=1)
        _spread(right, [row for row in rows if _belongs(row, summary)], summary, line)
    marks = (
        ("flown", "flown", _FLOWN, "o"),
        ("legs", "leg by leg", _LEGS, "s"),
        ("joint", "jointly", _JOINT, "D"),
    )
    for name, label, colour, marker in marks:
        values = [getattr(summary, name) for summary in summaries]
        left.plot(values, range(len(values)), marker, color=colour, mec="white", ms=9, label=label)
    left.set_yticks(range(len(summaries)), [_label(summary) for summary in summaries])
    left.set_ylim(len(summaries) - 0.5, -0.5)
    left.set_xlabel("mean Eq. 5 of the whole route", color=INK)
    left.legend(loc="lower left", bbox_to_anchor=(-0.02, 0.985), ncols=3, **_LEGEND)
    right.axvline(0.0, color=FAINT, lw=0.9, ls=(0, (4, 3)), zorder=0)
    right.set_xlabel("regret: flown less jointly", color=INK)
    right.legend(loc="lower left", bbox_to_anchor=(-0.02, 0.985), ncols=2, **_LEGEND)
    for axes in (left, right):
        axes.locator_params(axis="x", nbins=6)
        axes.grid(axis="x", color="#e6e8ec", lw=0.8)
        axes.set_axisbelow(True)
        plain_axes(axes)
        axes.tick_params(axis="y", length=0)
    title = "What one could have flown knowing all obstacles"
    note = "Eq. 5, lower is better; the same waypoints served; bars: 95 % interval of the mean"
    caption(figure, title, f"{rows[0].world}  ·  {note}", attribution)
    return figure


def _spread(axes: "Axes", mine: Sequence[RegretRow], summary: RegretSummary, line: int) -> None:
    values = np.sort([row.flown - row.joint for row in mine if row.joint is not None])
    first = line == 0
    heights = line + 0.22 * np.where(np.arange(len(values)) % 2, 1.0, -1.0)  # none hides another
    axes.plot(
        values, heights, ".", color=FAINT, alpha=0.6, ms=6, label="one flight" if first else None
    )
    mean = summary.over_joint
    ends = np.array([[mean.mean - mean.low], [mean.high - mean.mean]])
    axes.errorbar(
        [mean.mean],
        [line],
        xerr=None if np.isnan(ends).any() else ends,
        color=INK,
        lw=2.0,
        capsize=4,
        marker="o",
        ms=6,
        label="mean" if first else None,
    )


def _belongs(row: RegretRow, summary: RegretSummary) -> bool:
    return row.counts and (row.variant, row.gating) == (summary.variant, summary.gating)


def _label(summary: RegretSummary) -> str:
    variant = summary.variant
    return (
        f"{variant.contender.title}\n{summary.gating.title}\n"
        f"{MAP_NAMES[variant.priority_map]}, W_P/W_L = {variant.ratio:g}"
    )
