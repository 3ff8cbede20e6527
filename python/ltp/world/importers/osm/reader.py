# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from an OpenStreetMap extract: buildings, roads, water and parks on flat ground."""

import math
import os
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.archive import MAX_CELLS
from ltp.world.classes import LandClass
from ltp.world.crs import crs_name, metric_crs
from ltp.world.world import Datum, World

from ..optional import require
from . import tags
from .buildings import blocks
from .coast import sea
from .cover import area_cover, line_cover
from .shapes import Box, Shapes, read_shapes

#: The licence (ODbL 1.0) asks for this line beside every picture.
ATTRIBUTION = "(c) OpenStreetMap contributors, ODbL 1.0, https://www.openstreetmap.org/copyright"

_PURPOSE = "reading OpenStreetMap files"
_MARGIN = 100.0  # half of the widest road, and more: what lies outside but reaches in [m]
# Lines lie on top of areas, in this order: a crossing belongs to the road.
_LINE_ORDER = (
    LandClass.WATER,
    LandClass.RAIL,
    LandClass.PATH,
    LandClass.UNKNOWN,
    LandClass.ROAD,
)


def read(
    path: str | os.PathLike[str],
    *,
    bounds: Box,
    crs: str,
    cell: float = 1.0,
    default_height: float = 10.0,
    name: str = "",
    attribution: str = ATTRIBUTION,
) -> World:
    """Read a world from an OpenStreetMap extract, .osm.pbf or .osm.

    Args:
        path: the file; its ways must come with their nodes, its multipolygons with their ways.
        bounds: x_min, y_min, x_max, y_max in `crs`, a whole number of cells apart [m].
        crs: a projected CRS in metres, e.g. "EPSG:32618".
        cell: cell size of the world [m].
        default_height: height of a building without any tag that tells it [m].
        name: name of the world; default: the file name.
        attribution: the line that must stand beside every picture.

    Returns:
        A world on flat ground, z = 0. The surface is the top of buildings, trees and towers, solid
        down to the ground. A cell belongs to what covers its centre; of areas the smallest lies on
        top, then rails, paths and roads, then trees, then buildings. Unmapped ground is UNKNOWN.

    Raises:
        ImportError: if osmium, pyproj, rasterio or shapely are not installed.
        ValueError: naming the file or argument and what is wrong with it.
        OSError: if the file cannot be opened.
    """
    path = Path(path)
    if not (math.isfinite(default_height) and default_height > 0.0):
        raise ValueError(f"default_height must be above zero, not {default_height!r}")
    canvas = _Canvas.over(bounds, cell)
    projection = metric_crs(crs, "crs")
    shapes = read_shapes(path, projection, _geographic(projection, bounds))
    _paint_cover(canvas, shapes)
    _paint_heights(canvas, shapes, default_height)
    return World(
        name=name or path.name.removesuffix(".pbf").removesuffix(".osm"),
        ground=np.zeros(canvas.shape),
        surface=canvas.surface,
        classes=canvas.classes,
        cell=cell,
        datum=Datum(crs_name(projection), float(bounds[0]), float(bounds[1]), "flat ground"),
        attribution=attribution,
    )


def _paint_cover(canvas: "_Canvas", shapes: Shapes) -> None:
    """What lies on the ground."""
    shapely = require("shapely", _PURPOSE)
    coast = [s.geometry for s in shapes.lines if s.tags.get("natural") == "coastline"]
    canvas.paint([(area, LandClass.WATER) for area in sea(coast, canvas.box)])

    areas = [(shape, area_cover(shape.tags)) for shape in shapes.areas]
    covers = [(s, kind) for s, kind in areas if kind is not None and kind != LandClass.TREES]
    covers.sort(key=lambda item: (-item[0].geometry.area, item[0].key))
    canvas.paint([(shape.geometry, kind) for shape, kind in covers])

    lines = [(shape, line_cover(shape.tags)) for shape in shapes.lines]
    for wanted in _LINE_ORDER:
        chosen = [(s.geometry, c[1]) for s, c in lines if c is not None and c[0] == wanted]
        half_widths = [width / 2 for _, width in chosen]
        strips = shapely.buffer([line for line, _ in chosen], half_widths, quad_segs=4)
        canvas.paint([(strip, wanted) for strip in strips])


