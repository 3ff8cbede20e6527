# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The best routes over known ground: against all pairs, against planners, against their bound."""

import itertools

import numpy as np
import pytest

from ltp import _core as core
from ltp.evaluation.conditions import Weights
from ltp.evaluation.regret.gates import GatedLegs
from ltp.evaluation.regret.graph import LegGraph, Space
from ltp.evaluation.regret.routes import KnownGround
from ltp.evaluation.regret.slopes import Route, best_route
from ltp.registry import make_planner

FRAME = core.GridFrame((0.0, 0.0, 0.0), (2.0, 2.0, 4.0), (30, 24, 3))
PLANAR = (0.0, 0.0)


def ground(seed: int, density: float = 0.15) -> tuple[core.OccupancyGrid, core.Raster]:
    rng = np.random.default_rng(seed)
    blocked = np.repeat(rng.random((30, 24, 1)) < density, 3, axis=2)
    for i, j in ((2, 3), (14, 18), (20, 6), (27, 20)):
        blocked[i - 1 : i + 2, j - 1 : j + 2] = False
    patches = np.kron(rng.random((10, 8)) < 0.4, np.ones((3, 3)))
    return core.OccupancyGrid.from_array(blocked, FRAME), core.Raster(patches, cell=2.0)


def points(*cells: tuple[int, int]) -> np.ndarray:
    return np.array([FRAME.centre((i, j, 1)) for i, j in cells])


START, *WAYPOINTS = points((2, 3), (14, 18), (20, 6), (27, 20))


def judged(tally: core.PathTally, direct: float, ratio: float) -> float:
    return core.penalty(tally, direct, Weights.at_ratio(ratio).of_core)


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("ratio", [0.0, 1.0, 2.0])
def test_one_leg_is_what_the_exact_planner_finds(seed: int, ratio: float) -> None:
    grid, priority = ground(seed)
    weights = Weights.at_ratio(ratio).of_core
    direct = float(np.linalg.norm(WAYPOINTS[0] - START))
    exact = make_planner("exact", weights=weights)
    plan = exact.plan(core.Scene(grid, priority), core.Query(START, WAYPOINTS[0], PLANAR))
    assert plan.status == core.PlanStatus.FOUND
    known = KnownGround(grid, priority, PLANAR, weights)
    best = known.joint(START, np.array(WAYPOINTS[:1]), np.zeros(1), direct)
    assert best is not None
    mine = judged(best.route.tally, direct, ratio)
    # The optimum lies between the bound and the route: nothing known beats what is known.
    assert best.bound - 1e-9 <= plan.penalty <= mine + 1e-9
    assert mine - best.bound < 0.05
    np.testing.assert_allclose(best.route.path[[0, -1]], [START, WAYPOINTS[0]])


@pytest.mark.parametrize("seed", range(3))
def test_gates_are_passed_at_the_best_of_all_their_cells(seed: int) -> None:
    grid, priority = ground(seed)
    graph = LegGraph(grid, priority, Space.between(FRAME, (6.0, 6.0), PLANAR))
    alpha = 1.3
    gates = [graph.gate(waypoint, 4.1) for waypoint in WAYPOINTS[:2]]
    found = GatedLegs([graph, graph], gates, START).least(alpha)
    assert found is not None
    path, cost = found

    def from_cell(cell: int) -> np.ndarray:
        return graph.spread(np.array([cell]), np.zeros(1), alpha, np.flatnonzero(graph.free))

    first = from_cell(graph.cell_of(START))
    pairs = {(a, b): first[a] + from_cell(a)[b] for a, b in itertools.product(*gates)}
    assert cost == pytest.approx(min(pairs.values()))
    along = core.tally(path, priority)
    assert alpha * along.length - along.priority == pytest.approx(cost)
    assert grid.first_blocked(path) is None
    for waypoint in WAYPOINTS[:2]:
        assert np.linalg.norm(path[:, :2] - waypoint[:2], axis=1).min() <= 4.1
    # A wider gate costs nothing.
    wider = [graph.gate(waypoint, 8.0) for waypoint in WAYPOINTS[:2]]
    assert GatedLegs([graph, graph], wider, START).least(alpha)[1] <= cost + 1e-9  # type: ignore[index]


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("planner", ["lp-dijkstra", "sweep", "ggwp"])
def test_no_route_that_planners_fly_through_the_gates_is_below_the_bound(
    seed: int, planner: str
) -> None:
    grid, priority = ground(seed)
    weights, ways = Weights.at_ratio(2.0).of_core, np.array(WAYPOINTS)
    direct = float(core.path_length(np.array([START, *WAYPOINTS])))
    known = KnownGround(grid, priority, PLANAR, weights)
    radii = np.full(3, 4.1)
    best, legs = known.joint(START, ways, radii, direct), known.leg_by_leg(START, ways, radii)
    assert best is not None and legs is not None
    assert best.bound <= judged(legs.tally, direct, 2.0) + 1e-9
    assert best.bound <= judged(best.route.tally, direct, 2.0) <= best.bound + 0.05
    other = make_planner(planner, weights=weights)
    length = gained = 0.0
    for a, b in itertools.pairwise([START, *WAYPOINTS]):
        plan = other.plan(core.Scene(grid, priority), core.Query(a, b, PLANAR))
        length, gained = length + plan.tally.length, gained + plan.tally.priority
    flown = judged(core.PathTally(length=length, priority=gained), direct, 2.0)
    assert flown >= best.bound - 1e-9


