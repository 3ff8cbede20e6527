# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a goal can be reached at all through the true world's own cells: the judge of drops."""

import math
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.world import World

from .flood import connected

if TYPE_CHECKING:
    from ltp._core import ObstacleMapOptions

_RING = 2  # free cells kept round the world and above it: one may fly round its edge
_MOST_WAYS_OUT = 500  # nearest free cells tried from a blocked one: some 20 m round it


class TrueCells:
    """The cells of a mission's lattice that a perfect and complete sensor would block.

    The cells are those that hold any of the world's solid, inflated as the mission's map is, over
    the whole world and a free ring round it. Nothing of the planners is used: this is their judge.

    Args:
        world: what stands where.
        mapping: the mission's map options: edges of a cell, inflation radius. The lattice passes
            through the world's origin, as the map's does.
    """

    def __init__(self, world: World, mapping: "ObstacleMapOptions") -> None:
        from ltp._core import GridFrame, HeightSurface, inflate

        self._cell = np.array(mapping.cell, dtype=np.float64)
        inflation_radius = mapping.inflation_radius
        x0, y0, x1, y1 = world.extent
        reach = inflation_radius + self._cell * (1 + _RING)
        low = np.array([x0, y0, world.ground.min()]) - reach * (1.0, 1.0, 0.0)
        high = np.array([x1, y1, world.surface.max()]) + reach
        first, last = np.floor(low / self._cell), np.ceil(high / self._cell)
        self._origin = first * self._cell
        dims = [int(n) for n in last - first]
        frame = GridFrame(self._origin, self._cell, dims)
        self._surface = HeightSurface(world.surface_raster())
        occupied = self._surface.occupancy(frame)
        self._columns = inflate(occupied, inflation_radius).columns  # (nx, ny, words) uint64
        self._dims = dims
        self._free: dict[tuple[int, int], NDArray[np.bool_]] = {}

    def on_lattice(self, corner: ArrayLike) -> bool:
        """Whether a point (3,) [m] is a corner of these cells, but for rounding."""
        steps = np.asarray(corner, dtype=np.float64) / self._cell
        return bool(np.all(np.abs(steps - np.round(steps)) < 1e-6))

    def reachable(
        self, start: ArrayLike, goal: ArrayLike, *, below: float = math.inf, above: float = math.inf
    ) -> bool:
        """Whether a walk from cell to cell leads from `start` to `goal`.

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
        if not free[tuple(cells[1] + 1)]:
            return False
        seed = cells[0]
        if not free[tuple(seed + 1)]:
            way_out = self._way_out(free, ends[0], low)
            if way_out is None:
                return False
            seed = way_out
        return connected(free, seed, cells[1])

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
            shape = (self._dims[0] + 2, self._dims[1] + 2, high - low + 3)
            free = np.zeros(shape, dtype=np.bool_)
            for level in range(low, high + 1):
                word, bit = divmod(level, 64)
                blocked = self._columns[:, :, word] >> np.uint64(bit) & np.uint64(1)
                free[1:-1, 1:-1, level - low + 1] = blocked == 0
            self._free[low, high] = free
        return self._free[low, high]
