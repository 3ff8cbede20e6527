# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`MissionSetup`: what a flight is given, and what follows from it before anything moves."""

import copy
import dataclasses
import math
from dataclasses import dataclass
from typing import Any, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp._core import HeightSurface, Raster, Surface, path_length
from ltp.brief import brief
from ltp.config import MissionConfig
from ltp.sim.scenery import scenery_of
from ltp.sim.take_off import check_take_off
from ltp.world import World, priority_map
from ltp.world.off_world import refuse_off_world
from ltp.world.priority import seen_priority


@dataclass(frozen=True, eq=False)
class MissionSetup:
    """One world, one configuration, one global path. It stays as it is while the UAV flies."""

    world: World
    config: MissionConfig
    global_path: NDArray[np.float64]  # (n, 3): the start and the waypoints to begin with, world [m]
    surface: Surface  # what is really there
    priority: Raster  # the map that the UAV is given
    time_limit: float = math.inf  # after so long a mission has timed out [s]
    bare: bool = False  # whether there is a surface only, and `world` is what is drawn of it

    __repr__ = brief

    @classmethod
    def of(
        cls,
        world: World | Surface,
        config: MissionConfig,
        global_path: ArrayLike,
        priority: Raster | None = None,
    ) -> Self:
        """Prepare a mission: see `fly`.

        Raises:
            ValueError: for a configuration, a global path or a start that cannot be flown; it is
                named.
            TypeError: for an argument of another kind.
        """
        _demand("config", config, MissionConfig)
        path = checked_points("global_path", global_path)
        if len(path) < 2 or np.ndim(global_path) != 2:
            raise ValueError(
                f"global_path.shape = {np.shape(global_path)}: expected (n, 3) with n >= 2"
            )
        length = path_length(path)
        if length == 0.0:
            raise ValueError("global_path: expected a path longer than 0 m")
        limit = config.time_limit_factor * length / config.vehicle.speed
        return cls._made(world, config, path, priority, "global_path", limit)

    @classmethod
    def at(
        cls,
        world: World | Surface,
        config: MissionConfig,
        start: ArrayLike,
        priority: Raster | None = None,
    ) -> Self:
        """Prepare a flight without a time limit: see `Flight`.

        Raises:
            ValueError: for a configuration, waypoints or a start that cannot be flown; it is named.
        """
        path = checked_points("start", start)
        if not len(path):
            raise ValueError("start.shape = (0, 3): expected (3,), or (n, 3) with n >= 1")
        return cls._made(world, config, path, priority, "start")

    @classmethod
    def _made(
        cls,
        world: World | Surface,
        config: MissionConfig,
        path: NDArray[np.float64],
        priority: Raster | None,
        name: str,
        time_limit: float = math.inf,
    ) -> Self:
        _demand("world", world, World, Surface)
        _demand("config", config, MissionConfig)
        if priority is not None:
            _demand("priority", priority, Raster)
        config = copy.copy(config)  # whatever becomes of the caller's
        config.check()
        if isinstance(world, Surface):
            seen = _no_priority() if priority is None else seen_priority(priority)
            return cls(scenery_of(world), config, path, world, seen, time_limit, bare=True)
        refuse_off_world(world, path, name)
        if len(path) > 1:  # else it may be told to climb
            check_take_off(world, config, path)
        surface = HeightSurface(world.surface_raster())
        seen = _priority(world, config, path, priority)
        return cls(world, config, path, surface, seen, time_limit)

    @property
    def waypoints(self) -> NDArray[np.float64]:
        """(n - 1, 3), the global path without its start [m]."""
        return self.global_path[1:]

    def check(self, waypoints: NDArray[np.float64]) -> None:
        """Raise `ValueError` for waypoints (n, 3) [m] that lie off the world."""
        if not self.bare and len(waypoints):
            refuse_off_world(self.world, waypoints, "waypoints")

    def along(self, waypoints: NDArray[np.float64]) -> Self:
        """The same with other waypoints (n, 3) to begin with [m].

        Raises:
            ValueError: for waypoints off the world, or a start too low to get to them.
        """
        self.check(waypoints)
        path = np.concatenate([self.global_path[:1], waypoints])
        if not self.bare and len(waypoints):
            check_take_off(self.world, self.config, path)
        return dataclasses.replace(self, global_path=path)

    def gates(self, waypoints: NDArray[np.float64]) -> NDArray[np.float64]:
        """Radius and height in which each of the waypoints is served [m]; (0, 2): as points.

        The camera's radius is half its footprint at the waypoint's height above ground. The last
        waypoint stays a point. Height 0: one cell.

        Args:
            waypoints: (n, 3) [m].

        Returns:
            (n, 2), or (0, 2).
        """
        gate = self.config.gate
        if gate == "point" or not len(waypoints):
            return np.zeros((0, 2))
        gates = np.zeros((len(waypoints), 2))
        if isinstance(gate, str):
            ground = self.world.ground_raster().at(waypoints[:, 0], waypoints[:, 1])
            half_angle = np.radians(self.config.fov_deg) / 2
            gates[:, 0] = np.maximum(0.0, waypoints[:, 2] - ground) * np.tan(half_angle)
        else:
            gates[:, 0] = gate
        gates[-1] = 0.0
        return gates

    def gate_radii(self, waypoints: NDArray[np.float64]) -> NDArray[np.float64]:
        """Radius of the gate of each of the waypoints (n, 3), (n,) [m]; 0: a point."""
        given = self.gates(waypoints)
        if len(given):
            return np.asarray(given[:, 0])
        radii = np.full(len(waypoints), self.config.navigation.gate_radius)
        radii[-1:] = 0.0
        return radii

    def first_touch(
        self, before: NDArray[np.float64], after: NDArray[np.float64]
    ) -> tuple[float, float, float] | None:
        """Where a straight move between two points (3,) first touches the true world [m]."""
        segment = np.array((before, after))
        arc = self.surface.first_collision(segment)
        if arc is None:
            return None
        length = path_length(segment)
        x, y, z = before + (after - before) * (arc / length if length > 0 else 0.0)
        return float(x), float(y), float(z)


