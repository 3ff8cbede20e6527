# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a goal can be reached at all through the true world's own cells: the judge of drops."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.world import World

from .flood import connected
from .true_grid import free_levels, true_grid

if TYPE_CHECKING:
    from ltp._core import ObstacleMapOptions

_MOST_WAYS_OUT = 500  # nearest free cells tried from a blocked one: some 20 m round it


class TrueCells:
    """The cells of a mission's lattice that a perfect and complete sensor would block.

    The cells are those of `true_grid`. Nothing of the planners is used: this is their judge.

    Args:
        world: what stands where.
        mapping: the mission's map options: edges of a cell, inflation radius.
    """

    def __init__(self, world: World, mapping: "ObstacleMapOptions") -> None:
        from ltp._core import HeightSurface

        self._grid = true_grid(world, mapping)
        frame = self._grid.frame
        self._cell, self._origin, self._dims = frame.cell, frame.origin, frame.dims
        self._surface = HeightSurface(world.surface_raster())
        self._free: dict[tuple[int, int], NDArray[np.bool_]] = {}

    def on_lattice(self, corner: ArrayLike) -> bool:
        """Whether a point (3,) [m] is a corner of these cells, but for rounding."""
        steps = np.asarray(corner, dtype=np.float64) / self._cell
        return bool(np.all(np.abs(steps - np.round(steps)) < 1e-6))

    def reachable(
        self,
        start: ArrayLike,
        goal: ArrayLike,
        *,
        below: float = math.inf,
        above: float = math.inf,
        radius: float = 0.0,
    ) -> bool:
        """Whether a walk from cell to cell leads from `start` to `goal`.

        Or, with a radius [m], to one of the cells of the goal's level whose centres are that near
        to it.

        A step goes to one of the 26 neighbours and needs every cell of its bounding box free: the
        planners' rule against cutting corners. Levels reach from `below` [m] under the lower of
        both ends to `above` [m] over the higher one. A start in a blocked cell leaves by the
        nearest free one to which nothing solid bars the straight way.
        """
        ends = np.array([start, goal], dtype=np.float64)
        cells = np.floor((ends - self._origin) / self._cell).astype(np.int64)
        heights = np.clip([ends[:, 2].min() - below, ends[:, 2].max() + above], -1e9, 1e9)
        levels = np.floor((heights - self._origin[2]) / self._cell[2]).astype(np.int64)
        top = self._dims[2] - 1
        if levels[0] > top:
            return True  # all of it above the highest roof
        low, high = int(np.clip(levels[0], 0, top)), int(np.clip(levels[1], 0, top))
        free = self._levels(low, high)
        # Beyond the ring everything is as free as the ring.
        cells[:, :2] = np.clip(cells[:, :2], 0, np.array(self._dims[:2]) - 1)
        cells[:, 2] = np.clip(cells[:, 2], low, high) - low
        goals = self._around(ends[1], cells[1], radius)
        goals = goals[free[tuple((goals + 1).T)]]
        if not len(goals):
            return False
        seed = cells[0]
        if not free[tuple(seed + 1)]:
            way_out = self._way_out(free, ends[0], low)
            if way_out is None:
                return False
            seed = way_out
        return connected(free, seed, goals)

    def _around(
        self, point: NDArray[np.float64], cell: NDArray[np.int64], radius: float
    ) -> NDArray[np.int64]:
        """The cells of a point's level whose centres are within the radius [m], and its own."""
        reach = np.ceil(radius / self._cell[:2]).astype(np.int64)
        low = np.maximum(cell[:2] - reach, 0)
        high = np.minimum(cell[:2] + reach + 1, np.array(self._dims[:2]))
        found = np.mgrid[low[0] : high[0], low[1] : high[1]].reshape(2, -1).T
        centres = self._origin[:2] + (found + 0.5) * self._cell[:2]
        near = np.linalg.norm(centres - point[:2], axis=1) <= radius
        near |= np.all(found == cell[:2], axis=1)
        levels = np.full((np.count_nonzero(near), 1), cell[2])
        return np.concatenate([found[near], levels], axis=1)

    def _way_out(
        self, free: NDArray[np.bool_], start: NDArray[np.float64], low: int
    ) -> NDArray[np.int64] | None:
        found = np.argwhere(free) - 1
        centres = self._origin + (found + (0, 0, low) + 0.5) * self._cell
        order = np.argsort(np.square(centres - start).sum(axis=1), kind="stable")
        for index in order[:_MOST_WAYS_OUT]:
            way = np.stack([start, centres[index]])
            if self._surface.first_collision(way) is None:
                return np.asarray(found[index], dtype=np.int64)
        return None

    def _levels(self, low: int, high: int) -> NDArray[np.bool_]:
        """Free cells of the levels low...high, with one blocked cell all round."""
        if (low, high) not in self._free:
            self._free[low, high] = free_levels(self._grid, low, high)
        return self._free[low, high]
