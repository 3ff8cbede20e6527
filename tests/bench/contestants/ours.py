# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""ltp's planners as contestants."""

from collections.abc import Callable
from typing import Any

import numpy as np

from ltp import OccupancyGrid, PenaltyWeights, Plan, Query, Raster, Scene, make_planner

from ..contest import Shared, Solver
from ..workload import Pairs, centres


def shortest(name: str) -> Callable[[Shared], Solver]:
    """A planner that is to find the shortest path through the solid town."""
    return lambda shared: _planner(name, shared.town.solid_grid, shared.town.pairs, _length)


def proof(name: str) -> Callable[[Shared], Solver]:
    """A planner that is to prove that no path leads into a building of the hollow town."""
    return lambda shared: _planner(name, shared.town.hollow_grid, shared.town.sealed, _unreachable)


def _planner(name: str, grid: OccupancyGrid, pairs: Pairs, answer: Callable[[Plan], Any]) -> Solver:
    planner = make_planner(name, weights=PenaltyWeights(length=1.0, priority=0.0))
    scene = Scene(grid, Raster(np.zeros((1, 1))))
    ends = centres(pairs)
    return Solver(lambda i: planner.plan(scene, Query(ends[i, 0], ends[i, 1])), answer)


def _length(plan: Plan) -> float:
    return plan.tally.length if plan.status.name == "FOUND" else float("inf")


def _unreachable(plan: Plan) -> bool:
    return plan.status.name == "UNREACHABLE"
