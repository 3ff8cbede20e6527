# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point clouds as drivers deliver them: every layout means the same points, the rest is refused."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import ltp
from ltp._core import (
    ConcurrentTrajectoryPlanner,
    HeightSurface,
    Lidar,
    LidarOptions,
    LidarPattern,
    LocalTrajectoryPlanner,
    ObstacleMap,
    OctreeSurface,
    Pose,
    Raster,
)

ORIGIN = (0.0, 0.0, 50.0)
CLOUD = np.random.default_rng(5).uniform((-30, -30, 20), (30, 30, 80), (120, 3))
CLOUD = CLOUD.astype(np.float32).astype(float)  # the same points in either type


def records(dtype: Any, **more: str) -> np.ndarray:
    """The cloud as records with fields x, y, z in that order, and others behind them."""
    out = np.zeros(len(CLOUD), dtype=[*((axis, dtype) for axis in "xyz"), *more.items()])
    for index, axis in enumerate("xyz"):
        out[axis] = CLOUD[:, index]
    return out


def scattered() -> np.ndarray:
    """Records whose coordinates do not lie side by side, of two types."""
    out = np.zeros(len(CLOUD), dtype=[("z", "f8"), ("t", "i4"), ("x", "f4"), ("y", ">f4")])
    for index, axis in enumerate("xyz"):
        out[axis] = CLOUD[:, index]
    return out


def packed() -> np.ndarray:
    """Records of a length that no coordinate divides."""
    return records("f4", intensity="f4", ring="u2")


LAYOUTS: dict[str, Callable[[], Any]] = {
    "float64": lambda: CLOUD,
    "float32": lambda: CLOUD.astype(np.float32),
    "fortran": lambda: np.asfortranarray(CLOUD),
    "fortran float32": lambda: np.asfortranarray(CLOUD.astype(np.float32)),
    "transposed": lambda: np.ascontiguousarray(CLOUD.T).T,
    "every second row": lambda: np.repeat(CLOUD, 2, axis=0)[::2],
    "backwards": lambda: CLOUD[::-1].copy()[::-1],
    "with intensity": lambda: np.column_stack((CLOUD, np.full(len(CLOUD), np.nan))),
    "wide float32": lambda: np.column_stack((CLOUD, CLOUD, CLOUD)).astype(np.float32),
    "columns of a wider one": lambda: np.column_stack((CLOUD[:, :1], CLOUD))[:, 1:],
    "every second column": lambda: np.repeat(CLOUD, 2, axis=1)[:, ::2],
    "big-endian": lambda: CLOUD.astype(">f4"),
    "read-only": lambda: np.frombuffer(CLOUD.tobytes()).reshape(-1, 3),
    "unaligned": lambda: np.frombuffer(b"." + CLOUD.tobytes(), offset=1).reshape(-1, 3),
    "organised": lambda: CLOUD.reshape(10, 12, 3),
    "organised float32 with intensity": lambda: (
        np.concatenate((CLOUD, CLOUD[:, :1]), axis=1).astype(np.float32).reshape(12, 10, 4)
    ),
    "organised, strided": lambda: np.repeat(CLOUD.reshape(10, 12, 3), 2, axis=0)[::2],
    "organised, fortran": lambda: np.asfortranarray(CLOUD.reshape(10, 12, 3)),
    "records": lambda: records("f4"),
    "records of doubles": lambda: records("f8", t="f8"),
    "records with more": lambda: records("f4", intensity="f4"),
    "packed records": packed,
    "scattered records": scattered,
    "organised records": lambda: records("f4", intensity="f4").reshape(10, 12),
    "every second record": lambda: np.repeat(records("f4"), 2)[::2],
    "lists": lambda: CLOUD.tolist(),
}


def planner(kind: Any) -> Any:
    return kind(Raster(np.zeros((4, 4)), cell=100.0), ORIGIN)


def mapped(cloud: Any) -> list[Any]:
    """What map and planners make of a cloud, as hits and as misses."""
    obstacles = ObstacleMap(centre=ORIGIN)
    out: list[Any] = [obstacles.insert(ORIGIN, cloud).marked, obstacles.voxels]
    for kind in (LocalTrajectoryPlanner, ConcurrentTrajectoryPlanner):
        flown = planner(kind)
        flown.sense(ORIGIN, cloud)
        flown.sense(Pose(ORIGIN), np.zeros((0, 3)), cloud)
        out.append(flown.map.voxels)
    return out


EXPECTED = mapped(CLOUD)


@pytest.mark.parametrize("layout", LAYOUTS)
def test_every_layout_means_the_same_points(layout: str) -> None:
    assert EXPECTED[0] > 100
    assert mapped(LAYOUTS[layout]()) == EXPECTED


