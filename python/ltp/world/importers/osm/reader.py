# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from an OpenStreetMap extract: buildings, roads, water and parks on flat ground."""

import math
import os
from pathlib import Path
from typing import Any

import numpy as np

from ltp.world.crs import check_scale, crs_name, crs_report, metric_crs, refuse_degrees
from ltp.world.world import Datum, World

from ..optional import require
from .canvas import Canvas
from .ground import paint_ground
from .shapes import read_shapes
from .solids import raise_solids
from .source import Box
from .summary import summary

#: The licence (ODbL 1.0) asks for this line beside every picture.
ATTRIBUTION = "(c) OpenStreetMap contributors, ODbL 1.0, https://www.openstreetmap.org/copyright"

_PURPOSE = "reading OpenStreetMap files"
_MARGIN = 100.0  # half of the widest road, and more: what lies outside but reaches in [m]


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
        crs: a projected CRS in metres that are true within the bounds, e.g. "EPSG:32618".
        cell: cell size of the world [m].
        default_height: height of a building without any tag that tells it [m].
        name: name of the world; default: the file name.
        attribution: the line that must stand beside every picture.

    Returns:
        A world on flat ground, z = 0. The surface is the top of buildings, trees and towers, solid
        down to the ground. A cell belongs to what covers its centre; of areas the smallest lies on
        top, then water, then rails, paths and roads, then trees, then buildings. Unmapped ground is
        UNKNOWN. Its `report` says what was read, which heights were guessed, what was left out.

    Raises:
        ImportError: if osmium, pyproj, rasterio or shapely are not installed.
        ValueError: naming the file or argument and what is wrong with it; also if the file lacks
            nodes of something in the bounds that must not be missed, such as a building, or if the
            scale of the CRS is off there by more than 1 %.
        OSError: if the file cannot be opened.
    """
    path = Path(path)
    if not (math.isfinite(default_height) and default_height > 0.0):
        raise ValueError(f"default_height must be above zero, not {default_height!r}")
    projection = metric_crs(crs, "crs")
    if len(bounds) == 4:  # else Canvas.over says so
        refuse_degrees(bounds, "bounds", crs=projection)
    canvas = Canvas.over(bounds, cell)
    scale = check_scale(projection, bounds, "crs")
    source, shapes = read_shapes(path, projection, _geographic(projection, bounds), canvas.box)
    try:
        paint_ground(canvas, shapes)
        solids = raise_solids(canvas, shapes, default_height)
        report = summary(source, shapes, solids, canvas.box, default_height)
    except ImportError:
        raise
    except Exception as error:  # GEOS's own, of hostile coordinates
        raise ValueError(f"{path} cannot be read as an OpenStreetMap file: {error}") from error
    return World(
        name=name or path.name.removesuffix(".pbf").removesuffix(".osm"),
        ground=np.zeros(canvas.shape),
        surface=canvas.surface,
        classes=canvas.classes,
        cell=cell,
        datum=Datum(crs_name(projection), float(bounds[0]), float(bounds[1]), "flat ground"),
        attribution=attribution,
        report=(crs_report(projection, scale, "named by the caller"), *report),
    )


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
