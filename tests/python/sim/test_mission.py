# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whole flights over small worlds: given a scene, when it is flown, then this happens."""

import itertools

import numpy as np
import pytest

import ltp
from ltp.sim import MissionSetup, Outcome, Step
from ltp.sim.log import FlightLog
from ltp.world import LandClass, LandingLimits, World


def flat_world(size: int = 240) -> np.ndarray:
    return np.zeros((size, size))


def make_world(surface: np.ndarray) -> World:
    ground = np.zeros_like(surface)
    classes = np.where(surface > 0, LandClass.BUILDING, LandClass.GRASS).astype(np.uint8)
    return World("test", ground, surface, classes, cell=1.0)


def line(*points: tuple[float, float], altitude: float = 30.0) -> np.ndarray:
    return np.array([(x, y, altitude) for x, y in points])


def small_config(**values) -> ltp.MissionConfig:
    config = ltp.MissionConfig(**values)
    config.mapping.dims = [80, 80, 20]
    return config


COMPLETE = [name for name in ltp.PLANNERS if ltp.make_planner(name).complete]


@pytest.mark.parametrize("planner", ltp.PLANNERS)
def test_an_open_field_is_flown_straight(planner: str) -> None:
    path = line((40, 40), (90, 40), (140, 40))
    config = small_config(planner=planner)
    config.planner_options.weights = ltp.PenaltyWeights(length=1.0, priority=0.0)
    record = ltp.fly(make_world(flat_world()), config, path)
    assert record.outcome is Outcome.REACHED
    assert record.complete
    assert record.length_ratio < 1.03
    assert len(record.plans) == 2
    assert record.min_clearance == pytest.approx(30.0, abs=1.0)
    assert record.mean_priority == 1.0


@pytest.mark.parametrize("planner", COMPLETE)
def test_a_tower_in_the_way_is_flown_round(planner: str) -> None:
    surface = flat_world()
    surface[100:120, 60:130] = 60.0
    path = line((40, 100), (180, 100))
    record = ltp.fly(make_world(surface), small_config(planner=planner), path)
    assert record.outcome is Outcome.REACHED
    assert record.complete
    assert record.min_clearance > 1.0
    assert record.length_ratio > 1.1
    assert np.ptp(record.positions[:, 2]) < 1.0, "planar flight"


@pytest.mark.parametrize("planner", COMPLETE)
def test_a_waypoint_inside_a_tower_is_dropped_with_proof_and_the_next_one_reached(
    planner: str,
) -> None:
    surface = flat_world()
    surface[90:120, 90:120] = 60.0
    path = line((40, 105), (105, 105), (180, 105))
    record = ltp.fly(make_world(surface), small_config(planner=planner), path)
    assert record.outcome is Outcome.REACHED
    assert [event.index for event in record.dropped] == [0]
    assert record.dropped[0].reason in ("unreachable", "goal_blocked")
    assert record.waypoints[-1].outcome == "reached"


def test_a_flight_repeats_to_the_byte() -> None:
    surface = flat_world()
    surface[100:120, 60:130] = 60.0
    world, path = make_world(surface), line((40, 100), (180, 100))
    config = small_config()
    config.lidar.range_noise_sd = 0.05
    config.lidar.drop_out = 0.1
    first, second = (ltp.fly(world, config, path) for _ in range(2))
    assert first.positions.tobytes() == second.positions.tobytes()
    assert first.plan_index.tobytes() == second.plan_index.tobytes()


def test_a_flight_that_cannot_get_on_times_out() -> None:
    surface = flat_world()
    surface[60:180, 60:180] = 60.0
    surface[64:176, 64:176] = 0.0  # a courtyard, and the UAV in it
    config = small_config(planner="bezier", hold_limit=3.0)
    record = ltp.fly(make_world(surface), config, line((120, 120), (220, 120)))
    assert record.outcome is Outcome.TIMED_OUT
    assert record.dropped == []
    assert record.duration < 60.0


