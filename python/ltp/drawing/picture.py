# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`world_picture`: height, land classes and both priority maps of a world on one page."""

import math
import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp.files import atomic_write
from ltp.world import CLASS_COLOURS, LandClass, World
from ltp.world.box_mean import box_mean
from ltp.world.checks import positive
from ltp.world.priority import PRIORITY_CELL, binary_values, footprint

from .maps import FAINT, INK, PRIORITY_COLOURS, draw_array, draw_bar, dress, thin
from .shading import sunlight

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_HEIGHT_COLOURS = ("#f4f2ec", "#f0dcb8", "#e3a872", "#c76a5b", "#84406b", "#3b2a5a")
_OBSTACLE = "#e0604c"


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

    panel = (5.9, 5.9 * min(2.0, max(0.5, world.shape[1] / world.shape[0])))  # [inch]
    width, height = 2 * panel[0] + 4.3, 2 * panel[1] + 2.6
    figure = Figure(figsize=(width, height), facecolor="white")
    grid = figure.subplots(2, 2)
    figure.subplots_adjust(
        left=0.8 / width,
        right=1.0 - 1.9 / width,
        bottom=0.85 / height,
        top=1.0 - 0.95 / height,
        wspace=1.6 / panel[0],
        hspace=0.8 / panel[1],
    )
    surface, cell = thin(world.surface, world.cell)
    light = sunlight(surface, cell)
    _height_panel(world, grid[0, 0], surface, light)
    _class_panel(world, grid[0, 1], light)

    binary, origin = binary_values(world)
    side = float(footprint(altitude))
    seen = box_mean(binary, side / PRIORITY_CELL)
    _priority_panel(world, grid[1, 0], binary, origin, altitude)
    _priority_panel(world, grid[1, 1], seen, origin, altitude)
    _mark_footprint(world, grid[1, 1], side)

    share = f"{binary.mean():.0%} of the map may be landed on (wide)"
    for axes, title in (
        (grid[0, 0], f"Surface height, up to {world.surface.max():.0f} m"),
        (grid[0, 1], "Land classes"),
        (grid[1, 0], f"Binary priority: {share}"),
        (grid[1, 1], f"Low-pass priority, camera {altitude:g} m above ground"),
    ):
        axes.set_title(title, fontsize=12.5, color=INK, loc="left")
        _dress_map(world, axes)
    _caption(world, figure)
    return figure


def _caption(world: World, figure: "Figure") -> None:
    """Name and frame above the panels, attribution below them."""
    width, height = figure.get_size_inches()
    x_min, y_min, x_max, y_max = world.extent
    place = world.datum.crs or "local frame"
    if world.datum.crs:
        place += f", x = 0 at {world.datum.easting:,.0f} E, y = 0 at {world.datum.northing:,.0f} N"
    facts = (
        f"{x_max - x_min:,.0f} m \u00d7 {y_max - y_min:,.0f} m at {world.cell:g} m  \u00b7  {place}"
    )
    left, top = 0.8 / width, 1.0 - 0.38 / height
    figure.text(left, top, world.name, fontsize=16, color=INK, weight="bold", va="center")
    figure.text(1.0 - 1.9 / width, top, facts, fontsize=10.5, color=FAINT, ha="right", va="center")
    figure.text(left, 0.25 / height, world.attribution, fontsize=9.5, color=FAINT, va="center")


def _height_panel(
    world: World, axes: "Axes", surface: NDArray[np.float64], light: NDArray[np.float64]
) -> None:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    colours = LinearSegmentedColormap.from_list("height", _HEIGHT_COLOURS)
    low, high = float(world.ground.min()), float(world.surface.max())
    scale = Normalize(low, max(low + 1.0, high))
    draw_array(axes, world, np.clip(colours(scale(surface))[..., :3] * light[..., None], 0.0, 1.0))
    draw_bar(axes, ScalarMappable(scale, colours), f"height [m], datum: {world.datum.vertical}")


def _class_panel(world: World, axes: "Axes", light: NDArray[np.float64]) -> None:
    from matplotlib.patches import Patch

    classes, _ = thin(world.classes, world.cell)
    table = np.array([CLASS_COLOURS[land] for land in sorted(LandClass)]) / 255.0
    shade = 0.55 + 0.45 * light[..., None]  # a hint of relief
    draw_array(axes, world, np.clip(table[classes] * shade, 0.0, 1.0))
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
        bbox_to_anchor=(1.005, 1.01),
        frameon=False,
        fontsize=9.5,
        handlelength=1.2,
        handleheight=1.2,
        labelcolor=INK,
    )


def _priority_panel(
    world: World,
    axes: "Axes",
    values: NDArray[np.float64],
    origin: tuple[float, float],
    altitude: float,
) -> None:
    from matplotlib.colors import LinearSegmentedColormap, to_rgba
    from matplotlib.patches import Patch

    (x, y), (nx, ny) = origin, values.shape
    image = axes.imshow(
        values.T,
        origin="lower",
        extent=(x, x + nx * PRIORITY_CELL, y, y + ny * PRIORITY_CELL),
        cmap=LinearSegmentedColormap.from_list("priority", PRIORITY_COLOURS),
        vmin=0.0,
        vmax=1.0,
    )
    draw_bar(axes, image, "priority")
    tall, _ = thin(world.height_above_ground >= altitude, world.cell)
    overlay = np.zeros((*tall.shape, 4))
    overlay[tall] = to_rgba(_OBSTACLE)
    draw_array(axes, world, overlay)
    axes.legend(
        handles=[Patch(facecolor=_OBSTACLE, label=f"stands {altitude:g} m or more above ground")],
        loc="upper right",
        fontsize=9,
        framealpha=0.9,
        edgecolor="none",
        labelcolor=INK,
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


def _dress_map(world: World, axes: "Axes") -> None:
    """Axes in metres, a scale bar, an arrow to the north."""
    x_min, y_min, x_max, y_max = world.extent
    dress(axes, world.extent)
    length = _round_length(0.2 * (x_max - x_min))
    box = {"facecolor": "#ffffffd8", "edgecolor": "none", "boxstyle": "round,pad=0.3"}
    start, level = x_min + 0.04 * (x_max - x_min), y_min + 0.035 * (y_max - y_min)
    axes.plot([start, start + length], [level, level], color="white", lw=6.0, solid_capstyle="butt")
    axes.plot([start, start + length], [level, level], color=INK, lw=3.0, solid_capstyle="butt")
    axes.annotate(
        f"{length:g} m",
        (start + length / 2, level),
        xytext=(0, 6),
        textcoords="offset points",
        ha="center",
        fontsize=9,
        color=INK,
        bbox=box,
    )
    axes.annotate(
        "N \u2191", (0.03, 0.965), xycoords="axes fraction", va="top", color=INK, bbox=box
    )


def _percent(share: float) -> str:
    return "< 1 %" if share < 0.005 else f"{100.0 * share:.0f} %"


def _round_length(length: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that does not exceed `length`."""
    power: float = 10.0 ** math.floor(math.log10(length))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= length * (1.0 + 1e-9))
