# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from a classified airborne laser survey (LAS or LAZ)."""

import math
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import las_header
from .archive import MAX_CELLS
from .classes import LandClass
from .fill import fill_linear, grow, wide_gaps
from .geotiff import HEIGHTS, OBJECT_HEIGHT
from .metric_crs import crs_name, metric_crs
from .optional import require
from .world import Datum, World

#: Unclassified returns higher than this above the ground are obstacles: cars, wires, masts [m].
CLUTTER_HEIGHT = 0.5

# ASPRS classes (LAS 1.4 R15, tables 9 and 10), and those of the French national survey from 64 on.
_GROUND = (2, 8, 9, 10, 11)  # ground, its key points, water, rail, road surface
_KINDS = {9: LandClass.WATER, 10: LandClass.RAIL, 11: LandClass.ROAD}
_VEGETATION = (3, 4, 5)
_STRUCTURES = (6, 13, 14, 15, 16, 17, 64)  # buildings, wires, masts, bridges, permanent objects
_CLUTTER = (0, 1, 19, 20, 21, 22)  # never classified, unclassified, overhead, ignored, snow, ...
_DROPPED = (7, 12, 18, 65, 66, 67)  # noise, overlap, high noise, artefacts, virtual points, other

_CHUNK = 1_000_000  # points in memory at a time
_CELLS_PER_POINT = 100  # with more, the extent in the header is a lie, or the cell a slip

Bounds = tuple[float, float, float, float]


def read(
    path: str | os.PathLike[str],
    *,
    cell: float = 2.0,
    bounds: Bounds | None = None,
    max_gap: float = 8.0,
    crs: str | None = None,
    name: str = "",
    attribution: str = "",
    vertical: str = "as in the survey",
) -> World:
    """Read a world from a survey whose returns have ASPRS classes.

    Args:
        path: a .las or .laz file in a metric CRS.
        cell: cell size of the world [m]; best not much below the spacing of the returns.
        bounds: x_min, y_min, x_max, y_max in the CRS, to cut a piece out [m]; default: the extent
            in the file's header. The world starts at whole multiples of `cell`.
        max_gap: gaps without any return that are wider than this are most likely water:
            interpolated, but UNKNOWN, so that nobody lands there [m].
        crs: the CRS, where the file does not say.
        name: name of the world; default: the file name.
        attribution: the line that must stand beside every picture.
        vertical: name of the height datum.

    Returns:
        A world whose ground is the mean of the ground returns per cell, interpolated where there is
        none; whose surface is the highest return of a building, bridge, tree or other object in
        the cell. Narrower gaps take after the cells around them, so that roofs have no holes. Cells
        with something unclassified on them are UNKNOWN; low plants stand on open ground.

    Raises:
        ImportError: if laspy with lazrs is not installed.
        ValueError: naming the file and what is wrong with it, or the argument.
        OSError: if the file cannot be opened.
    """
    path = Path(path)
    for what, value in (("cell", cell), ("max_gap", max_gap)):
        if not (math.isfinite(value) and value > 0.0):
            raise ValueError(f"{what} must be above zero, not {value!r}")
    if not path.is_file():
        raise FileNotFoundError(f"{path} is not a file")
    las_header.check_complete(path)
    laspy = require("laspy", "reading LAS and LAZ")
    require("lazrs", "reading LAS and LAZ")
    header, chunks = _open(laspy, path)
    lattice = _Lattice.around(path, header, cell, bounds)
    layers = _Layers(lattice)
    for chunk in chunks:
        layers.add(path, chunk, cropped=bounds is not None)
    if np.isnan(layers.ground()).all():
        raise ValueError(f"{path} has no ground return (class 2) within the bounds")

    ground, surface, classes = _interpret(layers, max_gap)
    return World(
        name=name or path.stem,
        ground=ground,
        surface=surface,
        classes=classes,
        cell=cell,
        datum=Datum(_crs(path, header, crs), lattice.xmin, lattice.ymin, vertical),
        attribution=attribution,
    )


