# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The obstacle map from Python: a set of voxels, its inflation, its rolling window, its files."""

import itertools
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ltp._core import (
    GridFrame,
    InsertStatistics,
    ObstacleMap,
    ObstacleMapOptions,
    OccupancyGrid,
    Pose,
    inflate,
)

CELL = np.array([2.0, 2.0, 4.0])
NO_POINTS = np.empty((0, 3))


def small_map(centre: tuple[float, float, float] = (0, 0, 0), **options: object) -> ObstacleMap:
    """A map of 20 x 16 x 10 cells that sees 30 m far, and as near as can be."""
    settings = {"dims": (20, 16, 10), "max_range": 30.0, "blind_distance": 0.0, **options}
    return ObstacleMap(ObstacleMapOptions(**settings), centre)


def slow_inflation(blocked: np.ndarray, cell: np.ndarray, radius: float) -> np.ndarray:
    """Box by box."""
    out = blocked.copy()
    sources = np.argwhere(blocked)
    for index in np.ndindex(blocked.shape):
        gaps = np.maximum(np.abs(sources - index) - 1, 0) * cell
        near = np.linalg.norm(gaps, axis=1) <= radius * (1 + 1e-9)
        out[index] |= radius > 0 and bool(near.any())
    return out


@settings(deadline=None, max_examples=60)
@given(
    shape=st.tuples(st.integers(1, 6), st.integers(1, 6), st.sampled_from([1, 2, 63, 64, 65, 80])),
    cell=st.tuples(*[st.sampled_from([0.5, 1.0, 2.0, 4.0])] * 3),
    radius=st.sampled_from([0.0, 0.25, 1.0, 2.0, 3.3]),
    seed=st.integers(0, 2**32 - 1),
)
def test_inflation_is_the_distance_between_boxes(
    shape: tuple[int, int, int], cell: tuple[float, float, float], radius: float, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    blocked = rng.random(shape) < 3.0 / np.prod(shape)
    grid = OccupancyGrid.from_array(blocked, GridFrame((1, 2, 3), cell, shape))
    inflated = inflate(grid, radius)
    assert inflated.frame == grid.frame
    np.testing.assert_array_equal(
        inflated.to_array(), slow_inflation(blocked, np.array(cell), radius)
    )
    np.testing.assert_array_equal(grid.to_array(), blocked)


@settings(deadline=None, max_examples=60)
@given(
    moves=st.lists(
        st.tuples(*[st.one_of(st.integers(-3, 3), st.integers(-25, 25))] * 3),
        min_size=1,
        max_size=12,
    ),
    carve=st.booleans(),
    seed=st.integers(0, 2**32 - 1),
)
def test_cells_that_come_back_to_a_map_that_forgets_are_unknown(
    moves: list[tuple[int, int, int]], carve: bool, seed: int
) -> None:
    """Whatever way the window takes, the map is the set of voxels hit since they last entered."""
    rng = np.random.default_rng(seed)
    obstacles = small_map(carve_free_space=carve, remember=False)
    centre = np.zeros(3)
    hit: set[tuple[int, ...]] = set()
    for move in moves:
        shift = obstacles.recentre(centre + np.array(move) * CELL)
        np.testing.assert_array_equal(shift, move)
        centre += np.array(move) * CELL
        low = np.array(obstacles.voxels.frame.origin) / 2.0
        high = np.array(obstacles.voxels.frame.upper) / 2.0
        hit = {v for v in hit if (low <= v).all() and (v < high).all()}

        points = centre + rng.normal(scale=9.0, size=(15, 3))
        statistics = obstacles.insert(centre, points)
        near = np.linalg.norm(points - centre, axis=1) < 30.0
        voxels = np.floor(points / 2.0)
        inside = near & (low <= voxels).all(axis=1) & (voxels < high).all(axis=1)
        hit |= {tuple(int(x) for x in voxel) for voxel in voxels[inside]}
        assert statistics.marked == inside.sum()
        assert statistics.outside == (near & ~inside).sum()
        assert statistics.out_of_range == (~near).sum()

        found = np.argwhere(obstacles.voxels.to_array()) + np.round(low).astype(int)
        assert {tuple(int(x) for x in voxel) for voxel in found} == hit
        pairs = obstacles.voxels.to_array().reshape(20, 16, 10, 2)
        np.testing.assert_array_equal(obstacles.occupied.to_array(), pairs.any(axis=3))
        assert obstacles.blocked == inflate(obstacles.voxels, 1.0, (1, 1, 2))


def test_what_was_seen_is_there_again(tmp_path: Path) -> None:
    rng = np.random.default_rng(4)
    obstacles = small_map(margin=0.5)
    hits = rng.normal(scale=6.0, size=(100, 3))
    obstacles.insert((0, 0, 0), hits)
    voxels, blocked = obstacles.voxels.to_array(), obstacles.blocked.to_array()
    obstacles.recentre((500, 0, 0))
    assert obstacles.voxels.count() == 0
    expected = {tuple(x) for x in np.floor(hits / 2) * 2 + 1}
    assert {tuple(x) for x in obstacles.remembered()} == expected
    assert obstacles.mission_bytes > 1000
    obstacles.save(tmp_path / "mission.bt")
    second = small_map(margin=0.5)
    second.load(tmp_path / "mission.bt")
    for back in (obstacles, second):
        back.recentre((0, 0, 0))
        np.testing.assert_array_equal(back.voxels.to_array(), voxels)
        np.testing.assert_array_equal(back.blocked.to_array(), blocked)
    obstacles.clear()
    assert len(obstacles.remembered()) == obstacles.mission_bytes == 0


def test_inflation_measures_from_parts_of_cells() -> None:
    voxels = np.zeros((5, 5, 10), bool)
    voxels[2, 2, 4] = True  # the lower half of the middle cell
    grid = OccupancyGrid.from_array(voxels, GridFrame((0, 0, 0), (2, 2, 2), voxels.shape))
    blocked = inflate(grid, 1.0, (1, 1, 2))
    np.testing.assert_array_equal(blocked.frame.cell, [2, 2, 4])
    assert blocked.count() == 18
    assert not blocked.to_array()[:, :, 3].any()
    with pytest.raises(ValueError, match=r"parts\.z"):
        inflate(grid, 1.0, (1, 1, 3))


def test_strange_points_are_counted_not_refused() -> None:
    obstacles = small_map()
    hits = np.array(
        [
            [np.nan, 0, 0],
            [0, np.inf, 0],
            [0, 0, -np.inf],
            [30.0, 0, 0],  # exactly the maximum range
            [1e300, 0, 0],
            [0, 0, 25.0],  # above the window
            [-5.0, -5.0, -5.0],
            [-5.1, -5.1, -5.1],
        ]
    )
    statistics = obstacles.insert((0, 0, 0), hits, np.array([[np.nan, 1, 1], [1, 1, 1]]))
    assert statistics.invalid == 4
    assert statistics.out_of_range == 2
    assert statistics.outside == 1
    assert statistics.marked == 2
    assert statistics.new_cells == 1
    assert statistics.erased_cells == 0
    assert obstacles.occupied.count() == 1
    assert obstacles.blocked.count() == 18  # no voxel touches the level above
    assert isinstance(statistics, InsertStatistics)
    assert "marked=2" in repr(statistics)


def test_own_returns_are_counted_and_never_mapped() -> None:
    centre = np.array([7.0, -3.0, 12.0])
    arms = [[0.3, 0.3, 0], [-0.6, 0.6, 0], [0, 0, 0], [0, 0, -0.99]]
    beyond = [[0, 0, 1.0], [0, 5, 0], [15, 0, 0]]
    for carve in (False, True):
        obstacles = small_map((7, -3, 12), carve_free_space=carve, blind_distance=1.0)
        for _ in range(3):
            statistics = obstacles.insert(centre, centre + np.array(arms + beyond))
            assert (statistics.too_near, statistics.marked) == (4, 3)
        assert obstacles.voxels.count() == 3
        assert (obstacles.totals.too_near, obstacles.totals.marked) == (12, 9)
        assert obstacles.totals.warnings(obstacles.options) == [
            "12 of 21 hits are nearer than the map's blind_distance of 1 m and were not mapped"
        ]


def test_a_body_box_turns_with_the_pose() -> None:
    """A boom of 3 m to the front and a wall beside it, seen while the UAV turns."""
    boom, wall = np.array([2.9, 0.0, 0.0]), np.array([0.0, 2.9, 0.0])
    for yaw in np.radians([0.0, 30.0, 90.0, -135.0]):
        turn = np.array([[np.cos(yaw), -np.sin(yaw), 0], [np.sin(yaw), np.cos(yaw), 0], [0, 0, 1]])
        obstacles = small_map(body_min=(-0.5, -0.5, -0.5), body_max=(3.0, 0.5, 0.5))
        hits = np.array([turn @ boom, turn @ wall])
        statistics = obstacles.insert(Pose((0, 0, 0), yaw=yaw), hits)
        assert (statistics.in_body, statistics.marked) == (1, 1)
        assert obstacles.voxels.blocked_at(hits).tolist() == [False, True]
    # Without an attitude the box lies along the world's axes.
    assert obstacles.insert((0, 0, 0), np.array([boom, wall])).in_body == 1


def test_hits_beyond_range_and_window_are_told() -> None:
    obstacles = small_map(remember=False)
    obstacles.insert((0, 0, 0), np.array([[45.0, 0, 0], [5, 5, 5], [0, 0, 25.0]]))
    sentences = obstacles.totals.warnings(obstacles.options)
    assert sentences == [
        "1 of 3 hits lie at or beyond the map's max_range of 30 m and were not mapped: "
        "raise it to that of the sensor",
        "1 of 3 hits lie outside the map's window of 40 m x 32 m x 40 m and were not mapped: "
        "give it more cells (dims)",
    ]
    assert InsertStatistics.warnings(small_map().totals, ObstacleMapOptions()) == []


def test_a_pole_survives_unless_octomaps_rule_is_chosen() -> None:
    sensor, pole = np.array([1.0, 1.0, 1.0]), np.array([[11.0, 1.0, 1.0]])
    wall = np.array([[19.0, 1.0, 1.0]])
    for keep, expected in ((True, [True] * 4), (False, [True, True, True, False])):
        obstacles = small_map(carve_free_space=True, keep_hits=keep)
        obstacles.insert(sensor, pole)
        seen = [bool(obstacles.occupied.blocked_at(pole)[0])]
        for _ in range(3):
            obstacles.insert(sensor, wall)
            seen.append(bool(obstacles.occupied.blocked_at(pole)[0]))
        assert seen == expected
        assert obstacles.log_odds_at((5, 1, 1)) == pytest.approx(-1.6)
        assert obstacles.log_odds_at((100, 1, 1)) == 0.0


def test_views_follow_the_map_and_keep_it_alive() -> None:
    obstacles = small_map()
    blocked = obstacles.blocked
    columns = blocked.columns
    assert not columns.flags.writeable
    obstacles.insert((0, 0, 0), np.array([[5.0, 5.0, 5.0]]))
    del obstacles
    assert blocked.count() == 18
    del blocked
    assert sum(int(word).bit_count() for word in columns.ravel()) == 18


def test_wrong_arguments_are_named() -> None:
    for field, value in (
        ("cell", (2.0, 2.0, 3.0)),
        ("cell", (0.0, 2.0, 4.0)),
        ("dims", (0, 10, 10)),
        ("inflation_radius", float("nan")),
        ("margin", -0.1),
        ("max_range", -1.0),
        ("blind_distance", -0.1),
        ("blind_distance", float("nan")),
        ("blind_distance", 50.0),
        ("body_max", (1.0, 1.0, -1.0)),
        ("body_min", (0.0, 0.0, float("inf"))),
        ("hit_log_odds", 0.0),
        ("miss_log_odds", 0.4),
        ("min_log_odds", 1.0),
        ("max_log_odds", float("inf")),
    ):
        options = ObstacleMapOptions(**{field: value})
        with pytest.raises(ValueError, match=rf"{field}.* = .*expected"):
            ObstacleMap(options)
        with pytest.raises(ValueError, match=field):
            options.check()
    with pytest.raises(TypeError, match="inflation"):
        ObstacleMapOptions(inflation=1.0)
    obstacles = small_map()
    with pytest.raises(ValueError, match="origin"):
        obstacles.insert((np.nan, 0, 0), NO_POINTS)
    with pytest.raises(ValueError, match="centre"):
        obstacles.recentre((0, np.inf, 0))
    with pytest.raises(ValueError, match="centre"):
        ObstacleMap(centre=(0, np.nan, 0))
    with pytest.raises(ValueError, match="radius"):
        inflate(obstacles.occupied, -1.0)


def test_options_are_read_and_written_by_name() -> None:
    options = ObstacleMapOptions(dims=(10, 12, 6), keep_hits=False)
    options.cell = (1.0, 1.0, 3.0)
    options.inflation_radius = 0.0
    obstacles = ObstacleMap(options, (7.0, 0.0, 0.0))
    options.max_range = 1.0  # the map has its own copy
    assert obstacles.options.max_range == 50.0
    assert obstacles.options.dims == [10, 12, 6]
    np.testing.assert_array_equal(obstacles.options.cell, [1.0, 1.0, 3.0])
    assert obstacles.voxel_size == 1.0
    assert obstacles.voxels.frame.dims == [10, 12, 18]
    np.testing.assert_array_equal(obstacles.voxels.frame.origin, obstacles.blocked.frame.origin)
    assert all(hasattr(options, name) for name in ObstacleMapOptions.__fields__)


@pytest.mark.parametrize("suffix", [".bt", ".ot"])
@pytest.mark.parametrize("carve", [False, True])
def test_a_file_brings_back_what_the_map_knew(tmp_path: Path, suffix: str, carve: bool) -> None:
    rng = np.random.default_rng(11)
    centre = np.array([-40.0, 30.0, 20.0])
    # What lies beyond the window is not in the file of a map that forgets.
    obstacles = small_map((-40, 30, 20), carve_free_space=carve, remember=False)
    for _ in range(5):
        obstacles.insert(centre, centre + rng.normal(scale=9.0, size=(40, 3)))
    file = tmp_path / f"map{suffix}"
    obstacles.save(file)
    assert [path.name for path in tmp_path.iterdir()] == [file.name]

    again = small_map((-40, 30, 20), carve_free_space=carve, remember=False)
    again.load(str(file))
    for name in ("voxels", "occupied", "blocked"):
        assert getattr(again, name) == getattr(obstacles, name)
    voxels = obstacles.voxels.frame
    free = 0
    for index in itertools.product(*(range(n) for n in voxels.dims)):
        known = obstacles.log_odds_at(voxels.centre(index))
        loaded = again.log_odds_at(voxels.centre(index))
        if suffix == ".ot":
            assert loaded == pytest.approx(known, abs=1e-6)
        else:
            assert np.sign(loaded) == np.sign(known)
        free += known < 0
    assert (free > 100) == carve

    # A window elsewhere takes what it holds of the file, and keeps what it has.
    beside = small_map((-28, 30, 20), carve_free_space=carve)
    beside.insert((-28, 30, 20), np.array([[-12.0, 30.0, 20.0]]))
    beside.load(file)
    shifted = obstacles.voxels.to_array()[6:]
    expected = np.zeros_like(obstacles.voxels.to_array())
    expected[: shifted.shape[0]] = shifted
    expected[tuple(beside.voxels.frame.cell_of((-12.0, 30.0, 20.0)))] = True
    np.testing.assert_array_equal(beside.voxels.to_array(), expected)


def test_a_file_that_is_none_changes_nothing(tmp_path: Path) -> None:
    obstacles = small_map()
    obstacles.insert((0, 0, 0), np.array([[5.0, 5.0, 5.0], [-5.0, 5.0, 5.0]]))
    whole = tmp_path / "whole.bt"
    obstacles.save(whole)
    before = obstacles.voxels.to_array()

    truncated = tmp_path / "truncated.bt"
    truncated.write_bytes(whole.read_bytes()[:-3])
    empty = tmp_path / "empty.ot"
    empty.write_bytes(b"")
    finer = tmp_path / "finer.bt"
    ObstacleMap(ObstacleMapOptions(cell=(1.0, 1.0, 1.0), dims=(4, 4, 4))).save(finer)
    for file in (truncated, empty, finer, tmp_path / "missing.bt", tmp_path / "map.txt"):
        with pytest.raises(ValueError, match=file.name):
            obstacles.load(file)
        np.testing.assert_array_equal(obstacles.voxels.to_array(), before)
    with pytest.raises(ValueError, match="resolution = 1"):
        obstacles.load(finer)
    with pytest.raises(ValueError, match=r"map\.txt"):
        obstacles.save(tmp_path / "map.txt")
    with pytest.raises(ValueError, match=r"far\.bt.*32768"):
        far = small_map((1e6, 0, 0))
        far.insert((1e6, 0, 0), np.array([[1e6, 5.0, 5.0]]))
        far.save(tmp_path / "far.bt")
    with pytest.raises(RuntimeError, match="nowhere"):
        obstacles.save(tmp_path / "nowhere" / "map.bt")
