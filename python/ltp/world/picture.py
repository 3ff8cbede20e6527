# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`world_picture`: height, land classes and both priority maps of a world on one page."""

import math
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ltp.files import atomic_write

from .box_mean import box_mean
from .checks import positive
from .classes import CLASS_COLOURS, LandClass
from .priority import PRIORITY_CELL, binary_values, footprint
from .shading import sunlight
from .world import World

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_MOST_PIXELS = 1500  # along an axis; more cells are thinned
_INK, _FAINT = "#22262b", "#6d7480"
_HEIGHT_COLOURS = ("#f4f2ec", "#f0dcb8", "#e3a872", "#c76a5b", "#84406b", "#3b2a5a")
_OBSTACLE = "#1b1b1f"


def world_picture(world: World, path: str | os.PathLike[str], altitude: float = 50.0) -> None:
    """Draw a world: shaded height, land classes, binary and low-pass priority ("wide" landing).

    Args:
        world: what to draw.
        path: where the picture goes, all or nothing; .png, .pdf or .svg.
        altitude: of the flight, above ground [m]: sets the camera's footprint, and which obstacles
            are marked on the priority maps.

    Raises:
        ValueError: if `altitude` or the ending of `path` makes no sense.
        OSError: if the file cannot be written.
    """
    altitude = positive("altitude", altitude)
    ending = Path(path).suffix.lower().removeprefix(".")
    if ending not in ("png", "pdf", "svg"):
        raise ValueError(f"path must end in .png, .pdf or .svg, not {os.fspath(path)!r}")
    figure = _draw(world, altitude)
    with atomic_write(path) as file:
        figure.savefig(file, format=ending, dpi=150)


def _draw(world: World, altitude: float) -> "Figure":
    from matplotlib.figure import Figure

    width, depth = world.shape
    aspect = min(2.0, max(0.5, depth / width))
    figure = Figure(figsize=(14.5, 2.6 + 11.6 * aspect), layout="constrained", facecolor="white")
    grid = figure.subplots(2, 2)
    _height_panel(world, grid[0, 0])
    _class_panel(world, grid[0, 1])

    binary, origin = binary_values(world)
    side = float(footprint(altitude))
    seen = box_mean(binary, side / PRIORITY_CELL)
    _priority_panel(world, grid[1, 0], binary, origin, altitude)
    grid[1, 0].set_title(f"Binary priority: {binary.mean():.0%} may be landed on (wide)")
    _priority_panel(world, grid[1, 1], seen, origin, altitude)
    grid[1, 1].set_title(f"Low-pass priority at {altitude:g} m above ground")
    _mark_footprint(world, grid[1, 1], side)

    for axes in grid.flat:
        _dress(world, axes)
    frame = world.datum.crs or "local frame"
    east, north = world.shape[0] * world.cell, world.shape[1] * world.cell
    figure.suptitle(
        f"{world.name}   \u00b7   {east:,.0f} m \u00d7 {north:,.0f} m at {world.cell:g} m   "
        f"\u00b7   {frame}, heights: {world.datum.vertical}",
        fontsize=15,
        color=_INK,
    )
    figure.supxlabel(world.attribution or " ", fontsize=9.5, color=_FAINT)
    return figure


def _height_panel(world: World, axes: "Axes") -> None:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    surface, cell = _thin(world.surface, world.cell)
    colours = LinearSegmentedColormap.from_list("height", _HEIGHT_COLOURS)
    low = float(np.quantile(world.ground, 0.01))
    scale = Normalize(low, max(low + 1.0, float(np.quantile(world.surface, 0.999))))
    rgb = colours(scale(surface))[..., :3] * sunlight(surface, cell)[..., None]
    _show(world, axes, np.clip(rgb, 0.0, 1.0))
    axes.set_title(f"Surface height, up to {world.surface.max():.0f} m")
    bar = axes.figure.colorbar(
        ScalarMappable(scale, colours), ax=axes, shrink=0.8, pad=0.015, aspect=32, extend="max"
    )
    bar.set_label(f"above the {world.datum.vertical} datum [m]", color=_INK)
    bar.outline.set_visible(False)


def _class_panel(world: World, axes: "Axes") -> None:
    from matplotlib.patches import Patch

    classes, _ = _thin(world.classes, world.cell)
    table = np.array([CLASS_COLOURS[land] for land in sorted(LandClass)]) / 255.0
    surface, cell = _thin(world.surface, world.cell)
    shade = 0.55 + 0.45 * sunlight(surface, cell)[..., None]  # a hint of relief
    _show(world, axes, np.clip(table[classes] * shade, 0.0, 1.0))
    axes.set_title("Land classes")
    share = np.bincount(world.classes.reshape(-1), minlength=len(LandClass)) / world.classes.size
    present = sorted((land for land in LandClass if share[land] > 0.0), key=lambda c: -share[c])
    handles = [
        Patch(
            facecolor=table[land],
            edgecolor="#00000040",
            label=f"{land.name.lower()}  {_percent(float(share[land]))}",
        )
        for land in present
    ]
    axes.legend(
        handles=handles,
        loc="upper left",
        bbox_to_anchor=(1.005, 1.0),
        frameon=False,
        fontsize=9.5,
        handlelength=1.2,
        handleheight=1.2,
        labelcolor=_INK,
    )


