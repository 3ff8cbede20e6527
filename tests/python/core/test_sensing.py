# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces and the LiDAR from Python: arrays, errors, and properties of random scenes."""

import gc
import itertools
import math
import threading
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ltp._core import (
    GridFrame,
    HeightSurface,
    Lidar,
    LidarOptions,
    LidarPattern,
    OctreeSurface,
    Pose,
    Raster,
)


def town() -> HeightSurface:
    """200 m x 200 m at height 0, a block of 30 m in its middle."""
    heights = np.zeros((200, 200))
    heights[90:110, 90:110] = 30.0
    return HeightSurface(Raster(heights))


def random_city(seed: int, shape: tuple[int, int] = (30, 24)) -> HeightSurface:
    """Blocks of any height and of multiples of 4 m."""
    rng = np.random.default_rng(seed)
    heights = np.zeros(shape)
    for _ in range(20):
        i, j = rng.integers(0, shape)
        height = rng.uniform(-5, 25)
        heights[i : i + rng.integers(1, 6), j : j + rng.integers(1, 6)] = (
            4.0 * round(height / 4) if rng.random() < 0.4 else height
        )
    return HeightSurface(Raster(heights, origin=(-3, 5)))


def small_lidar(**options: Any) -> Lidar:
    return Lidar(LidarOptions(pattern=LidarPattern(azimuths=60, rows=12), **options))


def test_a_ray_hits_the_wall_in_front() -> None:
    hit = town().cast((60.5, 95.5, 20), (1, 0, 0), 50.0)
    assert hit.hit
    assert hit.range == 29.5
    np.testing.assert_allclose(hit.inside, [90.001, 95.5, 20], atol=1e-9)
    miss = town().cast((60.5, 95.5, 20), (-1, 0, 0), 50.0)
    assert not miss.hit
    assert miss.range == math.inf
    assert np.isnan(miss.inside).all()


def test_rays_cast_together_are_rays_cast_one_by_one() -> None:
    rng = np.random.default_rng(3)
    surface = random_city(3)
    origins = np.repeat(rng.uniform([8, 14, 26], [18, 20, 28], (3, 3)), (1500, 2, 1), axis=0)
    directions = rng.normal(size=origins.shape)
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    ranges = surface.cast_rays(origins, directions, 30.0)
    expected = [surface.cast(o, d, 30.0).range for o, d in zip(origins, directions, strict=True)]
    np.testing.assert_array_equal(ranges, expected)
    assert 100 < np.isfinite(ranges).sum() < 1300
    assert surface.cast_rays(np.zeros((0, 3)), np.zeros((0, 3)), 30.0).shape == (0,)


def test_misses_can_be_counted_only() -> None:
    pose = Pose((60, 95, 20), pitch=0.1)
    listed = small_lidar().scan(town(), pose)
    counted = small_lidar().scan(town(), pose, misses=False)
    np.testing.assert_array_equal(counted.hits, listed.hits)
    assert counted.misses.shape == (0, 3)
    assert counted.statistics.misses == len(listed.misses)


@settings(deadline=None, max_examples=40)
@given(
    seed=st.integers(0, 2**32 - 1),
    yaw=st.floats(-4, 4),
    tilt=st.sampled_from([0.0, 0.0, 0.2]),
    x=st.floats(-5, 35),
    y=st.floats(0, 35),
    z=st.floats(-3, 40),
)
def test_a_complete_map_holds_every_hit(
    seed: int, yaw: float, tilt: float, x: float, y: float, z: float
) -> None:
    surface = random_city(seed)
    scan = small_lidar().scan(surface, Pose((x, y, z), yaw=yaw, pitch=tilt))
    frame = GridFrame((-60, -60, -100), (2, 2, 4), (80, 80, 60))
    assert surface.occupancy(frame).blocked_at(scan.hits).all()
    # Without noise the ends lie in the solid or on it, the misses' at the maximum range.
    assert (surface.clearance(scan.hits, 10.0) == 0.0).all()
    ends = np.linalg.norm(scan.misses - scan.origin, axis=1)
    np.testing.assert_allclose(ends, 50.0, atol=1e-9)
    counts = scan.statistics
    assert (counts.hits, counts.misses) == (len(scan.hits), len(scan.misses))
    assert counts.hits + counts.misses == 60 * 12


