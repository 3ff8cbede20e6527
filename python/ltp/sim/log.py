# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightLog`: gathers a flight step by step and makes its record."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp._core import LocalTrajectoryPlanner, tally
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEvent
from ltp.sim.vehicle import PointMass

if TYPE_CHECKING:
    from ltp.sim.mission import Mission

_CLEARANCE_HORIZON = 50.0  # the sensor's range; farther obstacles do not matter [m]


class FlightLog:
    """Remembers what happened; knows nothing of why."""

    def __init__(self, planner: LocalTrajectoryPlanner) -> None:
        self._planner = planner
        self._times: list[float] = []
        self._positions: list[NDArray[np.float64]] = []
        self._velocities: list[NDArray[np.float64]] = []
        self._plan_index: list[int] = []
        self._waypoint_index: list[int] = []
        self._plans: list[PlanEntry] = []
        self._events: list[WaypointEvent] = []
        self._plans_made = 0
        self._path_id = -1

    def note(self, time: float, vehicle: PointMass) -> bool:
        """Note one step. Returns whether the planner has taken up another path."""
        planner = self._planner
        self._note_events(time)
        if planner.plans_made != self._plans_made:
            self._plans_made = planner.plans_made
            self._note_plans(time)
        self._times.append(time)
        self._positions.append(vehicle.position)
        self._velocities.append(vehicle.velocity)
        self._plan_index.append(len(self._plans) - 1)
        self._waypoint_index.append(planner.waypoint_index)
        changed = planner.path_id != self._path_id
        self._path_id = planner.path_id
        return changed

    def _note_plans(self, time: float) -> None:
        for answer in self._planner.plans:
            plan = answer.plan
            self._plans.append(
                PlanEntry(
                    time=time,
                    waypoint=answer.waypoint,
                    status=plan.status.name.lower(),
                    path=plan.path,
                    penalty=plan.penalty,
                    length=plan.tally.length,
                    priority=plan.tally.priority,
                    direct_length=answer.direct_length,
                    expanded=plan.stats.expanded,
                    seconds=plan.stats.seconds,
                )
            )

    def _note_events(self, time: float) -> None:
        if self._planner.events_count == len(self._events):
            return
        for event in self._planner.events[len(self._events) :]:
            self._events.append(
                WaypointEvent(
                    index=event.index,
                    outcome="reached" if event.reached else "dropped",
                    reason="" if event.reached else event.reason.name.lower(),
                    time=time,
                    position=_point(event.position),
                    goal=_point(event.goal),
                    window_origin=_point(event.window_origin),
                )
            )

    def record(
        self,
        mission: "Mission",
        outcome: Outcome,
        collision: tuple[float, float, float] | None,
    ) -> FlightRecord:
        """The record of the flight so far."""
        positions = np.array(self._positions)
        flown = tally(positions, mission.priority)
        clearance = mission.surface.clearance(positions, _CLEARANCE_HORIZON)
        return FlightRecord(
            config=mission.config,
            world_name=mission.world.name,
            attribution=mission.world.attribution,
            global_path=mission.global_path,
            times=np.array(self._times),
            positions=positions,
            velocities=np.array(self._velocities),
            plan_index=np.array(self._plan_index, dtype=np.int64),
            waypoint_index=np.array(self._waypoint_index, dtype=np.int64),
            waypoints=self._events,
            plans=self._plans,
            outcome=outcome,
            collision=collision,
            min_clearance=float(clearance.min()),
            mean_priority=flown.mean_priority,
            length=flown.length,
        )


def _point(values: NDArray[np.float64]) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
