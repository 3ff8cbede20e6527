# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Equations 2 to 5 from Python, and what one asks of polylines."""

import itertools
import math

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