def _paint_heights(canvas: "_Canvas", shapes: Shapes, default_height: float) -> None:
    """What stands on the ground, trees first."""
    trees = [
        (shape.geometry, tags.wood_height(shape.tags))
        for shape in shapes.areas
        if area_cover(shape.tags) == LandClass.TREES
    ]
    for shape in (*shapes.points, *shapes.lines):
        if (size := tags.tree(shape.tags)) is not None:
            trees.append((shape.geometry.buffer(size[1] / 2), size[0]))
    canvas.raise_to(trees, LandClass.TREES)
    canvas.raise_to(blocks(shapes.areas, default_height), LandClass.BUILDING)
    canvas.raise_to(_tall_objects(shapes), LandClass.BUILDING, every_touched_cell=True)


def _tall_objects(shapes: Shapes) -> list[tuple[Any, float]]:
    found = []
    for shape in (*shapes.points, *shapes.areas):
        size = None if tags.building(shape.tags) else tags.tall(shape.tags)
        if size is not None:
            is_point = shape.geometry.geom_type == "Point"
            area = shape.geometry.buffer(size[1] / 2) if is_point else shape.geometry
            found.append((area, size[0]))
    return found


@dataclass(frozen=True)
class _Canvas:
    """The rasters of the world while they are painted, [x, y]."""

    bounds: Box
    cell: float
    box: Any  # the bounds as a shapely polygon
    surface: NDArray[np.float64]
    classes: NDArray[np.uint8]

    @staticmethod
    def over(bounds: Box, cell: float) -> "_Canvas":
        if not (math.isfinite(cell) and cell > 0.0):
            raise ValueError(f"cell must be above zero, not {cell!r}")
        if len(bounds) != 4 or not all(math.isfinite(value) for value in bounds):
            raise ValueError(f"bounds must be x_min, y_min, x_max, y_max in metres, not {bounds}")
        x0, y0, x1, y1 = bounds
        cells = np.array([(x1 - x0) / cell, (y1 - y0) / cell])
        whole = np.rint(cells)
        if (whole < 1).any() or (np.abs(cells - whole) > 1e-6).any():
            raise ValueError(f"bounds must span whole cells of {cell:g} m, not {cells} of them")
        if whole.prod() > MAX_CELLS:
            raise ValueError(f"bounds hold {whole.prod():.0f} cells, more than {MAX_CELLS:,}")
        shape = (int(whole[0]), int(whole[1]))
        box = require("shapely", _PURPOSE).box(x0, y0, x1, y1)
        classes = np.full(shape, LandClass.UNKNOWN, dtype=np.uint8)
        return _Canvas(bounds, cell, box, np.zeros(shape), classes)

    @property
    def shape(self) -> tuple[int, int]:
        return self.surface.shape[0], self.surface.shape[1]

    def paint(self, areas: list[tuple[Any, LandClass]]) -> None:
        """Lay `areas` on the ground, the last on top."""
        none = 255
        burnt = self._burn([(area, float(kind)) for area, kind in areas], none, all_touched=False)
        self.classes[burnt != none] = burnt[burnt != none].astype(np.uint8)

    def raise_to(
        self, solids: list[tuple[Any, float]], kind: LandClass, every_touched_cell: bool = False
    ) -> None:
        """Put up solids of a height each; where they overlap, the highest is seen."""
        ordered = sorted(solids, key=lambda solid: solid[1])
        height = self._burn(ordered, 0.0, all_touched=every_touched_cell)
        np.maximum(self.surface, height, out=self.surface)
        self.classes[height > 0.0] = kind

    def _burn(
        self, areas: list[tuple[Any, float]], fill: float, *, all_touched: bool
    ) -> NDArray[np.float64]:
        features = require("rasterio.features", _PURPOSE)
        affine = require("rasterio", _PURPOSE).Affine
        near = [(area, value) for area, value in areas if area.intersects(self.box)]
        if not near:
            return np.full(self.shape, fill)
        image = features.rasterize(
            near,
            out_shape=self.shape[::-1],
            fill=fill,
            transform=affine(self.cell, 0.0, self.bounds[0], 0.0, -self.cell, self.bounds[3]),
            all_touched=all_touched,
            dtype="float64",
        )
        # Image order is [row, column] from the north-west corner.
        return np.asarray(image[::-1].T)


def _geographic(projection: Any, bounds: Box) -> Box:
    """The bounds and a margin as lon_min, lat_min, lon_max, lat_max."""
    pyproj = require("pyproj", _PURPOSE)
    to_degrees = pyproj.Transformer.from_crs(projection, "EPSG:4326", always_xy=True)
    x0, y0, x1, y1 = bounds
    west, south, east, north = to_degrees.transform_bounds(
        x0 - _MARGIN, y0 - _MARGIN, x1 + _MARGIN, y1 + _MARGIN
    )
    if not np.isfinite([west, south, east, north]).all() or west > east:
        raise ValueError(f"bounds {bounds} do not lie within the area of {projection.name}")
    return west, south, east, north
