# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figures of planners against the optimum: one query's front, and the spread of all gaps.

Each function returns a matplotlib figure and writes nothing; see `backdrop.save_figure`.
"""

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ..conditions import MAP_NAMES
from ..contenders import OPTIMUM, contender_title
from ..gap.cases import Case
from ..gap.front import EXACT, FrontView, plane
from ..gap.rows import GapRow
from ..gap.tables import CLOSE, number
from .backdrop import FAINT, INK, caption, plain_axes

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

#: Of planners, in order; with the markers, told apart by the colour-blind too.
COLOURS = ("#e0409a", "#1f8be0", "#18b07b", "#f0a30a", "#e8602c", "#7d5fd0", "#3b2a6b", "#8a8f98")
_MARKERS = ("o", "s", "D", "^", "v", "P", "X", "<", ">", "p", "h", "d")
_DASHES: tuple[Any, ...] = ("-", (0, (4, 1.5)), (0, (1.2, 1.2)))
_EXACT = ("#c8960c", "*")
_IMPOSSIBLE = "#eceef2"
_CERTIFIED = "#b3261e"


def front_figure(view: FrontView, world: str, attribution: str) -> "Figure":
    """All that one query offers, and where each planner lands.

    Args:
        view: of the query.
        world: its name.
        attribution: of the world.
    """
    from matplotlib.figure import Figure

    figure = Figure(figsize=(11.4, 6.6), facecolor="white")
    axes = figure.add_axes((0.073, 0.115, 0.555, 0.735))
    points = plane(
        np.array([(b.length, b.priority) for b in view.landings]).reshape(-1, 2),
        view.direct_length,
    )
    corners = plane(view.hull, view.direct_length)
    _frame(axes, points, corners)
    _isolines(axes, view)
    x0, x1 = axes.get_xlim()
    line = view.envelope(x1)
    wall = np.concatenate([[(x0, -9.0), (line[0, 0], -9.0)], line])
    axes.fill_between(wall[:, 0], wall[:, 1], 9.0, color=_IMPOSSIBLE, lw=0.0, zorder=1)
    axes.plot(*line.T, color=INK, lw=1.6, zorder=3, label="hull: no grid path lies above it")
    axes.plot(
        *corners.T, "o", color=INK, ms=3.5, zorder=3, label="its corners, the supported paths"
    )
    if view.front is not None:
        front = plane(view.front, view.direct_length)
        style: dict[str, Any] = {"color": "#8f5d00", "mfc": "#ffc94d", "ms": 3.8, "mew": 0.6}
        axes.plot(*front.T, "o", zorder=3.5, label=f"exact front: {len(front)} paths", **style)
    _bound(axes, view)
    ranked = sorted(view.landings, key=lambda landing: landing.penalty)
    style_of = {b.planner: _style(i) for i, b in enumerate(view.landings)}
    style_of[EXACT] = _EXACT
    for rank, landing in enumerate(ranked):
        colour, marker = style_of[landing.planner]
        (at,) = plane(np.array([(landing.length, landing.priority)]), view.direct_length)
        label = f"{contender_title(landing.planner)}:  {number(landing.penalty)}"
        axes.plot(
            *at,
            marker,
            color=colour,
            ms=17.0 if marker == "*" else 12.0 - 0.35 * rank,  # drawn below, it shows round others
            mec="white",
            mew=1.1,
            zorder=4.9 if marker == "*" else 5 + 0.01 * rank,
            label=label,
            ls="none",
        )
    axes.set_xlabel("length ratio  L / L_direct", color=INK)
    axes.set_ylabel("mean priority of the path", color=INK)
    plain_axes(axes)
    _side_legend(axes, len(view.landings))
    weights = view.weights
    note = f"L_direct = {view.direct_length:.0f} m, W_L = {weights.length:g}, W_P = "
    note += f"{weights.priority:g}"
    title = "Which paths there are, and which ones planners take"
    about = f"{world}  ·  query {view.query}  ·  {view.case.title}  ·  {note}"
    caption(figure, title, about, attribution)
    return figure


def gap_figure(rows: Sequence[GapRow], attribution: str) -> "Figure":
    """How the gaps of each planner are spread: a panel for each map, band and ratio.

    Args:
        rows: of one world.
        attribution: of the world.

    Raises:
        ValueError: if no row has an optimum to be held against.
    """
    from matplotlib.figure import Figure

    solved = [row for row in rows if row.optimum is not None and row.planner != OPTIMUM]
    if not solved:
        raise ValueError("the rows hold no planner that could be held against an optimum")
    lines = list(dict.fromkeys((row.priority_map, row.band) for row in solved))
    ratios = sorted({row.ratio for row in solved})
    planners = list(dict.fromkeys(row.planner for row in solved))
    width, height = 2.6 + 2.7 * len(ratios), 1.6 + 2.3 * len(lines)
    width, height = max(width, 8.0), max(height, 5.4)
    figure = Figure(figsize=(width, height), facecolor="white")
    panels = figure.subplots(len(lines), len(ratios), squeeze=False, sharex=True, sharey=True)
    figure.subplots_adjust(
        left=0.75 / width,
        right=1.0 - 2.25 / width,
        bottom=0.95 / height,
        top=1.0 - 1.1 / height,
        wspace=0.1,
        hspace=0.3,
    )
    highest = max(row.gap for row in solved if row.gap is not None)
    lowest = min(row.gap for row in solved if row.gap is not None)
    for (kind, band), axes_row in zip(lines, panels, strict=True):
        for ratio, axes in zip(ratios, axes_row, strict=True):
            mine = [r for r in solved if r.case == Case(kind, band, ratio)]
            _spread(axes, mine, planners)
            axes.set_title(
                f"{MAP_NAMES[kind]}, {band}, W_P/W_L = {ratio:g}", size=9.5, color=INK, loc="left"
            )
            axes.set_xscale("symlog", linthresh=CLOSE, linscale=0.8)
            axes.set_xlim(min(-1e-3, 1.3 * lowest), 1.3 * max(highest, 10 * CLOSE))
            axes.set_ylim(0.0, 1.02)
            axes.set_xticks([0.0, 0.01, 0.1, 1.0][: 4 if highest > 0.5 else 3])
            axes.minorticks_off()
            axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
            axes.yaxis.set_major_formatter(lambda value, _: f"{100 * value:.0f} %")
    for axes in panels[-1]:
        axes.set_xlabel("gap to the optimum, Eq. 5", color=INK, size=9.5)
    for axes in panels[:, 0]:
        axes.set_ylabel("of the queries", color=INK, size=9.5)
    handles, labels = panels[0, -1].get_legend_handles_labels()
    panels[0, -1].legend(
        handles,
        labels,
        loc="upper left",
        bbox_to_anchor=(1.03, 1.03),
        frameon=False,
        fontsize=9,
        labelcolor=INK,
    )
    count = len({row.query for row in solved})
    title = "How near planners come to the best path there is"
    note = (
        f"share of {count} recorded queries with a gap up to x; dashed: 0.01; below 0: off the grid"
    )
    caption(figure, title, f"{rows[0].world}  ·  {note}", attribution)
    return figure


def _style(index: int) -> tuple[str, str]:
    return COLOURS[index % len(COLOURS)], _MARKERS[index % len(_MARKERS)]


def _frame(axes: "Axes", points: Any, corners: Any) -> None:
    """Room for every landing, and for some of what lies beyond."""
    if not len(points):
        points = corners
    x0, x1 = corners[0, 0], max(points[:, 0].max(), corners[0, 0] * 1.02)
    near = corners[corners[:, 0] <= x1 + 0.2 * (x1 - x0)]
    y0, y1 = min(points[:, 1].min(), near[:, 1].min()), max(points[:, 1].max(), near[:, 1].max())
    pad = max(0.02, 0.12 * (y1 - y0))
    axes.set_xlim(x0 - 0.12 * (x1 - x0), x1 + 0.2 * (x1 - x0))
    axes.set_ylim(y0 - pad, y1 + pad)
    axes.text(
        0.015,
        0.975,
        "no path of the grid here",
        transform=axes.transAxes,
        size=9,
        color=FAINT,
        va="top",
    )


def _isolines(axes: "Axes", view: FrontView) -> None:
    """Lines of equal Eq. 5, their value at the right edge."""
    weights = view.weights
    if not weights.priority:
        return
    (x0, x1), (y0, y1) = axes.get_xlim(), axes.get_ylim()
    slope = weights.length / weights.priority
    low = weights.priority * (slope * x0 - y1)
    high = weights.priority * (slope * x1 - y0)
    step = _round_step((high - low) / 9.0)
    for value in np.arange(np.ceil(low / step), np.floor(high / step) + 1) * step:
        shift = value / weights.priority
        axes.plot(
            (x0, x1), (slope * x0 - shift, slope * x1 - shift), color="#c3c9d2", lw=0.8, zorder=2
        )
        y = slope * x1 - shift
        if y0 < y < y1:
            text = f"{value:.2f}".replace("-", "−")
            axes.text(x1, y, f" {text}", size=8, color=FAINT, va="center", ha="left", clip_on=False)
    axes.text(x1, y1, " Eq. 5 =", size=8, color=FAINT, va="bottom", ha="left")


def _round_step(step: float) -> float:
    """1, 2 or 5 times a power of ten, no smaller than the step."""
    power = 10.0 ** np.floor(np.log10(step))
    return float(next(power * f for f in (1.0, 2.0, 5.0, 10.0) if power * f >= step * 0.999))


def _bound(axes: "Axes", view: FrontView) -> None:
    weights, surest = view.weights, view.certificate
    if surest is None or surest.bound is None or not weights.priority:
        return
    xs = np.array(axes.get_xlim())
    ys = (weights.length * xs - surest.bound) / weights.priority
    label = f"certificate of {contender_title(surest.planner)}:\nno path has Eq. 5 < "
    label += number(surest.bound)
    axes.plot(xs, ys, color=_CERTIFIED, lw=1.5, ls=(0, (5, 2.5)), zorder=4, label=label)


def _side_legend(axes: "Axes", landings: int) -> None:
    """The planners from the best to the worst, then what the lines are."""
    handles, labels = axes.get_legend_handles_labels()
    lines, planners = handles[:-landings], handles[-landings:]
    style: dict[str, Any] = {"frameon": False, "fontsize": 9.5, "labelcolor": INK, "loc": "left"}
    style |= {"alignment": "left", "title_fontproperties": {"weight": "bold", "size": 9.5}}
    style["loc"] = "upper left"
    first = axes.legend(
        planners,
        labels[-landings:],
        bbox_to_anchor=(1.09, 1.02),
        title="Eq. 5 of each path, the best first",
        **style,
    )
    axes.add_artist(first)
    style["loc"] = "lower left"
    axes.legend(
        lines, labels[:-landings], bbox_to_anchor=(1.09, -0.02), title="What there is", **style
    )


def _spread(axes: "Axes", rows: Sequence[GapRow], planners: Sequence[str]) -> None:
    """Share of the queries whose gap is at most x; a planner that finds none ends below 100 %."""
    axes.axvline(CLOSE, color=FAINT, lw=0.9, ls=(0, (4, 3)), zorder=1)
    axes.axvline(0.0, color="#c9ced6", lw=0.8, zorder=1)
    looks = itertools.product(_DASHES, COLOURS)
    for planner, (dashes, colour) in zip(planners, itertools.cycle(looks)):
        mine = [row for row in rows if row.planner == planner]
        gaps = np.sort([row.gap for row in mine if row.gap is not None])
        share = np.arange(1, len(gaps) + 1) / max(1, len(mine))
        axes.step(
            np.concatenate([[-9.0], gaps, [99.0]]),
            np.concatenate([[0.0], share, share[-1:] if len(share) else [0.0]]),
            where="post",
            color=colour,
            ls=dashes,
            lw=1.6,
            label=contender_title(planner),
        )
    axes.grid(color="#eef0f3", lw=0.8)
    axes.set_axisbelow(True)
    plain_axes(axes)