def test_starting_inside_a_building_is_a_collision_not_a_crash() -> None:
    surface = flat_world()
    surface[90:120, 90:120] = 60.0
    record = ltp.fly(make_world(surface), small_config(), line((105, 105), (180, 105)))
    assert record.outcome is Outcome.COLLIDED
    assert record.collision is not None
    assert record.min_clearance == 0.0


def test_a_priority_map_of_ones_own_is_flown_with() -> None:
    world, path = make_world(flat_world()), line((40, 100), (180, 100))
    values = np.zeros((120, 120))
    values[:, 56:62] = 1.0  # a strip beside the straight line
    own = ltp.Raster(values, cell=2.0)
    config = small_config(planner="lp-dijkstra")
    assert ltp.fly(world, config, path).mean_priority == 1.0
    record = ltp.fly(world, config, path, priority=own)
    assert record.complete and 0.5 < record.mean_priority < 1.0
    assert np.any(record.positions[:, 1] > 111.0)
    config.priority_map = "lpf"
    seen = MissionSetup.of(world, config, path, own).priority.values
    assert 0.0 < seen[60, 50] < 0.3 < seen[60, 59] < 1.0
    surface = ltp.HeightSurface(world.surface_raster())
    for place in (world, surface):
        with pytest.raises(ValueError, match="priority must hold shares"):
            ltp.fly(place, config, path, priority=ltp.Raster(2.0 * values, cell=2.0))
        with pytest.raises(ValueError, match=r"priority\.outside must be a share"):
            ltp.fly(place, config, path, priority=ltp.Raster(values, cell=2.0, outside=-1.0))


class Watcher:
    """Keeps what it is told."""

    def __init__(self) -> None:
        self.steps: list[Step] = []
        self.calls: list[str] = []

    def on_start(self, setup: MissionSetup) -> None:
        self.setup = setup
        self.calls.append("start")

    def on_step(self, step: Step) -> None:
        self.steps.append(step)
        self.calls.append("step")

    def on_end(self, record: ltp.FlightRecord) -> None:
        self.record = record
        self.calls.append("end")


def flown_round_a_tower() -> tuple[ltp.FlightRecord, Watcher, FlightLog]:
    surface = flat_world()
    surface[100:120, 60:130] = 60.0
    watcher, log = Watcher(), FlightLog()
    path = line((40, 100), (105, 100), (180, 100))
    return ltp.fly(make_world(surface), small_config(), path, [watcher, log]), watcher, log


def test_observers_are_told_every_step_once() -> None:
    record, watcher, _ = flown_round_a_tower()
    assert watcher.calls == ["start", *["step"] * len(record.times), "end"]
    assert watcher.record is record
    np.testing.assert_array_equal(watcher.setup.global_path, record.global_path)
    np.testing.assert_array_equal(watcher.setup.waypoints, record.global_path[1:])


def test_the_steps_are_the_record() -> None:
    record, watcher, _ = flown_round_a_tower()
    steps = watcher.steps
    np.testing.assert_array_equal([step.time for step in steps], record.times)
    np.testing.assert_array_equal([step.position for step in steps], record.positions)
    np.testing.assert_array_equal([step.velocity for step in steps], record.velocities)
    np.testing.assert_array_equal([step.waypoint_index for step in steps], record.waypoint_index)
    plans = [(step.time, answer) for step in steps for answer in step.plans]
    assert [time for time, _ in plans] == [plan.time for plan in record.plans]
    assert [answer.plan.penalty for _, answer in plans] == [p.penalty for p in record.plans]
    events = [(step.time, event.index, event.reached) for step in steps for event in step.events]
    assert events == [(e.time, e.index, e.outcome == "reached") for e in record.waypoints]
    assert len(plans) > 2
    assert len(events) == 2
    assert all(step.scan is not None for step in steps)
    assert steps[-1].status == ltp.NavigationStatus.FINISHED


