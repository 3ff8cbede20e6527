# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightLog`: an observer that gathers a flight step by step and makes its record."""

import numpy as np
from numpy.typing import NDArray

from ltp._core import tally
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEntry
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step

_CLEARANCE_HORIZON = 50.0  # the sensor's range; farther obstacles do not matter [m]


class FlightLog:
    """Remembers what happened; knows nothing of why."""

    _setup: MissionSetup  # since the start

    def __init__(self) -> None:
        self._times: list[float] = []
        self._positions: list[NDArray[np.float64]] = []
        self._velocities: list[NDArray[np.float64]] = []
        self._plan_index: list[int] = []
        self._waypoint_index: list[int] = []
        self._plans: list[PlanEntry] = []
        self._waypoints: list[WaypointEntry] = []

    def on_start(self, setup: MissionSetup) -> None:
        """See `Observer`."""
        self._setup = setup

    def on_step(self, step: Step) -> None:
        """See `Observer`."""
        self._plans += [PlanEntry.of(answer, step.time) for answer in step.plans]
        self._waypoints += [WaypointEntry.of(event, step.time) for event in step.events]
        self._times.append(step.time)
        self._positions.append(step.position)
        self._velocities.append(step.velocity)
        self._plan_index.append(len(self._plans) - 1)
        self._waypoint_index.append(step.waypoint_index)

    def on_end(self, record: FlightRecord) -> None:
        """See `Observer`."""

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
        flown = tally(positions, setup.priority)
        clearance = setup.surface.clearance(positions, _CLEARANCE_HORIZON)
        return FlightRecord(
            config=setup.config,
            world_name=setup.world.name,
            attribution=setup.world.attribution,
            global_path=setup.global_path,
            times=np.array(self._times),
            positions=positions,
            velocities=np.array(self._velocities),
            plan_index=np.array(self._plan_index, dtype=np.int64),
            waypoint_index=np.array(self._waypoint_index, dtype=np.int64),
            waypoints=self._waypoints,
            plans=self._plans,
            outcome=outcome,
            collision=collision,
            min_clearance=float(clearance.min()),
            mean_priority=flown.mean_priority,
            length=flown.length,
            reason=reason,
        )
