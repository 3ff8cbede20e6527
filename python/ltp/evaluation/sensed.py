# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Observers that keep what a flight's obstacle map held: for the figures."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp._core import GridFrame, OccupancyGrid
from ltp.brief import brief
from ltp.sim.record import fate_of

if TYPE_CHECKING:
    from ltp.sim import FlightRecord, MissionSetup, Step

_SENSED_EVERY = 1.0  # [s]


@dataclass(frozen=True)
class CellMap:
    """Cells of a grid at one moment, a copy."""

    frame: GridFrame
    columns: NDArray[np.uint64]  # (nx, ny, words): bit k of word w is level 64 w + k

    __repr__ = brief

    @staticmethod
    def of(grid: OccupancyGrid) -> "CellMap":
        """Copy a grid's cells."""
        return CellMap(grid.frame, grid.columns.copy())

    def level(self, z: float) -> NDArray[np.bool_]:
        """(nx, ny): the cells of the level that holds altitude z [m]; none outside the grid."""
        level = int(np.floor((z - self.frame.origin[2]) / self.frame.cell[2]))
        if not 0 <= level < self.frame.dims[2]:
            return np.zeros(self.columns.shape[:2], dtype=np.bool_)
        word, bit = divmod(level, 64)
        return np.asarray(self.columns[:, :, word] >> np.uint64(bit) & np.uint64(1), dtype=np.bool_)

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """(x_min, x_max, y_min, y_max) [m], as `imshow` wants it."""
        (x0, y0, _), (x1, y1, _) = self.frame.origin, self.frame.upper
        return float(x0), float(x1), float(y0), float(y1)


@dataclass(frozen=True)
class Snapshot:
    """What the planner knew and wanted at one moment."""

    time: float  # [s]
    flown: NDArray[np.float64]  # (t, 3) so far [m]
    occupied: CellMap
    blocked: CellMap
    path: NDArray[np.float64]  # (k, 3) to follow, empty if there is none [m]
    goal: NDArray[np.float64]  # (3,) of the last plan [m]
    dropped: bool  # whether this moment's answer dropped the goal

    __repr__ = brief

    @property
    def position(self) -> NDArray[np.float64]:
        """Of the UAV, (3,) [m]."""
        return np.asarray(self.flown[-1])


class SnapshotTaker:
    """Takes a snapshot whenever the planner takes up another path or retires a waypoint."""

    def __init__(self) -> None:
        self.snapshots: list[Snapshot] = []
        self._flown: list[NDArray[np.float64]] = []

    def on_start(self, setup: "MissionSetup") -> None:
        """See `Observer`."""

    def on_step(self, step: "Step") -> None:
        """See `Observer`."""
        self._flown.append(step.position)
        if not (step.path_changed or step.events):
            return
        drops = [event for event in step.events if fate_of(event) == "dropped"]
        goals = step.waypoints if len(step.waypoints) else step.position[None]
        index = min(step.waypoint_index, len(goals) - 1)
        self.snapshots.append(
            Snapshot(
                time=step.time,
                flown=np.array(self._flown),
                occupied=CellMap.of(step.map.occupied),
                blocked=CellMap.of(step.map.blocked),
                path=step.path,
                goal=np.array(drops[0].goal) if drops else goals[index],
                dropped=bool(drops),
            )
        )

    def on_end(self, record: "FlightRecord") -> None:
        """See `Observer`."""


class SensedTrace:
    """Gathers every obstacle cell that a flight sensed at its altitude, on the world's lattice."""

    def __init__(self) -> None:
        self.cell = np.ones(2)  # edges of the cells [m]
        self._found: set[tuple[int, int]] = set()
        self._next = 0.0
        self._last: Step | None = None

    @property
    def corners(self) -> NDArray[np.float64]:
        """(n, 2) south-west corners of the cells, sorted [m]."""
        cells = np.array(sorted(self._found), dtype=np.float64).reshape(-1, 2)
        return np.asarray(cells * self.cell)

    def on_start(self, setup: "MissionSetup") -> None:
        """See `Observer`."""
        self.cell = np.array(setup.config.mapping.cell)[:2]

    def on_step(self, step: "Step") -> None:
        """See `Observer`."""
        self._last = step
        if step.time < self._next - 1e-9:
            return
        self._next += _SENSED_EVERY
        self._gather(step)

    def on_end(self, record: "FlightRecord") -> None:
        """See `Observer`."""
        if self._last is not None:
            self._gather(self._last)

    def _gather(self, step: "Step") -> None:
        grid = step.map.occupied
        here = CellMap(grid.frame, grid.columns).level(float(step.position[2]))
        first = np.round(np.array(grid.frame.origin)[:2] / self.cell).astype(int)
        self._found.update(map(tuple, (np.argwhere(here) + first).tolist()))
