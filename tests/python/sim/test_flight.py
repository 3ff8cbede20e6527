# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A flight driven by hand: the mission's own loop, changes in mid-air, parts of one's own."""

import dataclasses
import itertools

import numpy as np
import pytest

import ltp
from ltp._core import NavigationReason, NavigationStatus
from ltp.evaluation.scenarios import ScenarioOptions, make_scenario
from ltp.sim import Flight, Mission, MissionSetup, Outcome
from ltp.sim.log import FlightLog
from ltp.sim.step import StepMaker
from ltp.world import LandClass, World, make_city


def make_world(*boxes: tuple[int, int, int, int, float], size: int = 160) -> World:
    """Flat grass with buildings (x0, x1, y0, y1, height)."""
    surface = np.zeros((size, size))
    for x0, x1, y0, y1, height in boxes:
        surface[x0:x1, y0:y1] = height
    classes = np.where(surface > 0, LandClass.BUILDING, LandClass.GRASS).astype(np.uint8)
    return World("test", np.zeros_like(surface), surface, classes, cell=1.0)


TOWER = (70, 90, 40, 100, 60.0)
START = np.array([30.0, 70.0, 30.0])


def config(**values) -> ltp.MissionConfig:
    settings = ltp.MissionConfig(**values)
    settings.mapping.dims = [80, 80, 20]
    settings.lidar.pattern.azimuths, settings.lidar.pattern.rows = 120, 16
    return settings


def path(*points: tuple[float, float]) -> np.ndarray:
    return np.array([(x, y, 30.0) for x, y in points])


def same(one: ltp.FlightRecord, other: ltp.FlightRecord) -> bool:
    """Whether two records hold the same, to the last bit, but for wall times."""
    for name in ("times", "positions", "velocities", "plan_index", "waypoint_index", "global_path"):
        if getattr(one, name).tobytes() != getattr(other, name).tobytes():
            return False
    plans = [
        [(p.path.tobytes(), {**vars(p), "path": 0, "seconds": 0}) for p in record.plans]
        for record in (one, other)
    ]
    rest = [
        {k: v for k, v in vars(record).items() if not isinstance(v, np.ndarray | list)}
        | {"waypoints": record.waypoints, "config": record.config.to_toml()}
        for record in (one, other)
    ]
    return plans[0] == plans[1] and rest[0] == rest[1]


def flown_in_one_loop(
    world: World, settings: ltp.MissionConfig, global_path: np.ndarray
) -> ltp.FlightRecord:
    """A mission's record by the plain loop: sense, map, plan, guide, move."""
    setup, log, maker = MissionSetup.of(world, settings, global_path), FlightLog(), StepMaker()
    mission = Mission(world, settings, global_path)  # for its parts
    planner, vehicle, guidance = mission.planner, mission.vehicle, mission.guidance
    lidar, carve = ltp.Lidar(settings.lidar), settings.mapping.carve_free_space
    waypoints = setup.waypoints
    log.on_start(setup)
    for tick in itertools.count():
        scan = lidar.scan(setup.surface, ltp.Pose(vehicle.position), tick, misses=carve)
        planner.sense(scan.origin, scan.hits, scan.misses)
        status = planner.update(vehicle.position)
        about = {
            "time": tick * settings.step,
            "scans": (scan,),
            "status": status,
            "waypoints": waypoints,
            "priority": setup.priority,
        }
        step = maker.make(planner, vehicle, **about, collision=None)
        log.on_step(step)
        assert status != NavigationStatus.HOLDING, "chosen so that none holds"
        if status == NavigationStatus.FINISHED:
            return log.record(Outcome.REACHED, None, mission_reason(log))
        if step.path_changed:
            guidance.follow(step.path)
        vehicle.step(
            guidance.command(step.position, step.velocity, step.map.occupied), settings.step
        )
        collision = setup.first_touch(step.position, vehicle.position)
        if collision is not None:
            about |= {"time": (tick + 1) * settings.step, "scans": (), "status": status}
            log.on_step(maker.make(planner, vehicle, **about, collision=collision))
            return log.record(Outcome.COLLIDED, collision, "the true world was touched")
    raise AssertionError


