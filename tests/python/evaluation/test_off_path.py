# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The distance of a flight from its global path: by hand, and against one point at a time."""

import numpy as np
import pytest

from ltp import _core as core
from ltp.evaluation import off_path as module
from ltp.evaluation.off_path import distances_to_path, off_path
from tests.python.scenes import record


def flown(*points: tuple[float, float, float]):
    """A flight through these points; its global path is 50 m along x, at y = 20 m."""
    flight = record()
    flight.positions = np.array(points, dtype=np.float64)
    return flight


def test_a_flight_along_the_global_path_is_nowhere_off_it() -> None:
    assert off_path(record()) == module.OffPath(0.0, 0.0)


def test_the_mean_is_over_the_length_flown_not_over_time() -> None:
    # 10 m along the path, 10 m away from it (5 m on average), 10 m beside it; then it hovers.
    corners = [(0.0, 20.0, 30.0), (10.0, 20.0, 30.0), (10.0, 30.0, 30.0), (20.0, 30.0, 30.0)]
    away = off_path(flown(*corners, *[corners[-1]] * 100))
    assert away.mean == pytest.approx((0.0 + 5.0 + 10.0) / 3.0)
    assert away.largest == pytest.approx(10.0)


def test_heights_do_not_count_and_beyond_the_ends_the_ends_are_nearest() -> None:
    assert off_path(flown((0, 20, 30), (25, 20, 90), (50, 20, 0))).largest == 0.0
    assert off_path(flown((50, 20, 30), (53, 24, 30))).largest == pytest.approx(5.0)
    assert off_path(flown((0, 23, 30))).mean == pytest.approx(3.0)  # it never moved


@pytest.mark.parametrize("seed", range(3))
def test_distances_are_those_of_one_point_at_a_time(
    seed: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, "_CHUNK", 40)  # several pieces
    rng = np.random.default_rng(seed)
    path = np.column_stack([rng.uniform(0, 100, (7, 2)), np.zeros(7)])
    path[3] = path[2]  # a segment of no length
    points = np.column_stack([rng.uniform(-20, 120, (50, 2)), np.zeros(50)])
    one_by_one = [core.closest_point(path, point)[2] for point in points]
    np.testing.assert_allclose(distances_to_path(points, path), one_by_one, atol=1e-9)
    alone = np.linalg.norm(points[:, :2] - path[0, :2], axis=1)
    np.testing.assert_allclose(distances_to_path(points, path[:1]), alone)
    assert len(distances_to_path(points[:0], path)) == 0