@pytest.mark.parametrize("layout", LAYOUTS)
def test_points_and_paths_are_read_alike(layout: str) -> None:
    points = LAYOUTS[layout]()
    surface = HeightSurface(Raster(np.full((40, 40), 30.0), origin=(-20, -20)))
    np.testing.assert_array_equal(surface.clearance(points, 9.0), surface.clearance(CLOUD, 9.0))
    assert ltp._core.path_length(points) == ltp._core.path_length(CLOUD)
    octree = OctreeSurface(points, 1.0)
    assert octree.voxels == OctreeSurface(CLOUD, 1.0).voxels
    assert octree.voxels.blocked_at(points).all()
    down = np.tile((0.0, 0.0, -1.0), (len(CLOUD), 1))
    np.testing.assert_array_equal(
        surface.cast_rays(points, down, 99.0), surface.cast_rays(CLOUD, down, 99.0)
    )


def test_lost_returns_of_an_organised_cloud_are_counted() -> None:
    cloud = CLOUD.astype(np.float32).reshape(10, 12, 3).copy()
    cloud[2, 3:5] = np.nan
    masked = np.ma.masked_array(CLOUD.copy(), mask=np.zeros_like(CLOUD))
    masked.mask[7:9] = True
    hidden = np.ma.masked_array(records("f4", intensity="f4"))
    hidden[7:9] = np.ma.masked
    some = np.ma.masked_array(scattered())  # one coordinate is as bad as all
    some.mask["y"][7], some.mask["z"][8] = True, True
    for lossy in (cloud, masked, hidden, some):
        statistics = ObstacleMap(centre=ORIGIN).insert(ORIGIN, lossy)
        assert statistics.invalid == 2
        assert statistics.marked == EXPECTED[0] - 2


WRONG: list[tuple[Any, str]] = [
    (np.zeros((5, 2)), r"shape \(5, 2\) and dtype float64"),
    (np.zeros(5), r"shape \(5,\) and dtype float64"),
    (np.zeros((3, 100), np.float32), r"shape \(3, 100\) and dtype float32"),
    (np.zeros((2, 2, 2, 3)), r"shape \(2, 2, 2, 3\)"),
    (np.zeros((4, 4, 2)), r"shape \(4, 4, 2\)"),
    (np.float64(3.0), r"shape \(\) and dtype float64"),
    (np.zeros((5, 3), np.int32), "dtype int32"),
    (np.zeros((5, 3), np.uint16), "dtype uint16"),
    (np.ma.masked_equal(np.eye(3, dtype=np.int32), 1), "dtype int32, partly masked"),
    (np.zeros((5, 3), np.float16), "dtype float16"),
    (np.zeros((5, 3), complex), "dtype complex128"),
    (np.zeros((5, 3), bool), "dtype bool"),
    (np.zeros((5, 3), object), "dtype object"),
    (np.zeros((5, 3), "U4"), "dtype <U4"),
    (np.zeros(5, [("X", "f4"), ("Y", "f4"), ("Z", "f4")]), "dtype .*'X'"),
    (np.zeros(5, [("x", "f4"), ("y", "f4")]), r"shape \(5,\) and dtype .*'y'"),
    (np.zeros(5, [("x", "i4"), ("y", "i4"), ("z", "i4")]), "dtype .*<i4"),
    ([[1.0, 2.0], [3.0, 4.0]], r"numbers of shape \(2, 2\)"),
    ([[1.0, 2.0, 3.0], [3.0, 4.0]], "type list"),
    ("cloud", "type str"),
    ({}, "type dict"),
]


@pytest.mark.parametrize(("wrong", "message"), WRONG)
def test_what_is_no_cloud_is_told_in_one_sentence(wrong: Any, message: str) -> None:
    obstacles = ObstacleMap()
    for call, name in (
        (lambda: obstacles.insert(ORIGIN, wrong), "hits"),
        (lambda: obstacles.insert(ORIGIN, CLOUD, wrong), "misses"),
        (lambda: planner(LocalTrajectoryPlanner).sense(ORIGIN, wrong), "hits"),
        (lambda: planner(ConcurrentTrajectoryPlanner).sense(ORIGIN, CLOUD, wrong), "misses"),
    ):
        with pytest.raises(TypeError, match=message) as error:
            call()
        text = str(error.value)
        assert text.startswith(f"{name}: expected points of shape (N, 3)")
        assert "float32 or float64" in text
        assert "\n" not in text
    assert obstacles.voxels.count() == 0
    with pytest.raises(TypeError, match="hits"):
        obstacles.insert(ORIGIN, None)


