# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Path following: a path and a position in, a velocity command out."""

import math

import numpy as np
from numpy.typing import NDArray

from ltp._core import closest_point, path_length, point_at


class PathFollower:
    """Flies towards a point a little ahead on the path, and stops at the path's end.

    A short look-ahead keeps the corners that it cuts within a cell of the path; at 3 m/s and
    3 m/s^2 the measured deviation stays below the margin that inflation leaves.
    """

    def __init__(self, speed: float, max_acceleration: float, look_ahead: float = 2.0) -> None:
        self.speed = speed
        self.max_acceleration = max_acceleration
        self.look_ahead = look_ahead
        self._path: NDArray[np.float64] = np.empty((0, 3))
        self._length = 0.0
        self._progress = 0.0

    def follow(self, path: NDArray[np.float64]) -> None:
        """Take up a path (n, 3) [m]; n = 0 means: stay."""
        self._path = path
        self._length = path_length(path) if len(path) else 0.0
        self._progress = 0.0

    def command(self, position: NDArray[np.float64]) -> NDArray[np.float64]:
        """The velocity (3,) to fly now [m/s]."""
        if len(self._path) == 0:
            return np.zeros(3)
        # Only a stretch ahead is looked at, so that a path that passes by itself is not cut short.
        _, arc, _ = closest_point(self._path, position, self._progress)
        self._progress = arc
        ahead = point_at(self._path, arc + self.look_ahead) - position
        distance = math.sqrt(ahead @ ahead)
        if distance < 1e-9:
            return np.zeros(3)
        left = self._length - arc + 1e-9
        brake = math.sqrt(2.0 * 0.8 * self.max_acceleration * left)  # v^2 = 2 a s, with a reserve
        return ahead * (min(self.speed, brake) / distance)
