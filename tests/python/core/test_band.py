# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The band is in metres: altitudes of ends and band are kept, whatever the levels of the grid."""

import math

import numpy as np
import pytest

import ltp
from ltp import PlanStatus

INF = math.inf
NAMES = tuple(info.name for info in ltp.planners())
FRAME = ltp.GridFrame((-30, -30, 0), (2, 2, 4), (30, 30, 40))
EVEN = ltp.Raster(np.zeros((30, 30)), (-30, -30), 2.0)


def make(name: str, **options: object) -> ltp.Planner:
    bezier = ltp.BezierOptions(offsets=9, reach=24.0, z_offsets=5, z_reach=8.0, segments=24)
    hermite = ltp.HermiteOptions(segments=24, starts=3, refined=2, iterations=8)
    return ltp.make_planner(name, bezier=bezier, hermite=hermite, **options)


def wall(*windows: tuple[int, int]) -> ltp.OccupancyGrid:
    """A wall across the whole frame, but for cells (iy, iz)."""
    blocked = np.zeros((30, 30, 40), bool)
    blocked[15] = True
    for iy, iz in windows:
        blocked[15, iy, iz] = False
    return ltp.OccupancyGrid.from_array(blocked, FRAME)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("refine", [False, True])
def test_planar_flight_is_at_the_altitude_of_its_ends(name: str, refine: bool) -> None:
    planner = make(name, refine=refine)
    for z in (7.9, 8.0, 8.1, 50.0, 50.3, 51.999, 4.0 * math.nextafter(13, 0), 0.0, 159.9999):
        level = int(z // 4)
        grid = wall(*[(iy, level) for iy in range(12, 18)])
        plan = planner.plan(ltp.Scene(grid, EVEN), ltp.Query((-20, 0.3, z), (20, 0.7, z), (0, 0)))
        assert plan.status == PlanStatus.FOUND
        np.testing.assert_allclose(plan.path[:, 2], z, rtol=0, atol=1e-9)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize(
    ("start", "goal", "band", "level"),
    [
        (50.0, 50.0, (0, 2), 13),  # the ceiling touches the level at 52 m
        (50.0, 50.0, (2, 0), 11),
        (116.0, 116.0, (0, 4), 30),
        (51.7, 50.0, (0, 0.3), 13),  # 51.7 + 0.3 is a little more than 52
        (50.0, 49.0, (1, 0), 11),
        (50.0, 50.0, (2, 2), 13),
        (50.0, 58.0, (3, 1.9), 15),
    ],
)
def test_no_ceiling_and_no_floor_is_exceeded_by_a_cell(
    name: str, start: float, goal: float, band: tuple[float, float], level: int
) -> None:
    scene = ltp.Scene(wall((14, level), (15, level), (16, level)), EVEN)
    planner = make(name)
    plan = planner.plan(scene, ltp.Query((-20, 0.3, start), (20, 0.3, goal), band))
    closed = PlanStatus.UNREACHABLE if planner.complete else PlanStatus.NONE_FOUND
    assert plan.status == closed
    # A little more of the band opens the level, and the path flies in that little.
    below, above = band[0] + 0.25, band[1] + 0.25
    plan = planner.plan(scene, ltp.Query((-20, 0.3, start), (20, 0.3, goal), (below, above)))
    if planner.complete:
        assert plan.status == PlanStatus.FOUND
    if plan.status == PlanStatus.FOUND:
        assert plan.path[:, 2].min() >= min(start, goal) - below - 1e-9
        assert plan.path[:, 2].max() <= max(start, goal) + above + 1e-9
        assert plan.tally.length == ltp.tally(plan.path, EVEN).length


@pytest.mark.parametrize("name", NAMES)
def test_start_and_goal_in_one_are_that_point_twice(name: str) -> None:
    scene = ltp.Scene(ltp.OccupancyGrid(FRAME), EVEN)
    for refine in (False, True):
        for band in ((0, 0), (INF, INF)):
            here = np.array((1.3, -4.2, 50.7))
            plan = make(name, refine=refine).plan(scene, ltp.Query(here, here, band))
            np.testing.assert_array_equal(plan.path, [here, here])
            assert plan.tally.length == 0.0


@pytest.mark.parametrize("w_l", [0.25, 0.5, 1.0])
def test_without_priority_the_papers_planners_find_the_shortest_path_soon(w_l: float) -> None:
    rng = np.random.default_rng(5)
    frame = ltp.GridFrame((0, 0, 0), (2, 2, 4), (120, 120, 10))
    blocked = np.zeros((120, 120, 10), bool)
    for x, y in rng.integers(5, 110, (25, 2)):
        blocked[x : x + 8, y : y + 9, : rng.integers(3, 10)] = True
    scene = ltp.Scene(ltp.OccupancyGrid.from_array(blocked, frame), EVEN)
    weights = ltp.PenaltyWeights(length=w_l, priority=0.0)
    found = 0
    for _ in range(25):
        start, goal = rng.uniform((0, 0, 0), (240, 240, 40), (2, 3))
        query = ltp.Query(start, goal, [(0, 0), (3, 5), (INF, INF)][found % 3])
        best = make("additive", weights=weights).plan(scene, query)
        for name in ("lp-dijkstra", "lp-a-star"):
            plan = make(name, weights=weights).plan(scene, query)
            assert plan.status == best.status
            if plan.status != PlanStatus.FOUND:
                continue
            found += 1
            assert plan.tally.length == pytest.approx(best.tally.length, abs=1e-9)
            assert plan.stats.expanded == best.stats.expanded
    assert found > 20