def _interpret(
    layers: "_Layers", max_gap: float
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.uint8]]:
    """Ground, surface and classes from what was returned in each cell."""
    seen = layers.seen
    gaps = wide_gaps(~seen, max_gap / layers.lattice.cell)
    ground = fill_linear(layers.ground())

    crowns = layers.vegetation - ground
    clutter = layers.clutter - ground
    structure = layers.structure > ground
    clutter[clutter <= CLUTTER_HEIGHT] = -np.inf
    height = np.maximum.reduce([np.zeros_like(ground), crowns, clutter, layers.structure - ground])

    classes = np.full(ground.shape, LandClass.GROUND, dtype=np.uint8)
    for kind, where in layers.kinds.items():
        classes[where] = kind
    classes[clutter > CLUTTER_HEIGHT] = LandClass.UNKNOWN
    classes[crowns > OBJECT_HEIGHT] = LandClass.TREES
    classes[structure] = LandClass.BUILDING

    classes[~seen] = LandClass.UNKNOWN
    solid = (LandClass.BUILDING, LandClass.TREES)
    classes, height = grow(classes, height, seen, ~seen & ~gaps, solid)
    return ground, ground + height, classes


def _open(laspy: Any, path: Path) -> tuple[Any, Iterator[Any]]:
    """The header of a survey, and its points chunk by chunk."""
    try:
        # Extended records may declare any size; the points do not need them.
        reader = laspy.open(path, laz_backend=laspy.LazBackend.Lazrs, read_evlrs=False)
    except Exception as error:
        raise _unsound(path, error) from error
    return reader.header, _chunks(path, reader)


def _chunks(path: Path, reader: Any) -> Iterator[Any]:
    expected = reader.header.point_count
    got = 0
    with reader:
        while got < expected:
            try:
                points = reader.read_points(min(_CHUNK, expected - got))
            except (KeyboardInterrupt, SystemExit):
                raise
            except BaseException as error:  # a panic in the decoder is no Exception
                raise _unsound(path, error) from error
            if len(points) == 0:
                raise ValueError(f"{path} ends early: {got} of {expected} points are there")
            got += len(points)
            yield points


def _unsound(path: Path, error: BaseException) -> ValueError:
    return ValueError(f"{path} cannot be read as LAS or LAZ: {error}")


def _crs(path: Path, header: Any, given: str | None) -> str | None:
    if given is not None:
        return crs_name(metric_crs(given, "crs"))
    pyproj = require("pyproj", "working with map coordinates")
    try:
        found = header.parse_crs()
    except pyproj.exceptions.CRSError as error:
        raise ValueError(f"{path} has a CRS that nobody knows: {error}; give crs") from error
    return None if found is None else crs_name(metric_crs(found, f"the CRS of {path}"))


@dataclass(frozen=True)
class _Lattice:
    """The cells of the world in the CRS of the survey."""

    xmin: float
    ymin: float
    cell: float
    shape: tuple[int, int]

    @staticmethod
    def around(path: Path, header: Any, cell: float, bounds: Bounds | None) -> "_Lattice":
        if bounds is None:
            (x0, y0), (x1, y1) = header.mins[:2], header.maxs[:2]
            source = f"{path}: the extent in the header"
        else:
            x0, y0, x1, y1 = bounds
            source = "bounds"
        if not (np.isfinite([x0, y0, x1, y1]).all() and x0 <= x1 and y0 <= y1):
            raise ValueError(f"{source} must be x_min, y_min, x_max, y_max, not {(x0, y0, x1, y1)}")
        if bounds is not None and (x0 == x1 or y0 == y1):
            raise ValueError(f"bounds must span an area, not {bounds}")
        i0, j0 = math.floor(x0 / cell), math.floor(y0 / cell)
        if bounds is None:  # a return on the northern rim needs a cell
            nx, ny = math.floor(x1 / cell) - i0 + 1, math.floor(y1 / cell) - j0 + 1
        else:
            nx, ny = math.ceil(x1 / cell) - i0, math.ceil(y1 / cell) - j0
        n_points = int(header.point_count)
        most = MAX_CELLS if bounds is not None else min(MAX_CELLS, _CELLS_PER_POINT * n_points)
        if nx * ny > most:
            raise ValueError(
                f"{source} needs {nx} x {ny} cells of {cell:g} m, more than {most:,} for "
                f"{n_points:,} returns"
            )
        return _Lattice(i0 * cell, j0 * cell, cell, (nx, ny))


