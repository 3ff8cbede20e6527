# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The vehicle keeps its limits, and reaches what is commanded."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ltp.config import VehicleOptions
from ltp.sim.vehicle import PointMass

number = st.floats(-20, 20)
LIMITS = VehicleOptions(speed=3.0, max_acceleration=2.0, max_climb=1.0)


def driven(commands: list[tuple[float, float, float]], steps: int = 40) -> np.ndarray:
    """The velocities (n, 3) under commands, each given long enough to be obeyed."""
    vehicle = PointMass(np.zeros(3), LIMITS)
    velocities = []
    for command in commands:
        for _ in range(steps):
            position, velocity = vehicle.position, vehicle.velocity
            vehicle.step(np.array(command), 0.1)
            assert np.linalg.norm(vehicle.velocity - velocity) <= 0.2 + 1e-9
            moved = vehicle.position - position
            np.testing.assert_allclose(moved, 0.1 * vehicle.velocity, atol=1e-12)
            velocities.append(vehicle.velocity)
    return np.array(velocities)


@given(st.lists(st.tuples(number, number, number), min_size=1, max_size=5))
def test_the_vehicle_keeps_its_limits(commands) -> None:
    velocities = driven(commands)
    assert np.linalg.norm(velocities, axis=1).max() <= 3.0 + 1e-9
    assert np.abs(velocities[:, 2]).max() <= 1.0 + 1e-9


@pytest.mark.parametrize(
    ("command", "speed", "climb"),
    [
        ((20.0, 0.0, 0.0), 3.0, 0.0),
        ((-15.0, 15.0, 0.0), 3.0, 0.0),
        ((20.0, 0.0, 2.0), 3.0, 0.2985),  # fast with a small climb: the speed limit binds
        ((20.0, 5.0, -1.0), 3.0, 0.1453),
        ((0.0, 0.0, 20.0), 1.0, 1.0),  # straight up: the climb limit
        ((0.0, 0.0, -20.0), 1.0, 1.0),
        ((1.0, 0.0, 5.0), 1.0198, 1.0),
        ((10.0, 0.0, 10.0), 1.4142, 1.0),  # both: as a whole, so that the direction stays
    ],
)
def test_the_limits_are_reached_and_the_direction_stays(command, speed, climb) -> None:
    last = driven([command])[-1]
    assert np.linalg.norm(last) == pytest.approx(speed, abs=1e-3)
    assert abs(last[2]) == pytest.approx(climb, abs=1e-3)
    np.testing.assert_allclose(np.cross(last, command), 0.0, atol=1e-6)


def test_the_vehicle_reaches_what_is_commanded() -> None:
    vehicle = PointMass(np.zeros(3), VehicleOptions())
    for _ in range(20):
        vehicle.step(np.array([0.0, 3.0, 0.0]), 0.1)
    np.testing.assert_allclose(vehicle.velocity, [0, 3, 0], atol=1e-12)


@pytest.mark.parametrize("position", [(1.0, 2.0), (1.0, 2.0, np.nan), np.zeros((1, 3))])
def test_a_position_that_is_none_is_refused(position) -> None:
    with pytest.raises(ValueError, match=r"position = .*expected three finite numbers"):
        PointMass(position, VehicleOptions())
