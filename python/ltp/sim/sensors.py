# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`MountedLidar`: a simulated LiDAR with its place on the vehicle and its rate; `look_down`."""

import copy
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from ltp._core import Lidar, LidarOptions, ObstacleMap, Pose, Scan, Surface
from ltp.brief import brief
from ltp.config import MissionConfig
from ltp.sim.parts import Vehicle
from ltp.sim.setup import MissionSetup

_AT_THE_BODY = Pose((0.0, 0.0, 0.0))  # a pose never changes
_INSIDE = 1e-6  # of a cell, from its faces
_ON_TIME = 1e-9  # of a scan: rounding does not put one off to the next step


class Sensor(Protocol):
    """What a flight senses with. `MountedLidar` is one; a stand-in may leave scans out or delay."""

    def scan(
        self, surface: Surface, body: Pose, tick: int, step: float, *, misses: bool
    ) -> Scan | None:
        """The scan that a step brings, if it brings one.

        Args:
            surface: what is really there.
            body: where the vehicle is and how it is turned.
            tick: number of the step, from 0.
            step: how long one is [s].
            misses: whether rays without a return are to be listed; only carving needs them.
        """


@dataclass(frozen=True, eq=False)
class MountedLidar:
    """A LiDAR on the vehicle. It remembers nothing: one may serve many flights.

    Raises:
        ValueError: for options or a rate out of range; it is named.
    """

    options: LidarOptions = field(default_factory=LidarOptions)  # its rays; a copy is kept
    mount: Pose = _AT_THE_BODY  # in its frame: x forward, y left, z up [m]
    rate: float = math.inf  # scans a second [Hz]; inf: one a step, and never more than that
    lidar: Lidar = field(init=False, repr=False)

    __repr__ = brief

    def __post_init__(self) -> None:
        if not self.rate > 0.0:
            raise ValueError(f"rate = {self.rate!r}: expected a positive number [Hz]")
        object.__setattr__(self, "options", copy.copy(self.options))
        object.__setattr__(self, "lidar", Lidar(self.options))

    def scan(
        self, surface: Surface, body: Pose, tick: int, step: float, *, misses: bool
    ) -> Scan | None:
        """See `Sensor`. The first step brings a scan; noise differs from scan to scan."""
        number = self._number(tick, step)
        if tick > 0 and number == self._number(tick - 1, step):
            return None
        return self.lidar.scan(surface, on_body(body, self.mount), number, misses=misses)

    def _number(self, tick: int, step: float) -> int:
        """Of the last scan that has begun at a step, from 0."""
        return tick if self.rate * step >= 1.0 else math.floor(tick * step * self.rate + _ON_TIME)


def look_down(*, max_range: float = 50.0) -> LidarOptions:
    """The rays that the default LiDAR leaves out: a cone to 43 degrees about straight down.

    Who descends must look down: what lies steeper below than -45 degrees is seen by no ray of the
    level pattern. 120 x 22 rays from -89 to -47 degrees meet flat ground 30 m below in rings 1.0 to
    1.9 m apart, with at most 1.5 m between neighbours. (*Assumed*: no data sheet's pattern.) Its
    noise, if any is set, is drawn from a seed of its own.

    Args:
        max_range: a return at or beyond it is no return [m].
    """
    options = LidarOptions(max_range=max_range, seed=1)
    options.pattern.azimuths = 120
    options.pattern.rows = 22
    options.pattern.elevation_from_deg = -89.0
    options.pattern.elevation_to_deg = -47.0
    return options


def scans_of(
    sensors: Sequence[Sensor], setup: MissionSetup, vehicle: Vehicle, tick: int
) -> tuple[Scan | None, ...]:
    """What each sensor on a vehicle brings at a step of a flight."""
    config = setup.config
    body = getattr(vehicle, "pose", None) or Pose(vehicle.position)
    return tuple(
        sensor.scan(setup.surface, body, tick, config.step, misses=config.mapping.carve_free_space)
        for sensor in sensors
    )


def mapped_from(
    scan: Scan, position: NDArray[np.float64], known: ObstacleMap
) -> NDArray[np.float64]:
    """Where a scan is said to begin, (3,) [m], so that the map's window stays with the vehicle.

    `sense` moves the window to a scan's origin. Mounts on both sides of a cell's face would move it
    there and back at every step: a millisecond, and the outermost cells forgotten. So the origin is
    moved to the nearest point from which the window is the vehicle's, by no more than the mount is
    away. A map that carves follows the rays, and is told the origin itself.

    Args:
        scan: of a sensor on the vehicle.
        position: of the vehicle, (3,) [m].
        known: the map that it is for.
    """
    origin = scan.origin
    if known.options.carve_free_space or np.array_equal(origin, position):
        return origin
    frame = known.occupied.frame
    half = 0.5 * np.array(frame.dims)
    middle = np.floor((position - frame.origin) / frame.cell - half + 0.5) + half - 0.5
    low = frame.origin + middle * frame.cell
    return np.clip(origin, low + _INSIDE * frame.cell, low + (1.0 - _INSIDE) * frame.cell)


def check_sensors(sensors: Sequence[Sensor], config: MissionConfig) -> None:
    """Refuse LiDARs that scan faster than the simulation steps, or farther than the map reaches.

    Raises:
        ValueError: that names the sensor and its setting.
    """
    most, range_ = 1.0 / config.step, config.mapping.max_range
    for index, sensor in enumerate(sensors):
        if not isinstance(sensor, MountedLidar):
            continue
        if math.isfinite(sensor.rate) and sensor.rate > most * (1.0 + _ON_TIME):
            raise ValueError(
                f"sensors[{index}].rate = {sensor.rate!r}: expected at most one scan a step, "
                f"{most:g} Hz, or inf"
            )
        if sensor.options.max_range > range_:
            raise ValueError(
                f"sensors[{index}].options.max_range = {sensor.options.max_range!r}: expected at "
                f"most mapping.max_range = {range_!r}, or the map ignores far hits"
            )


def on_body(body: Pose, mount: Pose) -> Pose:
    """The pose in the world of what is mounted on a body. mount: in the body's frame."""
    position = body.position + body.rotation @ mount.position
    yaw, pitch, roll = _angles(body.rotation @ mount.rotation)
    return Pose(position, yaw=yaw, pitch=pitch, roll=roll)


def _angles(rotation: NDArray[np.float64]) -> tuple[float, float, float]:
    """Yaw, pitch and roll [rad] of a rotation (3, 3); straight up or down, roll is 0."""
    (r00, r01, _), (r10, r11, _), (r20, r21, r22) = rotation.tolist()
    pitch = math.atan2(-r20, math.hypot(r00, r10))
    if math.hypot(r00, r10) < 1e-9:
        return math.atan2(-r01, r11), pitch, 0.0
    return math.atan2(r10, r00), pitch, math.atan2(r21, r22)
