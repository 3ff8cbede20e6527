# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightLog`: an observer that gathers a flight step by step and makes its record."""

import itertools

import numpy as np
from numpy.typing import NDArray

from ltp._core import InsertStatistics, ObstacleMap, Raster, tally
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEntry
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step

_CLEARANCE_HORIZON = 50.0  # the sensor's range; farther obstacles do not matter [m]


class FlightLog:
    """Remembers what happened; knows nothing of why."""

    _setup: MissionSetup  # since the start
    _gate_radii: NDArray[np.float64]  # of the waypoints that are flown [m]

    def __init__(self) -> None:
        self._times: list[float] = []
        self._positions: list[NDArray[np.float64]] = []
        self._velocities: list[NDArray[np.float64]] = []
        self._plan_index: list[int] = []
        self._waypoint_index: list[int] = []
        self._plans: list[PlanEntry] = []
        self.waypoints: list[WaypointEntry] = []  # reached and dropped so far
        self._given: NDArray[np.float64] | None = None  # waypoints that are flown
        self._before = 0  # how many of the entries are about waypoints given earlier
        self._global_path: NDArray[np.float64] = np.empty((0, 3))
        self._map: ObstacleMap | None = None  # of the last step; its counts are those of all scans
        self._counts: list[tuple[InsertStatistics, list[str]]] = []  # of maps that were given up
        self._priorities: list[tuple[int, Raster]] = []  # each from a step on

    def on_start(self, setup: MissionSetup) -> None:
        """See `Observer`."""
        self._setup = setup

    def on_step(self, step: Step) -> None:
        """See `Observer`."""
        if step.waypoints is not self._given:
            self._take_up(step.waypoints)
        if not self._priorities or step.priority is not self._priorities[-1][1]:
            self._priorities.append((len(self._times), step.priority))
        if step.map is not self._map:
            self._counts = self._counted()
            self._map = step.map
        before = self._before
        self._plans += [PlanEntry.of(answer, step.time, before) for answer in step.plans]
        self.waypoints += [
            WaypointEntry.of(event, step.time, before, float(self._gate_radii[event.index]))
            for event in step.events
        ]
        self._times.append(step.time)
        self._positions.append(step.position)
        self._velocities.append(step.velocity)
        self._plan_index.append(len(self._plans) - 1)
        self._waypoint_index.append(before + step.waypoint_index)

    def on_end(self, record: FlightRecord) -> None:
        """See `Observer`."""

    def _take_up(self, waypoints: NDArray[np.float64]) -> None:
        """The global path goes on along other waypoints; those not come to are no part of it."""
        self._given, self._before = waypoints, len(self.waypoints)
        self._gate_radii = self._setup.gate_radii(waypoints)
        flown = np.array([entry.goal for entry in self.waypoints]).reshape(-1, 3)
        self._global_path = np.concatenate([self._setup.global_path[:1], flown, waypoints])

    def _counted(self) -> list[tuple[InsertStatistics, list[str]]]:
        """What became of the points sensed, and which losses are worth a word, of each map."""
        if self._map is None:
            return self._counts
        totals = self._map.totals
        return [*self._counts, (totals, totals.warnings(self._map.options))]

    def _mean_priority(self, positions: NDArray[np.float64]) -> float:
        """Along the positions (t, 3), each stretch by the map that it was flown with."""
        begins = [begin for begin, _ in self._priorities]
        pieces = [
            tally(positions[begin : end + 1], priority)
            for (begin, priority), end in zip(
                self._priorities, [*begins[1:], len(positions) - 1], strict=True
            )
        ]
        length = sum(piece.length for piece in pieces)
        if len(pieces) == 1 or length == 0.0:
            return pieces[-1].mean_priority
        return sum(piece.priority for piece in pieces) / length

    def record(
        self,
        outcome: Outcome,
        collision: tuple[float, float, float] | None,
        reason: str = "",
    ) -> FlightRecord:
        """The record of the flight so far.

        Args:
            outcome: how it ended.
            collision: where the true world was touched, if it was [m].
            reason: why it ended so.
        """
        setup, positions = self._setup, np.array(self._positions)
        length = tally(positions, setup.priority).length
        counted = self._counted()
        clearance = setup.surface.clearance(positions, _CLEARANCE_HORIZON)
        return FlightRecord(
            config=setup.config,
            world_name=setup.world.name,
            attribution=setup.world.attribution,
            global_path=self._global_path,
            times=np.array(self._times),
            positions=positions,
            velocities=np.array(self._velocities),
            plan_index=np.array(self._plan_index, dtype=np.int64),
            waypoint_index=np.array(self._waypoint_index, dtype=np.int64),
            waypoints=list(self.waypoints),
            plans=list(self._plans),
            outcome=outcome,
            collision=collision,
            min_clearance=float(clearance.min()),
            mean_priority=self._mean_priority(positions),
            length=length,
            reason=reason,
            map_totals={
                name: sum(getattr(totals, name) for totals, _ in counted)
                for name in InsertStatistics.__fields__
            },
            map_losses=list(itertools.chain.from_iterable(words for _, words in counted)),
        )
