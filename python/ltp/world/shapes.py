# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Boxes, cylinders and prisms that stand on flat ground, and the cells that they fill."""

from collections.abc import Iterable, Sequence
from dataclasses import KW_ONLY, dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .checks import finite, positive
from .classes import LandClass, land_class

_SLACK = 1e-9  # cells: what reaches no farther into a cell only touches it
_MOST_CELLS = 100_000_000

Extent = tuple[float, float, float, float]


@dataclass(frozen=True)
class Box:
    """An upright box along the axes.

    Raises:
        ValueError: naming the field that is out of range.
    """

    x_min: float  # [m]
    y_min: float  # [m]
    x_max: float  # [m]
    y_max: float  # [m]
    height: float  # above the ground [m]
    _: KW_ONLY
    kind: LandClass | str = LandClass.BUILDING  # what it is

    def __post_init__(self) -> None:
        _check(self, "x_min", "y_min", "x_max", "y_max")
        for low, high in (("x_min", "x_max"), ("y_min", "y_max")):
            if not getattr(self, low) < getattr(self, high):
                raise ValueError(
                    f"Box.{high} must be above {low} = {getattr(self, low)!r} [m], "
                    f"not {getattr(self, high)!r}"
                )

    @property
    def extent(self) -> Extent:
        """(x_min, y_min, x_max, y_max) [m]."""
        return self.x_min, self.y_min, self.x_max, self.y_max

    def fills(
        self, x: NDArray[np.float64], y: NDArray[np.float64], half: float
    ) -> NDArray[np.bool_]:
        """Which of the squares round (x, y), of half an edge `half` [m], it reaches into."""
        reach = half - 2.0 * half * _SLACK
        along_x = (x > self.x_min - reach) & (x < self.x_max + reach)
        return np.asarray(along_x & (y > self.y_min - reach) & (y < self.y_max + reach))


@dataclass(frozen=True)
class Cylinder:
    """An upright cylinder.

    Raises:
        ValueError: naming the field that is out of range.
    """

    x: float  # of its axis [m]
    y: float  # [m]
    radius: float  # [m]
    height: float  # above the ground [m]
    _: KW_ONLY
    kind: LandClass | str = LandClass.BUILDING  # what it is

    def __post_init__(self) -> None:
        _check(self, "x", "y")
        object.__setattr__(self, "radius", positive("Cylinder.radius", self.radius))

    @property
    def extent(self) -> Extent:
        """(x_min, y_min, x_max, y_max) [m]."""
        r = self.radius
        return self.x - r, self.y - r, self.x + r, self.y + r

    def fills(
        self, x: NDArray[np.float64], y: NDArray[np.float64], half: float
    ) -> NDArray[np.bool_]:
        """Which of the squares round (x, y), of half an edge `half` [m], it reaches into."""
        beside = np.maximum(np.abs(x - self.x) - half, 0.0)
        before = np.maximum(np.abs(y - self.y) - half, 0.0)
        return np.asarray(np.hypot(beside, before) < self.radius - 2.0 * half * _SLACK)


@dataclass(frozen=True)
class Prism:
    """Upright walls over a polygon, whose sides must not cross.

    Raises:
        ValueError: naming the field that is out of range.
    """

    corners: Sequence[tuple[float, float]]  # (x, y) of three or more, either way round [m]
    height: float  # above the ground [m]
    _: KW_ONLY
    kind: LandClass | str = LandClass.BUILDING  # what it is

    def __post_init__(self) -> None:
        _check(self)
        try:
            corners = np.array([(float(x), float(y)) for x, y in self.corners])
        except (TypeError, ValueError) as error:
            raise ValueError(f"Prism.corners must be points (x, y) [m]: {error}") from error
        if len(corners) < 3 or not np.isfinite(corners).all():
            raise ValueError(
                f"Prism.corners must be three points (x, y) or more, finite [m], "
                f"not {self.corners!r}"
            )
        x, y = (corners - corners[0]).T
        if abs(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1))) == 0.0:
            raise ValueError(f"Prism.corners must enclose an area, not {self.corners!r}")
        object.__setattr__(self, "corners", tuple((x, y) for x, y in corners.tolist()))

    @property
    def extent(self) -> Extent:
        """(x_min, y_min, x_max, y_max) [m]."""
        (x_min, y_min), (x_max, y_max) = (f(self.corners, axis=0) for f in (np.min, np.max))
        return float(x_min), float(y_min), float(x_max), float(y_max)

    def fills(
        self, x: NDArray[np.float64], y: NDArray[np.float64], half: float
    ) -> NDArray[np.bool_]:
        """Which of the squares round (x, y), of half an edge `half` [m], it reaches into."""
        reach = half - 2.0 * half * _SLACK
        inside = np.zeros(np.broadcast_shapes(x.shape, y.shape), dtype=bool)
        crossed = inside.copy()
        for (ax, ay), (bx, by) in zip(
            self.corners, (*self.corners[1:], self.corners[0]), strict=True
        ):
            dx, dy = bx - ax, by - ay
            if dy != 0.0:  # a ray to the east from the middle: even-odd rule
                beyond = x < ax + (y - ay) / dy * dx
                inside ^= ((ay > y) != (by > y)) & beyond
            # The side and the square are apart along x, along y, or across the side; or they meet.
            along_x = (x + reach > min(ax, bx)) & (x - reach < max(ax, bx))
            along_y = (y + reach > min(ay, by)) & (y - reach < max(ay, by))
            across = np.abs(dx * (y - ay) - dy * (x - ax)) < reach * (abs(dx) + abs(dy))
            crossed |= along_x & along_y & across
        return inside | crossed


