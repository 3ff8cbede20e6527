# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from GeoTIFF rasters: surface model, terrain model, canopy heights and land classes."""

from collections.abc import Mapping
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass
from ltp.world.world import Datum, World

from ..fill import fill_linear
from ..limits import HEIGHTS, OBJECT_HEIGHT
from .coarsen import coarsen
from .raster import PathLike, TiffRaster, read_raster

ClassTable = Mapping[int, LandClass | str | int]


def read(
    *,
    dsm: PathLike,
    dem: PathLike,
    canopy: PathLike | None = None,
    classes: PathLike | None = None,
    class_table: ClassTable | None = None,
    cell: float | None = None,
    name: str = "",
    attribution: str = "",
    vertical: str = "as in the rasters",
) -> World:
    """Read a world from rasters that share one metric, axis-parallel grid.

    Args:
        dsm: heights of ground and buildings above the height datum [m], with or without trees.
        dem: heights of the bare ground above the same datum [m].
        canopy: heights of the tree crowns **above the ground** [m], 0 where there is no tree.
        classes: land-class codes; `class_table` gives each code in it a meaning.
        class_table: code -> LandClass, its name in any case, or its number.
        cell: cell size of the world [m], a multiple of that of the rasters; default: theirs.
        name: name of the world; default: the file name of `dsm`.
        attribution: the line that must stand beside every picture.
        vertical: name of the height datum.

    Returns:
        A world whose surface is the highest of `dsm`, `dem` + `canopy` and `dem`. Crowns above 2 m
        are TREES unless over a BUILDING. Without `classes`, what stands above 2 m is a BUILDING
        and the rest GROUND. Cells without a height in `dsm` or `dem` are interpolated and UNKNOWN.

    Raises:
        ImportError: if rasterio is not installed.
        ValueError: naming the file and what is wrong with it.
        OSError: if a file cannot be opened.
    """
    table = _check_table(class_table, classes)
    surface_model = read_raster(dsm)
    terrain = read_raster(dem, like=surface_model)
    ground, no_ground = _heights(terrain)
    top, no_top = _heights(surface_model)
    crowns = np.zeros_like(ground)
    if canopy is not None:
        raster = read_raster(canopy, like=surface_model)
        values = _mask_absurd(raster)
        crowns = np.where(np.isnan(values), 0.0, values)

    surface = np.maximum(np.maximum(top, ground + crowns), ground)
    if classes is not None:
        kinds = _translate(read_raster(classes, like=surface_model), table)
    else:
        built = top - ground > OBJECT_HEIGHT
        kinds = np.where(built, LandClass.BUILDING, LandClass.GROUND).astype(np.uint8)
    kinds[(crowns > OBJECT_HEIGHT) & (kinds != LandClass.BUILDING)] = LandClass.TREES
    kinds[no_ground | no_top] = LandClass.UNKNOWN

    grid = surface_model.grid
    factor = _factor(cell, grid.cell)
    if factor > 1:
        ground, surface, kinds = coarsen(ground, surface, kinds, factor)
    return World(
        name=name or Path(dsm).stem,
        ground=ground,
        surface=surface,
        classes=kinds,
        cell=grid.cell * factor,
        datum=Datum(grid.crs, grid.xmin, grid.ymin, vertical),
        attribution=attribution,
    )


def _mask_absurd(raster: TiffRaster) -> NDArray[np.float64]:
    """Heights as float64, NaN where the raster has none."""
    with np.errstate(invalid="ignore"):  # of numbers that are none
        values = raster.values.astype(np.float64)
        bad = raster.missing | ~((values >= HEIGHTS[0]) & (values <= HEIGHTS[1]))
    values[bad] = np.nan
    return values


def _heights(raster: TiffRaster) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Heights without holes, and where the holes were."""
    values = _mask_absurd(raster)
    missing = np.isnan(values)
    if missing.all():
        raise ValueError(f"{raster.path} holds no height in {HEIGHTS[0]:g}...{HEIGHTS[1]:g} m")
    return fill_linear(values), missing


def _check_table(table: ClassTable | None, classes: PathLike | None) -> dict[int, LandClass]:
    if (table is None) != (classes is None):
        raise ValueError("classes and class_table go together: codes mean nothing by themselves")
    return {int(code): land_class(kind) for code, kind in (table or {}).items()}


def land_class(kind: LandClass | str | int) -> LandClass:
    """The class of that name (in any case) or number.

    Raises:
        ValueError: if there is none, naming those there are.
    """
    try:
        return LandClass[kind.upper()] if isinstance(kind, str) else LandClass(kind)
    except (KeyError, ValueError):
        names = ", ".join(c.name.lower() for c in LandClass)
        raise ValueError(f"class must be one of {names}, not {kind!r}") from None


def _translate(raster: TiffRaster, table: Mapping[int, LandClass]) -> NDArray[np.uint8]:
    kinds = np.full(raster.values.shape, LandClass.UNKNOWN, dtype=np.uint8)
    present = ~raster.missing & np.isfinite(raster.values)
    codes, counts = np.unique(raster.values[present], return_counts=True)
    for code, count in zip(codes, counts, strict=True):
        if code not in table:
            raise ValueError(
                f"{raster.path} holds code {code:g} in {count} cells, class_table names only "
                f"{sorted(table)}; add {code:g}=unknown, or what it means"
            )
        kinds[present & (raster.values == code)] = table[int(code)]
    return kinds


def _factor(cell: float | None, native: float) -> int:
    """How many cells of the rasters make one of the world, along each axis."""
    if cell is None:
        return 1
    ratio = cell / native if np.isfinite(cell) else 0.0
    factor = round(ratio)
    if factor < 1 or abs(ratio - factor) > 1e-6:
        raise ValueError(f"cell must be a multiple of the rasters' {native:g} m, not {cell!r}")
    return factor