class _Layers:
    """What the returns of a survey say about each cell, gathered chunk by chunk."""

    def __init__(self, lattice: _Lattice) -> None:
        self.lattice = lattice
        n = lattice.shape[0] * lattice.shape[1]
        self._sum, self._count = np.zeros(n), np.zeros(n)
        self._seen = np.zeros(n, dtype=bool)
        self._tops = {group: np.full(n, -np.inf) for group in (_VEGETATION, _STRUCTURES, _CLUTTER)}
        self._kinds = {kind: np.zeros(n, dtype=bool) for kind in _KINDS.values()}

    def add(self, path: Path, points: Any, *, cropped: bool) -> None:
        """Take in one chunk of returns; those outside the lattice only if it was cut out."""
        lattice = self.lattice
        x, y, z = (np.asarray(axis) for axis in (points.x, points.y, points.z))
        kind = np.asarray(points.classification)
        keep = ~np.isin(kind, _DROPPED) & ~np.asarray(points.withheld, dtype=bool)
        keep &= (z >= HEIGHTS[0]) & (z <= HEIGHTS[1])
        i = np.floor((x - lattice.xmin) / lattice.cell)
        j = np.floor((y - lattice.ymin) / lattice.cell)
        inside = (i >= 0) & (i < lattice.shape[0]) & (j >= 0) & (j < lattice.shape[1])
        if not cropped and not inside[keep].all():
            where = np.flatnonzero(keep & ~inside)[0]
            raise ValueError(
                f"{path} has a return at ({x[where]:.2f}, {y[where]:.2f}), outside of the extent "
                "in its header"
            )
        keep &= inside
        at = i[keep].astype(np.intp) * lattice.shape[1] + j[keep].astype(np.intp)
        kind, z = kind[keep], z[keep]

        self._seen[at] = True
        is_ground = np.isin(kind, _GROUND)
        n = self._seen.size
        self._count += np.bincount(at[is_ground], minlength=n)
        self._sum += np.bincount(at[is_ground], weights=z[is_ground], minlength=n)
        known = {*_GROUND, *_VEGETATION, *_STRUCTURES}
        for group, top in self._tops.items():
            # A class that nobody knows is an obstacle as well.
            of = ~np.isin(kind, list(known)) if group is _CLUTTER else np.isin(kind, group)
            np.maximum.at(top, at[of], z[of])
        for code, land in _KINDS.items():
            self._kinds[land][at[kind == code]] = True

    def _shaped(self, flat: NDArray[Any]) -> NDArray[Any]:
        return flat.reshape(self.lattice.shape)

    def ground(self) -> NDArray[np.float64]:
        """(nx, ny) mean height of the ground returns [m], NaN where there is none."""
        with np.errstate(invalid="ignore"):
            return self._shaped(self._sum / self._count)

    @property
    def seen(self) -> NDArray[np.bool_]:
        """(nx, ny) whether any return came from the cell."""
        return self._shaped(self._seen)

    @property
    def vegetation(self) -> NDArray[np.float64]:
        """(nx, ny) highest return of a plant [m], -inf where there is none."""
        return self._shaped(self._tops[_VEGETATION])

    @property
    def structure(self) -> NDArray[np.float64]:
        """(nx, ny) highest return of a building, bridge or other lasting object [m], or -inf."""
        return self._shaped(self._tops[_STRUCTURES])

    @property
    def clutter(self) -> NDArray[np.float64]:
        """(nx, ny) highest unclassified return [m], -inf where there is none."""
        return self._shaped(self._tops[_CLUTTER])

    @property
    def kinds(self) -> dict[LandClass, NDArray[np.bool_]]:
        """Where the survey says what the ground is, by class."""
        return {kind: self._shaped(where) for kind, where in self._kinds.items()}