def test_a_steps_path_changes_when_it_says_so() -> None:
    _, watcher, _ = flown_round_a_tower()
    changes = 0
    for before, after in itertools.pairwise(watcher.steps):
        changes += after.path_changed
        if not after.path_changed:
            assert after.path is before.path
    assert watcher.steps[0].path_changed
    assert 1 < changes < len(watcher.steps) / 10


def test_the_flight_log_is_an_observer_as_any_other() -> None:
    record, _, log = flown_round_a_tower()
    again = log.record(record.outcome, record.collision)
    assert again.positions.tobytes() == record.positions.tobytes()
    assert again.waypoints == record.waypoints
    assert [plan.penalty for plan in again.plans] == [plan.penalty for plan in record.plans]
    assert (again.mean_priority, again.length) == (record.mean_priority, record.length)


def test_the_last_step_of_a_collision_is_where_the_uav_came_to_be() -> None:
    surface = flat_world()
    surface[90:120, 90:120] = 60.0
    watcher = Watcher()
    path = line((105, 105), (180, 105))
    record = ltp.fly(make_world(surface), small_config(), path, [watcher])
    assert record.outcome is Outcome.COLLIDED
    assert [step.scan is None for step in watcher.steps] == [False, True]
    np.testing.assert_array_equal([step.position for step in watcher.steps], record.positions)
    assert (watcher.steps[-1].plans, watcher.steps[-1].events) == ((), ())


def test_a_record_keeps_the_settings_that_were_flown() -> None:
    config = small_config()
    record = ltp.fly(make_world(flat_world()), config, line((40, 40), (60, 40)))
    config.planner_options.weights.length = 7.0
    assert record.config.planner_options.weights.length == 0.5


@pytest.mark.parametrize(
    "path",
    [
        np.zeros((1, 3)),
        np.zeros((2, 2)),
        np.zeros((3, 3)),
        np.array([[0, 0, 0], [np.nan, 0, 0]]),
        np.zeros(3),
        "path",
        None,
        [(0, 0, 0), (1, 1)],
    ],
)
def test_a_strange_global_path_is_refused_by_name(path: np.ndarray) -> None:
    with pytest.raises(ValueError, match="global_path"):
        ltp.fly(make_world(flat_world()), small_config(), path)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"world": "city"}, "world: expected a World or Surface, not a str"),
        ({"config": None}, "config: expected a MissionConfig, not a NoneType"),
        ({"priority": np.eye(4)}, "priority: expected a Raster, not a ndarray"),
    ],
)
def test_an_argument_of_another_kind_is_refused_by_name(change, message: str) -> None:
    arguments = {"world": make_world(flat_world()), "config": small_config()}
    with pytest.raises(TypeError, match=message):
        ltp.fly(**(arguments | change), global_path=line((40, 100), (180, 100)))


def test_an_unknown_preset_of_landing_ground_is_refused_by_name() -> None:
    with pytest.raises(ValueError, match="everywhere"):
        small_config(landable="everywhere")
    config = small_config()
    config.landable = ["grass", "everywhere"]
    with pytest.raises(ValueError, match="everywhere"):
        ltp.fly(make_world(flat_world()), config, line((40, 40), (60, 40)))


def test_the_limits_of_landing_ground_are_the_missions() -> None:
    heights = np.add.outer(np.arange(240.0), np.zeros(240)) * np.tan(np.radians(12.0))
    classes = np.full(heights.shape, LandClass.GRASS, np.uint8)
    world, path = World("ramp", heights, heights, classes, 1.0), line((40, 40), (60, 40))
    path[:, 2] += 60.0
    for limit, share in ((10.0, 0.0), (15.0, 1.0)):
        config = small_config(landing=LandingLimits(max_slope=limit), landable=["grass"])
        assert (MissionSetup.of(world, config, path).priority.values == share).all()
