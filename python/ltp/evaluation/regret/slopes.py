# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The least Eq. 5 of whole routes, by searches with one slope for all of their legs."""

import itertools
import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from ltp._core import PathTally, PenaltyWeights, penalty

_SEARCHES = 16  # at most
_TOLERANCE = 0.001  # of Eq. 5: ends when route and bound are this close
_LEAST_COST = 0.02  # alpha stays so far above the largest priority
_SHORTEST = 100.0  # of priorities: a slope at which next to nothing but the length counts
_APART = 0.005  # slopes nearer to each other find the same


@dataclass(frozen=True)
class Route:
    """A way through all gates of a flight, or through one."""

    path: NDArray[np.float64]  # (n, 3) [m]
    tally: PathTally  # over the priority of the columns, which is what the search adds up
    cost: float  # sum of (alpha - p) dl, the least there is


@dataclass(frozen=True)
class Best:
    """The best route found, and what no route can fall below."""

    route: Route
    bound: float  # of Eq. 5


#: The route of the least sum of (alpha - p) dl; None if there is none.
Search = Callable[[float], Route | None]


class _Line(NamedTuple):
    """What a search proves of all routes: P <= slope L - cost."""

    slope: float
    cost: float


def best_route(
    search: Search, weights: PenaltyWeights, direct: float, best_priority: float
) -> Best | None:
    """The best route that one slope can find; None if there is none at all.

    Eq. 5 is linearised at a route, which makes it the sum of (alpha - p) dl, as in the planner
    `sweep`. Every search proves P <= alpha L - C for all routes, so that the next slope is that of
    Eq. 5 where these leave most room, else at the best route, else between the routes found beside
    that room; it ends where they leave less than 0.001. What is inside the hull of all (L, P) may
    be better than the route, never than the bound.

    Args:
        search: see `Search`; alpha is above `best_priority`, or 1 where W_P = 0.
        weights: of Eq. 5.
        direct: L_direct [m].
        best_priority: the largest priority there is.

    Raises:
        ValueError: if W_L = 0: circling over good ground then has no end.
    """
    if weights.length == 0.0:
        raise ValueError("weights: W_L = 0 knows no best route")
    if weights.priority == 0.0:  # over ground without priority the least cost is the shortest
        shortest = search(1.0)
        if shortest is None:
            return None
        return Best(shortest, penalty(shortest.tally, direct, weights))
    ratio = weights.length / weights.priority
    lines = [_Line(best_priority, 0.0)]
    best: Route | None = None
    value, bound = math.inf, -math.inf
    found: list[tuple[float, float]] = []
    alphas = [_SHORTEST]
    while alphas and len(lines) <= _SEARCHES:
        route = search(alphas[0])
        if route is None:
            return None
        lines.append(_Line(alphas[0], route.cost))
        judged = penalty(route.tally, direct, weights)
        if judged < value:
            best, value = route, judged
        bound, length, priority = _least(lines, weights, direct)
        if best is None or value - bound <= _TOLERANCE:
            break
        points = ((length, priority), (best.tally.length, best.tally.priority))
        slopes = [p / along + along / direct * ratio for along, p in points]
        found.append((route.tally.length, route.tally.priority))
        slopes += _chord(found, length)
        slopes = [max(slope, best_priority + _LEAST_COST) for slope in slopes]
        alphas = [s for s in slopes if min(abs(s - line.slope) for line in lines[1:]) > _APART]
    return None if best is None else Best(best, min(bound, value))


def _chord(found: Sequence[tuple[float, float]], length: float) -> list[float]:
    """The slope between the nearest (L, P) found on either side of a length; none outside."""
    shorter = max((point for point in found if point[0] < length), default=None)
    longer = min((point for point in found if point[0] > length), default=None)
    if shorter is None or longer is None:
        return []
    return [(longer[1] - shorter[1]) / (longer[0] - shorter[0])]


def _least(
    lines: Sequence[_Line], weights: PenaltyWeights, direct: float
) -> tuple[float, float, float]:
    """The least Eq. 5 that the lines allow, and the (L, P) where they do.

    On each line Eq. 5 is a convex function of L, and what they allow together is the largest of
    these: its least value is where one has its own, or where two meet.
    """
    a, b = weights.length / direct, weights.priority
    slope, cost = np.array(lines).T
    meet = [
        (one.cost - other.cost) / (one.slope - other.slope)
        for one, other in itertools.combinations(lines, 2)
        if one.slope != other.slope
    ]
    lengths = np.concatenate([np.sqrt(b * np.maximum(cost, 0.0) / a), meet])
    lengths = lengths[lengths > 0.0]
    room = (slope[:, None] * lengths - cost[:, None]).min(axis=0)
    values = a * lengths - b * room / lengths
    at = int(np.argmin(values))
    return float(values[at]), float(lengths[at]), float(room[at])