@pytest.mark.parametrize(
    "call",
    [
        lambda: ObstacleMap().insert((0, 0), CLOUD),
        lambda: ObstacleMap(centre=(1, 2, 3, 4)),
        lambda: planner(LocalTrajectoryPlanner).update(np.zeros((2, 3))),
        lambda: planner(LocalTrajectoryPlanner).sense("here", CLOUD),
        lambda: Pose((0, 0)),
        lambda: ltp.GridFrame((0, 0), (1, 1, 1), (2, 2, 2)),
        lambda: ltp.ObstacleMapOptions(cell=(1.0, 2.0)),
        lambda: ltp._core.closest_point(CLOUD, (1, 2j, 3)),
    ],
)
def test_a_point_of_a_wrong_shape_is_told_in_one_sentence(call: Callable[[], object]) -> None:
    with pytest.raises(TypeError, match=r"expected a point, .* of shape \(3,\), got") as error:
        call()
    assert "\n" not in str(error.value)


@pytest.mark.parametrize(
    "call",
    [
        lambda wrong: ltp._core.path_length(wrong),
        lambda wrong: ltp._core.resample(wrong, 1.0),
        lambda wrong: planner(LocalTrajectoryPlanner).set_waypoints(wrong),
        lambda wrong: ObstacleMap().occupied.blocked_at(wrong),
        lambda wrong: ObstacleMap().occupied.first_blocked(wrong),
    ],
)
def test_a_path_of_a_wrong_shape_is_told_in_one_sentence(call: Callable[[Any], object]) -> None:
    for wrong in (np.zeros((4, 2)), np.zeros((2, 3), complex), "path", None):
        with pytest.raises(TypeError, match=r"expected points of shape \(N, 3\)") as error:
            call(wrong)
        assert "\n" not in str(error.value)
    call(np.array([[1, 2, 3], [4, 5, 6]]))  # whole metres are a path


def test_what_a_mask_hides_is_nowhere_read() -> None:
    """Under a mask lies anything: a fill value, the last scan."""
    lidar = Lidar(LidarOptions(pattern=LidarPattern(azimuths=4, rows=3)))
    ranges = np.full(12, 9.0)
    lost = np.ma.masked_array(ranges, mask=np.arange(12) < 5)
    statistics = lidar.from_ranges(lost, Pose(ORIGIN)).statistics
    assert (statistics.hits, statistics.invalid) == (7, 5)
    assert lidar.from_ranges(np.ma.masked_array(ranges), Pose(ORIGIN)).statistics.hits == 12
    heights = np.ma.masked_equal([[1.0, -9999.0], [2.0, 3.0]], -9999.0)
    with pytest.raises(ValueError, match=r"values\[0, 1\] = nan"):
        Raster(heights)
    with pytest.raises(TypeError, match=r"values: .* dtype int64, partly masked"):
        Raster(np.ma.masked_equal([[1, -9999], [2, 3]], -9999))
    assert Raster(np.ma.masked_array(np.eye(2))).values.sum() == 2.0
    frame = ltp.GridFrame((0, 0, 0), (1, 1, 1), (2, 2, 2))
    cells = np.zeros((2, 2, 2), bool)
    assert ltp.OccupancyGrid.from_array(np.ma.masked_array(cells), frame).count() == 0
    with pytest.raises(TypeError, match=r"blocked: .* dtype bool, partly masked"):
        ltp.OccupancyGrid.from_array(np.ma.masked_array(cells, mask=~cells), frame)
    here = np.ma.masked_array([1.0, 2.0, 3.0], mask=[True, False, False])
    with pytest.raises(ValueError, match="origin"):
        ObstacleMap().insert(here, CLOUD)
    way = np.ma.masked_array(np.eye(3), mask=np.eye(3))
    with pytest.raises(ValueError, match=r"waypoints\[0\]"):
        planner(LocalTrajectoryPlanner).set_waypoints(way)


def test_ranges_come_in_either_type_and_as_an_image() -> None:
    lidar = Lidar(LidarOptions(pattern=LidarPattern(azimuths=4, rows=3), min_range=0.5))
    ranges = np.array([[1, 2, 3], [np.nan, 0.25, 60], [5, 6, np.inf], [0, 7, 8]])
    pose = Pose(ORIGIN, yaw=0.3)
    expected = lidar.from_ranges(ranges.ravel(), pose)
    assert expected.statistics.too_near == 1
    assert expected.statistics.misses == 2
    assert expected.statistics.invalid == 2
    for layout in (
        ranges,
        ranges.astype(np.float32),
        np.asfortranarray(ranges),
        ranges.astype(">f4").ravel(),
        np.repeat(ranges.ravel(), 2)[::2],
        ranges.ravel().tolist(),
    ):
        np.testing.assert_array_equal(lidar.from_ranges(layout, pose).hits, expected.hits)
    for wrong in (ranges.T, ranges.astype(complex), np.zeros(12, int), {}):
        with pytest.raises(TypeError, match=r"ranges: expected shape \(12,\) or \(4, 3\)") as error:
            lidar.from_ranges(wrong, pose)
        assert "\n" not in str(error.value)
    with pytest.raises(ValueError, match="ranges"):
        lidar.from_ranges(np.zeros(11), pose)