def _priority_panel(
    world: World,
    axes: "Axes",
    values: NDArray[np.float64],
    origin: tuple[float, float],
    altitude: float,
) -> None:
    from matplotlib.colors import ListedColormap
    from matplotlib.patches import Patch

    nx, ny = values.shape
    extent = (
        origin[0],
        origin[0] + nx * PRIORITY_CELL,
        origin[1],
        origin[1] + ny * PRIORITY_CELL,
    )
    image = axes.imshow(values.T, origin="lower", extent=extent, cmap="viridis", vmin=0.0, vmax=1.0)
    tall, _ = _thin(world.height_above_ground >= altitude, world.cell)
    overlay = np.ma.masked_equal(tall.astype(np.uint8), 0)
    _show(world, axes, overlay, cmap=ListedColormap([_OBSTACLE]))
    bar = axes.figure.colorbar(image, ax=axes, shrink=0.8, pad=0.015, aspect=32)
    bar.set_label("priority", color=_INK)
    bar.outline.set_visible(False)
    axes.legend(
        handles=[Patch(facecolor=_OBSTACLE, label=f"stands {altitude:g} m or more above ground")],
        loc="upper right",
        fontsize=9,
        framealpha=0.9,
        edgecolor="none",
    )


def _mark_footprint(world: World, axes: "Axes", side: float) -> None:
    """The square that the camera sees, drawn to scale in the lower right corner."""
    from matplotlib.patches import Rectangle

    x_min, y_min, x_max, y_max = world.extent
    if side > 0.4 * min(x_max - x_min, y_max - y_min):
        return
    margin = 0.03 * (x_max - x_min)
    corner = (x_max - margin - side, y_min + margin)
    axes.add_patch(Rectangle(corner, side, side, facecolor="#ffffff55", edgecolor="white", lw=1.8))
    axes.annotate(
        f"camera footprint {side:.0f} m",
        (corner[0] - 0.01 * (x_max - x_min), corner[1] + side / 2),
        ha="right",
        va="center",
        color="white",
        fontsize=9,
        bbox={"facecolor": "#00000080", "edgecolor": "none", "boxstyle": "round,pad=0.25"},
    )


def _dress(world: World, axes: "Axes") -> None:
    """Axes in metres, a scale bar, an arrow to the north."""
    x_min, y_min, x_max, y_max = world.extent
    axes.set_xlim(x_min, x_max)
    axes.set_ylim(y_min, y_max)
    axes.set_aspect("equal")
    axes.set_xlabel("east x [m]", color=_INK)
    axes.set_ylabel("north y [m]", color=_INK)
    axes.set_title(axes.get_title(), fontsize=12.5, color=_INK, loc="left")
    axes.tick_params(colors=_FAINT, labelsize=9)
    for spine in axes.spines.values():
        spine.set_color("#c9ced6")
    length = _round_length(0.2 * (x_max - x_min))
    box = {"facecolor": "#ffffffd8", "edgecolor": "none", "boxstyle": "round,pad=0.3"}
    start, level = x_min + 0.04 * (x_max - x_min), y_min + 0.035 * (y_max - y_min)
    axes.plot([start, start + length], [level, level], color="white", lw=6.0, solid_capstyle="butt")
    axes.plot([start, start + length], [level, level], color=_INK, lw=3.0, solid_capstyle="butt")
    axes.annotate(
        f"{length:g} m",
        (start + length / 2, level),
        xytext=(0, 6),
        textcoords="offset points",
        ha="center",
        fontsize=9,
        color=_INK,
        bbox=box,
    )
    axes.annotate(
        "N \u2191", (0.03, 0.965), xycoords="axes fraction", va="top", color=_INK, bbox=box
    )


def _show(world: World, axes: "Axes", values: NDArray[Any], **options: Any) -> None:
    """Draw an [ix, iy] array over the extent of the world, north up."""
    x_min, y_min, x_max, y_max = world.extent
    image = np.ma.swapaxes(values, 0, 1) if np.ma.isMaskedArray(values) else values.swapaxes(0, 1)
    axes.imshow(image, origin="lower", extent=(x_min, x_max, y_min, y_max), **options)


def _thin(values: NDArray[Any], cell: float) -> tuple[NDArray[Any], float]:
    """Every n-th cell, so that a picture of a large world stays a picture; and the new cell."""
    step = max(1, math.ceil(max(values.shape) / _MOST_PIXELS))
    return values[::step, ::step], cell * step


def _percent(share: float) -> str:
    return "< 1 %" if share < 0.005 else f"{100.0 * share:.0f} %"


def _round_length(length: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that does not exceed `length`."""
    power: float = 10.0 ** math.floor(math.log10(length))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= length * (1.0 + 1e-9))
