# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The simulated mission: sense, map, plan, guide, move, until the global path is flown."""

from collections.abc import Sequence
from typing import Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp._core import (
    HeightSurface,
    Lidar,
    LocalTrajectoryPlanner,
    NavigationStatus,
    Pose,
    Raster,
    Scan,
    path_length,
)
from ltp.config import MissionConfig
from ltp.sim.guidance import PathFollower
from ltp.sim.log import FlightLog
from ltp.sim.record import FlightRecord, Outcome
from ltp.sim.vehicle import PointMass
from ltp.world import World, priority_map


class Observer(Protocol):
    """Something that watches a mission: progress, a log, a recording. It changes nothing."""

    def on_start(self, mission: "Mission") -> None:
        """Before the first step."""

    def on_step(self, mission: "Mission") -> None:
        """After each step's plan, before the vehicle moves."""

    def on_end(self, mission: "Mission", record: FlightRecord) -> None:
        """After the last step."""


class Mission:
    """One UAV, one world, one global path."""

    def __init__(
        self,
        world: World,
        config: MissionConfig,
        global_path: ArrayLike,
        observers: Sequence[Observer] = (),
    ) -> None:
        config.check()
        self.world = world
        self.config = config
        self.global_path = _checked_path(global_path)
        self.observers = observers
        self.surface = HeightSurface(world.surface_raster())
        self.priority = _priority(world, config, self.global_path)
        self.lidar = Lidar(config.lidar)
        self.planner = LocalTrajectoryPlanner(
            self.priority,
            self.global_path[0],
            planner=config.planner,
            planner_options=config.planner_options(),
            map_options=config.mapping,
            options=config.navigation,
        )
        self.planner.set_waypoints(self.global_path[1:])
        self.vehicle = PointMass(self.global_path[0], config.vehicle)
        self.guidance = PathFollower(config.vehicle.speed, config.vehicle.max_acceleration)
        self.log = FlightLog(self.planner)
        self.time_limit = (
            config.time_limit_factor * path_length(self.global_path) / config.vehicle.speed
        )
        self.tick = 0
        self.scan: Scan | None = None

    @property
    def time(self) -> float:
        """Since the start [s]."""
        return self.tick * self.config.step

    @property
    def position(self) -> NDArray[np.float64]:
        """Of the UAV, (3,) [m]."""
        return self.vehicle.position

    def fly(self) -> FlightRecord:
        """Fly until the waypoints are used up, the time is over, or something is hit."""
        for observer in self.observers:
            observer.on_start(self)
        outcome, collision, held = None, None, 0.0
        while outcome is None:
            self.scan = self.lidar.scan(
                self.surface,
                Pose(self.position),
                self.tick,
                misses=self.config.mapping.carve_free_space,
            )
            self.planner.sense(self.scan.origin, self.scan.hits, self.scan.misses)
            status = self.planner.update(self.position)
            if self.log.note(self.time, self.vehicle):
                self.guidance.follow(self.planner.path)
            for observer in self.observers:
                observer.on_step(self)

            held = held + self.config.step if status == NavigationStatus.HOLDING else 0.0
            if status == NavigationStatus.FINISHED:
                outcome = Outcome.REACHED
            elif self.time >= self.time_limit or held >= self.config.hold_limit:
                outcome = Outcome.TIMED_OUT
            else:
                before = self.position
                self.vehicle.step(self.guidance.command(before), self.config.step)
                self.tick += 1
                collision = _collision(self.surface, before, self.position)
                if collision is not None:
                    self.log.note(self.time, self.vehicle)
                    outcome = Outcome.COLLIDED
        record = self.log.record(self, outcome, collision)
        for observer in self.observers:
            observer.on_end(self, record)
        return record


def fly(
    world: World,
    config: MissionConfig,
    global_path: ArrayLike,
    observers: Sequence[Observer] = (),
) -> FlightRecord:
    """Fly a mission over a world.

    Args:
        world: what is really there; the UAV learns of it through its LiDAR only.
        config: planner, weights, sensor, map, vehicle.
        global_path: (n, 3), n >= 2, world [m]; the UAV starts at its first point, the others are
            its waypoints. It may lead through buildings.
        observers: told of every step, in order.

    Returns:
        The record of the flight; the same for the same arguments, but for wall times.
    """
    return Mission(world, config, global_path, observers).fly()


def _checked_path(global_path: ArrayLike) -> NDArray[np.float64]:
    path = np.ascontiguousarray(global_path, dtype=np.float64)
    if path.ndim != 2 or path.shape[1] != 3 or len(path) < 2:
        raise ValueError(f"global_path.shape = {path.shape}: expected (n, 3) with n >= 2")
    if not np.isfinite(path).all():
        raise ValueError("global_path: expected finite coordinates")
    if path_length(path) == 0.0:
        raise ValueError("global_path: expected a path longer than 0 m")
    return path


def _priority(world: World, config: MissionConfig, path: NDArray[np.float64]) -> Raster:
    """The priority map; the camera's footprint is that of the path's mean height above ground."""
    ground = world.ground_raster().at(path[:, 0], path[:, 1])
    height = max(1.0, float(np.round(np.mean(path[:, 2] - ground))))
    return priority_map(
        world,
        config.priority_map,  # type: ignore[arg-type]
        altitude=height,
        fov_deg=config.fov_deg,
        landable=config.landable,
    )


def _collision(
    surface: HeightSurface, before: NDArray[np.float64], after: NDArray[np.float64]
) -> tuple[float, float, float] | None:
    segment = np.array((before, after))
    arc = surface.first_collision(segment)
    if arc is None:
        return None
    length = path_length(segment)
    x, y, z = before + (after - before) * (arc / length if length > 0 else 0.0)
    return float(x), float(y), float(z)
