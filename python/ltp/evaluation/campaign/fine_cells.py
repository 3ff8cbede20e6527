# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a goal can be reached through the true world, whatever the map's cells."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.world import World

from .flood import connected

if TYPE_CHECKING:
    pass

FINE_CELL = 0.5  # edge of a cell [m]
_MOST_CELLS = 4000  # along x or y: a larger world is judged by larger cells
_RING = 2  # free cells kept round the world: one may fly round its edge


class FineCells:
    """Where a vehicle fits over the solid world itself, by cells of 0.5 m.

    The world is a height field, so whoever fits at a height fits above it too: a way inside a band
    of altitudes can be lifted to the top of the band. So there is one exactly if both ends are free
    and a level flood at the top joins them.

    Args:
        world: what stands where.
        radius: of the vehicle [m]: a cell is free if no solid is nearer to it.
    """

    def __init__(self, world: World, radius: float) -> None:
        from ltp._core import HeightSurface

        x0, y0, x1, y1 = world.extent
        self.cell = max(FINE_CELL, max(x1 - x0, y1 - y0) / _MOST_CELLS)
        self._surface: HeightSurface = HeightSurface(world.surface_raster())
        self._radius = radius
        self._top = float(world.surface.max())
        self._reach = math.ceil(radius / self.cell) + 1  # cells that inflation can span
        margin = (self._reach + _RING) * self.cell
        self._corner = np.floor((np.array([x0, y0]) - margin) / self.cell) * self.cell
        self._dims = np.ceil((np.array([x1, y1]) + margin - self._corner) / self.cell).astype(int)
        self._levels: dict[int, NDArray[np.bool_]] = {}

    def reachable(self, start: ArrayLike, goal: ArrayLike, *, above: float = math.inf) -> bool:
        """Whether the vehicle can go from `start` to `goal` (3,) [m], at most `above` [m] over the
        higher one.

        A start that is nearer to something than the radius counts as the free cell above it where
        there is one in the band, else it reaches nothing.
        """
        ends = np.array([start, goal], dtype=np.float64)
        if not self._free(ends[1, 2])[self._cell_of(ends[1])]:
            return False
        top = min(ends[:, 2].max() + above, self._top + self._radius + self.cell)
        free = self._free(max(top, ends[:, 2].max()))
        cells = [self._cell_of(end) for end in ends]
        if not free[cells[0]]:
            return False
        padded = np.zeros((free.shape[0] + 2, free.shape[1] + 2, 3), dtype=np.bool_)
        padded[1:-1, 1:-1, 1] = free
        first, last = (np.array([*cell, 0]) for cell in cells)
        return connected(padded, first, last)

    def _cell_of(self, point: NDArray[np.float64]) -> tuple[int, int]:
        """Beyond the ring everything is as free as the ring."""
        cell = np.floor((point[:2] - self._corner) / self.cell).astype(int)
        i, j = np.clip(cell, 0, self._dims - 1)
        return int(i), int(j)

    def _free(self, z: float) -> NDArray[np.bool_]:
        """(nx, ny) cells of the level at height `z` [m] in which the vehicle fits."""
        from ltp._core import GridFrame, inflate

        level = math.floor(z / self.cell)
        if level not in self._levels:
            height = 2 * self._reach + 1
            origin = (*self._corner, (level - self._reach) * self.cell)
            frame = GridFrame(origin, (self.cell,) * 3, [*map(int, self._dims), height])
            solid = inflate(self._surface.occupancy(frame), self._radius).columns
            blocked = solid[:, :, 0] >> np.uint64(self._reach) & np.uint64(1)
            self._levels[level] = blocked == 0
        return self._levels[level]
