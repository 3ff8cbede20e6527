# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What all figures of flights share: page, backdrops, lines that stay legible, attribution."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.drawing.maps import FAINT as FAINT
from ltp.drawing.maps import INK as INK
from ltp.drawing.maps import PRIORITY_COLOURS, Box, draw_bar, thin
from ltp.drawing.maps import draw_array as draw_array
from ltp.drawing.maps import dress as dress
from ltp.drawing.maps import plain_axes as plain_axes
from ltp.drawing.shading import sunlight
from ltp.files import atomic_write
from ltp.world import World

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

    from ltp._core import Raster

GLOBAL_PATH = "#00c8e6"  # cyan, as in the paper
START = "#e0213a"  # the paper's red point
HEIGHT_COLOURS = ("#f6f5f1", "#dcdcd9", "#b4b8bd", "#858b97", "#585e70", "#2f3448")

TALL = "#7a1020"  # outlines of what reaches the flight altitude

_LETTER = 0.0092  # width of a letter for each point of its size, bold [inch]
_RIM_STEP, _MOST_RIMS = 2.6, 4  # [points]
_FORMATS = ("png", "pdf", "svg")
_LEFT, _RIGHT, _BOTTOM, _TOP = 0.75, 0.35, 0.95, 0.95  # margins of a page [inch]


def make_page(
    world: World,
    panels: int,
    title: str,
    subtitle: str = "",
    *,
    gap: float = 1.5,
    size: float = 5.6,
    view: Box | None = None,
    bars: bool = True,
    below: float = 0.0,
) -> tuple["Figure", list["Axes"]]:
    """A figure with map panels in a row, a title above and the world's attribution below.

    Args:
        world: gives the shape of the panels and the attribution.
        panels: how many.
        title: bold, on the left.
        subtitle: small, below the title.
        gap: beside each panel, for colour bars; without them only between panels [inch].
        size: width of a panel [inch].
        view: the part of the world that is shown; default: all.
        bars: whether the panels have colour bars.
        below: room left free between the panels and the attribution [inch].
    """
    from matplotlib.figure import Figure

    x_min, y_min, x_max, y_max = view or world.extent
    tall = size * min(1.6, max(0.5, (y_max - y_min) / (x_max - x_min)))
    right = _RIGHT + (gap if bars else 0.0)
    width = _LEFT + panels * size + (panels - 1) * gap + right
    height = _BOTTOM + below + tall + _TOP
    figure = Figure(figsize=(width, height), facecolor="white")
    axes = figure.subplots(1, panels, squeeze=False)[0]
    figure.subplots_adjust(
        left=_LEFT / width,
        right=1.0 - right / width,
        bottom=(_BOTTOM + below) / height,
        top=1.0 - _TOP / height,
        wspace=gap / size,
    )
    caption(figure, title, subtitle, world.attribution)
    return figure, list(axes)


def view_round(path: ArrayLike, world: World, margin: float, aspect: float = 1.5) -> Box:
    """The part of the world round a path (n, 3), no flatter than `aspect` times its height.

    Args:
        path: to be shown [m].
        world: to stay inside of, where it is large enough.
        margin: shown round the path [m].
        aspect: width over height of the part.
    """
    xy = np.asarray(path)[:, :2]
    half = (xy.max(axis=0) - xy.min(axis=0)) / 2.0 + margin
    half = np.maximum(half, (half[1] * aspect, half[0] / aspect))
    extent = np.array(world.extent).reshape(2, 2)
    half = np.minimum(half, (extent[1] - extent[0]) / 2.0)
    middle = (xy.max(axis=0) + xy.min(axis=0)) / 2.0
    middle = np.clip(middle, extent[0] + half, extent[1] - half)
    (x_min, y_min), (x_max, y_max) = middle - half, middle + half
    return float(x_min), float(y_min), float(x_max), float(y_max)


def caption(figure: "Figure", title: str, subtitle: str, attribution: str) -> None:
    """Title and subtitle at the top left, attribution at the bottom left."""
    width, height = figure.get_size_inches()
    left = _LEFT / width
    room = width - _LEFT - 0.1
    bold: dict[str, Any] = {"weight": "bold", "color": INK}
    texts = (
        (title, height - 0.28, 14.0, bold),
        (subtitle, height - 0.53, 10.0, {"color": FAINT}),
        (attribution, 0.2, 8.5, {"color": FAINT}),
    )
    for text, level, size, style in texts:
        fitting = min(size, room / (_LETTER * max(1, len(text))))
        figure.text(left, level / height, text, size=fitting, va="center", **style)


def save_figure(figure: "Figure", path: str | os.PathLike[str]) -> None:
    """Write a figure, all or nothing; the same figure gives the same bytes.

    Raises:
        ValueError: if `path` does not end in .png, .pdf or .svg.
        OSError: if the file cannot be written.
    """
    ending = Path(path).suffix.lower().removeprefix(".")
    if ending not in _FORMATS:
        raise ValueError(f"a figure's file must end in .png, .pdf or .svg, not {os.fspath(path)!r}")
    dated = {"png": {}, "pdf": {"CreationDate": None}, "svg": {"Date": None}}[ending]
    with atomic_write(path) as file:
        figure.savefig(file, format=ending, dpi=150, metadata=dated)