@settings(deadline=None, max_examples=60)
@given(seed=st.integers(0, 2**32 - 1))
def test_a_path_collides_where_its_samples_reach_the_solid(seed: int) -> None:
    rng = np.random.default_rng(seed)
    surface = random_city(seed)
    path = rng.uniform([-8, 0, 2], [32, 34, 25], (4, 3))
    steps = np.linspace(0, 1, 2001)[:, None]
    samples = np.concatenate([a + steps * (b - a) for a, b in itertools.pairwise(path)])
    arcs = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(samples, axis=0), axis=1))])
    inside = surface.clearance(samples, 1.0) == 0.0
    first = surface.first_collision(path)
    if inside.any():  # sampling can miss a corner, never invent one
        assert first is not None
        assert first <= arcs[inside][0] + 1e-6
    if first is not None:
        at = np.array([np.interp(first, arcs, samples[:, k]) for k in range(3)])
        assert surface.clearance(at[None], 1.0)[0] < 1e-6


@settings(deadline=None, max_examples=40)
@given(seed=st.integers(0, 2**32 - 1))
def test_clearance_is_the_distance_to_the_nearest_column(seed: int) -> None:
    surface = random_city(seed)
    heights = surface.heights
    rng = np.random.default_rng(seed)
    points = rng.uniform([-20, -20, -10], [50, 50, 45], (20, 3))
    i, j = np.indices(heights.shape)
    x = heights.origin[0] + i * heights.cell
    y = heights.origin[1] + j * heights.cell
    expected = []
    for px, py, pz in points:
        dx = np.maximum(np.maximum(x - px, px - x - heights.cell), 0)
        dy = np.maximum(np.maximum(y - py, py - y - heights.cell), 0)
        dz = np.maximum(pz - heights.values, 0)
        expected.append(min(np.sqrt(dx**2 + dy**2 + dz**2).min(), 15.0))
    np.testing.assert_allclose(surface.clearance(points, 15.0), expected, atol=1e-9)


def test_scans_are_views_that_outlive_what_they_came_from() -> None:
    scan = small_lidar().scan(town(), Pose((60, 95, 20)))
    hits = scan.hits
    assert hits.dtype == np.float64
    assert hits.shape == (scan.statistics.hits, 3)
    assert np.shares_memory(hits, scan.hits)
    with pytest.raises(ValueError, match="read-only"):
        hits[0, 0] = 1.0
    copy = hits.copy()
    del scan
    gc.collect()
    small_lidar().scan(town(), Pose((20, 20, 40)))
    np.testing.assert_array_equal(hits, copy)


def test_an_empty_scan_has_arrays_without_rows() -> None:
    scan = small_lidar().scan(town(), Pose((100, 100, 900)))
    assert scan.hits.shape == (0, 3)
    assert scan.misses.shape == (720, 3)
    assert town().clearance(scan.hits, 1.0).shape == (0,)


def test_noise_repeats_by_seed_and_sequence() -> None:
    noisy: dict[str, Any] = {"range_noise_sd": 0.2, "drop_out": 0.1, "seed": 5}
    pose = Pose((60, 95, 20), yaw=0.3)
    first = small_lidar(**noisy).scan(town(), pose, sequence=3)
    again = small_lidar(**noisy).scan(town(), pose, sequence=3)
    np.testing.assert_array_equal(first.hits, again.hits)
    assert first.statistics.dropped > 0
    other = small_lidar(**noisy).scan(town(), pose, sequence=4)
    assert other.hits.shape != first.hits.shape or (other.hits != first.hits).any()


