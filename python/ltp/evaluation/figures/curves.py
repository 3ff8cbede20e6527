# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plane of flown length and mean priority, swept over the weights: one curve a planner."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp.brief import brief

from ..campaign.rows import FlightRow
from ..conditions import PRIORITY_MAPS, map_title
from ..contenders import contender_title
from .backdrop import FAINT, INK, caption, draw_legend, panel_title, plain_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

COLOURS = ("#1f8be0", "#e0409a", "#18b07b", "#f0a30a", "#7d5fd0", "#e8602c", "#3b2a6b")
_MARKERS = ("o", "s", "D", "^", "v", "P", "X")


@dataclass(frozen=True, eq=False)
class Curve:
    """Means over scenarios of one planner's flights, ratio by ratio, and their standard errors."""

    planner: str
    ratios: list[float]  # W_P / W_L, rising
    length: NDArray[np.float64]  # (n,) flown length ratio
    length_error: NDArray[np.float64]
    priority: NDArray[np.float64]  # (n,) mean priority
    priority_error: NDArray[np.float64]

    __repr__ = brief


def curves(
    rows: Sequence[FlightRow], priority_map: str, planners: Sequence[str] = ()
) -> tuple[list[Curve], int]:
    """The curve of each planner over one map, and over how many scenarios.

    Only scenarios count that every planner flew to the end at every ratio at hand: the curves then
    differ by nothing but the planner.

    Args:
        rows: of a campaign.
        priority_map: that was flown with.
        planners: to draw; default: those with two ratios or more.
    """
    flights: dict[tuple[str, float], dict[tuple[int, int], FlightRow]] = {}
    for row in rows:
        if row.priority_map == priority_map and row.length_weight:
            flown = row.variant
            ended = flights.setdefault((flown.contender.name, flown.ratio), {})
            if row.completed:
                ended[row.seed, row.scenario] = row
    ratios: dict[str, list[float]] = {}
    for planner, ratio in flights:
        ratios.setdefault(planner, []).append(ratio)
    drawn = [p for p, swept in ratios.items() if (p in planners if planners else len(swept) > 1)]
    sets = [set(ended) for (planner, _), ended in flights.items() if planner in drawn]
    common = sorted(set.intersection(*sets)) if sets else []
    if not common:
        return [], 0
    found = []
    for planner in drawn:
        swept = sorted(ratios[planner])
        mine = [[flights[planner, ratio][key] for key in common] for ratio in swept]
        length = np.array([[row.length_ratio for row in line] for line in mine])
        priority = np.array([[row.mean_priority for row in line] for line in mine])
        means = [part for values in (length, priority) for part in (values.mean(1), _error(values))]
        found.append(Curve(planner, swept, *means))
    return found, len(common)


def curve_figure(
    rows: Sequence[FlightRow], attribution: str, planners: Sequence[str] = ()
) -> "Figure":
    """One panel a map, one curve a planner, a point a ratio, with standard errors.

    Args:
        rows: of a campaign with `--ratios`.
        attribution: of the world.
        planners: to draw; default: those flown at two ratios or more.

    Raises:
        ValueError: if there is no such planner, or the rows are of several worlds.
    """
    from matplotlib.figure import Figure

    worlds = {row.world for row in rows}
    if len(worlds) > 1:
        raise ValueError(f"rows of several worlds in one figure: {', '.join(sorted(worlds))}")
    panels = {kind: curves(rows, kind, planners) for kind in PRIORITY_MAPS}
    panels = {kind: found for kind, found in panels.items() if found[0]}
    if not panels:
        raise ValueError("the rows hold no planner that was flown at two ratios W_P / W_L or more")
    width, height = 1.4 + 5.6 * len(panels), 6.0
    figure = Figure(figsize=(max(width, 8.5), height), facecolor="white")
    row = figure.subplots(1, len(panels), squeeze=False)[0]
    figure.subplots_adjust(left=0.95 / width, right=0.965, bottom=0.15, top=0.82, wspace=0.16)
    looks = dict.fromkeys(curve.planner for found, _ in panels.values() for curve in found)
    styles = {
        name: (COLOURS[i % len(COLOURS)], _MARKERS[i % len(_MARKERS)])
        for i, name in enumerate(looks)
    }
    for axes, (kind, (found, count)) in zip(row, panels.items(), strict=True):
        for index, curve in enumerate(found):
            _draw(axes, curve, *styles[curve.planner], below=index > 0)
        panel_title(axes, f"{map_title(kind).capitalize()}, {count} global paths")
        axes.set_xlabel("flown length ratio  L_LP / L_GP", color=INK)
        axes.grid(color="#e6e8ec", lw=0.8)
        axes.set_axisbelow(True)
        axes.margins(0.08)
        plain_axes(axes)
        draw_legend(axes, loc="lower right")
    row[0].set_ylabel("mean priority", color=INK)
    title = "What a planner gets for the length that it flies"
    note = "numbers: W_P/W_L; bars: standard error; up and to the left is better"
    caption(figure, title, f"{worlds.pop()}  ·  {note}", attribution)
    return figure


def _draw(axes: "Axes", curve: Curve, colour: str, marker: str, below: bool) -> None:
    axes.errorbar(
        curve.length,
        curve.priority,
        xerr=curve.length_error,
        yerr=curve.priority_error,
        color=colour,
        ecolor=colour + "70",
        elinewidth=1.0,
        lw=2.0,
        marker=marker,
        ms=6.5,
        mec="white",
        label=contender_title(curve.planner),
    )
    for x, y, ratio in zip(curve.length, curve.priority, curve.ratios, strict=True):
        axes.annotate(
            f"{ratio:g}",
            (x, y),
            xytext=(6, -11) if below else (-6, 6),
            textcoords="offset points",
            ha="left" if below else "right",
            size=8,
            color=FAINT,
        )


def _error(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Standard error of the mean of each row; 0 for a single value."""
    count = values.shape[1]
    if count < 2:
        return np.zeros(len(values))
    return np.asarray(values.std(axis=1, ddof=1) / np.sqrt(count))
