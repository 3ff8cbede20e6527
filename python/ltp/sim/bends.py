# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A path's bends: how fast they may be flown, and how far past them to aim."""

import bisect
import math
from dataclasses import dataclass
from typing import Self

import numpy as np
from numpy.typing import NDArray

_SCALES = (4.0, 8.0, 16.0, 32.0)  # windows in which a path is seen to bend [cuts]; assumed
_CUT = 2.0 / math.e  # of look-ahead * sin(t / 2): what pure pursuit cuts off a small bend t


@dataclass(frozen=True, eq=False)
class Bends:
    """Where a path bends too much for its speed, and how that is flown. Arrays (n,)."""

    arcs: NDArray[np.float64]  # arc lengths of the bends, ascending [m]
    speeds: NDArray[np.float64]  # there, squared [m^2/s^2]
    reaches: NDArray[np.float64]  # look-ahead there; the bend begins and ends so far from it [m]
    pairs: list[tuple[float, float]]  # arcs and reaches, for a look at one or two of them

    @classmethod
    def of(
        cls,
        path: NDArray[np.float64],
        arcs: NDArray[np.float64],
        *,
        speed: float,
        reach: float,
        acceleration: float,
        cut: float,
    ) -> Self:
        """The bends of a path.

        A bend is the angle t between two chords of length w that meet at a vertex. It is flown at
        v^2 = a max(w / t, c / sin^2(t / 2)), the slowest over several w: on the path's own circle,
        or, cutting a corner by at most c, at 0.7 of the speed at which constant acceleration would.
        There the look-ahead is c / (0.74 sin(t / 2)).

        Args:
            path: (n, 3), n >= 1 [m].
            arcs: (n,), arc lengths of the vertices [m].
            speed: at most [m/s].
            reach: look-ahead at that speed [m]; what bears both is no bend.
            acceleration: a, across the path [m/s^2].
            cut: c, how far a corner may be cut [m].
        """
        limits = np.full(len(path), float(speed * speed))
        reaches = np.full(len(path), np.inf)
        for scale in _SCALES:
            window = scale * cut
            if scale > _SCALES[0] and acceleration * window > math.pi * speed * speed:
                break  # bears the speed whatever the turn
            behind = path - _points(path, arcs, arcs - window)
            ahead = _points(path, arcs, arcs + window) - path
            sizes = np.linalg.norm(behind, axis=1) * np.linalg.norm(ahead, axis=1)
            cosine = np.ones(len(path))
            np.divide(np.einsum("ij,ij->i", behind, ahead), sizes, out=cosine, where=sizes > 1e-12)
            turn = np.maximum(np.arccos(np.clip(cosine, -1.0, 1.0)), 1e-6)
            sine = np.sin(0.5 * turn)
            allowed = acceleration * np.maximum(window / turn, cut / sine**2)
            limits = np.minimum(limits, allowed)
            reaches = np.minimum(reaches, cut / (_CUT * sine))
        bends = (limits < speed * speed) | (reaches < reach)
        where, reach_at = arcs[bends], reaches[bends]
        pairs = list(zip(where.tolist(), reach_at.tolist(), strict=True))
        return cls(where, limits[bends], reach_at, pairs)

    def speed(self, arc: float, braking: float) -> float:
        """How fast to fly at an arc length [m], that each bend is entered at its speed [m/s].

        braking: before and after bends [m/s^2].
        """
        if not self.pairs:
            return math.inf
        beyond = np.maximum(np.abs(self.arcs - arc) - self.reaches, 0.0)
        return math.sqrt((self.speeds + 2.0 * braking * beyond).min())

    def aim(self, arc: float, aim: float) -> float:
        """The arc length to aim at from one [m]: not farther past a bend than its look-ahead."""
        for index in range(bisect.bisect_left(self.pairs, (arc,)), len(self.pairs)):
            bend, reach = self.pairs[index]
            if bend >= aim:
                break
            aim = min(aim, max(bend, arc + reach))
        return aim


def _points(
    path: NDArray[np.float64], arcs: NDArray[np.float64], at: NDArray[np.float64]
) -> NDArray[np.float64]:
    return np.stack([np.interp(at, arcs, path[:, axis]) for axis in range(3)], axis=1)
