# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`MissionSetup`: what a mission is given, and what follows from it before anything moves."""

import copy
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
    """One world, one configuration, one global path. It stays as it is while the mission flies."""

    world: World
    config: MissionConfig
    global_path: NDArray[np.float64]  # (n, 3), n >= 2: the start and the waypoints, world [m]
    surface: Surface  # what is really there
    priority: Raster  # the map that the UAV is given

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
        _demand("world", world, World, Surface)
        _demand("config", config, MissionConfig)
        if priority is not None:
            _demand("priority", priority, Raster)
        config = copy.copy(config)  # whatever becomes of the caller's
        config.check()
        path = _checked_path(global_path)
        if isinstance(world, Surface):
            scenery = scenery_of(world)
            given = _no_priority() if priority is None else seen_priority(priority)
            return cls(scenery, config, path, world, given)
        refuse_off_world(world, path)
        check_take_off(world, config, path)
        surface = HeightSurface(world.surface_raster())
        return cls(world, config, path, surface, _priority(world, config, path, priority))

    @property
    def waypoints(self) -> NDArray[np.float64]:
        """(n - 1, 3), the global path without its start [m]."""
        return self.global_path[1:]

    @property
    def time_limit(self) -> float:
        """After so long a flight has timed out [s]."""
        config = self.config
        return config.time_limit_factor * path_length(self.global_path) / config.vehicle.speed

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


def _checked_path(global_path: ArrayLike) -> NDArray[np.float64]:
    try:
        path = np.ascontiguousarray(global_path, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"global_path: expected numbers of shape (n, 3), {error}") from error
    if path.ndim != 2 or path.shape[1] != 3 or len(path) < 2:
        raise ValueError(f"global_path.shape = {path.shape}: expected (n, 3) with n >= 2")
    if not np.isfinite(path).all():
        raise ValueError("global_path: expected finite coordinates")
    if path_length(path) == 0.0:
        raise ValueError("global_path: expected a path longer than 0 m")
    return path


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
