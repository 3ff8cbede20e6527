# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One band of a GeoTIFF file, with where it lies; read with distrust, turned to [x, y]."""

import os
import warnings
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.archive import MAX_CELLS

from ..optional import require
from .layout import check_complete
from .masks import has_alpha, read_band

PathLike = str | os.PathLike[str]

# Packed tighter than this, a raster is not one: its blocks were never written, or are a trap.
_MAX_BYTES_PER_BYTE = 10_000
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
class TiffRaster:
    """One band of a file."""

    path: Path
    grid: Grid
    values: NDArray[Any]  # (nx, ny), axis 0 = east, axis 1 = north
    missing: NDArray[np.bool_]  # (nx, ny) no-data tag, mask or alpha band says: nothing here
    scale: float = 1.0  # a value is a stored number times this
    offset: float = 0.0  # plus this
    largest: float | None = None  # largest number that an integer type of the file can store
    report: tuple[str, ...] = ()  # what lay beside or inside the file and was read, or was not


def read_raster(path: PathLike, like: TiffRaster | None = None) -> TiffRaster:
    """Read the one band of a raster and turn it from image order to [x, y].

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
    # Only the file itself: sidecars beside it could change the grid; a mask is read by name.
    options = {"GDAL_DISABLE_READDIR_ON_OPEN": "EMPTY_DIR", "GDAL_PAM_ENABLED": "NO"}
    try:
        with warnings.catch_warnings(), rasterio.Env(**options):
            # A missing georeference becomes an error below.
            warnings.simplefilter("ignore", rasterio.errors.NotGeoreferencedWarning)
            # The driver is named, or else GDAL would follow a VRT to other files and hosts.
            with rasterio.open(path.resolve(), driver="GTiff") as dataset:
                grid, rows_go_north = _grid(path, dataset)
                if like is not None and not grid.matches(like.grid):
                    raise ValueError(
                        f"{path} lies on another grid than {like.path}: {grid}, "
                        f"expected {like.grid}"
                    )
                stored, missing, report = read_band(path, dataset)
                scale, offset = dataset.scales[0], dataset.offsets[0]
    except (
        rasterio.errors.RasterioError,
        rasterio.errors.CRSError,
        MemoryError,
        UnicodeDecodeError,  # of a text in the file
    ) as error:
        raise ValueError(f"{path} cannot be read as a GeoTIFF: {error}") from error
    values = stored
    if (scale, offset) != (1.0, 0.0):
        values = values * scale + offset
    # Image order is [row, column]; the first row of a north-up raster is the northernmost.
    turn = slice(None) if rows_go_north else slice(None, None, -1)
    largest = float(np.iinfo(stored.dtype).max) if stored.dtype.kind in "iu" else None
    return TiffRaster(
        path, grid, values[turn].T, missing[turn].T, scale, offset, largest, tuple(report)
    )


def _grid(path: Path, dataset: Any) -> tuple[Grid, bool]:
    """The grid of an open raster, and whether its rows go north; nothing is read before this."""
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
    return Grid(crs and crs.to_string(), (nx, ny), float(t.a), *corner), t.e > 0.0
