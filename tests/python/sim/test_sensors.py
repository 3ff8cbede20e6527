# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sensors on a vehicle: where their rays begin, how often they scan, what two see of a world."""

import numpy as np
import pytest

import ltp
from ltp.sim import Flight, MountedLidar, look_down
from ltp.sim.sensors import mapped_from, on_body
from tests.python.scenes import box_world

SURFACE = ltp.HeightSurface(ltp.Raster(np.zeros((200, 200)), origin=(-100.0, -100.0), cell=1.0))
BODY = ltp.Pose((0.5, 0.25, 20.0))


def options(**pattern) -> ltp.LidarOptions:
    settings = ltp.LidarOptions()
    for name, value in ({"azimuths": 60, "rows": 8} | pattern).items():
        setattr(settings.pattern, name, value)
    return settings


def config() -> ltp.MissionConfig:
    settings = ltp.MissionConfig(lidar=options())
    settings.mapping.dims = [80, 80, 20]
    return settings


def scan(sensor: MountedLidar, body: ltp.Pose = BODY, tick: int = 0) -> ltp.Scan:
    return sensor.scan(SURFACE, body, tick, 0.1, misses=True)


def test_a_sensor_at_the_body_is_the_lidar_itself() -> None:
    noisy = options()
    noisy.range_noise_sd = 0.1
    mounted, bare = MountedLidar(noisy), ltp.Lidar(noisy)
    for tick in (0, 7):
        one, other = scan(mounted, tick=tick), bare.scan(SURFACE, BODY, tick)
        assert one.hits.tobytes() == other.hits.tobytes()
        assert one.misses.tobytes() == other.misses.tobytes()


@pytest.mark.parametrize("seed", range(20))
def test_a_mount_turns_and_moves_with_the_body(seed: int) -> None:
    rng = np.random.default_rng(seed)
    angles = dict(zip(("yaw", "pitch", "roll"), rng.uniform(-3.0, 3.0, 3), strict=True))
    if seed % 4 == 0:
        angles |= {"pitch": np.pi / 2 * (1 if seed % 8 else -1)}  # straight down, and up
    body, mount = ltp.Pose(rng.normal(size=3), **angles), ltp.Pose(rng.normal(size=3), yaw=1.0)
    level = ltp.Pose((0.0, 0.0, 0.0))
    for first, second in ((body, mount), (level, body), (body, level)):
        there = on_body(first, second)
        np.testing.assert_allclose(there.rotation, first.rotation @ second.rotation, atol=1e-8)
        np.testing.assert_allclose(
            there.position, first.position + first.rotation @ second.position, atol=1e-12
        )


def test_a_scan_begins_where_the_sensor_sits() -> None:
    sensor = MountedLidar(options(), ltp.Pose((0.3, 0.0, -0.2)))
    np.testing.assert_allclose(scan(sensor).origin, (0.8, 0.25, 19.8))
    turned = ltp.Pose(BODY.position, yaw=np.pi / 2)
    np.testing.assert_allclose(scan(sensor, turned).origin, (0.5, 0.55, 19.8))


@pytest.mark.parametrize("rate", [10.0, 5.0, 3.0, 0.7, np.inf])
def test_a_rate_is_kept_in_the_mean(rate: float) -> None:
    sensor = MountedLidar(options(azimuths=4, rows=1), rate=rate)
    ticks = [tick for tick in range(1001) if scan(sensor, tick=tick) is not None]
    assert ticks[0] == 0
    assert len(ticks) == int(min(rate, 10.0) * 100.0 + 1e-6) + 1
    gaps = np.diff(ticks)
    assert gaps.max() - gaps.min() <= 1


def test_noise_differs_from_scan_to_scan_and_repeats() -> None:
    noisy = options()
    noisy.range_noise_sd = 0.1
    first, again = (MountedLidar(noisy, rate=5.0) for _ in range(2))
    scans = [scan(first, tick=tick).hits.tobytes() for tick in (0, 2, 4)]
    assert len(set(scans)) == 3
    assert [scan(again, tick=tick).hits.tobytes() for tick in (0, 2, 4)] == scans


def test_look_down_sees_the_cone_that_the_default_leaves_out() -> None:
    below = scan(MountedLidar(look_down())).hits[:, :2] - BODY.position[:2]
    level = scan(MountedLidar()).hits[:, :2] - BODY.position[:2]
    assert np.linalg.norm(below, axis=1).min() < 0.5
    assert np.linalg.norm(level, axis=1).min() > 19.9
    assert np.linalg.norm(below, axis=1).max() > 18.0


def test_sensors_that_do_not_fit_are_refused_by_name() -> None:
    world, start = box_world([]), (30.0, 30.0, 30.0)
    with pytest.raises(ValueError, match=r"sensors\[1\]\.rate = 20\.0: expected at most .* 10 Hz"):
        Flight(world, config(), start, sensors=[MountedLidar(), MountedLidar(rate=20.0)])
    with pytest.raises(ValueError, match=r"sensors\[0\]\.options\.max_range = 80\.0"):
        Flight(world, config(), start, sensors=[MountedLidar(look_down(max_range=80.0))])
    for rate in (0.0, -1.0, np.nan):
        with pytest.raises(ValueError, match="rate"):
            MountedLidar(rate=rate)


