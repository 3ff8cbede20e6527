# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The exact planner's front of length and priority, from Python."""

import math

import numpy as np
import pytest

import ltp

CELL = (2.0, 2.0, 4.0)


def puzzle(seed: int) -> tuple[ltp.Scene, ltp.Query, ltp.Raster]:
    shape = (30, 30, 2)
    rng = np.random.default_rng(seed)
    blocked = rng.random(shape) < 0.2
    blocked[2, 3, 0] = blocked[27, 25, 0] = False
    frame = ltp.GridFrame((0, 0, 0), CELL, shape)
    priority = ltp.Raster(rng.random(shape[:2]), cell=2.0)
    scene = ltp.Scene(ltp.OccupancyGrid.from_array(blocked, frame), priority)
    return scene, ltp.Query((5, 7, 2), (55, 51, 2), (0.0, 0.0)), priority


def losses(front: ltp.Front, priority: ltp.Raster) -> np.ndarray:
    return priority.values.max() * front.tallies[:, 0] - front.tallies[:, 1]


def test_the_front_is_sorted_and_its_paths_have_its_tallies() -> None:
    scene, query, priority = puzzle(1)
    front = ltp.pareto_front(scene, query)
    assert front.status == ltp.PlanStatus.FOUND
    count = len(front.paths)
    assert front.tallies.shape == (count, 2)
    assert count > 10
    assert (np.diff(front.tallies[:, 0]) > 0).all()
    assert (np.diff(losses(front, priority)) < 0).all()
    for path, (length, integral) in zip(front.paths, front.tallies, strict=True):
        tally = ltp.tally(path, priority)
        assert (tally.length, tally.priority) == (length, integral)
        np.testing.assert_array_equal(path[0], query.start)
        np.testing.assert_array_equal(path[-1], query.goal)
    length_only = ltp.PenaltyWeights(priority=0.0)
    shortest = ltp.make_planner("exact", weights=length_only).plan(scene, query)
    assert front.tallies[0, 0] == pytest.approx(shortest.tally.length, rel=1e-12)
    assert "FOUND" in repr(front)


def test_the_optimum_is_on_the_front_where_the_length_weighs_enough() -> None:
    scene, query, _ = puzzle(2)
    planner = ltp.make_planner("exact", weights=ltp.PenaltyWeights(length=1.0, priority=1.0))
    plan, front = planner.plan(scene, query), ltp.pareto_front(scene, query)
    direct = math.dist(query.start, query.goal)
    length, integral = front.tallies.T
    assert (length / direct - integral / length).min() == pytest.approx(plan.penalty, abs=1e-9)
    assert plan.bound == pytest.approx(plan.penalty, abs=1e-8)
    assert plan.bound <= plan.penalty


def test_a_coarse_front_keeps_its_factor() -> None:
    scene, query, priority = puzzle(3)
    fine = ltp.pareto_front(scene, query)
    coarse = ltp.pareto_front(scene, query, ltp.ExactOptions(eps=0.05))
    assert 0 < len(coarse.paths) < len(fine.paths)
    mine, theirs = losses(fine, priority), losses(coarse, priority)
    for length, loss in zip(fine.tallies[:, 0], mine, strict=True):
        near = (coarse.tallies[:, 0] <= 1.05 * length + 1e-9) & (theirs <= 1.05 * loss + 1e-9)
        assert near.any()


def test_it_answers_by_status_and_refuses_what_is_wrong() -> None:
    scene, query, _ = puzzle(4)
    outside = ltp.pareto_front(scene, ltp.Query((5, 7, 2), (500, 7, 2)))
    assert outside.status == ltp.PlanStatus.OUTSIDE_MAP
    assert outside.tallies.shape == (0, 2)
    assert outside.paths == []
    small = ltp.pareto_front(scene, query, ltp.ExactOptions(memory=0.01))
    assert small.status == ltp.PlanStatus.OUT_OF_BUDGET
    few = ltp.pareto_front(scene, query, budget=ltp.Budget(max_expansions=10))
    assert few.status == ltp.PlanStatus.OUT_OF_BUDGET
    soon = ltp.pareto_front(scene, query, budget=ltp.Budget(time_limit=1e-9))
    assert soon.status == ltp.PlanStatus.OUT_OF_BUDGET
    with pytest.raises(ValueError, match=r"^max_expansions = -1"):
        ltp.pareto_front(scene, query, budget=ltp.Budget(max_expansions=-1))
    for option, value in (("memory", 0.0), ("eps", -0.1), ("eps", math.nan), ("eps", math.inf)):
        with pytest.raises(ValueError, match=rf"^exact\.{option} = "):
            ltp.pareto_front(scene, query, ltp.ExactOptions(**{option: value}))
    with pytest.raises(ValueError, match=r"^start = "):
        ltp.pareto_front(scene, ltp.Query((math.nan, 7, 2), (55, 51, 2)))


def test_the_front_of_a_planner_is_the_old_name() -> None:
    scene, query, _ = puzzle(1)
    with pytest.warns(DeprecationWarning, match=r"ltp\.pareto_front"):
        front = ltp.make_planner("exact").front(scene, query)
    np.testing.assert_array_equal(front.tallies, ltp.pareto_front(scene, query).tallies)
