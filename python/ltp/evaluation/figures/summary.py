# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One picture that says it all: a city from above, a global path, what each planner made of it."""

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp.drawing.shading import sunlight
from ltp.sim.record import FlightRecord
from ltp.world import CLASS_COLOURS, LandClass, World

from ..sensed import SensedTrace
from .backdrop import (
    draw_array,
    draw_legend,
    dress,
    make_page,
    quiet_corner,
    view_round,
)
from .flights import PATH_COLOURS, draw_flights
from .headline import headline, record_title, worth
from .profile import draw_strips, strips_height

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_SENSED = "#c1272d"
_MARGIN = 70.0  # shown round the flights [m]


def summary_figure(
    world: World, records: Sequence[FlightRecord], sensed: SensedTrace, size: float = 11.0
) -> "Figure":
    """The flights of several planners along one global path, over the city's land classes.

    Args:
        world: that was flown over.
        records: one per planner, all of the same global path.
        sensed: the obstacle cells that one of them met.
        size: width of the map [inch].
    """
    config = records[0].config
    weights = config.planner_options.weights
    heights = records[0].global_path[:, 2]
    height = f"{heights.min():.0f}" + (f" ... {heights.max():.0f}" if np.ptp(heights) > 1.0 else "")
    flown = np.concatenate([record.positions for record in records])
    view = view_round(flown, world, _MARGIN)
    figure, (axes,) = make_page(
        world,
        1,
        headline(world, records),
        f"{world.name}  ·  {records[0].global_length:.0f} m at z = {height} m  ·  W_L = "
        f"{weights.length:g}, W_P = {weights.priority:g}, {config.priority_map} map",
        gap=0.0,
        size=size,
        view=view,
        bars=False,
        below=strips_height(len(records)),
    )
    _draw_city(axes, world)
    _draw_sensed(axes, sensed)
    draw_flights(axes, world, records, [_label(record) for record in records], 2.2)
    draw_legend(axes, fontsize=9.5, loc=quiet_corner(view, flown))
    dress(axes, view)
    draw_strips(figure, world, records, PATH_COLOURS)
    return figure


def _label(record: FlightRecord) -> str:
    return f"{record_title(record)}:  {worth(record)}"


def _draw_city(axes: "Axes", world: World) -> None:
    """Land classes in pale colours, the higher the building the darker, under the sun."""
    table = np.array([CLASS_COLOURS[land] for land in sorted(LandClass)]) / 255.0
    colours = table[world.classes]
    grey = colours.mean(axis=-1, keepdims=True)
    colours = 0.25 + 0.75 * (0.55 * colours + 0.45 * grey)  # paths must outshine the map
    built = world.classes == LandClass.BUILDING
    tall = np.clip(world.height_above_ground / 90.0, 0.0, 1.0)[..., None]
    roofs = np.array([0.86, 0.83, 0.79]) * (1.0 - tall) + np.array([0.36, 0.37, 0.44]) * tall
    colours = np.where(built[..., None], roofs, colours)
    light = 0.42 + 0.58 * sunlight(world.surface, world.cell)[..., None]
    draw_array(axes, world, np.clip(colours * light, 0.0, 1.0))


def _draw_sensed(axes: "Axes", sensed: SensedTrace) -> None:
    from matplotlib.collections import PolyCollection

    corners: NDArray[np.float64] = sensed.corners
    if not len(corners):
        return
    unit = np.array([(0, 0), (1, 0), (1, 1), (0, 1)]) * sensed.cell
    squares = list(corners[:, None, :] + unit)
    cells = PolyCollection(squares, facecolor=_SENSED, edgecolor="none", zorder=2.5)
    cells.set_label("obstacle cells sensed at flight altitude")
    axes.add_collection(cells)