def test_ranges_of_a_real_sensor() -> None:
    lidar = Lidar(
        LidarOptions(
            pattern=LidarPattern(azimuths=8, rows=1, elevation_from_deg=0.0, elevation_to_deg=0.0),
            max_range=30.0,
        )
    )
    np.testing.assert_allclose(lidar.directions[4], [1, 0, 0], atol=1e-12)
    ranges = [5.0, np.nan, np.inf, -np.inf, 10.0, 30.0, -2.0, 0.0]
    scan = lidar.from_ranges(np.array(ranges), Pose((1, 2, 3)))
    counts = scan.statistics
    assert (counts.hits, counts.misses, counts.invalid, counts.dropped) == (2, 2, 4, 0)
    np.testing.assert_allclose(scan.hits[1], [11, 2, 3], atol=1e-9)
    as_drivers_give_them = lidar.from_ranges(np.array(ranges, dtype=np.float32), Pose((1, 2, 3)))
    np.testing.assert_allclose(as_drivers_give_them.hits, scan.hits)
    with pytest.raises(ValueError, match=r"ranges\.size = 7"):
        lidar.from_ranges(np.ones(7), Pose((0, 0, 0)))


def test_an_octree_surface_holds_the_voxels_of_its_points() -> None:
    surface = OctreeSurface(np.array([[0.5, 0.5, 0.5], [0.6, 0.6, 0.6], [3.5, 0.5, 0.5]]), 1.0)
    assert surface.size == 2
    assert surface.resolution == 1.0
    assert surface.cast((-4, 0.5, 0.5), (1, 0, 0), 10.0).range == 4.0
    scan = small_lidar().scan(surface, Pose((0.5, 0.5, 2.5)))
    assert scan.statistics.hits > 0
    assert surface.voxels.blocked_at(scan.hits).all()


def test_rays_over_an_octree_are_those_cast_one_by_one() -> None:
    rng = np.random.default_rng(3)
    surface = OctreeSurface(rng.uniform(-10, 10, (4000, 3)), 0.25)
    assert surface.memory < 2_000_000
    scan = small_lidar().scan(surface, Pose((0.1, 0.2, 0.3), yaw=0.4, pitch=0.5))
    assert scan.statistics.hits > 100
    assert surface.voxels.blocked_at(scan.hits).all()
    directions = rng.normal(size=(500, 3))
    directions /= np.linalg.norm(directions, axis=1, keepdims=True)
    ranges = surface.cast_rays(np.zeros((500, 3)), directions, 30.0)
    alone = [surface.cast((0, 0, 0), direction, 30.0).range for direction in directions]
    np.testing.assert_array_equal(ranges, alone)