@pytest.mark.parametrize("seed", range(5))
@pytest.mark.parametrize("band", [(0.0, 0.0), (1.0, 3.0), (np.inf, np.inf)])
def test_routes_keep_to_the_altitudes_of_their_legs(seed: int, band: tuple[float, float]) -> None:
    rng = np.random.default_rng(seed)
    blocked = rng.random(FRAME.dims) < 0.15
    ways = points((2, 3), (14, 18), (20, 6), (27, 20))
    ways[:, 2] = (5.0, 9.5, 6.5, 6.5)  # vertices lie at the altitudes where the band ends
    for i, j in ((2, 3), (14, 18), (20, 6), (27, 20)):
        blocked[i - 1 : i + 2, j - 1 : j + 2] = False
    grid = core.OccupancyGrid.from_array(blocked, FRAME)
    priority = core.Raster(rng.random((30, 24)), cell=2.0)
    weights, radii = Weights.at_ratio(2.0).of_core, np.full(3, 3.0)
    known = KnownGround(grid, priority, band, weights)
    direct = float(core.path_length(ways))
    best = known.joint(ways[0], ways[1:], radii, direct)
    legs = known.leg_by_leg(ways[0], ways[1:], radii)
    assert best is not None and legs is not None
    for route in (best.route, legs):
        assert grid.first_blocked(route.path) is None
        low, high = ways[:, 2].min() - band[0], ways[:, 2].max() + band[1]
        assert route.path[:, 2].min() >= low - 1e-9 and route.path[:, 2].max() <= high + 1e-9
        served = 0  # in order
        for point in route.path:
            if np.linalg.norm((point - ways[served + 1])[:2]) <= 3.0:
                served += 1
                if served == 3:
                    break
        assert served == 3
        # The search knows the route's cost, also where two legs see a gate's vertex apart.
        alpha = 1.3
        found = GatedLegs(*_legs(known, ways, radii), ways[0]).least(alpha)
        assert found is not None
        along = core.tally(found[0], priority)
        assert alpha * along.length - along.priority == pytest.approx(found[1])


def _legs(known: KnownGround, ways: np.ndarray, radii: np.ndarray) -> tuple[list, list]:
    heights = itertools.pairwise(float(z) for z in ways[:, 2])
    graphs = [known._graph(ends) for ends in heights]
    legs = zip(graphs, ways[1:], radii, strict=True)
    return graphs, [graph.gate(waypoint, float(radius)) for graph, waypoint, radius in legs]


def test_a_waypoint_behind_walls_leaves_no_route() -> None:
    blocked = np.zeros(FRAME.dims, dtype=bool)
    blocked[10] = True
    grid = core.OccupancyGrid.from_array(blocked, FRAME)
    known = KnownGround(grid, core.Raster(np.ones((1, 1))), PLANAR, Weights(0.5, 1.0).of_core)
    ways = np.array(WAYPOINTS[:1])
    assert known.joint(START, ways, np.zeros(1), 10.0) is None
    assert known.leg_by_leg(START, ways, np.zeros(1)) is None
    # A gate across the wall is served from this side.
    near = points((12, 3))
    best = known.joint(START, near, np.array([7.0]), 20.0)
    assert best is not None and best.route.path[:, 0].max() < 20.0


@pytest.mark.parametrize("seed", range(20))
def test_slopes_find_the_best_corner_of_the_hull_and_bound_everything(seed: int) -> None:
    rng = np.random.default_rng(seed)
    length = 100.0 * (1.0 + rng.exponential(0.6, 60))
    gained = length * np.clip(rng.normal(0.9 - 25.0 / length, 0.1), 0.0, 1.0)
    weights, direct = Weights.at_ratio(2.0).of_core, 95.0
    tallies = [core.PathTally(length=x, priority=p) for x, p in zip(length, gained, strict=True)]
    asked = []

    def search(alpha: float) -> Route:
        asked.append(alpha)
        costs = alpha * length - gained
        at = int(np.argmin(costs))
        return Route(np.empty((0, 3)), tallies[at], float(costs[at]))

    best = best_route(search, weights, direct, 1.0)
    assert best is not None and len(asked) <= 16
    values = [core.penalty(tally, direct, weights) for tally in tallies]
    assert best.bound <= min(values) + 1e-12
    slopes = np.linspace(1.02, 5.0, 4000)
    corners = {int(np.argmin(slope * length - gained)) for slope in slopes}
    found = core.penalty(best.route.tally, direct, weights)
    assert found <= min(values[corner] for corner in corners) + 0.002
    with pytest.raises(ValueError, match="W_L = 0"):
        best_route(search, core.PenaltyWeights(length=0.0, priority=1.0), direct, 1.0)
