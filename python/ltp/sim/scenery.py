# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world's rasters for a surface that has none: what pictures and viewers draw."""

import numpy as np
from numpy.typing import NDArray

from ltp._core import HeightSurface, OccupancyGrid, OctreeSurface, Surface
from ltp.world import LandClass, World


def scenery_of(surface: Surface) -> World:
    """The tops of a surface over a ground as low as its lowest point; all of unknown class."""
    if isinstance(surface, OctreeSurface):
        grid = surface.voxels
        tops, bottom = _tops(grid), float(grid.frame.origin[2])
        tops = np.where(np.isnan(tops), bottom, tops)
        x, y, _ = (float(value) for value in grid.frame.origin)
        return _world("octree", tops, bottom, surface.resolution, x, y)
    if isinstance(surface, HeightSurface):
        raster = surface.heights
        tops = np.asarray(raster.values)
        x, y = (float(value) for value in raster.origin)
        return _world("heights", tops, float(tops.min()), raster.cell, x, y)
    return _world("surface", np.zeros((1, 1)), 0.0, 1.0, 0.0, 0.0)


def _world(
    name: str, tops: NDArray[np.float64], bottom: float, cell: float, x: float, y: float
) -> World:
    return World(
        name,
        ground=np.full(tops.shape, bottom),
        surface=tops,
        classes=np.full(tops.shape, LandClass.UNKNOWN, dtype=np.uint8),
        cell=cell,
        origin=(x, y),
    )


def _tops(grid: OccupancyGrid) -> NDArray[np.float64]:
    """(nx, ny): upper face of each column's highest occupied cell [m]; NaN where there is none."""
    nx, ny, nz = grid.frame.dims
    bottom, height = float(grid.frame.origin[2]), float(grid.frame.cell[2])
    tops = np.full((nx, ny), np.nan)
    for level in range(nz):
        occupied = (grid.columns[:, :, level // 64] >> np.uint64(level % 64)) & np.uint64(1)
        tops[occupied.astype(bool)] = bottom + (level + 1) * height
    return tops
