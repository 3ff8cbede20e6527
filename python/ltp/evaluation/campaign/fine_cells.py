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
_LOOK = 100  # cells round both ends that are looked at first
_RING = 2  # free cells kept round the world: one may fly round its edge


class FineCells:
    """Where a vehicle fits over the solid world itself, by cells of 0.5 m.

    The world is a height field, so whoever fits at a height fits above it too: a way inside a band
    of altitudes can be lifted to the top of the band. So there is one exactly if both ends are free
    and a level flood at the top joins them. The flood first looks round the two ends, where most
    ways are found, then at the whole world; the levels of the world are kept.

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

    def reachable(
        self,
        start: ArrayLike,
        goal: ArrayLike,
        *,
        above: float = math.inf,
        radius: float = 0.0,
    ) -> bool:
        """Whether the vehicle can go from `start` to `goal` (3,) [m], at most `above` [m] over the
        higher one; with a radius [m], to a point at the goal's height that is that near to it.

        A start that is nearer to something than the radius counts as the cell above it, at the top
        of the band; if that is blocked too it reaches nothing.
        """
        ends = np.array([start, goal], dtype=np.float64)
        first, last = (self._cell_of(end) for end in ends)
        goals = self._around(ends[1], last, radius)
        if not len(goals):
            return False
        top = min(ends[:, 2].max() + above, self._top + self._radius + self.cell)
        z = max(top, float(ends[:, 2].max()))
        low = np.maximum(np.minimum(first, goals.min(axis=0)) - _LOOK, 0)
        high = np.minimum(np.maximum(first, goals.max(axis=0)) + _LOOK + 1, self._dims)
        if 4 * np.prod(high - low) < np.prod(self._dims):
            near = _Level.of(self._free(z, low, high))
            if near.joins(first - low, goals - low):
                return True
        return self._world(z).joins(first, goals)

    def _around(
        self, point: NDArray[np.float64], cell: NDArray[np.int64], radius: float
    ) -> NDArray[np.int64]:
        """The free cells (n, 2) at a point's height whose centres are within the radius, or its
        own."""
        reach = math.ceil(radius / self.cell)
        low, high = np.maximum(cell - reach, 1), np.minimum(cell + reach + 1, self._dims - 1)
        found = np.argwhere(self._free(point[2], low, high)) + low
        centres = self._corner + (found + 0.5) * self.cell
        near = np.linalg.norm(centres - point[:2], axis=1) <= radius
        return np.asarray(found[near | np.all(found == cell, axis=1)])

    def _cell_of(self, point: NDArray[np.float64]) -> NDArray[np.int64]:
        """Beyond the ring everything is as free as the ring."""
        cell = np.floor((point[:2] - self._corner) / self.cell).astype(np.int64)
        return np.clip(cell, 1, self._dims - 2)

    def _free(self, z: float, low: NDArray[np.int64], high: NDArray[np.int64]) -> NDArray[np.bool_]:
        """Where the vehicle fits at height `z` [m], of the columns from `low` to below `high`."""
        from ltp._core import GridFrame, inflate

        reach, level = self._reach, math.floor(z / self.cell)
        corner = self._corner + (low - reach) * self.cell
        origin = (*corner, (level - reach) * self.cell)
        dims = [*map(int, high - low + 2 * reach), 2 * reach + 1]
        frame = GridFrame(origin, (self.cell,) * 3, dims)
        solid = inflate(self._surface.occupancy(frame), self._radius).columns
        inside = solid[reach:-reach, reach:-reach, 0]
        return np.asarray(inside >> np.uint64(reach) & np.uint64(1) == 0)

    def _world(self, z: float) -> "_Level":
        """The whole level at height `z` [m]."""
        number = math.floor(z / self.cell)
        if number not in self._levels:
            if len(self._levels) >= _MOST_LEVELS:
                del self._levels[next(iter(self._levels))]
            whole = self._free(z, np.zeros(2, dtype=np.int64), self._dims)
            self._levels[number] = _Level.of(whole)
        return self._levels[number]


@dataclass(frozen=True)
class _Level:
    """The cells of one height in which the vehicle fits, and their components as far as asked."""

    free: NDArray[np.bool_]  # (nx, ny)
    labels: NDArray[np.int32]  # (nx, ny) number of the component, from 1; 0: not flooded

    @staticmethod
    def of(free: NDArray[np.bool_]) -> "_Level":
        """A level; a flood ends at its outermost cells."""
        free[[0, -1]], free[:, [0, -1]] = False, False
        return _Level(free, np.zeros(free.shape, dtype=np.int32))

    def joins(self, first: NDArray[np.int64], goals: NDArray[np.int64]) -> bool:
        """Whether a walk leads from a cell (2,) to one of others (n, 2)."""
        component = self._component((int(first[0]), int(first[1])))
        return component != 0 and bool(np.any(self.labels[tuple(goals.T)] == component))

    def _component(self, cell: tuple[int, int]) -> int:
        """The number of the component that a cell is in; 0 if it is blocked."""
        if self.free[cell] and not self.labels[cell]:
            self._fill(cell)
        return int(self.labels[cell])

    def _fill(self, cell: tuple[int, int]) -> None:
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