Shape = Box | Cylinder | Prism


class Raised(NamedTuple):
    """Shapes on flat ground as rasters."""

    ground: NDArray[np.float64]  # (nx, ny) [m]
    surface: NDArray[np.float64]  # (nx, ny) [m]
    classes: NDArray[np.uint8]  # (nx, ny) LandClass
    cell: float  # [m]
    origin: tuple[float, float]  # [m]


def checked(shapes: Iterable[Shape]) -> list[Shape]:
    """Return shapes as a list; demand that they are."""
    found = list(shapes)
    for index, shape in enumerate(found):
        if not isinstance(shape, Box | Cylinder | Prism):
            raise ValueError(f"shapes[{index}] must be a Box, Cylinder or Prism, not {shape!r}")
    return found


def raise_shapes(
    shapes: Sequence[Shape],
    extent: Extent,
    cell: float,
    ground: float,
    land: LandClass | str,
) -> Raised:
    """Stand shapes on flat ground. See `World.from_shapes`.

    Raises:
        ValueError: naming the argument or the shape that is wrong.
    """
    edge, level, cover = positive("cell", cell), finite("ground", ground), land_class(land)
    try:
        x_min, y_min, x_max, y_max = (finite("extent", value) for value in extent)
        is_box = x_min < x_max and y_min < y_max
    except (TypeError, ValueError):
        is_box = False
    if not is_box:
        raise ValueError(f"extent must be (x_min, y_min, x_max, y_max) [m], not {extent!r}")
    across, up = (x_max - x_min) / edge, (y_max - y_min) / edge
    if across * up > _MOST_CELLS:
        raise ValueError(f"extent must hold at most {_MOST_CELLS:,} cells of {edge:g} m")
    size = tuple(max(1, int(np.ceil(length - 1e-6))) for length in (across, up))
    x, y = (
        np.asarray(low + (np.arange(length) + 0.5) * edge, dtype=np.float64)
        for low, length in zip((x_min, y_min), size, strict=True)
    )
    above = np.zeros(size)
    classes = np.full(size, cover, dtype=np.uint8)
    for index, shape in enumerate(shapes):
        west, south, east, north = shape.extent
        i = slice(*np.searchsorted(x, (west - edge, east + edge)))
        j = slice(*np.searchsorted(y, (south - edge, north + edge)))
        filled = shape.fills(x[i, None], y[None, j], edge / 2.0)
        if not filled.any():
            raise ValueError(
                f"shapes[{index}] = {shape!r} lies off the world, x = {x_min:g} ... {x_max:g} m, "
                f"y = {y_min:g} ... {y_max:g} m"
            )
        taller = filled & (shape.height > above[i, j])
        above[i, j][taller] = shape.height
        classes[i, j][taller] = land_class(shape.kind)
    flat = np.full(size, level)
    return Raised(flat, flat + above, classes, edge, (x_min, y_min))


def extent_of(shapes: Sequence[Shape], margin: float, cell: float) -> Extent:
    """The box round all shapes and a margin [m], on whole cells.

    Raises:
        ValueError: if there is no shape.
    """
    if not shapes:
        raise ValueError("shapes must not be empty where no size or extent is given")
    corners = np.array([shape.extent for shape in shapes])
    low = np.floor((corners[:, :2].min(axis=0) - margin) / cell) * cell
    high = np.ceil((corners[:, 2:].max(axis=0) + margin) / cell) * cell
    return float(low[0]), float(low[1]), float(high[0]), float(high[1])


def _check(shape: Shape, *coordinates: str) -> None:
    """Check the fields that shapes have in common; coordinates become floats."""
    kind = type(shape).__name__
    for name in coordinates:
        object.__setattr__(shape, name, finite(f"{kind}.{name}", getattr(shape, name)))
    object.__setattr__(shape, "height", positive(f"{kind}.height", shape.height))
    try:
        object.__setattr__(shape, "kind", land_class(shape.kind))
    except ValueError as error:
        raise ValueError(f"{kind}.kind: {error}") from error
