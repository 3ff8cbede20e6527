# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Step`: all that one step of a flight brought, made once for everybody who watches."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ltp._core import (
    NavigationReason,
    NavigationStatus,
    ObstacleMap,
    PlanRecord,
    Raster,
    Scan,
    WaypointEvent,
)
from ltp.brief import brief
from ltp.sim.parts import FlightPlanner, Vehicle


@dataclass(frozen=True, eq=False, slots=True)
class Step:
    """The state of a flight after a step's plan, before the vehicle moves; world ENU."""

    time: float  # since the start [s]
    position: NDArray[np.float64]  # (3,), of the UAV [m]
    velocity: NDArray[np.float64]  # (3,), of the UAV [m/s]
    scans: Sequence[Scan | None]  # one a sensor, None where none was due; (): it has collided
    status: NavigationStatus
    reason: NavigationReason  # why it holds or escapes, or that all waypoints were dropped
    path: NDArray[np.float64]  # (k, 3), to follow from here; k = 0: stay [m]
    path_changed: bool  # since the step before
    waypoints: NDArray[np.float64]  # (n, 3), what is flown; the same object until others are set
    waypoint_index: int  # the waypoint flown to
    plans: Sequence[PlanRecord]  # the planner's new answers
    events: Sequence[WaypointEvent]  # waypoints newly reached or dropped
    map: ObstacleMap  # a view of the planner's: it changes with the next step
    priority: Raster  # the map that is flown with
    collision: tuple[float, float, float] | None = None  # where the true world was touched [m];
    # then nothing was sensed or planned any more

    __repr__ = brief

    @property
    def scan(self) -> Scan | None:
        """The first sensor's; None where none was due, or the UAV has collided."""
        return self.scans[0] if self.scans else None


class StepMaker:
    """Makes the steps of one flight: it knows what the planner had to say before."""

    def __init__(self) -> None:
        self._planner: FlightPlanner | None = None
        self._plans_made = 0
        self._events_count = 0
        self._path_id: object = None
        self._path: NDArray[np.float64] = np.empty((0, 3))

    def other_waypoints(self, planner: FlightPlanner) -> None:
        """Take note that the planner was given others: its events are about these."""
        self._events_count = planner.events_count

    def make(
        self,
        planner: FlightPlanner,
        vehicle: Vehicle,
        *,
        time: float,
        scans: Sequence[Scan | None],
        status: NavigationStatus,
        waypoints: NDArray[np.float64],
        priority: Raster,
        collision: tuple[float, float, float] | None,
    ) -> Step:
        """The step from what planner and vehicle are now; the arguments are its fields."""
        if planner is not self._planner:
            self._planner, self._path_id = planner, None
            self._plans_made = self._events_count = 0
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
            position=np.array(vehicle.position, dtype=np.float64),
            velocity=np.array(vehicle.velocity, dtype=np.float64),
            scans=scans,
            status=status,
            reason=planner.reason,
            path=self._path,
            path_changed=changed,
            waypoints=waypoints,
            waypoint_index=planner.waypoint_index,
            plans=plans,
            events=events,
            map=planner.map,
            priority=priority,
            collision=collision,
        )
