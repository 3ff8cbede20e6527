# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A point mass with limits on speed, acceleration and climb."""

import math

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.config import VehicleOptions


class PointMass:
    """Position and velocity of the UAV (world ENU) [m, m/s].

    It moves in straight pieces, one a step, so that a flight can be checked exactly.

    Raises:
        ValueError: for a position that is not three finite numbers.
    """

    def __init__(self, position: ArrayLike, options: VehicleOptions) -> None:
        self.options = options
        self.position = np.array(position, dtype=np.float64)
        if self.position.shape != (3,) or not np.isfinite(self.position).all():
            raise ValueError(
                f"position = {position!r:.80}: expected three finite numbers (x, y, z)"
            )
        self.velocity = np.zeros(3)

    def __repr__(self) -> str:
        place, pace = (", ".join(f"{n:g}" for n in v) for v in (self.position, self.velocity))
        return f"PointMass(position=({place}) m, velocity=({pace}) m/s, {self.options!r})"

    def step(self, command: ArrayLike, seconds: float) -> None:
        """Move for one step towards a commanded velocity (3,) [m/s], within the limits."""
        wanted = self._within_limits(command)
        change = wanted - self.velocity
        size = math.sqrt(change @ change)
        most = self.options.max_acceleration * seconds
        if size > most:
            change *= most / size
        self.velocity = self.velocity + change
        self.position = self.position + self.velocity * seconds

    def _within_limits(self, command: ArrayLike) -> NDArray[np.float64]:
        wanted = np.array(command, dtype=np.float64)
        # Slowed as a whole, so that the direction stays.
        scale = 1.0
        speed = math.sqrt(wanted @ wanted)
        if speed > self.options.speed:
            scale = self.options.speed / speed
        climb = abs(float(wanted[2]))
        if climb * scale > self.options.max_climb:
            scale = self.options.max_climb / climb
        return wanted * scale
