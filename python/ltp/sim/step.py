# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Step`: all that one step of a mission brought, made once for everybody who watches."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ltp._core import (
    LocalTrajectoryPlanner,
    NavigationReason,
    NavigationStatus,
    ObstacleMap,
    PlanRecord,
    Scan,
    WaypointEvent,
)
from ltp.brief import brief
from ltp.sim.vehicle import PointMass


@dataclass(frozen=True, eq=False, slots=True)
class Step:
    """The state of a mission after a step's plan, before the vehicle moves; world ENU."""

    time: float  # since the start [s]
    position: NDArray[np.float64]  # (3,), of the UAV [m]
    velocity: NDArray[np.float64]  # (3,), of the UAV [m/s]
    scan: Scan | None  # None: the UAV has collided, and nothing was sensed or planned any more
    status: NavigationStatus
    reason: NavigationReason  # why it holds or escapes, or that all waypoints were dropped
    path: NDArray[np.float64]  # (k, 3), to follow from here; k = 0: stay [m]
    path_changed: bool  # since the step before
    waypoint_index: int  # the waypoint flown to
    plans: Sequence[PlanRecord]  # the planner's new answers
    events: Sequence[WaypointEvent]  # waypoints newly reached or dropped
    map: ObstacleMap  # a view of the planner's: it changes with the next step

    __repr__ = brief


class StepMaker:
    """Makes the steps of one flight: it knows what the planner had to say before."""

    def __init__(self, planner: LocalTrajectoryPlanner, vehicle: PointMass) -> None:
        self._planner = planner
        self._vehicle = vehicle
        self._plans_made = 0
        self._events_count = 0
        self._path_id = -1
        self._path: NDArray[np.float64] = np.empty((0, 3))

    def make(self, time: float, scan: Scan | None, status: NavigationStatus) -> Step:
        """The step at a time [s], from what planner and vehicle are now."""
        planner, vehicle = self._planner, self._vehicle
        plans = planner.plans if planner.plans_made != self._plans_made else ()
        fresh = planner.events_count != self._events_count
        events = planner.events[self._events_count :] if fresh else ()
        changed = planner.path_id != self._path_id
        if changed:
            self._path = planner.path
        self._plans_made = planner.plans_made
        self._events_count = planner.events_count
        self._path_id = planner.path_id
        return Step(
            time=time,
            position=vehicle.position,
            velocity=vehicle.velocity,
            scan=scan,
            status=status,
            reason=planner.reason,
            path=self._path,
            path_changed=changed,
            waypoint_index=planner.waypoint_index,
            plans=plans,
            events=events,
            map=planner.map,
        )
