# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all maps share: inks, axes in metres, arrays over the world's extent, colour bars."""

import math
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from ltp.world import World

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.cm import ScalarMappable

INK, FAINT = "#22262b", "#6d7480"
PRIORITY_COLOURS = ("#232a44", "#2f5d78", "#4a9b8e", "#a5cf9a", "#f3f3cf")

Box = tuple[float, float, float, float]  # x_min, y_min, x_max, y_max [m]

_MOST_PIXELS = 1500  # along an axis; more cells are thinned


def draw_array(axes: "Axes", world: World, values: NDArray[Any]) -> None:
    """An [ix, iy, ...] array of colours over the extent of the world, north up."""
    x_min, y_min, x_max, y_max = world.extent
    axes.imshow(values.swapaxes(0, 1), origin="lower", extent=(x_min, x_max, y_min, y_max))


def draw_bar(axes: "Axes", mapped: "ScalarMappable", label: str) -> None:
    """A colour bar as high as its panel."""
    bar = axes.figure.colorbar(mapped, cax=axes.inset_axes((1.02, 0.0, 0.028, 1.0)))
    bar.set_label(label, color=INK)
    bar.ax.tick_params(colors=FAINT, labelsize=9)
    bar.outline.set_visible(False)


def dress(axes: "Axes", box: Box) -> None:
    """Axes in metres over a part of the world."""
    x_min, y_min, x_max, y_max = box
    axes.set(xlim=(x_min, x_max), ylim=(y_min, y_max), aspect="equal")
    axes.set_xlabel("east x [m]", color=INK)
    axes.set_ylabel("north y [m]", color=INK)
    plain_axes(axes)


def plain_axes(axes: "Axes") -> None:
    """Quiet ticks and spines."""
    axes.tick_params(colors=FAINT, labelsize=9)
    for spine in axes.spines.values():
        spine.set_color("#c9ced6")


def thin(values: NDArray[Any], cell: float) -> tuple[NDArray[Any], float]:
    """Every n-th cell, so that a picture of a large world stays a picture; and the new cell."""
    step = max(1, math.ceil(max(values.shape) / _MOST_PIXELS))
    return values[::step, ::step], cell * step
