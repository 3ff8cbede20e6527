# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A flight driven by hand: how it begins, what ends it and what does not, who is told."""

import dataclasses

import numpy as np
import pytest

import ltp
from ltp._core import NavigationReason, NavigationStatus
from ltp.sim import Flight, Mission, MissionSetup, Outcome
from tests.python.sim.towers import START, TOWER, config, make_world, path


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


def test_a_second_flight_begins_with_the_map_of_the_first(tmp_path) -> None:
    across = path((50, 70), (100, 70))
    first = Mission(make_world(TOWER), config(), across)
    seen = first.fly()
    first.planner.map.save(tmp_path / "seen.bt")
    second = Mission(make_world(TOWER), config(), across, known_map=tmp_path / "seen.bt")
    for flown in (second.fly(), second.fly()):
        assert (seen.outcome, flown.outcome) == (Outcome.REACHED, Outcome.REACHED)
        assert len(flown.plans) == 1 < len(seen.plans)
        assert flown.length <= seen.length
    with pytest.raises(ValueError, match=r"none\.bt"):
        ltp.fly(make_world(), config(), across, known_map=tmp_path / "none.bt")
    with pytest.raises(ValueError, match="known_map"):
        Flight(make_world(), config(), START, planner=first.planner, known_map="seen.bt")


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


def test_a_bare_surface_is_flown_over() -> None:
    surface = ltp.HeightSurface(ltp.Raster(np.zeros((100, 100)), cell=1.0))
    flight = Flight(surface, config(), (-500.0, 0.0, 30.0))
    flight.set_waypoints((-470.0, 0.0, 30.0))
    assert flight.run().status == NavigationStatus.FINISHED
    assert flight.end().world_name == "heights"


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