def draw_heights(axes: "Axes", world: World, bar: bool = True) -> None:
    """The obstacle surface from above, in greys, under a low sun."""
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import LinearSegmentedColormap, Normalize

    surface, cell = thin(world.surface, world.cell)
    colours = LinearSegmentedColormap.from_list("height", HEIGHT_COLOURS)
    low, high = float(world.ground.min()), float(world.surface.max())
    # Half the colours for the lowest third: most roofs are far below the highest.
    scale = Normalize(0.0, 1.0)
    share = np.clip((surface - low) / max(1.0, high - low), 0.0, 1.0)
    light = 0.35 + 0.65 * sunlight(surface, cell)[..., None]
    draw_array(axes, world, np.clip(colours(scale(np.sqrt(share)))[..., :3] * light, 0.0, 1.0))
    if bar:
        from matplotlib.colors import PowerNorm

        mapped = ScalarMappable(PowerNorm(0.5, low, max(low + 1.0, high)), colours)
        draw_bar(axes, mapped, "surface height [m]")
    dress(axes, world.extent)


def draw_priority(axes: "Axes", world: World, priority: "Raster", bar: bool = True) -> None:
    """A priority map, 0 dark to 1 light."""
    from matplotlib.colors import LinearSegmentedColormap

    values = priority.values
    (x, y), (nx, ny) = priority.origin, values.shape
    image = axes.imshow(
        values.T,
        origin="lower",
        extent=(x, x + nx * priority.cell, y, y + ny * priority.cell),
        cmap=LinearSegmentedColormap.from_list("priority", PRIORITY_COLOURS),
        vmin=0.0,
        vmax=1.0,
    )
    if bar:
        draw_bar(axes, image, "priority")
    dress(axes, world.extent)


def draw_path(
    axes: "Axes",
    path: ArrayLike,
    colour: str,
    label: str = "",
    width: float = 2.0,
    rim: float = 1.0,
    **style: Any,
) -> None:
    """A path (n, 3) from above, with a dark and a light rim that keep it legible anywhere."""
    from matplotlib.patheffects import Normal, Stroke

    xy = np.asarray(path)[:, :2]
    rims = [
        Stroke(linewidth=width + 2.2 * rim, foreground="#ffffffb0"),
        Stroke(linewidth=width + rim, foreground="#1a1d22"),
        Normal(),
    ]
    style = {"zorder": 4, "solid_capstyle": "round", **style}
    axes.plot(*xy.T, color=colour, lw=width, label=label, path_effects=rims, **style)


def draw_global_path(axes: "Axes", path: ArrayLike, label: str = "global path") -> None:
    """Dotted cyan with a red start, as in the paper."""
    dots: dict[str, Any] = {"linestyle": (0, (0.1, 1.9)), "dash_capstyle": "round", "zorder": 3}
    draw_path(axes, path, GLOBAL_PATH, label, 2.6, **dots)
    draw_start(axes, np.asarray(path)[:1])


def nested_widths(paths: Sequence[ArrayLike], width: float) -> list[float]:
    """Line widths for paths (n, 3) drawn in order, wider where later ones lie on top.

    A path that others cover for more than half its way shows as a rim round them.
    """
    tiles = [_tiles(np.asarray(path)[:, :2]) for path in paths]
    covers = [_around(tile) for tile in tiles]
    widths = []
    for index, tile in enumerate(tiles):
        above = sum(len(tile & cover) > 0.5 * len(tile) for cover in covers[index + 1 :])
        widths.append(width + _RIM_STEP * min(above, _MOST_RIMS))
    return widths


def _tiles(xy: NDArray[np.float64]) -> set[tuple[int, int]]:
    """The squares of 2 m that a densely sampled path passes."""
    return set(map(tuple, np.floor(xy / 2.0).astype(int).tolist()))


def _around(tiles: set[tuple[int, int]]) -> set[tuple[int, int]]:
    return {(i + di, j + dj) for i, j in tiles for di in (-1, 0, 1) for dj in (-1, 0, 1)}


def draw_tall(axes: "Axes", world: World, altitude: float) -> None:
    """Outlines of all that reaches an altitude above the datum [m]."""
    tall, cell = thin(world.surface >= altitude, world.cell)
    if not tall.any() or tall.all():
        return
    x, y = (o + cell * (np.arange(n) + 0.5) for o, n in zip(world.origin, tall.shape, strict=True))
    axes.contour(x, y, tall.T, levels=[0.5], colors=TALL, linewidths=0.9, zorder=2.7)
    axes.plot([], [], color=TALL, lw=0.9, label=f"reaches the flight altitude, {altitude:.0f} m")


def draw_start(axes: "Axes", points: NDArray[np.float64], size: float = 55.0) -> None:
    """Red dots (n, 3)."""
    axes.scatter(
        points[:, 0], points[:, 1], s=size, color=START, edgecolor="white", lw=1.0, zorder=6
    )


def draw_legend(axes: "Axes", **options: Any) -> None:
    """A legend that hides little."""
    style = {"loc": "upper right", "fontsize": 9, "framealpha": 0.92, "edgecolor": "none"}
    axes.legend(**(style | {"labelcolor": INK, "handlelength": 2.6} | options)).set_zorder(9)


def quiet_corner(box: Box, points: ArrayLike) -> str:
    """The corner of a view in which the fewest of the points (n, 2...) lie, for a legend."""
    xy = np.asarray(points)[:, :2]
    low, high = np.array(box[:2]), np.array(box[2:])
    share = (xy - low) / (high - low)
    corners = {"upper right": (1, 1), "upper left": (0, 1), "lower right": (1, 0)}
    corners |= {"lower left": (0, 0)}
    reach = np.array([0.5, 0.45])
    busy = {
        name: int(np.all(np.abs(share - corner) < reach, axis=1).sum())
        for name, corner in corners.items()
    }
    return min(busy, key=lambda name: busy[name])


def panel_title(axes: "Axes", text: str) -> None:
    """Above a panel, on the left."""
    axes.set_title(text, size=11.5, color=INK, loc="left")
