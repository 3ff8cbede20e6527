# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's figures of flights: paths over surface and priority map, the sweep, the global paths.

Each function returns a matplotlib figure and writes nothing; see `backdrop.save_figure`. Every
figure carries the attribution line of its world.
"""

import itertools
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ltp.sim.record import FlightRecord
from ltp.world import World

from ..campaign.rows import FlightRow
from ..campaign.summary import Spread
from ..campaign.variants import at_ratio
from ..conditions import PRIORITY_MAPS, map_title
from ..contenders import contender_title
from ..scenarios import Scenario
from .backdrop import (
    FAINT,
    GLOBAL_PATH,
    INK,
    caption,
    draw_global_path,
    draw_heights,
    draw_legend,
    draw_path,
    draw_priority,
    draw_start,
    draw_tall,
    dress,
    make_page,
    nested_widths,
    panel_title,
    plain_axes,
    quiet_corner,
    view_round,
)
from .headline import headline, record_title, worth
from .profile import draw_strips, strips_height

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ltp._core import Raster

#: Of flown paths, in order; told apart by the colour-blind too (Okabe and Ito, brightened).
PATH_COLOURS = ("#e0409a", "#1f8be0", "#18b07b", "#f0a30a", "#e8602c", "#b9a0f0", "#3b2a6b")

_MARGIN = 100.0  # shown round the flown paths [m]


def flown_paths_figure(
    world: World, records: Sequence[FlightRecord], priority: "Raster"
) -> "Figure":
    """Flights of one global path under different weights, over the surface and a priority map.

    Args:
        world: that was flown over.
        records: one per weight ratio, in order; all of the same global path.
        priority: the map to draw.
    """
    config = records[0].config
    flown = np.concatenate([record.positions for record in records])
    view = view_round(flown, world, _MARGIN, aspect=1.0)
    figure, (left, right) = make_page(
        world,
        2,
        f"Flown paths for different weights: {record_title(records[0])}",
        f"{world.name}  ·  {map_title(config.priority_map)}  ·  {headline(world, records)}",
        view=view,
        below=strips_height(len(records)),
    )
    draw_heights(left, world)
    draw_priority(right, world, priority)
    panel_title(left, "Over the obstacle surface")
    panel_title(right, f"Over the {map_title(config.priority_map)}")
    labels = [_weight_label(record) for record in records]
    for axes in (left, right):
        draw_flights(axes, world, records, labels)
        dress(axes, view)
    right.set_ylabel("")
    draw_legend(left, loc=quiet_corner(view, flown))
    draw_strips(figure, world, records, PATH_COLOURS)
    return figure


def draw_flights(
    axes: "Axes",
    world: World,
    records: Sequence[FlightRecord],
    labels: Sequence[str],
    width: float = 2.0,
) -> None:
    """The global path, the roofs that reach its altitude, the flights and what they dropped."""
    path = records[0].global_path
    draw_tall(axes, world, float(path[:, 2].min()))
    draw_global_path(axes, path)
    widths = nested_widths([record.positions for record in records], width)
    for record, label, wide, colour in zip(records, labels, widths, itertools.cycle(PATH_COLOURS)):
        draw_path(axes, record.positions, colour, label, wide)
    draw_drops(axes, records)


def global_paths_figure(
    world: World, scenarios: Sequence[Scenario], binary: "Raster", lowpass: "Raster"
) -> "Figure":
    """All global paths over the surface, beside both priority maps."""
    crossing = sum(scenario.crosses_building for scenario in scenarios)
    figure, (left, middle, right) = make_page(
        world,
        3,
        f"{len(scenarios)} straight global paths, {crossing} of them through buildings",
        f"{world.name}  ·  red: where each begins",
        gap=1.35,
        size=4.8,
    )
    draw_heights(left, world)
    draw_priority(middle, world, binary)
    draw_priority(right, world, lowpass)
    panel_title(left, "Obstacle surface")
    panel_title(middle, f"Binary priority, mean {np.mean(binary.values):.2f}")
    panel_title(right, f"Low-pass priority, mean {np.mean(lowpass.values):.2f}")
    for axes in (middle, right):
        axes.set_ylabel("")
    for axes in (left, middle, right):
        for scenario in scenarios:
            draw_path(axes, scenario.global_path, GLOBAL_PATH, width=1.3, rim=0.5)
        starts = np.array([scenario.global_path[0] for scenario in scenarios])
        draw_start(axes, starts, 24.0)
    return figure


def sweep_figure(rows: Sequence[FlightRow], attribution: str) -> "Figure":
    """Mean priority and length ratio over W_P / W_L, mean and SD band, for both priority maps.

    Args:
        rows: of a campaign; those of the sweep are picked out.
        attribution: of the world.

    Raises:
        ValueError: if no map has two ratios or more, or the rows are of several worlds.
    """
    from matplotlib.figure import Figure

    worlds = {row.world for row in rows}
    if len(worlds) > 1:
        raise ValueError(f"rows of several worlds in one sweep: {', '.join(sorted(worlds))}")
    planner, ratios = _sweep_of(rows)
    figure = Figure(figsize=(11.0, 7.4), facecolor="white")
    panels = figure.subplots(2, len(ratios), squeeze=False, sharex="col", sharey="row")
    figure.subplots_adjust(left=0.075, right=0.975, bottom=0.13, top=0.86, wspace=0.08, hspace=0.12)
    for column, (kind, found) in enumerate(ratios.items()):
        top, bottom = panels[:, column]
        panel_title(top, map_title(kind).capitalize())
        _band(top, rows, planner, kind, found, "mean_priority", PATH_COLOURS[1])
        _band(bottom, rows, planner, kind, found, "length_ratio", PATH_COLOURS[4])
        bottom.set_xlabel("W_P / W_L", color=INK)
        bottom.set_xticks([r for r in found if r in (0.0, 0.5, 1.0, 2.0, 5.0, 10.0, 15.0, 20.0)])
        bottom.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    panels[0, 0].set_ylabel("mean priority", color=INK)
    panels[1, 0].set_ylabel("length ratio  L_LP / L_GP", color=INK)
    flights = max(len(_values(rows, planner, k, r, "length")) for k, f in ratios.items() for r in f)
    title = f"Trading length for priority: {contender_title(planner)}"
    note = "mean, and a band of one standard deviation; the paper's operating point is 2"
    caption(figure, title, f"{worlds.pop()}  ·  {flights} global paths  ·  {note}", attribution)
    return figure


def draw_drops(axes: "Axes", records: Sequence[FlightRecord]) -> None:
    """Marks on the waypoints that any of the flights dropped as unreachable, or found too far."""
    style: dict[str, Any] = {"color": "#fff200", "edgecolor": "#1a1d22", "lw": 1.1, "zorder": 7}
    for fate, label, marker, size in (
        ("dropped", "waypoint proved unreachable", "X", 95),
        ("skipped", "waypoint too far", "D", 45),
    ):
        entries = [entry for r in records for entry in r.waypoints if entry.outcome == fate]
        if entries:
            goals = np.array([entry.goal for entry in {e.index: e for e in entries}.values()])
            axes.scatter(goals[:, 0], goals[:, 1], marker=marker, s=size, label=label, **style)


def _weight_label(record: FlightRecord) -> str:
    weights = record.config.planner_options.weights
    ratio = weights.priority / weights.length if weights.length else np.inf
    return f"W_P/W_L = {ratio:g}:  {worth(record)}"


def _sweep_of(rows: Sequence[FlightRow]) -> tuple[str, dict[str, list[float]]]:
    """The planner flown at the most ratios, and the ratios by priority map."""
    best: tuple[str, dict[str, list[float]]] = ("", {})
    most = 0
    for planner in dict.fromkeys(row.planner for row in rows):
        ratios = {}
        for kind in PRIORITY_MAPS:
            found = {
                row.priority_weight / row.length_weight
                for row in rows
                if row.planner == planner and row.priority_map == kind and row.length_weight
            }
            flown = sorted(r for r in found if _values(rows, planner, kind, r, "length"))
            if len(flown) > 1:
                ratios[kind] = flown
        if (count := sum(map(len, ratios.values()))) > most:
            best, most = (planner, ratios), count
    if not most:
        raise ValueError("the rows hold no sweep: no map was flown at two ratios W_P / W_L or more")
    return best


def _values(
    rows: Sequence[FlightRow], planner: str, kind: str, ratio: float, name: str
) -> list[float]:
    variant = at_ratio(ratio, planner, kind)
    mine = [row for row in rows if row.variant == variant and row.completed]
    return [getattr(row, name) for row in mine]


def _band(
    axes: "Axes",
    rows: Sequence[FlightRow],
    planner: str,
    kind: str,
    ratios: Sequence[float],
    name: str,
    colour: str,
) -> None:
    spreads = [Spread.of(_values(rows, planner, kind, ratio, name)) for ratio in ratios]
    mean = np.array([spread.mean for spread in spreads])
    sd = np.nan_to_num(np.array([spread.sd for spread in spreads]))
    axes.set_xscale("function", functions=(np.sqrt, np.square))  # room for the small ratios
    axes.axvline(2.0, color=FAINT, lw=1.0, ls=(0, (4, 3)), zorder=1)
    axes.fill_between(ratios, mean - sd, mean + sd, color=colour, alpha=0.18, lw=0.0)
    for edge in (mean - sd, mean + sd):
        axes.plot(ratios, edge, color=colour, lw=1.0, ls="--", alpha=0.8)
    axes.plot(ratios, mean, color=colour, lw=2.2, marker="o", ms=5, mec="white", clip_on=False)
    axes.grid(color="#e6e8ec", lw=0.8)
    axes.set_axisbelow(True)
    axes.set_xlim(0.0, max(ratios) * 1.02)
    plain_axes(axes)
