# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A flight is one loop, however it is cut: the mission's, stopped, interrupted, flown again."""

import itertools

import numpy as np
import pytest

import ltp
from ltp._core import NavigationStatus
from ltp.evaluation.scenarios import ScenarioOptions, make_scenario
from ltp.sim import Flight, Mission, MissionSetup, Outcome
from ltp.sim.log import FlightLog
from ltp.sim.step import StepMaker
from ltp.world import World, make_city
from tests.python.sim.towers import TOWER, config, make_world, path, same


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


class Interrupted:
    """A planner that Ctrl-C meets while it plans, once."""

    def __init__(self, planner: ltp.LocalTrajectoryPlanner) -> None:
        self._planner, self._left = planner, 10

    def __getattr__(self, name: str) -> object:
        return getattr(self._planner, name)

    def update(self, position: np.ndarray) -> NavigationStatus:
        self._left -= 1
        if self._left == 0:
            raise KeyboardInterrupt
        return self._planner.update(position)


def test_an_interrupted_step_is_taken_up_where_it_was() -> None:
    points = path((30, 70), (130, 70))
    whole = ltp.fly(make_world(TOWER), config(), points)
    flight = Flight(make_world(TOWER), config(), points)
    flight.planner = Interrupted(flight.planner)
    with pytest.raises(KeyboardInterrupt):
        flight.run()
    assert flight.time == pytest.approx(0.9)
    flight.run()
    record = flight.end()
    # One scan was mapped, then mapped again: no cell is new, its points count twice.
    assert record.map_totals["marked"] > whole.map_totals["marked"]
    assert record.map_totals["new_cells"] == whole.map_totals["new_cells"]
    record.map_totals = whole.map_totals
    assert same(whole, record)
