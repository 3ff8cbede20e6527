# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What paths one query offers, by length and priority, and which ones planners take."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ltp._core import ExactOptions, LinearisedOptions, PlanStatus, Query, Scene, pareto_front
from ltp.brief import brief
from ltp.registry import make_planner

from ..conditions import Weights
from ..contenders import Contender
from .cases import Case
from .queries import BANDS, QuerySet

EXACT = "exact"  # the planner whose bound is its own penalty

_SEARCHES = 200  # for a hull, at most
_NEAR = 1e-6  # nearer together two tallies are one [m]


@dataclass(frozen=True)
class Landing:
    """Where a planner's path lies."""

    planner: str  # name of its `Contender`
    length: float  # L [m]
    priority: float  # integral along the path [m]
    penalty: float  # Eq. 5
    bound: float | None  # the planner's certificate


@dataclass(frozen=True, eq=False)
class FrontView:
    """One query under one case. Tallies are rows (length, integral of the priority) [m]."""

    case: Case
    query: int
    direct_length: float  # [m]
    most: float  # the largest priority
    hull: NDArray[np.float64]  # (h, 2) supported tallies, by length: the best of alpha L - P
    front: NDArray[np.float64] | None  # (k, 2) see `exact_front`
    landings: list[Landing]

    __repr__ = brief

    @property
    def weights(self) -> Weights:
        """W_L and W_P."""
        return Weights.at_ratio(self.case.ratio)

    @property
    def certificate(self) -> Landing | None:
        """The plan with the best bound, but for the exact one: its bound is its own penalty."""
        bounded = [b for b in self.landings if b.bound is not None and b.planner != EXACT]
        return max(bounded, key=lambda b: -math.inf if b.bound is None else b.bound, default=None)

    def envelope(self, longest: float) -> NDArray[np.float64]:
        """Above it lies no path: (n, 2) in the plane, through all corners of the hull.

        Args:
            longest: how far it goes on beyond the last corner, where nothing but the last
                constraint and the largest priority hold [times direct length].
        """
        pieces = [self.hull[:1]]
        pieces += [_between(a, b) for a, b in itertools.pairwise(self.hull)]
        end = self.hull[-1]
        if (length := longest * self.direct_length) > end[0]:
            tail = _between(end, end + (length - end[0]) * np.array([1.0, _least_alpha(self.most)]))
            tail[:, 1] = np.minimum(tail[:, 1], self.most * tail[:, 0])
            pieces.append(tail)
        return plane(np.concatenate(pieces), self.direct_length)


def survey(
    queries: QuerySet,
    index: int,
    case: Case,
    contenders: Sequence[Contender],
    memory: float = 2048.0,
) -> FrontView:
    """Ask every contender one query, and find the front of all paths and its hull.

    Args:
        queries: the recorded ones.
        index: which of them.
        case: map, band and weights.
        contenders: to ask.
        memory: for the front [MB]; the view has none if it needs more.

    Raises:
        ValueError: if there is no such query, or it has no path.
    """
    if not 0 <= index < len(queries.queries):
        raise ValueError(f"query {index}: there are {len(queries.queries)}, the first is 0")
    recorded = queries.queries[index]
    scene, query = queries.scene(recorded, case.priority_map), recorded.query(BANDS[case.band])
    most = float(queries.priorities[recorded.scenario][case.priority_map].values.max())
    landings = []
    for contender in contenders:
        plan = contender.make(case.ratio).plan(scene, query)
        if plan.status == PlanStatus.FOUND:
            penalty, bound = contender.judge(plan, recorded.direct_length, case.ratio)
            sums = plan.tally
            landings.append(Landing(contender.name, sums.length, sums.priority, penalty, bound))
    hull = supported(scene, query, most)
    front = exact_front(scene, query, memory)
    return FrontView(case, index, recorded.direct_length, most, hull, front, landings)


def exact_front(scene: Scene, query: Query, memory: float) -> NDArray[np.float64] | None:
    """The tallies (k, 2) of all paths of which none is both shorter and over better ground.

    None if that takes more than `memory` [MB].
    """
    found = pareto_front(scene, query, ExactOptions(memory=memory))
    return np.asarray(found.tallies) if found.status == PlanStatus.FOUND else None


def supported(scene: Scene, query: Query, most: float) -> NDArray[np.float64]:
    """The corners of the hull of all (length, priority integral), (h, 2), by length [m].

    Dichotomic search (Aneja and Nair 1979): between two corners the additive planner looks for a
    path beyond the line through them. It ends where a longer path would gain less per metre than
    `most`: from there on, going in circles over the best ground would pay.

    Args:
        scene: where.
        query: from where to where.
        most: the largest priority.

    Raises:
        ValueError: if the query has no path.
    """
    least = _least_alpha(most)
    shortest, longest = _least(scene, query, 1e6), _least(scene, query, least)
    corners = {shortest, longest}
    waiting = [(shortest, longest)]
    for _ in range(_SEARCHES):
        if not waiting:
            break
        left, right = waiting.pop(0)
        rise, run = right[1] - left[1], right[0] - left[0]
        if run < _NEAR or (alpha := rise / run) < least:
            continue
        found = _least(scene, query, alpha)
        if alpha * found[0] - found[1] < alpha * left[0] - left[1] - _NEAR:
            corners.add(found)
            waiting += [(left, found), (found, right)]
    return _distinct(sorted(corners))


def _distinct(corners: Sequence[tuple[float, float]]) -> NDArray[np.float64]:
    """One of those that differ by rounding only."""
    kept = [corners[0]]
    kept += [b for a, b in itertools.pairwise(corners) if b[0] - a[0] >= _NEAR]
    return np.array(kept)


def _least(scene: Scene, query: Query, alpha: float) -> tuple[float, float]:
    """Length and priority integral of the path with the least alpha L - P [m]."""
    planner = make_planner("additive", linearised=LinearisedOptions(alpha=alpha))
    plan = planner.plan(scene, query)
    if plan.status != PlanStatus.FOUND:
        raise ValueError(f"the query has no path: {plan.status.name.lower()}")
    return plan.tally.length, plan.tally.priority


def _least_alpha(most: float) -> float:
    """The smallest with which every step costs something, and a little more."""
    return 1.001 * max(most, 1e-6)


def _between(a: NDArray[np.float64], b: NDArray[np.float64]) -> NDArray[np.float64]:
    """Tallies from a, which is left out, to b: straight, but curved in the plane."""
    return np.asarray(a + np.linspace(0.0, 1.0, 25)[1:, None] * (b - a))


def plane(tallies: NDArray[np.float64], direct: float) -> NDArray[np.float64]:
    """(length / direct length, mean priority) of tallies (n, 2)."""
    return np.column_stack([tallies[:, 0] / direct, tallies[:, 1] / tallies[:, 0]])
