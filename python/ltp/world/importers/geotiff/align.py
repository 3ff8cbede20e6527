# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rasters of other grids, reprojected and resampled onto the grid of the surface model."""

from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass
from ltp.world.crs import crs_name

from ..fill import fill_linear
from ..optional import require
from .holes import Layer
from .raster import TiffRaster

_PURPOSE = "aligning rasters"
# Any metric CRS will do for two rasters that name none.
_SOME_CRS = "EPSG:32631"


def alignment(raster: TiffRaster, like: TiffRaster) -> list[str]:
    """What to report of a raster that is brought onto the grid of another.

    Raises:
        ValueError: naming the file, if it cannot be: one of the two says no CRS, or it lies
            elsewhere.
    """
    if raster.grid.matches(like.grid):
        return []
    if (raster.frame.crs is None) != (like.frame.crs is None):
        silent, other = (raster, like) if raster.frame.crs is None else (like, raster)
        raise ValueError(
            f"{raster.path} cannot be aligned with {like.path}: {silent.path} names no CRS, "
            f"{other.path} does"
        )
    bilinear = require("rasterio.warp", _PURPOSE).Resampling.bilinear
    outside = np.isnan(_warped(raster, like, np.zeros(raster.grid.shape), bilinear, np.nan))
    if outside.all():
        raise ValueError(
            f"{raster.path} lies elsewhere than {like.path}: {raster.grid}, {like.grid}"
        )
    beyond = f"; {outside.mean():.1%} of the world lies outside of it" if outside.any() else ""
    return [f"{raster.path.name}: resampled from {raster.grid} onto the grid of the DSM{beyond}"]


def onto(like: TiffRaster, raster: TiffRaster, layer: Layer, *, peaks: bool = False) -> Layer:
    """Heights of a raster on the grid of another.

    Args:
        like: the raster of the other grid.
        raster: where the heights lie.
        layer: the heights.
        peaks: whether the highest of finer cells counts, or their mean.

    Returns:
        The layer there. Outside of the raster it is unknown; heights go on as at its rim, peaks
        are 0.
    """
    if raster.grid.matches(like.grid):
        return layer
    resampling = require("rasterio.warp", _PURPOSE).Resampling
    finer = raster.grid.cell < like.grid.cell
    how = resampling.max if peaks and finer else resampling.bilinear
    heights = _warped(raster, like, layer.heights, how, np.nan)
    unknown = _warped(raster, like, layer.unknown.astype(np.uint8), resampling.max, 255)
    outside = np.isnan(heights)
    heights = np.where(outside, 0.0, heights) if peaks else fill_linear(heights)
    return replace(layer, heights=heights, unknown=outside | (unknown != 0))


def onto_codes(like: TiffRaster, raster: TiffRaster, kinds: NDArray[np.uint8]) -> NDArray[np.uint8]:
    """Land classes (nx, ny) of a raster on the grid of another, UNKNOWN outside of it."""
    if raster.grid.matches(like.grid):
        return kinds
    nearest = require("rasterio.warp", _PURPOSE).Resampling.nearest
    found = _warped(raster, like, kinds, nearest, 255)
    return np.where(found == 255, np.uint8(LandClass.UNKNOWN), found)


def _warped(
    raster: TiffRaster, like: TiffRaster, values: NDArray[Any], how: Any, outside: float
) -> NDArray[Any]:
    rasterio = require("rasterio", _PURPOSE)
    warp = require("rasterio.warp", _PURPOSE)
    crs = [
        _SOME_CRS if each.frame.crs is None else crs_name(each.frame.crs) for each in (raster, like)
    ]
    image = np.full(like.grid.shape[::-1], outside, dtype=values.dtype)
    try:
        warp.reproject(
            np.ascontiguousarray(values.T),
            image,
            src_transform=raster.transform,
            src_crs=crs[0],
            src_nodata=outside,
            dst_transform=like.transform,
            dst_crs=crs[1],
            dst_nodata=outside,
            resampling=how,
        )
    except (rasterio.errors.RasterioError, rasterio.errors.CRSError) as error:
        raise ValueError(f"{raster.path} cannot be aligned with {like.path}: {error}") from error
    return image.T
