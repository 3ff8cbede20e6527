# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What changes in mid-air: waypoints, weights, priority; and parts of one's own."""

import numpy as np
import pytest

import ltp
from ltp._core import NavigationStatus, closest_point
from ltp.sim import Flight, Outcome
from tests.python.sim.towers import START, TOWER, config, make_world, path, same


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


@pytest.mark.parametrize(("margin", "turns"), [(0.0, True), (0.01, True), (100.0, False)])
def test_a_change_turns_the_uav_about_only_for_a_path_that_is_better_by_the_margin(
    margin: float, turns: bool
) -> None:
    values = np.zeros((160, 160))
    values[:, 95:110] = 1.0  # a strip north of the straight line
    none = ltp.Raster(np.zeros((1, 1)))
    flight = Flight(make_world(), config(), path((30, 70), (130, 70)), priority=none)
    before = flight.run(seconds=5.0).path
    flight.set_priority(ltp.Raster(values), margin)
    step = flight.step()
    assert step.path_changed is turns
    assert bool(step.path[:, 1].max() > 95.0) is turns
    flight.set_weights(ltp.PenaltyWeights(length=1.0, priority=0.0), margin)
    step = flight.step()
    assert step.path_changed is turns
    assert step.path[:, 1].max() < 95.0
    if not turns:
        np.testing.assert_array_equal(step.path, before)
    with pytest.raises(ValueError, match="keep_if_within = -1"):
        flight.set_weights(ltp.PenaltyWeights(), -1.0)
    with pytest.raises(ValueError, match="length"):
        flight.set_weights(ltp.PenaltyWeights(length=-1.0))


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


def test_a_guidance_exchanged_on_the_way_goes_on_from_there() -> None:
    flight = Flight(make_world(TOWER), config(), path((30, 70), (130, 70)))
    flight.run(lambda step: step.position[0] > 50.0)
    for speed in (1.0, 3.0):
        flight.guidance = ltp.PathFollower(speed, 3.0)
        before = flight.run(seconds=2.0)
        steps = [flight.step() for _ in range(20)]
        assert not any(step.path_changed for step in steps)
        flown = ltp.tally(
            [before.position, *(step.position for step in steps)], flight.setup.priority
        )
        assert flown.length == pytest.approx(2.0 * speed, rel=0.2)
        _, arc, apart = closest_point(before.path, before.position)
        _, later, _ = closest_point(before.path, steps[-1].position)
        assert later - arc == pytest.approx(2.0 * speed, rel=0.2), "onward"
        assert apart < 1.0
    flight.run()
    assert flight.end().complete


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
