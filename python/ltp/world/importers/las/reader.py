# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from a classified airborne laser survey (LAS or LAZ)."""

import math
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass
from ltp.world.world import Datum, World

from ..fill import fill_linear, grow, wide_gaps
from ..limits import OBJECT_HEIGHT
from ..optional import require
from .frame import survey_frame
from .header import check_complete
from .layers import Bounds, Lattice, Layers
from .meanings import Codes, Meanings

#: Unclassified returns higher than this above the ground are obstacles: cars, wires, masts [m].
CLUTTER_HEIGHT = 0.5

_CHUNK = 1_000_000  # points in memory at a time


def read(
    path: str | os.PathLike[str],
    *,
    cell: float = 2.0,
    bounds: Bounds | None = None,
    max_gap: float = 8.0,
    crs: str | None = None,
    convert_heights: bool = False,
    user_classes: str = "auto",
    class_table: Meanings | None = None,
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
        convert_heights: scale heights that the file says are in feet, or another unit, to metres;
            else it is refused.
        user_classes: whose meaning the classes 64 to 255 have, which the standard leaves to the
            producer. "ign": 64 to 67 are those of the French survey (LiDAR HD); "none": nobody
            says, and such returns are obstacles where they stand above the ground, else the cell
            is UNKNOWN; "auto": "ign" if the CRS is French or the header names that agency.
        class_table: class -> LandClass, its name in any case, its number, or "noise": what the
            producer means by it; wins over everything else.
        name: name of the world; default: the file name.
        attribution: the line that must stand beside every picture.
        vertical: name of the height datum.

    Returns:
        A world whose ground is the mean of the ground returns per cell, interpolated where there is
        none; whose surface is the highest return of a building, bridge, tree or other object in
        the cell. Narrower gaps take after the cells around them, so that roofs have no holes. Cells
        with something unclassified on them are UNKNOWN; low plants stand on open ground. `report`
        says which classes there are, how many returns each, and what they were taken for.

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
    check_complete(path)
    laspy = require("laspy", "reading LAS and LAZ")
    require("lazrs", "reading LAS and LAZ")
    header, chunks = _open(laspy, path)
    lattice = Lattice.around(path, header, cell, bounds)
    frame = survey_frame(path, header, crs=crs, bounds=bounds, convert_heights=convert_heights)
    codes = Codes.of(user_classes, class_table, frame.crs, header)
    layers = Layers(lattice, codes, frame.heights.metres)
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
        datum=Datum(frame.crs, lattice.xmin, lattice.ymin, vertical),
        attribution=attribution,
        report=(*frame.report, *layers.report()),
    )


def _interpret(
    layers: Layers, max_gap: float
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
    classes[(clutter > CLUTTER_HEIGHT) | layers.undefined] = LandClass.UNKNOWN
    classes[layers.drawn & (classes != LandClass.WATER)] = LandClass.UNKNOWN
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
