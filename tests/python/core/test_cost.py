# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Equations 2 to 5 from Python, and what one asks of polylines."""

import itertools
import math
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import ltp
from ltp._core import closest_point, path_length, point_at, resample

NAN, INF = math.nan, math.inf
PATHS = st.lists(st.tuples(*[st.floats(-20, 20)] * 3), min_size=1, max_size=8).map(np.array)


def halves() -> ltp.Raster:
    """Priority 1 where x < 10, 0.25 beyond; 0 outside of 20 m x 20 m."""
    return ltp.Raster(np.array([[1, 1], [0.25, 0.25]]), cell=10.0)


def test_the_paper_worked_out_by_hand() -> None:
    path = np.array([[5.0, 5, 0], [10, 5, 0], [15, 5, 0], [15, 5, 12], [15, 9, 15]])
    sums = ltp.tally(path, halves())
    assert sums.length == pytest.approx(5 + 5 + 12 + 5)  # Eq. (2)
    assert sums.priority == pytest.approx(5 + 22 * 0.25)  # Eq. (4), numerator
    assert sums.mean_priority == pytest.approx(10.5 / 27)
    direct = math.dist(path[0], path[-1])
    penalty = ltp.penalty(sums, direct, ltp.PenaltyWeights(length=0.5, priority=2.0))
    assert penalty == pytest.approx(0.5 * 27 / direct - 2.0 * 10.5 / 27)  # Eq. (5)
    assert ltp.penalty(sums, direct) == pytest.approx(0.5 * 27 / direct - 10.5 / 27)
    assert repr(sums) == "PathTally(length=27.0, priority=10.5)"


def test_the_straight_way_over_priority_one_costs_the_weights() -> None:
    sums = ltp.tally(np.array([[1.0, 1, 3], [9, 1, 3]]), halves())
    assert ltp.penalty(sums, 8.0, ltp.PenaltyWeights(length=0.5, priority=3.0)) == pytest.approx(
        -2.5
    )


def test_a_tally_is_made_of_both_integrals() -> None:
    sums = ltp.PathTally(length=27.0, priority=10.5)
    assert (sums.length, sums.priority, sums.mean_priority) == (27.0, 10.5, 10.5 / 27.0)
    weights = ltp.PenaltyWeights(length=0.5, priority=2.0)
    assert ltp.penalty(sums, 20.0, weights) == pytest.approx(0.5 * 27 / 20 - 2.0 * 10.5 / 27)
    with pytest.raises(TypeError):
        ltp.PathTally(27.0, 10.5)


def test_start_equals_goal() -> None:
    sums = ltp.tally(np.array([[1.0, 1, 3], [1, 1, 3]]), halves())
    assert (sums.length, sums.priority, sums.mean_priority) == (0, 0, 0)
    assert ltp.penalty(sums, 0.0) == 0.5  # the ratio of lengths is 1


@settings(deadline=None, max_examples=200)
@given(path=PATHS)
def test_a_tally_is_a_sum_over_pieces(path: np.ndarray) -> None:
    raster = halves()
    sums = ltp.tally(path, raster)
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    assert sums.length == pytest.approx(steps.sum())
    assert sums.length == pytest.approx(path_length(path))
    pieces = [raster.integral(a, b) for a, b in itertools.pairwise(path)]
    assert sums.priority == pytest.approx(sum(pieces), abs=1e-12)
    assert -1e-9 <= sums.priority <= sums.length + 1e-9
    back = ltp.tally(path[::-1].copy(), raster)
    # An end on the border of two priorities may be cut to either side.
    assert back.priority == pytest.approx(sums.priority, abs=1e-7)


@pytest.mark.parametrize(
    ("name", "arguments"),
    [
        ("weights.length", {"weights": ltp.PenaltyWeights(length=-1.0)}),
        ("weights.length", {"weights": ltp.PenaltyWeights(length=NAN)}),
        ("weights.priority", {"weights": ltp.PenaltyWeights(priority=INF)}),
        (
            "weights.length \\+ weights.priority",
            {"weights": ltp.PenaltyWeights(length=0.0, priority=0.0)},
        ),
        ("direct_length", {"direct_length": -1.0}),
        ("direct_length", {"direct_length": NAN}),
    ],
)
def test_a_penalty_names_what_is_wrong(name: str, arguments: dict[str, float]) -> None:
    with pytest.raises(ValueError, match=rf"^{name} = "):
        ltp.penalty(**({"tally": ltp.PathTally(), "direct_length": 1.0} | arguments))