def _demand(name: str, value: object, *kinds: type) -> None:
    if not isinstance(value, kinds):
        expected = " or ".join(kind.__name__ for kind in kinds)
        raise TypeError(f"{name}: expected a {expected}, not a {type(value).__name__}")


def _no_priority() -> Raster:
    return Raster(np.zeros((1, 1)), origin=(0.0, 0.0), cell=1.0)


def checked_points(name: str, points: ArrayLike) -> NDArray[np.float64]:
    """A copy, (n, 3), of points (n, 3) or of one point (3,) [m].

    Raises:
        ValueError: that names them, for another shape or a coordinate that is not finite.
    """
    try:
        array = np.array(points, dtype=np.float64, order="C")
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name}: expected numbers of shape (n, 3), {error}") from error
    if array.shape in ((3,), (0,)):
        array = array.reshape(-1, 3)
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}.shape = {array.shape}: expected (n, 3)")
    if not np.isfinite(array).all():
        raise ValueError(f"{name}: expected finite coordinates")
    return array


def _priority(
    world: World, config: MissionConfig, path: NDArray[np.float64], given: Raster | None
) -> Raster:
    """The priority map; the camera's footprint is that of the path's mean height above ground."""
    ground = world.ground_raster().at(path[:, 0], path[:, 1])
    height = max(1.0, float(np.round(np.mean(path[:, 2] - ground))))
    kind: Any = config.priority_map
    if given is not None:
        return seen_priority(given, kind, height, config.fov_deg)
    return priority_map(
        world,
        kind,
        altitude=height,
        fov_deg=config.fov_deg,
        **config.landing.rules(config.landable),
    )
