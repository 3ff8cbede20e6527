# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a goal can be reached through the true world, whatever the map's cells."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.world import World

if TYPE_CHECKING:
    pass

FINE_CELL = 0.5  # edge of a cell [m]
_MOST_CELLS = 4000  # along x or y: a larger world is judged by larger cells
_MOST_LEVELS = 4  # kept
_RING = 2  # free cells kept round the world: one may fly round its edge


class FineCells:
    """Where a vehicle fits over the solid world itself, by cells of 0.5 m.

    The world is a height field, so whoever fits at a height fits above it too: a way inside a band
    of altitudes can be lifted to the top of the band. So there is one exactly if both ends are free
    and a level flood at the top joins them. Each level is flooded once a component, however many
    drops are asked about.

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
        margin = (self._reach + 1 + _RING) * self.cell  # the outermost cells end a flood
        self._corner = np.floor((np.array([x0, y0]) - margin) / self.cell) * self.cell
        self._dims = np.ceil((np.array([x1, y1]) + margin - self._corner) / self.cell).astype(int)
        self._levels: dict[int, _Level] = {}  # the last ones asked about

    def reachable(self, start: ArrayLike, goal: ArrayLike, *, above: float = math.inf) -> bool:
        """Whether the vehicle can go from `start` to `goal` (3,) [m], at most `above` [m] over the
        higher one.

        A start that is nearer to something than the radius counts as the free cell above it where
        there is one in the band, else it reaches nothing.
        """
        ends = np.array([start, goal], dtype=np.float64)
        if not self._level(ends[1, 2]).free[self._cell_of(ends[1])]:
            return False
        top = min(ends[:, 2].max() + above, self._top + self._radius + self.cell)
        z = max(top, float(ends[:, 2].max()))
        first, last = (self._component(z, self._cell_of(end)) for end in ends)
        return first == last != 0

    def _component(self, z: float, cell: tuple[int, int]) -> int:
        """The number of the free component at height `z` [m] that a cell is in; 0 if blocked."""
        level = self._level(z)
        if level.free[cell] and not level.labels[cell]:
            level.fill(cell)
        return int(level.labels[cell])

    def _cell_of(self, point: NDArray[np.float64]) -> tuple[int, int]:
        """Beyond the ring everything is as free as the ring."""
        cell = np.floor((point[:2] - self._corner) / self.cell).astype(int)
        i, j = np.clip(cell, 1, self._dims - 2)
        return int(i), int(j)

    def _level(self, z: float) -> "_Level":
        """The level at height `z` [m]."""
        from ltp._core import GridFrame, inflate

        number = math.floor(z / self.cell)
        if number not in self._levels:
            height = 2 * self._reach + 1
            origin = (*self._corner, (number - self._reach) * self.cell)
            frame = GridFrame(origin, (self.cell,) * 3, [*map(int, self._dims), height])
            solid = inflate(self._surface.occupancy(frame), self._radius).columns
            free = solid[:, :, 0] >> np.uint64(self._reach) & np.uint64(1) == 0
            free[[0, -1]], free[:, [0, -1]] = False, False  # a flood ends there
            if len(self._levels) >= _MOST_LEVELS:
                del self._levels[next(iter(self._levels))]
            self._levels[number] = _Level(free, np.zeros(free.shape, dtype=np.int32))
        return self._levels[number]


@dataclass(frozen=True)
class _Level:
    """The cells of one height in which the vehicle fits, and their components as far as asked."""

    free: NDArray[np.bool_]  # (nx, ny)
    labels: NDArray[np.int32]  # (nx, ny) number of the component, from 1; 0: not flooded

    def fill(self, cell: tuple[int, int]) -> None:
        """Give a new number to all free cells that steps to the four neighbours reach.

        Where cutting corners is forbidden, eight neighbours reach no more.
        """
        free, labels, row = self.free.reshape(-1), self.labels.reshape(-1), self.free.shape[1]
        number = int(labels.max()) + 1
        front = np.array([cell[0] * row + cell[1]])
        steps = np.array([1, -1, row, -row])
        while len(front):
            labels[front] = number
            found = (front[:, None] + steps).reshape(-1)
            front = np.unique(found[free[found] & (labels[found] == 0)])
