# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The simulated mission: sense, map, plan, guide, move, until the global path is flown."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from ltp._core import (
    Lidar,
    LocalTrajectoryPlanner,
    NavigationReason,
    NavigationStatus,
    Pose,
    Raster,
    Scan,
    Surface,
)
from ltp.config import MissionConfig
from ltp.sim.decisions import DecisionLog
from ltp.sim.guidance import PathFollower
from ltp.sim.log import FlightLog
from ltp.sim.observer import Observer
from ltp.sim.record import FlightRecord, Outcome
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step, StepMaker
from ltp.sim.vehicle import PointMass
from ltp.world import World


class Mission:
    """One UAV, one world, one global path."""

    def __init__(
        self,
        world: World | Surface,
        config: MissionConfig,
        global_path: ArrayLike,
        observers: Sequence[Observer] = (),
        priority: Raster | None = None,
    ) -> None:
        self.setup = MissionSetup.of(world, config, global_path, priority)
        start = self.setup.global_path[0]
        self.observers = observers
        self.lidar = Lidar(config.lidar)
        self.planner = LocalTrajectoryPlanner(
            self.setup.priority,
            start,
            planner=config.planner,
            planner_options=config.planner_options,
            map_options=config.mapping,
            options=config.navigation,
        )
        self.planner.set_waypoints(self.setup.waypoints)
        self.vehicle = PointMass(start, config.vehicle)
        self.guidance = PathFollower(
            config.vehicle.speed,
            config.vehicle.max_acceleration,
            cell=float(np.min(config.mapping.cell)),
            max_climb=config.vehicle.max_climb,
            step=config.step,
            options=config.guidance,
        )

    def __repr__(self) -> str:
        setup = self.setup
        return (
            f"Mission({setup.config.planner} over {setup.world.name!r}, "
            f"{len(setup.waypoints)} waypoints)"
        )

    def fly(self) -> FlightRecord:
        """Fly until the waypoints are used up, the time is over, or something is hit."""
        config, log = self.setup.config, FlightLog()
        steps = StepMaker(self.planner, self.vehicle)
        observers: tuple[Observer, ...] = (log, DecisionLog(), *self.observers)
        for observer in observers:
            observer.on_start(self.setup)
        outcome, collision, tick, held = None, None, 0, 0.0
        while outcome is None:
            scan = self._scan(tick)
            self.planner.sense(scan.origin, scan.hits, scan.misses)
            status = self.planner.update(self.vehicle.position)
            step = steps.make(tick * config.step, scan, status)
            for observer in observers:
                observer.on_step(step)

            held = held + config.step if status == NavigationStatus.HOLDING else 0.0
            outcome = self._outcome(step, held)
            if outcome is None:
                self._move(step)
                tick += 1
                collision = self.setup.first_touch(step.position, self.vehicle.position)
            if collision is not None:
                outcome = Outcome.COLLIDED
                step = steps.make(tick * config.step, None, status)
                for observer in observers:
                    observer.on_step(step)
        record = log.record(outcome, collision, self._reason(step, outcome, held))
        for observer in observers:
            observer.on_end(record)
        return record

    def _scan(self, tick: int) -> Scan:
        return self.lidar.scan(
            self.setup.surface,
            Pose(self.vehicle.position),
            tick,
            misses=self.setup.config.mapping.carve_free_space,
        )

    def _outcome(self, step: Step, held: float) -> Outcome | None:
        """How the flight ends here, if it does. held: for how long it has had no path [s]."""
        if step.status == NavigationStatus.FINISHED:
            reached = step.reason != NavigationReason.ALL_DROPPED
            return Outcome.REACHED if reached else Outcome.NOTHING_REACHED
        if step.time >= self.setup.time_limit or held >= self.setup.config.hold_limit:
            return Outcome.TIMED_OUT
        return None

    def _move(self, step: Step) -> None:
        if step.path_changed:
            self.guidance.follow(step.path)
        command = self.guidance.command(step.position, step.velocity, step.map.occupied)
        self.vehicle.step(command, self.setup.config.step)

    def _reason(self, step: Step, outcome: Outcome, held: float) -> str:
        """Why the flight ended as it did, a sentence without its full stop."""
        if outcome is Outcome.COLLIDED:
            return "the true world was touched"
        if outcome is Outcome.NOTHING_REACHED:
            return step.reason.text
        if outcome is Outcome.REACHED:
            reached = [event.reached for event in self.planner.events]
            if all(reached):
                return "every waypoint was reached"
            return f"{sum(reached)} of {len(reached)} waypoints were reached, the others dropped"
        if step.status == NavigationStatus.HOLDING:
            since = f" for {held:.0f} s" if held >= self.setup.config.hold_limit else ""
            return f"held{since}: {step.reason.text}"
        return f"no more time: the limit of {self.setup.time_limit:.0f} s is over"


def fly(
    world: World | Surface,
    config: MissionConfig,
    global_path: ArrayLike,
    observers: Sequence[Observer] = (),
    priority: Raster | None = None,
) -> FlightRecord:
    """Fly a mission over a world.

    Args:
        world: what is really there; the UAV learns of it through its LiDAR only. A `World`, or any
            `Surface`: an octree, a window in a wall, wires.
        config: planner, weights, sensor, map, vehicle.
        global_path: (n, 3), n >= 2, world [m]; the UAV starts at its first point, the others are
            its waypoints. It may lead through buildings.
        observers: told of every step, in order.
        priority: a priority map in [0, 1] to fly with instead of that of the world and the
            configuration; `priority_map` "lpf" averages it over the camera's footprint.
            Over a bare surface the priority is 0 unless one is given.

    Returns:
        The record of the flight; the same for the same arguments, but for wall times.

    Raises:
        ValueError: for a configuration or a global path that cannot be flown; it is named. So is
            the least altitude that works, for a start too low above the ground.
    """
    return Mission(world, config, global_path, observers, priority).fly()