def test_an_octree_surface_may_be_as_wide_as_octomaps_world() -> None:
    ends = np.array([[-1638.4, -1638.4, -1638.4], [1638.35, 1638.35, 1638.35]])
    surface = OctreeSurface(ends + 0.01, 0.05)
    assert surface.cast((0, 0, 0), np.full(3, -(3**-0.5)), 3000.0).hit
    assert surface.clearance(np.array([[1638.375, 1638.375, 1630.35]]), 50.0) == pytest.approx(8.0)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda s: s.cast((0, math.nan, 0), (1, 0, 0), 10), "origin"),
        (lambda s: s.cast((0, 0, 0), (1, 1, 0), 10), "direction"),
        (lambda s: s.cast((0, 0, 0), (math.nan, 0, 0), 10), "direction"),
        (lambda s: s.cast((0, 0, 0), (1, 0, 0), -1), "max_range"),
        (lambda s: s.cast((0, 0, 0), (1, 0, 0), math.inf), "max_range"),
        (lambda s: s.cast_rays(np.full((1, 3), math.nan), np.eye(3)[:1], 10), r"origins\[0\]"),
        (lambda s: s.cast_rays(np.zeros((2, 3)), np.eye(3), 10), "directions"),
        (lambda s: s.cast_rays(np.eye(3), 2 * np.eye(3), 10), r"directions\[0\]"),
        (lambda s: s.cast_rays(np.eye(3), np.eye(3), 0), "max_range"),
        (lambda s: s.first_collision(np.array([[0, 0, 1], [0, 0, math.inf]])), r"path\[1\]"),
        (lambda s: s.clearance(np.array([[0, 0, 1], [0, math.nan, 0]]), 10), r"points\[1\]"),
        (lambda s: s.clearance(np.zeros((1, 3)), -1), "max_distance"),
        (lambda s: s.clearance(np.zeros((0, 3)), math.nan), "max_distance"),
        (lambda s: OctreeSurface(np.array([[0, 0, math.nan]]), 1.0), r"points\[0\]"),
        (lambda s: OctreeSurface(np.zeros((1, 3)), 0.0), "resolution"),
        (lambda s: OctreeSurface(np.zeros((1, 3)), 1e-300), "resolution = 1e-300.*1e-6 to 1e6 m"),
        (lambda s: OctreeSurface(np.zeros((1, 3)), 9e-7), "resolution"),
        (lambda s: OctreeSurface(np.zeros((1, 3)), 1.1e6), "resolution"),
        (lambda s: OctreeSurface(np.zeros((1, 3)), 1e300), "resolution"),
        (lambda s: Lidar(LidarOptions(min_range=-1.0)), "min_range"),
        (lambda s: Lidar(LidarOptions(min_range=50.0)), "min_range"),
        (lambda s: OctreeSurface(np.array([[0.0] * 3, [5000.0] * 3]), 1.0).voxels, "bounding box"),
        (lambda s: Lidar(LidarOptions(max_range=math.nan)), "max_range"),
        (lambda s: Lidar(LidarOptions(drop_out=2.0)), "drop_out"),
        (lambda s: Lidar(LidarOptions(pattern=LidarPattern(rows=0))), "rows"),
        (lambda s: Pose((0, 0, math.inf)), "position"),
    ],
)
def test_a_wrong_value_is_named(call: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        call(town())


@pytest.mark.parametrize(
    "call",
    [
        lambda s: s.first_collision(np.zeros((2, 2))),
        lambda s: s.cast_rays(np.zeros((3, 2)), np.eye(3), 1.0),
        lambda s: s.clearance(np.zeros((2, 3), dtype=complex), 1.0),
        lambda s: s.clearance(np.zeros((2, 2, 2, 3)), 1.0),
        lambda s: OctreeSurface(np.zeros((2, 3), dtype=object), 1.0),
        lambda s: HeightSurface(np.zeros((2, 2))),
        lambda s: Lidar(LidarOptions(range=3)),
        lambda s: LidarPattern(azimuths=1.5),
        lambda s: Lidar().scan(s, (0, 0, 0)),
    ],
)
def test_a_wrong_type_is_a_type_error(call: Any) -> None:
    with pytest.raises(TypeError):
        call(town())


def test_options_show_their_fields() -> None:
    options = LidarOptions(max_range=30.0)
    options.pattern.rows = 8
    assert options.pattern.rows == 8
    assert "max_range=30.0" in repr(options)
    assert "rows=8" in repr(options)
    assert Lidar(options).options.pattern.rows == 8


def test_threads_may_share_a_lidar_and_a_surface() -> None:
    lidar = small_lidar(range_noise_sd=0.1)
    surface = random_city(1)
    poses = [Pose((n, 12, 30), yaw=0.1 * n) for n in range(8)]
    expected = [lidar.scan(surface, pose, n).hits.copy() for n, pose in enumerate(poses)]
    found: list[np.ndarray[Any, Any]] = [np.empty(0)] * 8

    def work(n: int) -> None:
        for _ in range(20):
            found[n] = lidar.scan(surface, poses[n], n).hits

    threads = [threading.Thread(target=work, args=(n,)) for n in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one, other in zip(expected, found, strict=True):
        np.testing.assert_array_equal(one, other)
