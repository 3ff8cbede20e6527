# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The simulator's parts: vehicle, guidance, record."""

import errno
import os

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ltp.config import MissionConfig, VehicleOptions
from ltp.sim.guidance import PathFollower
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEvent
from ltp.sim.vehicle import PointMass

number = st.floats(-20, 20)


@given(st.lists(st.tuples(number, number, number), min_size=1, max_size=30))
def test_the_vehicle_keeps_its_limits(commands) -> None:
    options = VehicleOptions(speed=3.0, max_acceleration=2.0, max_climb=1.0)
    vehicle = PointMass(np.zeros(3), options)
    for command in commands:
        position, velocity = vehicle.position, vehicle.velocity
        vehicle.step(np.array(command), 0.1)
        assert np.linalg.norm(vehicle.velocity) <= 3.0 + 1e-9
        assert abs(vehicle.velocity[2]) <= 1.0 + 1e-9
        assert np.linalg.norm(vehicle.velocity - velocity) <= 0.2 + 1e-9
        np.testing.assert_allclose(vehicle.position - position, 0.1 * vehicle.velocity, atol=1e-12)


def test_the_vehicle_reaches_what_is_commanded() -> None:
    vehicle = PointMass(np.zeros(3), VehicleOptions())
    for _ in range(20):
        vehicle.step(np.array([0.0, 3.0, 0.0]), 0.1)
    np.testing.assert_allclose(vehicle.velocity, [0, 3, 0], atol=1e-12)


def fly(path: np.ndarray, steps: int = 600) -> np.ndarray:
    options = VehicleOptions()
    vehicle = PointMass(path[0], options)
    guidance = PathFollower(options.speed, options.max_acceleration)
    guidance.follow(path)
    track = [vehicle.position]
    for _ in range(steps):
        vehicle.step(guidance.command(vehicle.position), 0.1)
        track.append(vehicle.position)
    return np.array(track)


def distances(track: np.ndarray, path: np.ndarray) -> np.ndarray:
    from ltp._core import closest_point

    return np.array([closest_point(path, point)[2] for point in track])


def test_guidance_stops_at_the_end_and_stays_near_the_path() -> None:
    corner = np.array([[0, 0, 50], [40, 0, 50], [40, 40, 50], [10, 70, 50]], dtype=float)
    track = fly(corner)
    np.testing.assert_allclose(track[-1], corner[-1], atol=0.1)
    # Between a path and anything that was hit lies at least one whole 2 m cell.
    assert distances(track, corner).max() < 1.0


def test_guidance_follows_random_grid_paths() -> None:
    random = np.random.default_rng(4)
    headings = np.array([[2, 0, 0], [2, 2, 0], [0, 2, 0], [-2, 2, 0], [0, -2, 0], [2, 0, 4]])
    for _ in range(10):
        steps = np.repeat(headings[random.integers(0, 6, 12)], random.integers(2, 6, 12), axis=0)
        path = np.cumsum(np.vstack([[0, 0, 50], steps]), axis=0).astype(float)
        assert distances(fly(path, 300), path).max() < 2.0


def test_guidance_without_a_path_brakes() -> None:
    guidance = PathFollower(3.0, 3.0)
    guidance.follow(np.empty((0, 3)))
    np.testing.assert_array_equal(guidance.command(np.ones(3)), np.zeros(3))


def make_record(plans: int = 2) -> FlightRecord:
    times = np.arange(4) * 0.1
    return FlightRecord(
        config=MissionConfig(planner="ggwp"),
        world_name="test",
        attribution="nobody",
        global_path=np.array([[0.0, 0, 50], [3, 4, 50]]),
        times=times,
        positions=np.stack([times, times, 0 * times + 50], axis=1),
        velocities=np.ones((4, 3)),
        plan_index=np.array([-1, 0, 0, 1]),
        waypoint_index=np.zeros(4, dtype=np.int64),
        waypoints=[
            WaypointEvent(0, "dropped", "unreachable", 0.2, (0, 0, 50), (3, 4, 50), (-1, -1, 0))
        ],
        plans=[
            PlanEntry(0.1 * i, 0, "found", np.full((i + 2, 3), i), 0.5, 3.0, 1.0, 2.5, 7, 1e-3)
            for i in range(plans)
        ],
        outcome=Outcome.REACHED,
        collision=None,
        min_clearance=4.5,
        mean_priority=0.25,
        length=6.0,
        metadata={"scenario": 3},
    )


@pytest.mark.parametrize("plans", [0, 1, 3])
def test_record_round_trip(tmp_path, plans: int) -> None:
    record = make_record(plans)
    record.save(tmp_path / "flight.npz")
    again = FlightRecord.load(tmp_path / "flight.npz")
    assert again.config.to_dict() == record.config.to_dict()
    assert again.waypoints == record.waypoints
    assert again.metadata == {"scenario": 3}
    assert [len(plan.path) for plan in again.plans] == [i + 2 for i in range(plans)]
    for name in ("times", "positions", "velocities", "plan_index", "waypoint_index"):
        np.testing.assert_array_equal(getattr(again, name), getattr(record, name))
    assert again.outcome is Outcome.REACHED
    assert again.length_ratio == pytest.approx(6.0 / 5.0)
    assert not again.complete
    assert [event.reason for event in again.dropped] == ["unreachable"]


def test_a_truncated_record_is_refused_by_name(tmp_path) -> None:
    path = tmp_path / "flight.npz"
    make_record().save(path)
    whole = path.read_bytes()
    for size in range(0, len(whole) - 1, 97):
        path.write_bytes(whole[:size])
        with pytest.raises(ValueError, match=r"flight\.npz"):
            FlightRecord.load(path)


def test_a_full_disk_keeps_the_older_flight(tmp_path, monkeypatch) -> None:
    path = tmp_path / "flight.npz"
    make_record(1).save(path)

    def full(_descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match="No space left"):
        make_record(3).save(path)
    assert len(FlightRecord.load(path).plans) == 1
    assert [file.name for file in tmp_path.iterdir()] == ["flight.npz"]
