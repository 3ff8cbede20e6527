# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a flight is made of: planner, vehicle and guidance, as protocols, and those by default."""

from collections.abc import Sequence
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp._core import (
    LocalTrajectoryPlanner,
    NavigationReason,
    NavigationStatus,
    ObstacleMap,
    OccupancyGrid,
    PlanRecord,
    WaypointEvent,
    closest_point,
)
from ltp.config import MissionConfig
from ltp.sim.guidance import PathFollower
from ltp.sim.setup import MissionSetup


class FlightPlanner(Protocol):
    """Maps and decides: `LocalTrajectoryPlanner`, or something that stands in for it."""

    def sense(self, origin: Any, hits: Any, misses: Any, /) -> Any:
        """Add a scan, see `LocalTrajectoryPlanner.sense`."""

    def update(self, position: Any, /) -> NavigationStatus:
        """Decide what to do at a position (3,) [m]."""

    def set_waypoints(self, waypoints: Any, gates: Any = ..., /) -> None:
        """Replace what is left of the waypoints, (n, 3) [m].

        Their gates, (n, 2), radius and height [m], are only given where they are not points.
        """

    def set_priority(self, priority: Any, keep_if_within: float = ..., /) -> None:
        """Go on with another priority map.

        A margin is only given where it is not 0, see `LocalTrajectoryPlanner.set_priority`.
        """

    def set_weights(self, weights: Any, keep_if_within: float = ..., /) -> None:
        """Go on with other weights of Eq. 5; the margin as in `set_priority`."""

    @property
    def reason(self) -> NavigationReason:
        """Why it holds or escapes."""

    @property
    def path(self) -> NDArray[np.float64]:
        """(k, 3), to follow [m]."""

    @property
    def path_id(self) -> Any:
        """As long as it stands, so does `path`."""

    @property
    def plans(self) -> Sequence[PlanRecord]:
        """The answers when planning last."""

    @property
    def plans_made(self) -> int:
        """Since the beginning."""

    @property
    def events(self) -> Sequence[WaypointEvent]:
        """Waypoints reached and dropped, in order."""

    @property
    def events_count(self) -> int:
        """How many there are."""

    @property
    def waypoint_index(self) -> int:
        """The waypoint flown to."""

    @property
    def map(self) -> ObstacleMap:
        """What was sensed."""


class Vehicle(Protocol):
    """What moves: `PointMass`, or a model of your own. World ENU.

    If it has a `pose` (`ltp.Pose`) as well, its sensors turn with it; else it stays level, nose
    east. What touches the true world is the straight way from step to step.
    """

    @property
    def position(self) -> NDArray[np.float64]:
        """(3,) [m]."""

    @property
    def velocity(self) -> NDArray[np.float64]:
        """(3,) [m/s]."""

    def step(self, command: NDArray[np.float64], seconds: float, /) -> None:
        """Move for so long towards a commanded velocity (3,) [m/s]."""


class Guidance(Protocol):
    """What makes a velocity of a path: `PathFollower`, or something of your own."""

    def follow(self, path: NDArray[np.float64], /) -> None:
        """Take up a path (k, 3) [m]; k = 0: stay."""

    def command(
        self,
        position: NDArray[np.float64],
        velocity: NDArray[np.float64],
        occupied: OccupancyGrid,
        /,
    ) -> NDArray[np.float64]:
        """The velocity (3,) to fly now [m/s]; occupied: the cells with a hit in them."""


def default_planner(
    setup: MissionSetup, known_map: Path | str | None = None
) -> LocalTrajectoryPlanner:
    """The planner of a configuration, without waypoints; it knows a map in a file, if any."""
    config = setup.config
    planner = LocalTrajectoryPlanner(
        setup.priority,
        setup.global_path[0],
        planner=config.planner,
        planner_options=config.planner_options,
        map_options=config.mapping,
        options=config.navigation,
    )
    if known_map is not None:
        planner.load_map(known_map)
    return planner


def default_guidance(config: MissionConfig) -> PathFollower:
    """The path follower of a configuration."""
    return PathFollower(
        config.vehicle.speed,
        config.vehicle.max_acceleration,
        cell=float(np.min(config.mapping.cell)),
        max_climb=config.vehicle.max_climb,
        step=config.step,
        options=config.guidance,
    )


def check_at(start: NDArray[np.float64], vehicle: Vehicle) -> None:
    """Raise `ValueError` for a vehicle that is not at the start (3,) [m]."""
    position = np.asarray(vehicle.position)
    if position.shape != (3,) or not np.allclose(position, start, rtol=0.0, atol=1e-6):
        raise ValueError(
            f"vehicle.position = {position.tolist()}: expected the start, {start.tolist()}"
        )


def rest_of(path: NDArray[np.float64], position: NDArray[np.float64]) -> NDArray[np.float64]:
    """What is left of a path (k, 3) from the point of it nearest to a position (3,) [m]."""
    if len(path) < 2:
        return path
    here, arc, _ = closest_point(path, position)
    arcs = np.cumsum(np.linalg.norm(np.diff(path, axis=0), axis=1))
    return np.concatenate([here[None], path[1:][arcs > arc]])


def checked_velocity(command: ArrayLike) -> NDArray[np.float64]:
    """A command as (3,) [m/s]; `ValueError` if it is none."""
    velocity = np.array(command, dtype=np.float64)
    if velocity.shape != (3,) or not np.isfinite(velocity).all():
        raise ValueError(f"command = {command!r:.80}: expected three finite numbers [m/s]")
    return velocity