def test_paths_are_checked() -> None:
    good = np.zeros((3, 3))
    for function in (
        lambda p: ltp.tally(p, halves()),
        path_length,
        lambda p: resample(p, 1.0),
        lambda p: point_at(p, 1.0),
        lambda p: closest_point(p, (0, 0, 0)),
    ):
        for bad in (NAN, INF, -INF):
            broken = good.copy()
            broken[2, 1] = bad
            with pytest.raises(ValueError, match=r"^path\[2\] = "):
                function(broken)
        for wrong in (np.zeros((3, 2)), np.zeros(5), "abc", None):
            with pytest.raises(TypeError):
                function(wrong)


def test_a_tally_of_any_length_returns_at_once() -> None:
    raster = ltp.Raster(np.ones((10, 10)), outside=0.5)
    sums = ltp.tally(np.array([[-1e12, 5, 0], [1e12, 5, 0]]), raster)
    assert sums.mean_priority == pytest.approx(0.5)


@settings(deadline=None, max_examples=200)
@given(path=PATHS, spacing=st.floats(0.05, 50))
def test_resampling_keeps_both_ends(path: np.ndarray, spacing: float) -> None:
    points = resample(path, spacing)
    total = path_length(path)
    np.testing.assert_array_equal(points[0], path[0])
    if total > 0:
        np.testing.assert_array_equal(points[-1], path[-1])
    assert (np.linalg.norm(np.diff(points, axis=0), axis=1) <= spacing * (1 + 1e-8)).all()
    for i, point in enumerate(points[:-1]):
        np.testing.assert_allclose(point, point_at(path, i * spacing), atol=1e-9)


@settings(deadline=None, max_examples=200)
@given(path=PATHS, point=st.tuples(*[st.floats(-30, 30)] * 3), start=st.floats(0, 60))
def test_no_point_of_the_path_is_closer_than_the_closest(
    path: np.ndarray, point: tuple[float, float, float], start: float
) -> None:
    found, arc, distance = closest_point(path, point, from_arc_length=start)
    total = path_length(path)
    assert distance == pytest.approx(math.dist(found, point), abs=1e-9)
    assert min(start, total) - 1e-9 <= arc <= total + 1e-9
    np.testing.assert_allclose(point_at(path, arc), found, atol=1e-7)
    for other in np.linspace(min(start, total), total, 50):
        assert distance <= math.dist(point_at(path, other), point) + 1e-7


def test_what_is_no_number_is_refused() -> None:
    path = np.array([[0.0, 0, 0], [1, 0, 0]])
    with pytest.raises(ValueError, match=r"^arc_length = nan"):
        point_at(path, NAN)
    with pytest.raises(ValueError, match=r"^from_arc_length = nan"):
        closest_point(path, (0, 0, 0), NAN)
    for spacing in (0.0, -1.0, NAN, INF, 1e-12, 1e-300):
        with pytest.raises(ValueError, match=r"^spacing = "):
            resample(path, spacing)
    for function in (lambda p: resample(p, 1.0), lambda p: point_at(p, 0.0)):
        with pytest.raises(ValueError, match=r"^path = "):
            function(np.empty((0, 3)))


SCALES = (1e-300, 2e-292, 9.9e-272, 1e-160, 1e-100, 1.0, 1e100, 1e154, 1e250, 1e299)


@settings(deadline=None, max_examples=60)
@given(path=PATHS, share=st.floats(0, 1), scale=st.sampled_from(SCALES))
def test_whatever_the_unit_a_path_keeps_its_shape(
    path: np.ndarray, share: float, scale: float
) -> None:
    path = np.round(path, 3) / 64.0  # no length of it under- or overflows by itself
    whole = path_length(path)
    scaled = path * scale
    assert path_length(scaled) == pytest.approx(whole * scale, rel=1e-12)
    at = point_at(path, share * whole)
    np.testing.assert_allclose(point_at(scaled, share * whole * scale) / scale, at, atol=1e-9)
    point, _, distance = closest_point(path, (0.1, 0.2, 0.3))
    found = closest_point(scaled, np.array((0.1, 0.2, 0.3)) * scale)
    np.testing.assert_allclose(found[0] / scale, point, atol=1e-7)
    assert found[2] / scale == pytest.approx(distance, abs=1e-9)
    for spacing in (max(whole, 1e-3) / 3.5 * scale, 1.0):
        if whole * scale / spacing > 100:
            continue
        points = resample(scaled, spacing)
        np.testing.assert_array_equal(points[0], scaled[0])
        if whole > 0:
            np.testing.assert_array_equal(points[-1], scaled[-1])


