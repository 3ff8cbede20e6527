# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The true world as cells: what a mission's map would hold if its sensor had seen everything."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp.world import World

if TYPE_CHECKING:
    from ltp._core import ObstacleMapOptions, OccupancyGrid

_RING = 2  # free cells kept round the world and above it: one may fly round its edge


def true_grid(
    world: World,
    mapping: "ObstacleMapOptions",
    heights: tuple[float, float] = (math.inf, -math.inf),
) -> "OccupancyGrid":
    """The cells of a mission's lattice that a perfect and complete sensor would block.

    Blocked are the cells within the map's clearance of the voxels (or of the whole cells, if the
    map inflates those) that hold any of the world's solid, over the whole world and a free ring
    round it.

    Args:
        world: what stands where.
        mapping: the mission's map options: edges of a cell, what is inflated, and how far. The
            lattice passes through the world's origin, as the map's does.
        heights: (lowest, highest) [m] that the grid holds too, where the world ends before.
    """
    from ltp._core import GridFrame, HeightSurface, inflate

    cell = np.array(mapping.cell, dtype=np.float64)
    x0, y0, x1, y1 = world.extent
    clearance = mapping.inflation_radius + mapping.margin
    reach = clearance + cell * (1 + _RING)
    bottom = min(float(world.ground.min()), heights[0])
    top = max(float(world.surface.max()), heights[1])
    first = np.floor((np.array([x0, y0, bottom]) - reach * (1.0, 1.0, 0.0)) / cell)
    last = np.ceil((np.array([x1, y1, top]) + reach) / cell)
    source = cell if mapping.inflate_whole_cells else cell.min()
    parts = [round(n) for n in np.broadcast_to(cell / source, 3)]
    sources = [int(n) * k for n, k in zip(last - first, parts, strict=True)]
    frame = GridFrame(first * cell, cell / parts, sources)
    occupied = HeightSurface(world.surface_raster()).occupancy(frame)
    return inflate(occupied, clearance, parts)


def free_levels(grid: "OccupancyGrid", low: int, high: int) -> NDArray[np.bool_]:
    """Free cells of the levels low...high of a grid, with one blocked cell all round."""
    nx, ny, _ = grid.frame.dims
    free = np.zeros((nx + 2, ny + 2, high - low + 3), dtype=np.bool_)
    columns = grid.columns  # (nx, ny, words) uint64
    for level in range(low, high + 1):
        word, bit = divmod(level, 64)
        blocked = columns[:, :, word] >> np.uint64(bit) & np.uint64(1)
        free[1:-1, 1:-1, level - low + 1] = blocked == 0
    return free
