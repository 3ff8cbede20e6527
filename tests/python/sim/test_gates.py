# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Missions whose waypoints are served within a region."""

import math

import numpy as np
import pytest

import ltp
from ltp.sim import MissionSetup
from ltp.world import LandClass, World


@pytest.fixture
def world() -> World:
    """Level ground at 12 m, all of it good."""
    ground = np.full((200, 200), 12.0)
    classes = np.full(ground.shape, LandClass.GRASS, dtype=np.uint8)
    return World("level", ground, ground, classes, cell=1.0)


PATH = np.array([(40, 40, 42), (90, 40, 42), (90, 90, 52), (140, 90, 42)], dtype=float)


def config(**values: object) -> ltp.MissionConfig:
    made = ltp.MissionConfig(**values)
    made.mapping.dims = [80, 80, 20]
    made.navigation.band = (0.0, 0.0)
    return made


def test_the_cameras_gate_is_half_its_footprint_at_the_height_flown(world: World) -> None:
    gates = MissionSetup.of(world, config(gate="camera"), PATH).gates(PATH[1:])
    half = math.tan(math.radians(53.0 / 2))
    np.testing.assert_allclose(gates, [(30 * half, 0), (40 * half, 0), (0, 0)])
    assert 50 * half == pytest.approx(24.9, abs=0.05)


def test_a_number_is_metres_and_the_last_waypoint_stays_a_point(world: World) -> None:
    gates = MissionSetup.of(world, config(gate=7.5), PATH).gates(PATH[1:])
    np.testing.assert_array_equal(gates, [(7.5, 0), (7.5, 0), (0, 0)])
    assert MissionSetup.of(world, config(), PATH).gates(PATH[1:]).shape == (0, 2)


def test_wider_gates_make_shorter_flights(world: World) -> None:
    flat = PATH * (1, 1, 0) + (0, 0, 42)
    point, five, camera = (
        ltp.fly(world, config(gate=gate), flat) for gate in ("point", 8, "camera")
    )
    assert point.complete and five.complete and camera.complete
    assert camera.length < five.length < point.length
    # The record says in which gate, and from how near.
    assert [entry.gate_radius for entry in point.waypoints] == [0.0] * 3
    assert [entry.gate_radius for entry in five.waypoints] == [8.0, 8.0, 0.0]
    assert all(entry.distance <= entry.gate_radius for entry in five.waypoints[:2])
    assert five.waypoints[0].distance > point.waypoints[0].distance
    joint = config(gate="camera")
    joint.navigation.horizon = 3
    assert ltp.fly(world, joint, flat).length < camera.length


def test_the_setting_is_kept_in_files_and_checked() -> None:
    for gate in ("point", "camera", 12.5):
        again = ltp.MissionConfig.from_toml(ltp.MissionConfig(gate=gate).to_toml())
        assert again.gate == gate
    for gate in ("eye", -1.0, 1e6, math.nan):
        with pytest.raises(ValueError, match="gate = "):
            ltp.MissionConfig(gate=gate)
    with pytest.raises(ValueError, match="gate = "):
        ltp.MissionConfig.from_dict({"gate": True})
