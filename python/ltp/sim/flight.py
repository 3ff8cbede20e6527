# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Flight`: a UAV over a true world, driven step by step by whoever holds it."""

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp._core import NavigationStatus, PenaltyWeights, Raster, Scan, Surface
from ltp.config import MissionConfig
from ltp.sim.decisions import DecisionLog
from ltp.sim.log import FlightLog
from ltp.sim.observer import Observer
from ltp.sim.parts import (
    FlightPlanner,
    Guidance,
    Vehicle,
    check_at,
    checked_velocity,
    default_guidance,
    default_planner,
    rest_of,
)
from ltp.sim.record import FlightRecord, Outcome
from ltp.sim.sensors import MountedLidar, Sensor, check_sensors, mapped_from, scans_of
from ltp.sim.setup import MissionSetup, checked_points
from ltp.sim.standing import Standing
from ltp.sim.step import Step, StepMaker
from ltp.sim.vehicle import PointMass
from ltp.world import World
from ltp.world.priority import seen_priority


class Flight:
    """A UAV over a true world: each `step` guides and moves it, senses, maps and plans.

    Only a collision ends a flight. Without a waypoint left it hovers, without a path it holds:
    waypoints, priority and weights may be set at any time, and count from the next step on. Between
    steps `planner`, `vehicle`, `guidance` and `sensors` are yours to look at and to exchange (a
    planner by `take_over`). The same calls give the same flight, but for wall times.

    As a context manager it ends the flight for its observers, unless something was raised.

    Args:
        world: what is really there, as for `fly`.
        config: settings of all parts that are not given.
        start: (3,), where it begins, or (n, 3): that and its first waypoints, world [m].
        sensors: mapped in this order; by default the LiDAR of the configuration.
        planner: its waypoints are replaced by the flight's; by default a `LocalTrajectoryPlanner`.
        vehicle: at the start; by default a `PointMass`.
        guidance: by default a `PathFollower`.
        priority, known_map: as for `fly`.
        observers: told of every step, in order.

    Raises:
        ValueError: for a configuration, a map, a start or sensors that cannot be flown; it is
            named.
    """

    setup: MissionSetup
    planner: FlightPlanner
    vehicle: Vehicle
    guidance: Guidance
    held: float  # for how long it has had no path [s]
    _last: Step | None
    _next: Step | None  # what is to be flown
    _watchers: tuple[Observer, ...]  # the observers, since the first step

    def __init__(
        self,
        world: World | Surface,
        config: MissionConfig,
        start: ArrayLike,
        *,
        sensors: Sequence[Sensor] | None = None,
        planner: FlightPlanner | None = None,
        vehicle: Vehicle | None = None,
        guidance: Guidance | None = None,
        priority: Raster | None = None,
        known_map: Path | str | None = None,
        observers: Sequence[Observer] = (),
    ) -> None:
        if known_map is not None and planner is not None:
            raise ValueError("known_map: expected None where a planner is given: load_map it there")
        self.setup = self._set_up(world, config, start, priority)
        self._known_map = known_map
        self.observers = observers
        self.sensors = (MountedLidar(config.lidar),) if sensors is None else tuple(sensors)
        self._begin(planner, vehicle, guidance)

    def _set_up(self, *arguments: Any) -> MissionSetup:
        return MissionSetup.at(*arguments)

    def _begin(
        self, planner: FlightPlanner | None, vehicle: Vehicle | None, guidance: Guidance | None
    ) -> None:
        """Nothing is flown yet; the parts that are not given are made."""
        setup, config = self.setup, self.setup.config
        check_sensors(self.sensors, config)
        start = setup.global_path[0]
        self.planner = default_planner(setup, self._known_map) if planner is None else planner
        self.vehicle = PointMass(start, config.vehicle) if vehicle is None else vehicle
        self.guidance = default_guidance(config) if guidance is None else guidance
        check_at(start, self.vehicle)
        given = {"planner": planner, "vehicle": vehicle, "guidance": guidance}
        self._made = {name: getattr(self, name) for name in given if given[name] is None}
        self._seconds, self._tick, self.held = config.step, 0, 0.0
        self._last, self._next, self._watchers = None, None, ()
        self._guided_by, self._ended, self._stopped = self.guidance, False, False
        self._log, self._steps = FlightLog(), StepMaker()
        self._waypoints, self._priority = setup.waypoints, setup.priority
        self._tell(self._waypoints)

    def __repr__(self) -> str:
        setup = self.setup
        return (
            f"{type(self).__name__}({setup.config.planner} over {setup.world.name!r}, "
            f"{len(self._waypoints)} waypoints; {self.outcome.value} at {self.time:.1f} s)"
        )

    def step(self, command: ArrayLike | None = None) -> Step:
        """Move as was decided last, then sense, map and plan. The first step only does the latter.

        Args:
            command: a velocity (3,) to fly instead of the guidance's [m/s].

        Returns:
            The state that this has led to: where the UAV is, and what it is going to do.

        Raises:
            RuntimeError: after a collision, or the flight's `end`.
        """
        wanted = None if command is None else checked_velocity(command)
        if self._ended or (self._last is not None and self._last.collision is not None):
            raise RuntimeError("the flight has ended: reset() begins another")
        if not self._watchers:
            self._watchers = (self._log, DecisionLog(), *self.observers)
            for observer in self._watchers:
                observer.on_start(self.setup)
        collision = self._move(wanted)
        scans: Sequence[Scan | None] = ()
        status = NavigationStatus.HOLDING if self._last is None else self._last.status
        if collision is None:
            scans = scans_of(self.sensors, self.setup, self.vehicle, self._tick)
            position = self.vehicle.position
            for scan in filter(None, scans):
                origin = mapped_from(scan, position, self.planner.map)
                self.planner.sense(origin, scan.hits, scan.misses)
            status = self.planner.update(position)
            self.held = self.held + self._seconds if status == NavigationStatus.HOLDING else 0.0
        self._last = self._next = self._steps.make(
            self.planner,
            self.vehicle,
            time=self.time,
            scans=scans,
            status=status,
            waypoints=self._waypoints,
            priority=self._priority,
            collision=collision,
        )
        for observer in self._watchers:
            observer.on_step(self._last)
        return self._last

    def _move(self, command: NDArray[np.float64] | None) -> tuple[float, float, float] | None:
        """Fly the last decision, once, for a step; where that has touched the true world [m]."""
        step, self._next = self._next, None
        if step is None:  # nothing decided yet, or interrupted while planning
            return None
        if step.path_changed:
            self.guidance.follow(step.path)
        elif self._guided_by is not self.guidance:  # it was exchanged on the way
            self.guidance.follow(rest_of(step.path, step.position))
        self._guided_by = self.guidance
        guided = self.guidance.command(step.position, step.velocity, step.map.occupied)
        self.vehicle.step(guided if command is None else command, self._seconds)
        self._tick += 1
        after = np.array(self.vehicle.position, dtype=np.float64)
        return self.setup.first_touch(step.position, after)

    def run(
        self, until: Callable[[Step], bool] | None = None, *, seconds: float = math.inf
    ) -> Step:
        """Step until told to stop, or the UAV collides; the last step. Call it again to go on.

        Args:
            until: asked after every step. By default until the waypoints are used up, or the UAV
                has held for `config.hold_limit` without a break.
            seconds: and no longer than that [s].
        """
        if not seconds > 0.0:
            raise ValueError(f"seconds = {seconds!r}: expected a positive number")
        end = self.time + seconds - 0.5 * self._seconds
        self._stopped = False
        while True:
            step = self.step()
            used_up = step.status == NavigationStatus.FINISHED
            over = used_up or self.outcome is not Outcome.STOPPED if until is None else until(step)
            if over or self._stopped or step.collision is not None or self.time >= end:
                return step

    def stop(self) -> None:
        """Let `run` return after this step: for observers."""
        self._stopped = True

    @property
    def waypoints(self) -> NDArray[np.float64]:
        """(n, 3), as set last [m]."""
        return self._waypoints

    def set_waypoints(self, waypoints: ArrayLike) -> None:
        """Replace what is left of them: (n, 3), or (3,) for one, world [m]; none: hover.

        Raises:
            ValueError: for waypoints off the world; before the first step, for a start too low.
        """
        points = checked_points("waypoints", waypoints)
        self.setup.check(points)
        if not self._watchers:  # it begins with them
            self.setup = self.setup.along(points)
        self._tell(points)
        self._steps.other_waypoints(self.planner)
        self._waypoints = points
        self.held = 0.0

    def _tell(self, waypoints: NDArray[np.float64]) -> None:
        """Give the planner its waypoints; their gates, where they are not just points."""
        gates = self.setup.gates(waypoints)
        self.planner.set_waypoints(waypoints, *([gates] if len(gates) else []))

    def set_priority(self, priority: Raster, keep_if_within: float = 0.0) -> None:
        """Fly with another priority map, as it stands.

        Args:
            priority: shares from 0 to 1.
            keep_if_within: 0: the path is given up. Else it is kept, unless a new one is better by
                more than that by Eq. 5, see `LocalTrajectoryPlanner.set_priority`.

        Raises:
            ValueError: if a value is no priority, or the margin is below 0.
        """
        seen = seen_priority(priority)
        self.planner.set_priority(seen, *([keep_if_within] if keep_if_within else []))
        self._priority = seen

    def set_weights(self, weights: PenaltyWeights, keep_if_within: float = 0.0) -> None:
        """Go on with other weights of Eq. 5; map and waypoints stay.

        Args:
            weights: of length and priority.
            keep_if_within: as in `set_priority`.

        Raises:
            ValueError: for weights that are none, or a margin below 0.
        """
        self.planner.set_weights(weights, *([keep_if_within] if keep_if_within else []))

    def take_over(self, planner: FlightPlanner) -> None:
        """Another planner goes on, with the waypoints that are left and what it knows itself."""
        left = self._waypoints[self.planner.waypoint_index :]
        self.planner = planner
        self.set_waypoints(left)

    def reset(
        self,
        *,
        planner: FlightPlanner | None = None,
        vehicle: Vehicle | None = None,
        guidance: Guidance | None = None,
    ) -> None:
        """Begin another flight as this one began: start and first waypoints, and `known_map`.

        Parts of your own remember the flight: `ValueError`, unless new ones are given.
        """
        for name, part in {"planner": planner, "vehicle": vehicle, "guidance": guidance}.items():
            if part is None and getattr(self, name) is not self._made.get(name):
                raise ValueError(f"{name} = None: expected a new one, as the last was given, too")
        self._begin(planner, vehicle, guidance)

    @property
    def time(self) -> float:
        """Since the start [s]."""
        return self._tick * self._seconds

    @property
    def outcome(self) -> Outcome:
        """How the flight ends if it ends now; `STOPPED` while it is under way."""
        return self._standing().outcome

    def _standing(self) -> Standing:
        return Standing(self.setup, self._last, self.held, self._log.waypoints)

    def record(self) -> FlightRecord:
        """The record so far; the flight goes on. `RuntimeError` before the first step.

        Its global path is the start, the waypoints reached and dropped, and what is left.
        """
        if self._last is None:
            raise RuntimeError("nothing was flown yet: step() first")
        standing = self._standing()
        return self._log.record(standing.outcome, self._last.collision, standing.reason)

    def end(self) -> FlightRecord:
        """End the flight and tell its observers; the record."""
        record = self.record()
        if not self._ended:
            self._ended = True
            for observer in self._watchers:
                observer.on_end(record)
        return record

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if kind is None and self._last is not None:
            self.end()