def two(rate: float = 5.0) -> list[MountedLidar]:
    return [MountedLidar(options()), MountedLidar(look_down(), ltp.Pose((0.1, 0, -0.3)), rate)]


def test_a_step_has_a_scan_a_sensor_in_its_turn() -> None:
    flight = Flight(box_world([]), config(), (30.0, 30.0, 30.0), sensors=two())
    steps = [flight.step() for _ in range(5)]
    assert [[one is not None for one in step.scans] for step in steps] == [
        [True, tick % 2 == 0] for tick in range(5)
    ]
    assert all(step.scan is step.scans[0] for step in steps)


class Windows:
    """A planner that notes where its window was after every scan."""

    def __init__(self, planner: ltp.LocalTrajectoryPlanner) -> None:
        self._planner = planner
        self.origins: list[np.ndarray] = []

    def __getattr__(self, name: str) -> object:
        return getattr(self._planner, name)

    def sense(self, *scan: np.ndarray) -> None:
        self._planner.sense(*scan)
        self.origins.append(self._planner.map.occupied.frame.origin)


@pytest.mark.parametrize("carve", [False, True])
def test_two_sensors_fill_one_map_and_the_window_stays_with_the_vehicle(carve: bool) -> None:
    """Against a map that is never moved; the mount lies where the window would be another."""
    world, settings = box_world([(60, 80, 40, 60)], height=28.0), config()
    settings.mapping.carve_free_space = carve
    path = np.array([[30.0, 30, 34.1], [95, 70, 34.1]])
    flight = Flight(world, settings, path, sensors=two(rate=10.0))
    flight.planner = windows = Windows(flight.planner)
    fixed = ltp.ObstacleMapOptions(dims=[200, 200, 40], carve_free_space=carve)
    whole = ltp.ObstacleMap(fixed, path[0])
    cell_of = whole.occupied.frame.cell_of
    for _ in range(150):
        step = flight.step()
        frame = step.map.occupied.frame
        for scan_ in step.scans:
            whole.insert(scan_.origin, scan_.hits, scan_.misses)
        x, y, z = cell_of(frame.origin + 0.5 * frame.cell)
        nx, ny, nz = frame.dims
        there = whole.occupied.to_array()[x : x + nx, y : y + ny, z : z + nz]
        np.testing.assert_array_equal(step.map.occupied.to_array(), there)
        moved = [(origin != frame.origin).any() for origin in windows.origins[-2:]]
        assert moved == [False, carve], "rays are followed from where they begin"
    assert step.map.occupied.count() > 1000


@pytest.mark.parametrize("seed", range(10))
def test_an_origin_is_moved_no_farther_than_the_mount(seed: int) -> None:
    rng = np.random.default_rng(seed)
    known = ltp.ObstacleMap(ltp.ObstacleMapOptions(dims=[81, 80, 21]), rng.uniform(-9, 9, 3))
    for _ in range(200):
        position, mount = rng.uniform(-9, 9, 3), rng.uniform(-1.5, 1.5, 3)
        begun = scan(MountedLidar(options(azimuths=1, rows=1), ltp.Pose(mount)), ltp.Pose(position))
        origin = mapped_from(begun, position, known)
        assert np.linalg.norm(origin - begun.origin) <= np.linalg.norm(mount) + 1e-5
        known.recentre(position)
        assert (known.recentre(origin) == 0).all()


def test_a_tilted_vehicle_tilts_its_sensors() -> None:
    class Tilted:
        position, velocity = np.array([30.0, 30.0, 30.0]), np.zeros(3)
        pose = ltp.Pose(position, pitch=np.radians(20.0))

        def step(self, command, seconds) -> None: ...

    world = box_world([])
    level = Flight(world, config(), Tilted.position).step().scan
    flight = Flight(world, config(), Tilted.position, vehicle=Tilted())
    tilted = flight.step().scan
    expected = ltp.Lidar(options()).scan(flight.setup.surface, Tilted.pose)
    np.testing.assert_allclose(tilted.hits, expected.hits, atol=1e-6)
    assert len(tilted.hits) > len(level.hits), "more of its rays meet the ground ahead"


def test_a_stand_in_may_leave_scans_out() -> None:
    class Blind:
        def scan(self, surface, body, tick, step, *, misses):
            return None

    path = np.array([[30.0, 30, 30], [50, 30, 30]])
    flight = Flight(box_world([]), config(), path, sensors=[Blind()])
    assert flight.run().scans == (None,)
    assert flight.planner.map.occupied.count() == 0
    assert Flight(box_world([]), config(), path, sensors=[]).run().scan is None