def mission_reason(log: FlightLog) -> str:
    reached = [entry.outcome == "reached" for entry in log.waypoints]
    some = f"{sum(reached)} of {len(reached)} waypoints were reached, the others dropped"
    return "every waypoint was reached" if all(reached) else some


@pytest.mark.parametrize("planner", ["auto", "lp-dijkstra", "ggwp"])
def test_a_mission_is_its_loop_to_the_last_bit(planner: str) -> None:
    world = make_city(seed=1, size=400.0)
    for index, carve in ((0, False), (3, True)):
        options = ScenarioOptions(length=150.0, margin=20.0)
        global_path = make_scenario(world, options, index).global_path
        settings = config(planner=planner)
        settings.mapping.carve_free_space = carve
        settings.lidar.range_noise_sd, settings.lidar.drop_out = 0.05, 0.1
        record = ltp.fly(world, settings, global_path)
        assert same(record, flown_in_one_loop(world, settings, global_path))
        assert record.outcome is Outcome.REACHED
        assert len(record.times) > 300


def test_a_collision_is_the_loops_too() -> None:
    world, global_path = make_world(TOWER), path((75, 75), (150, 75))
    record = ltp.fly(world, config(), global_path)
    assert record.outcome is Outcome.COLLIDED
    assert same(record, flown_in_one_loop(world, config(), global_path))


def test_a_flight_with_the_missions_waypoints_is_the_mission() -> None:
    world, points = make_world(TOWER), path((30, 70), (60, 70), (130, 70))
    whole = ltp.fly(world, config(), points)
    at_once = Flight(world, config(), points)
    at_once.run()
    assert same(whole, at_once.record())
    later = Flight(world, config(), points[0])
    later.set_waypoints(points[1:])
    while later.step().status != NavigationStatus.FINISHED:
        pass
    assert same(whole, later.end())


def test_a_flight_without_waypoints_hovers_and_says_that_it_was_stopped() -> None:
    flight = Flight(make_world(), config(), START)
    assert flight.run().status == NavigationStatus.FINISHED
    step = flight.run(lambda step: False, seconds=2.0)
    assert step.time == pytest.approx(2.0)
    np.testing.assert_array_equal(step.position, START)
    record = flight.record()
    assert (record.outcome, record.reason) == (Outcome.STOPPED, "it was stopped on its way")
    assert np.isnan(record.length_ratio)
    assert record.global_path.shape == (1, 3)


def test_a_record_of_a_stopped_flight_is_kept_in_a_file(tmp_path) -> None:
    flight = Flight(make_world(), config(), START)
    flight.step()
    flight.record().save(tmp_path / "flight.npz")
    assert ltp.FlightRecord.load(tmp_path / "flight.npz").outcome is Outcome.STOPPED


def test_reached_waypoints_end_nothing_and_others_may_follow() -> None:
    flight = Flight(make_world(), config(), path((30, 70), (50, 70)))
    first = flight.run()
    assert (first.status, flight.outcome) == (NavigationStatus.FINISHED, Outcome.REACHED)
    hovering = flight.run(lambda step: not step.velocity.any())
    assert np.linalg.norm(hovering.position - first.position) < 2.0
    flight.set_waypoints((70.0, 70.0, 30.0))
    assert flight.step().status == NavigationStatus.FOLLOWING
    assert flight.outcome is Outcome.STOPPED
    flight.run()
    record = flight.end()
    assert record.complete
    assert [entry.index for entry in record.waypoints] == [0, 1]
    np.testing.assert_array_equal(record.global_path, path((30, 70), (50, 70), (70, 70)))


