# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world from GeoTIFF rasters: surface model, terrain model, canopy heights and land classes."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .archive import MAX_CELLS
from .classes import LandClass
from .coarsen import coarsen
from .fill import fill_linear
from .optional import require
from .tiff_layout import check_complete
from .world import Datum, World

#: What stands higher than this above the ground is an object, not a kind of ground [m].
OBJECT_HEIGHT = 2.0

# Heights outside of this are no-data values whose tag was lost (-9999, -3.4e38, ...) [m].
_HEIGHTS = (-1000.0, 10000.0)

_PathLike = str | os.PathLike[str]
ClassTable = Mapping[int, LandClass | str | int]


def read(
    *,
    dsm: _PathLike,
    dem: _PathLike,
    canopy: _PathLike | None = None,
    classes: _PathLike | None = None,
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
    surface_model = _read_raster(dsm)
    terrain = _read_raster(dem, like=surface_model)
    ground, no_ground = _heights(terrain)
    top, no_top = _heights(surface_model)
    crowns = np.zeros_like(ground)
    if canopy is not None:
        raster = _read_raster(canopy, like=surface_model)
        values = _mask_absurd(raster)
        crowns = np.where(np.isnan(values), 0.0, values)

    surface = np.maximum(np.maximum(top, ground + crowns), ground)
    if classes is not None:
        kinds = _translate(_read_raster(classes, like=surface_model), table)
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


@dataclass(frozen=True)
class _Grid:
    """Where the cells of a raster lie."""

    crs: str | None
    shape: tuple[int, int]  # cells along x, y
    cell: float  # [m]
    xmin: float  # CRS coordinate of the western edge [m]
    ymin: float  # CRS coordinate of the southern edge [m]

    def matches(self, other: "_Grid") -> bool:
        slack = self.cell * 1e-3
        return (
            self.crs == other.crs
            and self.shape == other.shape
            and abs(self.cell - other.cell) * max(self.shape) < slack
            and abs(self.xmin - other.xmin) < slack
            and abs(self.ymin - other.ymin) < slack
        )

    def __str__(self) -> str:
        nx, ny = self.shape
        where = f"({self.xmin:.10g}, {self.ymin:.10g})"
        return f"{nx} x {ny} cells of {self.cell:g} m from {where} in {self.crs or 'no CRS'}"


@dataclass(frozen=True)
class _Raster:
    path: Path
    grid: _Grid
    values: NDArray[Any]  # (nx, ny), axis 0 = east, axis 1 = north
    missing: NDArray[np.bool_]  # (nx, ny)


def _read_raster(path: _PathLike, like: _Raster | None = None) -> _Raster:
    """Read the one band of a raster and turn it from image order to [x, y]."""
    rasterio = require("rasterio", "reading GeoTIFF")
    path = Path(path)
    if not path.is_file():  # also keeps GDAL from taking the name for a URL or a virtual path
        raise FileNotFoundError(f"{path} is not a file")
    check_complete(path)
    # Only the file itself: sidecars beside it could change the grid or the no-data value.
    options = {"GDAL_DISABLE_READDIR_ON_OPEN": "EMPTY_DIR", "GDAL_PAM_ENABLED": "NO"}
    try:
        # The driver is named, or else GDAL would follow a VRT to other files and hosts.
        with rasterio.Env(**options), rasterio.open(path.resolve(), driver="GTiff") as dataset:
            grid, rows_go_north = _check_grid(path, dataset)
            if like is not None and not grid.matches(like.grid):
                raise ValueError(
                    f"{path} lies on another grid than {like.path}: {grid}; expected {like.grid}"
                )
            band = dataset.read(1, masked=True)
            scale, offset = dataset.scales[0], dataset.offsets[0]
    except (rasterio.errors.RasterioError, rasterio.errors.CRSError, MemoryError) as error:
        raise ValueError(f"{path} cannot be read as a GeoTIFF: {error}") from error
    values, missing = np.asarray(band.data), np.ma.getmaskarray(band)
    if (scale, offset) != (1.0, 0.0):
        values = values * scale + offset
    # Image order is [row, column]; the first row of a north-up raster is the northernmost.
    turn = slice(None) if rows_go_north else slice(None, None, -1)
    return _Raster(path, grid, values[turn].T, missing[turn].T)


def _check_grid(path: Path, dataset: Any) -> tuple[_Grid, bool]:
    """The grid of an open raster, and whether its rows go north; nothing is read before this."""
    nx, ny, t = dataset.width, dataset.height, dataset.transform
    if nx * ny > MAX_CELLS or max(int(a) * int(b) for a, b in dataset.block_shapes) > MAX_CELLS:
        raise ValueError(f"{path} declares {nx} x {ny} cells, more than {MAX_CELLS:,}")
    if dataset.count != 1:
        raise ValueError(f"{path} must have one band, it has {dataset.count}")
    if np.dtype(dataset.dtypes[0]).kind not in "iuf":
        raise ValueError(f"{path} must hold numbers, not {dataset.dtypes[0]}")
    if t.is_identity:
        raise ValueError(f"{path} does not say where on the Earth it lies (no georeference)")
    if not np.isfinite(t[:6]).all() or t.b != 0.0 or t.d != 0.0 or t.a <= 0.0 or t.e == 0.0:
        raise ValueError(f"{path} must have columns that go east and rows that go south or north")
    if abs(t.a - abs(t.e)) > 1e-6 * t.a:
        raise ValueError(f"{path} must have square cells, not {t.a:g} x {abs(t.e):g}")
    crs = dataset.crs
    if crs is not None and crs.is_geographic:
        raise ValueError(f"{path} is in degrees ({crs}); reproject it to a metric CRS first")
    if crs is not None and abs(crs.linear_units_factor[1] - 1.0) > 1e-9:
        raise ValueError(f"{path} must be in metres, not in {crs.linear_units}")
    unit = dataset.units[0]
    if unit and unit.lower() not in {"m", "metre", "meter", "metres", "meters"}:
        raise ValueError(f"{path} must hold heights in metres, not in {unit!r}")
    south = t.f if t.e > 0.0 else t.f + t.e * ny
    corner = round(float(t.c), 3), round(float(south), 3)  # a map has no tenths of a millimetre
    return _Grid(crs and crs.to_string(), (nx, ny), float(t.a), *corner), t.e > 0.0


def _mask_absurd(raster: _Raster) -> NDArray[np.float64]:
    """Heights as float64, NaN where the raster has none."""
    values = raster.values.astype(np.float64)
    with np.errstate(invalid="ignore"):
        bad = raster.missing | ~((values >= _HEIGHTS[0]) & (values <= _HEIGHTS[1]))
    values[bad] = np.nan
    return values


def _heights(raster: _Raster) -> tuple[NDArray[np.float64], NDArray[np.bool_]]:
    """Heights without holes, and where the holes were."""
    values = _mask_absurd(raster)
    missing = np.isnan(values)
    if missing.all():
        raise ValueError(f"{raster.path} holds no height in {_HEIGHTS[0]:g}...{_HEIGHTS[1]:g} m")
    return fill_linear(values), missing


def _check_table(table: ClassTable | None, classes: _PathLike | None) -> dict[int, LandClass]:
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


def _translate(raster: _Raster, table: Mapping[int, LandClass]) -> NDArray[np.uint8]:
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
