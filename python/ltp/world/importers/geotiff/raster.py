# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One band of a GeoTIFF file, with where it lies; read with distrust, turned to [x, y]."""

import math
import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.archive import MAX_CELLS
from ltp.world.crs import crs_name, same_grid

from ..optional import require
from .frame import Frame, raster_frame
from .layout import check_complete, read_geokeys
from .masks import has_alpha, read_band

PathLike = str | os.PathLike[str]

# Packed tighter than this, a raster is not one: its blocks were never written, or are a trap.
_MAX_BYTES_PER_BYTE = 10_000
_METRES_PER_DEGREE = 111_000.0
_SMALL = 4_000_000  # cells that anybody may promise


@dataclass(frozen=True)
class Grid:
    """Where the cells of a raster lie."""

    crs: str | None
    shape: tuple[int, int]  # cells along x, y
    cell: float  # [m]
    xmin: float  # CRS coordinate of the western edge [m]
    ymin: float  # CRS coordinate of the southern edge [m]

    def matches(self, other: "Grid") -> bool:
        """Whether the cells of both lie on each other, to a thousandth of a cell."""
        slack = self.cell * 1e-3
        known = self.crs is not None and other.crs is not None
        return (
            (self.crs == other.crs or (known and same_grid(self.crs, other.crs)))
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
class TiffRaster:
    """One band of a file."""

    path: Path
    grid: Grid
    values: NDArray[Any]  # (nx, ny), axis 0 = east, axis 1 = north
    missing: NDArray[np.bool_]  # (nx, ny) no-data tag, mask or alpha band says: nothing here
    frame: Frame
    transform: Any  # from column, row of values.T to x, y: an affine.Affine
    scale: float = 1.0  # a value is a stored number times this
    offset: float = 0.0  # plus this
    largest: float | None = None  # largest number that an integer type of the file can store
    report: tuple[str, ...] = ()  # what lay beside or inside the file and was read, or was not


def read_raster(
    path: PathLike,
    like: TiffRaster | None = None,
    *,
    heights: bool = True,
    align: bool = False,
    convert_heights: bool = False,
) -> TiffRaster:
    """Read the one band of a raster and turn it from image order to [x, y].

    Args:
        path: the file.
        like: a raster on whose grid it must lie.
        heights: whether the values are heights [m], and not codes.
        align: whether it may lie on any other grid than `like`, of which it will be brought there.
        convert_heights: whether heights in another unit are scaled to metres, or refused.

    Raises:
        ImportError: if rasterio is not installed.
        ValueError: naming the file, if it is damaged, no GeoTIFF, too large, not metric, or lies on
            another grid than `like`.
        OSError: if it cannot be opened.
    """
    rasterio = require("rasterio", "reading GeoTIFF")
    path = Path(path)
    if not path.is_file():  # also keeps GDAL from taking the name for a URL or a virtual path
        raise FileNotFoundError(f"{path} is not a file")
    check_complete(path)
    keys = read_geokeys(path)
    # Only the file itself: sidecars beside it could change the grid; a mask is read by name.
    options = {"GDAL_DISABLE_READDIR_ON_OPEN": "EMPTY_DIR", "GDAL_PAM_ENABLED": "NO"}
    options["GTIFF_REPORT_COMPD_CS"] = "YES"  # the vertical CRS too
    strict = like is None or not align
    try:
        with warnings.catch_warnings(), rasterio.Env(**options):
            # A missing georeference becomes an error below.
            warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
            # The driver is named, or else GDAL would follow a VRT to other files and hosts.
            with rasterio.open(path.resolve(), driver="GTiff") as dataset:
                _check_size(path, dataset)
                if strict:
                    _check_axes(path, dataset)
                frame = raster_frame(
                    path,
                    dataset,
                    keys,
                    metric=strict,
                    heights=heights,
                    convert_heights=convert_heights,
                )
                grid, transform = _grid(dataset, frame)
                if strict and like is not None and not grid.matches(like.grid):
                    raise ValueError(
                        f"{path} lies on another grid than {like.path}: {grid}, "
                        f"expected {like.grid}; with align it is resampled onto that grid"
                    )
                if not np.isfinite(dataset.scales[0]) or dataset.scales[0] == 0.0:
                    raise ValueError(f"{path} must have a scale other than {dataset.scales[0]}")
                stored, missing, report = read_band(path, dataset)
                unit = frame.heights.metres
                scale, offset = dataset.scales[0] * unit, dataset.offsets[0] * unit
    except (
        rasterio.errors.RasterioError,
        rasterio.errors.RasterioIOError,  # in 1.3 an OSError only
        rasterio.errors.CRSError,
        MemoryError,
        UnicodeDecodeError,  # of a text in the file
    ) as error:
        raise ValueError(f"{path} cannot be read as a GeoTIFF: {error}") from error
    values = stored
    if (scale, offset) != (1.0, 0.0):
        values = values * scale + offset
    # Image order is [row, column]; the first row of a north-up raster is the northernmost.
    turn = slice(None) if transform.e > 0.0 else slice(None, None, -1)
    if transform.e < 0.0:
        t, ny = transform, grid.shape[1]
        transform = rasterio.Affine(t.a, -t.b, t.c + t.b * ny, t.d, -t.e, t.f + t.e * ny)
    largest = float(np.iinfo(stored.dtype).max) if stored.dtype.kind in "iu" else None
    return TiffRaster(
        path,
        grid,
        values[turn].T,
        missing[turn].T,
        frame,
        transform,
        scale,
        offset,
        largest,
        tuple(report),
    )


def _check_size(path: Path, dataset: Any) -> None:
    """Nothing is read of an open raster before this."""
    nx, ny, t = dataset.width, dataset.height, dataset.transform
    if nx * ny > MAX_CELLS or max(int(a) * int(b) for a, b in dataset.block_shapes) > MAX_CELLS:
        raise ValueError(f"{path} declares {nx} x {ny} cells, more than {MAX_CELLS:,}")
    declared = nx * ny * np.dtype(dataset.dtypes[0]).itemsize
    if nx * ny > _SMALL and declared > _MAX_BYTES_PER_BYTE * path.stat().st_size:
        raise ValueError(
            f"{path} declares {nx} x {ny} cells, which its {path.stat().st_size} bytes do not hold"
        )
    if dataset.count != 1 and not has_alpha(dataset):
        raise ValueError(f"{path} must have one band, it has {dataset.count}")
    if np.dtype(dataset.dtypes[0]).kind not in "iuf":
        raise ValueError(f"{path} must hold numbers, not {dataset.dtypes[0]}")
    if t.is_identity:
        raise ValueError(f"{path} does not say where on the Earth it lies (no georeference)")
    if not np.isfinite(t[:6]).all() or t.determinant == 0.0:
        raise ValueError(f"{path} must have cells with an area, not those of {t[:6]}")


def _check_axes(path: Path, dataset: Any) -> None:
    t = dataset.transform
    if t.b != 0.0 or t.d != 0.0 or t.a <= 0.0 or t.e == 0.0:
        raise ValueError(f"{path} must have columns that go east and rows that go south or north")
    if abs(t.a - abs(t.e)) > 1e-6 * t.a:
        raise ValueError(f"{path} must have square cells, not {t.a:g} x {abs(t.e):g}")


def _grid(dataset: Any, frame: Frame) -> tuple[Grid, Any]:
    """The grid of an open raster, and its transform. Where it is not metric, its cell is rough."""
    t, ny = dataset.transform, dataset.height
    south = t.f if t.e > 0.0 else t.f + t.e * ny
    corner = round(float(t.c), 3), round(float(south), 3)  # a map has no tenths of a millimetre
    degrees = frame.crs is not None and frame.crs.is_geographic
    cell = math.sqrt(abs(t.determinant)) * _METRES_PER_DEGREE if degrees else float(t.a)
    name = None if frame.crs is None else crs_name(frame.crs)
    return Grid(name, (dataset.width, ny), cell, *corner), t