def test_waypoints_are_changed_in_mid_flight_and_the_record_keeps_count() -> None:
    flight = Flight(make_world(TOWER), config(), path((30, 70), (45, 70), (60, 20), (140, 20)))
    flight.run(lambda step: step.waypoint_index == 1)
    flight.run(seconds=1.0)
    others = path((45, 110), (80, 70), (60, 120))  # the second lies in the tower
    flight.set_waypoints(others)
    step = flight.step()
    assert step.waypoints is flight.waypoints
    assert step.waypoint_index == 0
    record = (flight.run(), flight.end())[1]
    assert [(entry.index, entry.outcome) for entry in record.waypoints] == [
        (0, "reached"),
        (1, "reached"),
        (2, "dropped"),
        (3, "reached"),
    ]
    np.testing.assert_array_equal(record.global_path[2:], others)
    for entry in record.waypoints:
        assert entry.goal == tuple(record.global_path[1 + entry.index])
    assert (np.diff(record.waypoint_index) >= 0).all()
    assert {plan.waypoint for plan in record.plans} <= {0, 1, 2, 3}
    assert record.reason == "3 of 4 waypoints were reached, the others dropped"


def test_no_event_is_lost_or_told_twice_when_waypoints_change_at_every_event() -> None:
    told = []
    flight = Flight(make_world(), config(), START)
    for x in (36.0, 42.0, 48.0, 54.0):
        flight.set_waypoints([(x, 70.0, 30.0), (150.0, 70.0, 30.0)])
        step = flight.run(lambda step: bool(step.events))
        told.append([(event.index, event.goal[0]) for event in step.events])
    assert told == [[(0, 36.0)], [(0, 42.0)], [(0, 48.0)], [(0, 54.0)]]
    assert [entry.index for entry in flight.record().waypoints] == [0, 1, 2, 3]


def test_other_weights_count_from_the_next_step_on_and_nothing_sensed_is_lost() -> None:
    values = np.zeros((160, 160))
    values[:, 95:110] = 1.0  # a strip north of the straight line
    flight = Flight(
        make_world(TOWER), config(), path((30, 70), (130, 70)), priority=ltp.Raster(values)
    )
    flight.set_weights(ltp.PenaltyWeights(length=1.0, priority=0.0))
    step = flight.run(seconds=5.0)
    known = step.map.occupied.columns.copy()
    before = step.position
    assert known.any()
    flight.set_weights(ltp.PenaltyWeights(length=0.5, priority=5.0))
    assert (flight.planner.map.occupied.columns == known).all()
    step = flight.step()
    assert step.path_changed
    assert np.linalg.norm(step.position - before) < 0.5
    assert step.path[:, 1].max() > 95.0
    flight.run()
    record = flight.end()
    assert record.outcome is Outcome.REACHED
    assert record.mean_priority > 0.3
    assert record.config.planner_options.weights.priority == 1.0, "as it began"
    flight.reset()
    assert flight.planner.map.occupied.count() == 0


def test_another_priority_counts_from_the_next_step_on_and_each_stretch_by_its_own() -> None:
    world = make_world()
    flight = Flight(world, config(), path((30, 70), (110, 70)))
    flight.run(lambda step: step.position[0] > 70.0)
    zero = ltp.Raster(np.zeros((160, 160)))
    flight.set_priority(zero)
    assert flight.step().priority is zero
    flight.run()
    record = flight.end()
    changed = int(np.argmax(record.positions[:, 0] > 70.0))
    share = ltp.tally(record.positions[: changed + 2], ltp.Raster(np.ones((1, 1)))).length
    assert record.mean_priority == pytest.approx(share / record.length)
    assert 0.3 < record.mean_priority < 0.7
    with pytest.raises(ValueError, match="priority must hold shares"):
        flight.set_priority(ltp.Raster(np.full((2, 2), 3.0)))


def test_a_command_of_ones_own_is_flown_in_place_of_the_guidances() -> None:
    flight = Flight(make_world(), config(), path((30, 70), (130, 70)))
    flight.step()
    for _ in range(30):
        step = flight.step(command=(0.0, 2.0, 0.0))
    np.testing.assert_allclose(step.velocity, (0.0, 2.0, 0.0))
    assert step.position[1] > 75.0
    assert flight.run().status == NavigationStatus.FINISHED
    with pytest.raises(ValueError, match="command"):
        flight.step(command=(0.0, np.nan, 0.0))


