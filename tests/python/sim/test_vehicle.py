# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The vehicle keeps its limits, and reaches what is commanded."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from ltp.config import VehicleOptions
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