@pytest.mark.parametrize("scale", SCALES)
def test_a_tally_knows_no_unit(scale: float) -> None:
    raster = ltp.Raster(np.array([[1, 1], [0.25, 0.25]]), cell=10.0 * scale)
    path = np.array([[5.0, 5, 0], [10, 5, 0], [15, 5, 0], [15, 5, 12], [15, 9, 15]])
    sums = ltp.tally(path * scale, raster)
    assert sums.length / scale == pytest.approx(27)
    assert sums.priority / scale == pytest.approx(10.5)
    assert ltp.penalty(sums, 10.0 * scale) == pytest.approx(0.5 * 2.7 - 10.5 / 27)
    assert raster.at(5 * scale, 5 * scale) == 1
    assert raster.bilinear(10 * scale, 10 * scale) == pytest.approx(0.625)
    assert raster.at(21 * scale, 5 * scale) == 0


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: path_length(np.array([[-1.5e308, 0, 0], [1.5e308, 0, 0]])), r"path\[1\]"),
        (lambda: point_at(np.array([[-1.5e308, 0, 0], [1.5e308, 0, 0]]), 1.0), r"path\[1\]"),
        (lambda: path_length(np.array([[0, 0, 0], [1e308, 0, 0]] * 2)), "length of the path"),
        (lambda: ltp.Raster(np.zeros((2, 2)), cell=1e308), "cell"),
        (lambda: ltp.Raster(np.zeros((2, 2)), origin=(1e6, 0), cell=1e-300), "cell"),
        (lambda: ltp.Raster(np.zeros((2, 2)), origin=(0, -1e6), cell=1e-11), "cell"),
        (lambda: ltp.GridFrame((0, 0, 0), (1, 1, 1e308), (2, 2, 2)), r"cell\.z"),
    ],
)
def test_what_no_number_can_hold_is_refused(call: Callable[[], object], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call()


@pytest.mark.parametrize("scale", SCALES)
def test_a_grid_knows_no_unit(scale: float) -> None:
    frame = ltp.GridFrame((0, 0, 0), (2 * scale, 2 * scale, 4 * scale), (8, 8, 8))
    grid = np.zeros((8, 8, 8), dtype=bool)
    grid[4, 2, 1] = True
    blocked = ltp.OccupancyGrid.from_array(grid, frame)
    inside = np.array([9.0, 5.0, 6.0]) * scale
    assert frame.cell_of(inside).tolist() == [4, 2, 1]
    np.testing.assert_allclose(frame.centre((4, 2, 1)), inside, rtol=1e-12)
    assert blocked.blocked_at(inside[None]).tolist() == [True]
    path = np.array([[1.0, 5.0, 6.0], [15.0, 5.0, 6.0]]) * scale
    assert blocked.first_blocked(path) / scale == pytest.approx(7.0)
    assert blocked.first_blocked(path[::-1]) / scale == pytest.approx(5.0)
    assert ltp.inflate(blocked, scale).count() == 27


@pytest.mark.parametrize("far", [1e9, 1e12, 1e17, 1e100, 1e300])
def test_a_blocked_cell_stops_the_longest_path(far: float) -> None:
    grid = np.zeros((8, 8, 8), dtype=bool)
    grid[4, 2, 1] = True
    blocked = ltp.OccupancyGrid.from_array(grid, ltp.GridFrame((0, 0, 0), (1, 1, 1), (8, 8, 8)))
    for begin, end in (
        ((-far, 2.5, 1.5), (far, 2.5, 1.5)),
        ((far, 2.5, 1.5), (4.5, 2.5, 1.5)),
        ((4.5, 2.5, 1.5), (4.5, far, 1.5)),
    ):
        found = blocked.first_blocked(np.array([begin, end]))
        assert found == pytest.approx(math.dist(begin, (4.5, 2.5, 1.5)), rel=1e-9, abs=1.0)
    assert blocked.first_blocked(np.array([(-far, 4.5, 1.5), (far, 4.5, 1.5)])) is None