def test_a_collision_ends_it_and_reset_begins_anew() -> None:
    flight = Flight(make_world(TOWER), config(), START)
    flight.step()
    for _ in range(400):
        step = flight.step(command=(3.0, 0.0, 0.0))
        if step.collision is not None:
            break
    assert step.collision[0] == pytest.approx(70.0)
    assert (step.scans, step.scan, flight.outcome) == ((), None, Outcome.COLLIDED)
    with pytest.raises(RuntimeError, match="reset"):
        flight.step()
    assert flight.end().outcome is Outcome.COLLIDED
    flight.reset()
    assert (flight.time, flight.outcome) == (0.0, Outcome.STOPPED)
    np.testing.assert_array_equal(flight.step().position, START)


def test_a_flight_flown_again_is_the_same_flight() -> None:
    flight = Flight(make_world(TOWER), config(), path((30, 70), (130, 70)))
    flight.run()
    first = flight.end()
    flight.reset()
    flight.run()
    assert same(first, flight.end())
    mission = Mission(make_world(TOWER), config(), path((30, 70), (130, 70)))
    assert same(mission.fly(), mission.fly())


def test_stop_and_go_is_the_same_flight() -> None:
    points = path((30, 70), (130, 70))
    whole = ltp.fly(make_world(TOWER), config(), points)
    flight = Flight(make_world(TOWER), config(), points)
    while flight.run(seconds=1.7).status != NavigationStatus.FINISHED:
        flight.record()  # changes nothing
    assert same(whole, flight.end())


class Watcher:
    """Keeps what it is told, and stops the flight when it likes."""

    def __init__(self) -> None:
        self.told: list[object] = []
        self.flight: Flight | None = None

    def on_start(self, setup: MissionSetup) -> None:
        self.told.append(setup)

    def on_step(self, step: object) -> None:
        self.told.append(step)
        if self.flight is not None and len(self.told) == 8:
            self.flight.stop()

    def on_end(self, record: ltp.FlightRecord) -> None:
        self.told.append(record)


def test_observers_are_told_of_steps_and_of_the_end_once() -> None:
    watcher = Watcher()
    with Flight(make_world(), config(), path((30, 70), (45, 70)), observers=[watcher]) as flight:
        watcher.flight = flight
        assert watcher.told == []
        step = flight.run()
        assert step is watcher.told[-1], "an observer may stop the run"
        assert len(watcher.told) == 8
        flight.run()
    record = flight.end()
    assert isinstance(watcher.told[0], MissionSetup)
    np.testing.assert_array_equal(watcher.told[0].waypoints, flight.waypoints)
    assert sum(isinstance(told, ltp.FlightRecord) for told in watcher.told) == 1
    assert len(watcher.told) == 2 + len(record.times)


def test_observers_hear_of_no_end_where_something_was_raised() -> None:
    watcher = Watcher()
    with (
        pytest.raises(ZeroDivisionError),
        Flight(make_world(), config(), START, observers=[watcher]) as flight,
    ):
        flight.step()
        raise ZeroDivisionError
    assert len(watcher.told) == 2


class Slow:
    """A vehicle of one's own: it answers within a second, and changes its arrays in place."""

    def __init__(self, position: np.ndarray) -> None:
        self.position, self.velocity = np.array(position), np.zeros(3)

    def step(self, command: np.ndarray, seconds: float) -> None:
        self.velocity += (command - self.velocity) * seconds / 1.0
        self.position += self.velocity * seconds


class Straight:
    """A guidance of one's own: towards the path's end, at 2 m/s."""

    def __init__(self) -> None:
        self.end: np.ndarray | None = None

    def follow(self, path: np.ndarray) -> None:
        self.end = path[-1] if len(path) else None

    def command(self, position, velocity, occupied) -> np.ndarray:
        ahead = np.zeros(3) if self.end is None else self.end - position
        return 2.0 * ahead / max(np.linalg.norm(ahead), 1.0)


