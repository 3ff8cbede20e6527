# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A priority off the grid's columns: resampled to them, and said so; a bound is never missing."""

import numpy as np
import pytest

import ltp
from ltp import PlanStatus

FRAME = ltp.GridFrame((0, 0, 0), (2, 2, 4), (16, 12, 3))
GRID = ltp.OccupancyGrid(FRAME)
QUERY = ltp.Query((3.1, 3.3, 5.0), (28.0, 20.5, 5.5), (0, 0))
RNG = np.random.default_rng(1)

OFF_THE_COLUMNS = {
    "shifted": ltp.Raster(RNG.random((16, 12)), (0.7, -0.2), 2.0),
    "finer": ltp.Raster(RNG.random((64, 48)), (0, 0), 0.5),
    "coarser": ltp.Raster(RNG.random((12, 9)), (0, 0), 3.0),
    "smaller": ltp.Raster(RNG.random((20, 15)), (4.5, 4.5), 1.0, 0.3),
    "nearly theirs": ltp.Raster(RNG.random((16, 12)), (0, 0), 2.0000001),
}
ON_THE_COLUMNS = {
    "theirs": ltp.Raster(RNG.random((16, 12)), (0, 0), 2.0),
    "theirs, elsewhere": ltp.Raster(RNG.random((10, 30)), (-6, 4), 2.0),
    "blocks of them": ltp.Raster(RNG.random((6, 4)), (-2, 0), 6.0),
}


def test_onto_columns_takes_means() -> None:
    fine = OFF_THE_COLUMNS["finer"]
    columns = ltp.onto_columns(fine, FRAME)
    assert columns.cell == 2.0
    np.testing.assert_array_equal(columns.origin, (0, 0))
    means = fine.values.reshape(16, 4, 12, 4).mean(axis=(1, 3))
    np.testing.assert_allclose(columns.values, means, atol=1e-12)
    for raster in ON_THE_COLUMNS.values():
        x, y = np.meshgrid(np.arange(1, 32, 2), np.arange(1, 24, 2), indexing="ij")
        made = ltp.onto_columns(raster, FRAME)
        np.testing.assert_allclose(made.values, raster.at(x, y), atol=1e-12)
    oblong = ltp.GridFrame((0, 0, 0), (2, 3, 4), (16, 8, 3))
    made = ltp.onto_columns(fine, oblong)
    assert (made.cell, made.shape) == (1.0, (32, 24))
    means = fine.values.reshape(16, 4, 8, 6).mean(axis=(1, 3))
    np.testing.assert_allclose(made.values, means.repeat(2, 0).repeat(3, 1), atol=1e-12)
    with pytest.raises(ValueError, match=r"^frame\.cell = .*1\.37.*: expected x and y edges"):
        ltp.onto_columns(fine, ltp.GridFrame((0, 0, 0), (1, 1.37, 4), (4, 4, 3)))


@pytest.mark.parametrize("refine", [False, True])
@pytest.mark.parametrize("info", ltp.planners(), ids=lambda info: info.name)
def test_every_plan_says_what_it_was_tallied_over_and_its_bound(
    info: ltp.PlannerInfo, refine: bool
) -> None:
    for priority in (0.0, 1.0):
        weights = ltp.PenaltyWeights(length=0.5, priority=priority)
        planner = ltp.make_planner(info.name, weights=weights, refine=refine)
        rasters = [(False, r) for r in ON_THE_COLUMNS.values()]
        for off, raster in rasters + [(True, r) for r in OFF_THE_COLUMNS.values()]:
            plan = planner.plan(ltp.Scene(GRID, raster), QUERY)
            assert plan.status == PlanStatus.FOUND
            assert plan.priority_resampled == off
            seen = ltp.onto_columns(raster, FRAME) if off else raster
            assert plan.tally.priority == ltp.tally(plan.path, seen).priority
            assert (plan.bound is not None) == info.bounds
            if info.bounds and not refine:
                assert plan.bound <= plan.penalty
            if info.bounds:  # of what is reported, so of any path over the same raster
                other = ltp.make_planner("lp-dijkstra", weights=weights)
                assert plan.bound <= other.plan(ltp.Scene(GRID, raster), QUERY).penalty + 1e-12


def test_a_window_that_rolls_is_resampled_anew() -> None:
    raster = OFF_THE_COLUMNS["finer"]
    planner = ltp.make_planner("auto")
    for shift in (0, 2, 4, 2):
        frame = ltp.GridFrame((shift, 0, 0), (2, 2, 4), (14, 12, 3))
        scene = ltp.Scene(ltp.OccupancyGrid(frame), raster)
        query = ltp.Query((5.1, 3.3, 5.0), (26.0, 20.5, 5.5), (0, 0))
        plan = planner.plan(scene, query)
        again = ltp.tally(plan.path, ltp.onto_columns(raster, frame))
        assert plan.tally.priority == again.priority


def test_the_front_is_over_the_columns_too() -> None:
    for off, rasters in ((False, ON_THE_COLUMNS), (True, OFF_THE_COLUMNS)):
        for raster in rasters.values():
            front = ltp.pareto_front(ltp.Scene(GRID, raster), QUERY)
            assert front.priority_resampled == off
            seen = ltp.onto_columns(raster, FRAME) if off else raster
            sums = [ltp.tally(path, seen) for path in front.paths]
            np.testing.assert_array_equal(front.tallies[:, 1], [s.priority for s in sums])


@pytest.mark.parametrize("cell", [(2, 3), (3, 2), (1, 2), (0.5, 0.75), (0.1, 0.3)])
def test_columns_that_are_no_squares_are_cut_into_squares(cell: tuple[float, float]) -> None:
    frame = ltp.GridFrame((0, 0, 0), (*cell, 4), (12, 9, 3))
    width, depth = 12 * cell[0], 9 * cell[1]
    query = ltp.Query((0.1 * width, 0.2 * depth, 5), (0.9 * width, 0.7 * depth, 5.5), (0, 0))
    raster = ltp.Raster(RNG.random((40, 40)), (-0.3, -0.1), width / 30)
    seen = ltp.onto_columns(raster, frame)
    for info in ltp.planners():
        for given, resampled in ((raster, True), (seen, False)):
            scene = ltp.Scene(ltp.OccupancyGrid(frame), given)
            plan = ltp.make_planner(info.name).plan(scene, query)
            assert plan.status == PlanStatus.FOUND
            assert plan.priority_resampled == resampled
            assert plan.tally.priority == ltp.tally(plan.path, seen).priority
            assert (plan.bound is not None) == info.bounds


def test_what_cannot_be_resampled_is_refused_by_name_where_exact() -> None:
    grid = ltp.OccupancyGrid(ltp.GridFrame((0, 0, 0), (1, 1.37, 4), (20, 16, 3)))
    scene = ltp.Scene(grid, OFF_THE_COLUMNS["shifted"])
    query = ltp.Query((3.1, 3.3, 5.0), (16.0, 18.5, 5.5), (0, 0))
    with pytest.raises(ValueError, match=r"^priority = a raster off the grid's columns: expected"):
        ltp.make_planner("exact").plan(scene, query)
    with pytest.raises(ValueError, match=r"^priority = a raster off the grid's columns: expected"):
        ltp.pareto_front(scene, query)
    plan = ltp.make_planner("auto").plan(scene, query)
    assert plan.status == PlanStatus.FOUND
    assert not plan.priority_resampled
    assert plan.bound is None
