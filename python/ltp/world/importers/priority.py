# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A priority map of one's own, from a GeoTIFF or an .npz file; read with distrust."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from ltp.files import atomic_write, blamed_on
from ltp.files.npz import NpzReader
from ltp.world.archive import MAX_CELLS
from ltp.world.checks import shares
from ltp.world.crs import same_grid
from ltp.world.world import World

from .geotiff.raster import read_raster

if TYPE_CHECKING:
    from ltp._core import Raster

_TIFF = (".tif", ".tiff")
_MEMBERS = {"values", "origin", "cell"}
_NUMBERS = ("<f8", "<f4", "<i8", "<i4", "|u1", "|b1")
_LENGTHS = ("<f8", "<f4", "<i8", "<i4")
_BASE, _RATIO = 200_000_000, 200  # bytes that a file may hold, and more for each of its own
_SLACK = 1e-6  # cells


class GivenPriority(NamedTuple):
    """A priority map from a file."""

    raster: "Raster"  # in the world's frame; 0 beyond its edges
    report: tuple[str, ...]  # what is worth knowing of it, a sentence each


def read_priority(path: str | os.PathLike[str], world: World) -> GivenPriority:
    """Read a priority map to fly with over a world.

    Args:
        path: of a GeoTIFF of one band in the world's CRS, or of an .npz file as `save_priority`
            and `numpy.savez(path, values=..., origin=[x, y], cell=...)` write it: values (nx, ny)
            indexed [ix, iy], the outer corner of cell (0, 0) and the edge of a cell, in the world's
            frame [m]. Values are shares from 0 to 1; cells without data count 0.
        world: that it is for.

    Raises:
        ImportError: if a GeoTIFF is given and rasterio is not installed.
        OSError: if the file cannot be opened.
        ValueError: naming the file, if it is damaged, holds anything but shares, or lies in another
            CRS than the world or off it.
    """
    path = Path(path)
    ending, report = path.suffix.lower(), []
    if ending == ".npz":
        values, origin, cell = _read_npz(path)
    elif ending in _TIFF:
        values, missing, origin, cell = _read_tiff(path, world)
        if missing:
            report.append(f"{path}: {missing:,} cells without data count 0")
    else:
        raise ValueError(f"{path}: a priority map is a .tif, .tiff or .npz file")
    shares(f"{path}: values", values)
    covered = _covered(world, values.shape, origin, cell)
    if covered == 0.0:
        raise ValueError(
            f"{path} covers {_box(*_extent(values.shape, origin, cell))} and so nothing of "
            f"{world.name}, which covers {_box(*world.extent)}"
        )
    if covered < 1.0 - _SLACK:
        report.append(
            f"{path} covers {100.0 * covered:.1f} % of {world.name}; elsewhere the priority is 0"
        )
    from ltp._core import Raster

    return GivenPriority(Raster(values, origin=origin, cell=cell), tuple(report))


def save_priority(raster: "Raster", path: str | os.PathLike[str]) -> None:
    """Write a priority map as an .npz file, all or nothing.

    Raises:
        OSError: if the file cannot be written.
        ValueError: if a value is no share, or the file's name does not end in .npz.
    """
    if Path(path).suffix.lower() != ".npz":
        raise ValueError(f"path must end in .npz, not {os.fspath(path)!r}")
    shares("raster", raster.values)
    with atomic_write(path) as file:
        np.savez_compressed(
            file, values=raster.values, origin=np.array(raster.origin), cell=np.array(raster.cell)
        )


def _read_npz(path: Path) -> tuple[NDArray[np.float64], tuple[float, float], float]:
    with path.open("rb") as file, blamed_on(path, "a sound priority map"):
        reader = NpzReader(file, _BASE, _RATIO)
        reader.expect(_MEMBERS)
        values = reader.array("values", _NUMBERS, (None, None), MAX_CELLS)
        west, south = reader.array("origin", _LENGTHS, (2,), 2).tolist()
        (cell,) = reader.array("cell", _LENGTHS, (), 1).reshape(-1).tolist()
        if values.size == 0 or not np.isfinite([west, south]).all() or not 0.0 < cell < np.inf:
            raise ValueError(
                f"expected values of cells above zero [m] from a corner, found shape "
                f"{values.shape}, cell {cell!r}, origin {(west, south)!r}"
            )
    return values, (west, south), cell


def _read_tiff(
    path: Path, world: World
) -> tuple[NDArray[np.float64], int, tuple[float, float], float]:
    """Values, how many are missing, corner and cell."""
    band = read_raster(path, heights=False)
    if not _alike(band.grid.crs, world.datum.crs):
        raise ValueError(
            f"{path} is in {band.grid.crs or 'no CRS'}, {world.name} in "
            f"{world.datum.crs or 'no CRS'}: give it in that of the world"
        )
    values = np.where(band.missing, 0.0, band.values).astype(np.float64)
    origin = (band.grid.xmin - world.datum.easting, band.grid.ymin - world.datum.northing)
    return values, int(band.missing.sum()), origin, band.grid.cell


def _alike(crs: str | None, other: str | None) -> bool:
    """Whether two CRSs have one horizontal grid, however they are spelt."""
    if crs is None or other is None or crs == other:
        return crs == other
    try:
        return same_grid(crs, other)
    except ValueError:  # one that nobody knows
        return False


def _extent(
    shape: tuple[int, ...], origin: tuple[float, float], cell: float
) -> tuple[float, float, float, float]:
    return (*origin, origin[0] + shape[0] * cell, origin[1] + shape[1] * cell)


def _covered(
    world: World, shape: tuple[int, ...], origin: tuple[float, float], cell: float
) -> float:
    """Share of the world that the map covers."""
    ours, theirs = world.extent, _extent(shape, origin, cell)
    share = 1.0
    for axis in (0, 1):
        overlap = min(ours[axis + 2], theirs[axis + 2]) - max(ours[axis], theirs[axis])
        share *= max(0.0, overlap) / (ours[axis + 2] - ours[axis])
    return share


def _box(x_min: float, y_min: float, x_max: float, y_max: float) -> str:
    return f"x = {x_min:.10g} ... {x_max:.10g} m, y = {y_min:.10g} ... {y_max:.10g} m"