def test_a_vehicle_and_a_guidance_of_ones_own_are_flown() -> None:
    world, points = make_world(), path((30, 70), (60, 70))
    flight = Flight(world, config(), points, vehicle=Slow(points[0]), guidance=Straight())
    flight.run()
    record = flight.end()
    assert record.complete
    assert 1.5 < np.linalg.norm(record.velocities, axis=1).max() <= 2.0
    assert len(np.unique(record.positions[:, 0])) > 100, "positions are copied"
    with pytest.raises(ValueError, match="vehicle = None"):
        flight.reset()
    flight.reset(vehicle=Slow(points[0]), guidance=Straight())
    flight.run()
    assert same(record, flight.end())
    with pytest.raises(ValueError, match=r"vehicle\.position"):
        Flight(world, config(), points, vehicle=Slow(points[1]))


def test_another_planner_takes_over_with_the_waypoints_left() -> None:
    flight = Flight(make_world(TOWER), config(), path((30, 70), (45, 70), (130, 70)))
    flight.run(lambda step: step.waypoint_index == 1)
    other = ltp.LocalTrajectoryPlanner(
        flight.setup.priority,
        flight.vehicle.position,
        planner="ggwp",
        map_options=config().mapping,
    )
    flight.take_over(other)
    np.testing.assert_array_equal(flight.waypoints, path((130, 70)))
    flight.run()
    record = flight.end()
    assert record.complete
    assert [entry.index for entry in record.waypoints] == [0, 1]


def test_holding_ends_a_run_after_its_limit_and_not_the_flight() -> None:
    world = make_world((50, 110, 50, 110, 60.0))
    heights = np.array(world.surface)
    heights[54:106, 54:106] = 0.0  # a courtyard
    world = dataclasses.replace(world, surface=heights)
    flight = Flight(world, config(planner="bezier", hold_limit=2.0), path((80, 80), (150, 80)))
    step = flight.run()
    assert step.status == NavigationStatus.HOLDING
    assert flight.held == pytest.approx(2.0)
    assert flight.outcome is Outcome.TIMED_OUT
    assert flight.record().reason == f"held for 2 s: {NavigationReason.WALLED_IN.text}"
    flight.set_waypoints((95.0, 80.0, 30.0))
    assert flight.run().status == NavigationStatus.FINISHED
    assert flight.outcome is Outcome.REACHED


@pytest.mark.parametrize(
    ("start", "match"),
    [
        (np.zeros((0, 3)), "start"),
        (np.zeros((2, 2)), "start.shape"),
        ((np.nan, 0.0, 0.0), "start: expected finite"),
        ((500.0, 0.0, 30.0), r"start\[0\].*lies off test"),
        (path((30, 70), (500, 70)), r"start\[1\].*lies off test"),
        ([(30, 70, 1.0), (60, 70, 1.0)], "at least 4 m"),
    ],
)
def test_a_strange_start_is_refused_by_name(start, match: str) -> None:
    with pytest.raises(ValueError, match=match):
        Flight(make_world(), config(), start)


def test_strange_waypoints_are_refused_by_name_and_nothing_changes() -> None:
    flight = Flight(make_world(), config(), (30.0, 70.0, 1.0))
    for points, match in (
        ([(500.0, 0.0, 30.0)], r"waypoints\[0\].*lies off test"),
        ([(30.0, np.inf, 30.0)], "waypoints: expected finite"),
        (np.zeros((2, 4)), "waypoints.shape"),
        ((60.0, 70.0, 1.0), "at least 4 m"),
    ):
        with pytest.raises(ValueError, match=match):
            flight.set_waypoints(points)
    assert len(flight.waypoints) == 0
    with pytest.raises(RuntimeError, match="step"):
        flight.record()
    with pytest.raises(ValueError, match="seconds"):
        flight.run(seconds=np.nan)
