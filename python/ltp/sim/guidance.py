# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Path following: a path, a position and a velocity in, a velocity command out."""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp._core import OccupancyGrid, closest_point, point_at
from ltp.config import GuidanceOptions
from ltp.sim.bends import Bends

_LOOK_AHEAD = 0.4  # v^2 / a on straight stretches; assumed
_SLOWER = (1.0, 0.75, 0.5, 0.25, 0.0)  # of the wanted speed, tried in turn until a stop is free


class PathFollower:
    """Flies towards a point a little ahead on the path, and stops at the path's end.

    Pure pursuit (Coulter 1992) with a speed of its own: no faster than bends, the path's end and
    what was hit allow. Look-ahead and cut of a bend are in cells: a path through cells of 0.25 m is
    followed to 0.125 m, more slowly. A command differs from the velocity by no more than the
    vehicle can change it in one step.

    Args:
        speed: on straight stretches, at most [m/s].
        max_acceleration: of the vehicle [m/s^2].
        look_ahead: least distance at which to aim [m]; by default from options and cell.
        cell: edge of the planner's cells, the smallest [m].
        max_climb: largest vertical speed, up or down [m/s].
        step: from command to command [s].
        options: see `GuidanceOptions`.
    """

    def __init__(
        self,
        speed: float,
        max_acceleration: float,
        look_ahead: float | None = None,
        *,
        cell: float = 2.0,
        max_climb: float = math.inf,
        step: float = 0.1,
        options: GuidanceOptions | None = None,
    ) -> None:
        numbers = {"speed": speed, "max_acceleration": max_acceleration, "cell": cell, "step": step}
        if look_ahead is not None:
            numbers["look_ahead"] = look_ahead
        for name, value in numbers.items():
            if not (math.isfinite(value) and value > 0.0):
                raise ValueError(f"{name} = {value!r}: expected a positive finite number")
        if not max_climb > 0.0:
            raise ValueError(f"max_climb = {max_climb!r}: expected a positive number")
        self.options = options or GuidanceOptions()
        self.speed = speed
        self.max_acceleration = max_acceleration
        self.look_ahead = self.options.look_ahead * cell if look_ahead is None else look_ahead
        self.cell = cell
        self.max_climb = max_climb
        self.step = step
        self._path: NDArray[np.float64] = np.empty((0, 3))
        self._length = 0.0
        self._bends: Bends | None = None
        self._progress = 0.0
        self._last: NDArray[np.float64] = np.zeros(3)

    def __repr__(self) -> str:
        return (
            f"PathFollower(speed={self.speed:g}, max_acceleration={self.max_acceleration:g}, "
            f"look_ahead={self.look_ahead:g}, cell={self.cell:g}; "
            f"{self._progress:.1f} m of {self._length:.1f} m flown)"
        )

    def follow(self, path: ArrayLike) -> None:
        """Take up a path (n, 3) [m]; n = 0 means: stay.

        Raises:
            ValueError: for another shape, or points that are not finite; the old path stays.
        """
        points = np.ascontiguousarray(path, dtype=np.float64)
        if points.size == 0:
            points = points.reshape(0, 3)
        if points.ndim != 2 or points.shape[1] != 3:
            raise ValueError(f"path.shape = {points.shape}: expected (n, 3)")
        if not np.isfinite(points).all():
            raise ValueError("path: expected finite coordinates")
        self._path = points
        self._progress, self._length, self._bends = 0.0, 0.0, None
        if len(self._path):
            arcs = np.zeros(len(self._path))
            np.cumsum(np.linalg.norm(np.diff(self._path, axis=0), axis=1), out=arcs[1:])
            self._length = float(arcs[-1])
            self._bends = Bends.of(
                self._path,
                arcs,
                speed=self.speed,
                reach=self._reach(self.speed),
                acceleration=self.options.lateral_share * self.max_acceleration,
                cut=self.options.tolerance * self.cell,
            )

    def command(
        self,
        position: NDArray[np.float64],
        velocity: NDArray[np.float64] | None = None,
        occupied: OccupancyGrid | None = None,
    ) -> NDArray[np.float64]:
        """The velocity (3,) to fly now [m/s].

        Args:
            position: (3,), of the UAV [m].
            velocity: (3,), of the UAV [m/s]; by default the last command, as if it was obeyed.
            occupied: the cells with a hit in them; if given, no command from which the UAV could
                not stop before them, straight ahead.
        """
        now = self._last if velocity is None else velocity
        wanted = self._wanted(position, math.sqrt(now @ now))
        for share in _SLOWER:
            self._last = self._reachable(share * wanted, now)
            if occupied is None or self._can_stop(position, self._last, occupied):
                break
        return self._last

    def _wanted(self, position: NDArray[np.float64], pace: float) -> NDArray[np.float64]:
        """Where the path leads from here, and how fast it may be flown."""
        if self._bends is None:
            return np.zeros(3)
        reach = self._reach(pace)
        # Only a stretch ahead is looked at, so that a path that passes by itself is not cut short.
        most = self._progress + max(2.0 * pace * self.step, reach)
        _, arc, _ = closest_point(self._path, position, self._progress, most)
        self._progress = arc
        aim = self._bends.aim(arc, arc + reach)
        ahead = point_at(self._path, aim) - position
        distance = math.sqrt(ahead @ ahead)
        if distance < 1e-9:
            return np.zeros(3)
        braking = self.options.braking_share * self.max_acceleration
        left = self._length - arc
        if left * braking < self.speed * self.speed:  # near the end; of a staircase its diagonal
            offset = self._path[-1] - position
            straight = math.sqrt(offset @ offset)
            left = straight if 2.0 * straight >= left else left
        speed = min(
            self.speed,
            self._bends.speed(arc, braking),
            math.sqrt(2.0 * braking * left),  # v^2 = 2 a s
            0.5 * left / self.step,  # comes to rest at the end
        )
        climb = abs(float(ahead[2])) / distance * speed
        if climb > self.max_climb:
            speed *= self.max_climb / climb
        return ahead * (speed / distance)

    def _reach(self, pace: float) -> float:
        """How far ahead to aim on a straight stretch at a speed [m/s]."""
        return max(self.look_ahead, _LOOK_AHEAD * pace * pace / self.max_acceleration)

    def _reachable(
        self, wanted: NDArray[np.float64], now: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """The velocity nearest to the wanted one that one step can bring."""
        change = wanted - now
        size = math.sqrt(change @ change)
        most = self.max_acceleration * self.step
        return wanted if size <= most else now + change * (most / size)

    def _can_stop(
        self,
        position: NDArray[np.float64],
        velocity: NDArray[np.float64],
        occupied: OccupancyGrid,
    ) -> bool:
        """Whether one step at a velocity and full braking end before what was hit."""
        speed = math.sqrt(velocity @ velocity)
        if speed < 1e-9:
            return True
        way = speed * self.step + speed * speed / (2.0 * self.max_acceleration)
        end = position + velocity * ((way + self.options.stop_margin) / speed)
        segment = np.array((position, end))
        if occupied.first_blocked(segment) is None:
            return True
        # The UAV's own cell may have a hit in it; it can leave.
        free = occupied.first_blocked(segment, 0.0, occupied.frame.cell_of(position))
        return free is None or way <= free - min(self.options.stop_margin, 0.5 * free)
