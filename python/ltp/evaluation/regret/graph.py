# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`LegGraph`: the planners' graph over known ground, searched by code that is none of theirs.

Cells, steps and vertices are those of docs/method.md, section 2; the search is label correcting,
a whole front at a time. The planners answer one goal; this answers every cell of a gate at once.
"""

import math
from typing import NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from ltp._core import GridFrame, OccupancyGrid, Raster, tally

from ..campaign.flood import step_boxes
from ..campaign.true_grid import free_levels

Cells = NDArray[np.int64]
Costs = NDArray[np.float64]

_TURNS = 4.0  # least steps whose costs are spread at once: wider costs repeats, narrower more turns


class Space(NamedTuple):
    """The altitudes [m] and the levels of a grid that are open to a leg."""

    lowest: float
    highest: float
    low: int
    high: int

    @classmethod
    def between(
        cls, frame: GridFrame, ends: tuple[float, float], band: tuple[float, float]
    ) -> Self:
        """The levels that hold more of the band than a face, and those of both ends.

        Args:
            frame: of the grid.
            ends: altitudes of the leg's two ends [m].
            band: (below, above): how far it may go under the lower and over the higher one [m].
        """
        below, above = max(min(ends) - band[0], -1e9), min(max(ends) + band[1], 1e9)
        height, bottom = float(frame.cell[2]), float(frame.origin[2])
        first, last = (math.floor((z - bottom) / height) for z in (min(ends), max(ends)))
        first = min(first, math.floor((below - bottom) / height + 1e-9))
        last = max(last, math.ceil((above - bottom) / height - 1e-9) - 1)
        return cls(below, above, *(min(max(n, 0), frame.dims[2] - 1) for n in (first, last)))


class LegGraph:
    """The cells open to one leg, with what a step between their vertices costs.

    Cells are numbered in the flat array of `shape`, which has one blocked cell all round.

    Args:
        grid: the blocked cells.
        columns: the priority, a value for each column of the grid: see `onto_columns`.
        space: the altitudes and levels that the leg may use.
    """

    def __init__(
        self,
        grid: OccupancyGrid,
        columns: Raster,
        space: Space,
    ) -> None:
        frame = grid.frame
        self._origin, self._cell = frame.origin, frame.cell
        self._low = space.low
        free = free_levels(grid, space.low, space.high)
        self.shape = free.shape
        self.free = free.reshape(-1)
        levels = np.arange(self.shape[2]) - 1 + self._low
        middles = self._origin[2] + (levels + 0.5) * self._cell[2]
        self._z = np.clip(middles, space.lowest, space.highest)
        steps = step_boxes(self.shape)
        self._offsets = np.array([offset for offset, _ in steps])
        self._legal = self._legal_steps([box for _, box in steps])  # (cells,), a bit a step
        self._lengths = self._step_lengths()  # (steps, levels)
        self._columns = columns
        x, y = (
            self._origin[a] + (np.arange(n) - 0.5) * self._cell[a]
            for a, n in enumerate(self.shape[:2])
        )
        priority = columns.at(*np.meshgrid(x, y, indexing="ij"))
        self._priority = np.asarray(priority, dtype=np.float64).reshape(-1)  # (columns,)
        self.best_priority = float(self._priority.max())

    def cell_of(self, point: NDArray[np.float64]) -> int:
        """The number of the cell that holds a point (3,) [m].

        Raises:
            ValueError: if the point is outside the grid or the leg's levels.
        """
        cell = np.floor((point - self._origin) / self._cell).astype(int)
        i, j, k = cell + np.array([1, 1, 1 - self._low])
        inside = all(0 < n < size - 1 for n, size in zip((i, j, k), self.shape, strict=True))
        if not inside:
            raise ValueError(f"point {point.tolist()} is outside the leg's cells")
        return int(np.ravel_multi_index((i, j, k), self.shape))

    def vertices(self, cells: Cells) -> NDArray[np.float64]:
        """The points (n, 3) [m] that paths run through."""
        i, j, k = np.unravel_index(cells, self.shape)
        x, y = (self._origin[a] + (n - 0.5) * self._cell[a] for a, n in enumerate((i, j)))
        return np.column_stack([x, y, self._z[k]])

    def gate(self, waypoint: NDArray[np.float64], radius: float) -> Cells:
        """The free cells that serve a waypoint (3,): on its level, their vertices within `radius`
        [m] of it, horizontally; its own cell always.
        """
        own = self.cell_of(waypoint)
        i, j, k = np.unravel_index(own, self.shape)
        reach = np.ceil(radius / self._cell[:2]).astype(int) + 1
        low = np.maximum(np.array([i, j]) - reach, 1)
        high = np.minimum(np.array([i, j]) + reach, np.array(self.shape[:2]) - 2)
        square = np.meshgrid(*(np.arange(a, b + 1) for a, b in zip(low, high, strict=True)))
        cells = np.ravel_multi_index((square[0], square[1], np.full_like(square[0], k)), self.shape)
        cells = np.unique(cells)
        away = np.linalg.norm(self.vertices(cells)[:, :2] - waypoint[:2], axis=1)
        cells = cells[(away <= radius) | (cells == own)]
        return np.asarray(cells[self.free[cells]])

    def same_cells(self, cells: Cells, other: "LegGraph") -> Cells:
        """The numbers here of another leg's cells; all of them must be open to both."""
        i, j, k = np.unravel_index(cells, other.shape)
        return np.asarray(np.ravel_multi_index((i, j, k + other._low - self._low), self.shape))

    def from_point(self, start: NDArray[np.float64], alpha: float) -> tuple[Cells, Costs]:
        """Where the first step from a point (3,) leads and what it costs; nothing if it is blocked.

        The path begins at the point itself, wherever in its cell that is.
        """
        own = self.cell_of(start)
        if not self.free[own]:
            return np.empty(0, dtype=np.int64), np.empty(0)
        cells = np.append(self._all_steps(np.array([own]))[1], own)
        steps = [tally(np.array([start, end]), self._columns) for end in self.vertices(cells)]
        return cells, np.array([alpha * step.length - step.priority for step in steps])

    def from_gate(
        self, cells: Cells, points: NDArray[np.float64], costs: Costs, alpha: float
    ) -> tuple[Cells, Costs, Cells]:
        """Where the first steps from a gate lead, at what least costs, and from which of its cells.

        The gate's vertices may lie at other altitudes in the leg before: the first step begins
        there, or leads up or down to this leg's vertex of the same cell.

        Args:
            cells: of the gate, their numbers here.
            points: (n, 3), their vertices in the leg before [m].
            costs: so far.
            alpha: above the largest priority.
        """
        depth = self.shape[2]
        places, ends, _ = self._all_steps(cells)
        places = np.concatenate([places, np.arange(len(cells))])
        ends = np.concatenate([ends, cells])
        lengths = np.linalg.norm(self.vertices(ends) - points[places], axis=1)
        halves = self._priority[cells[places] // depth] + self._priority[ends // depth]
        values = costs[places] + lengths * (alpha - 0.5 * halves)
        order = np.argsort(values, kind="stable")
        ends, first = np.unique(ends[order], return_index=True)
        return ends, values[order][first], places[order][first]

    def spread(self, cells: Cells, costs: Costs, alpha: float, until: Cells) -> Costs:
        """The least cost at every cell, (number of cells,): sum of (alpha - p) dl from any of
        `cells`, which begin with `costs`; inf where none leads.

        It ends when all of `until` are settled: beyond them costs may still be too high.
        """
        best = np.full(self.free.shape, np.inf)
        np.minimum.at(best, cells, costs)
        waiting = np.unique(cells)
        known = np.zeros(best.shape, dtype=np.bool_)  # those waiting, for a moment
        places = np.empty(best.shape, dtype=np.int64)
        width = _TURNS * (alpha - self.best_priority) * float(self._cell.min())
        while len(waiting):
            least = best[waiting].min()
            if least > best[until].max(initial=-np.inf):
                break
            turn = best[waiting] < least + width
            front, waiting = waiting[turn], waiting[~turn]
            of, ends, steps = self._all_steps(front)
            begins = front[of]
            values = best[begins] + self._cost(begins, ends, steps, alpha)
            better = values < best[ends] - 1e-12
            ends, values = ends[better], values[better]
            np.minimum.at(best, ends, values)
            ends = ends[values == best[ends]]
            known[waiting] = True
            ends = ends[~known[ends]]
            known[waiting] = False
            places[ends] = np.arange(len(ends))  # of each cell the last
            waiting = np.append(waiting, ends[places[ends] == np.arange(len(ends))])
        return best

    def trace(self, best: Costs, sources: dict[int, float], end: int, alpha: float) -> Cells:
        """The cells of a least path, from a source to `end`."""
        cells = [end]
        while not sources.get(cells[-1], math.inf) <= best[cells[-1]] + 1e-9:
            here = np.array([cells[-1]])
            places, ends, steps = self._all_steps(here)
            values = best[ends] + self._cost(here[places], ends, steps, alpha)
            cells.append(int(ends[np.argmin(values)]))
        return np.array(cells[::-1])

    def _all_steps(self, cells: Cells) -> tuple[Cells, Cells, Cells]:
        """Every legal step from cells: from which of them, where to, which step."""
        numbers = np.arange(len(self._offsets), dtype=np.uint32)[:, None]
        steps, places = np.nonzero(self._legal[cells] >> numbers & 1)
        return places, cells[places] + self._offsets[steps], steps

    def _cost(self, begins: Cells, ends: Cells, steps: Cells, alpha: float) -> Costs:
        """Half of a step lies in either cell: a diagonal crosses where they touch."""
        depth = self.shape[2]
        halves = self._priority[begins // depth] + self._priority[ends // depth]
        return np.asarray(self._lengths[steps, begins % depth] * (alpha - 0.5 * halves))

    def _legal_steps(self, boxes: list[list[int]]) -> NDArray[np.uint32]:
        """Which steps may begin in a cell: every cell of their bounding box is free."""
        bits = np.zeros(self.free.shape, dtype=np.uint32)
        for number, box in enumerate(boxes):
            legal = self.free.copy()
            for offset in box:
                legal &= np.roll(self.free, -offset)
            bits |= legal.astype(np.uint32) << np.uint32(number)
        return bits

    def _step_lengths(self) -> NDArray[np.float64]:
        """Vertices need not lie at the middle of their level, where the altitudes end in it."""
        nz, row = self.shape[2], self.shape[1] * self.shape[2]
        lengths = np.empty((len(self._offsets), nz))
        for number, offset in enumerate(self._offsets):
            i = round(offset / row)
            j = round((offset - i * row) / nz)
            climb = offset - i * row - j * nz
            rise = np.roll(self._z, -climb) - self._z
            flat = (i * self._cell[0]) ** 2 + (j * self._cell[1]) ** 2
            lengths[number] = np.sqrt(flat + rise**2)
        return lengths
