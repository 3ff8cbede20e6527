# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Following a path: near it at any cell size and speed, within the vehicle's limits, to rest."""

import itertools
import math

import numpy as np
import pytest

import ltp
from ltp._core import GridFrame, OccupancyGrid, closest_point, path_length
from ltp.config import GuidanceOptions, VehicleOptions
from ltp.sim.guidance import PathFollower
from ltp.sim.vehicle import PointMass

HEADINGS = np.array(
    [[1, 0, 0], [1, 1, 0], [0, 1, 0], [-1, 1, 0], [0, -1, 0], [1, 0, 1], [1, -1, 0], [0, 1, -1]]
)


def fly(
    path: np.ndarray,
    *,
    cell: float = 2.0,
    speed: float = 3.0,
    acceleration: float = 3.0,
    climb: float = 2.0,
    steps: int = 3000,
    step: float = 0.1,
    velocity: tuple[float, float, float] = (0.0, 0.0, 0.0),
) -> tuple[np.ndarray, np.ndarray]:
    """Positions and commands (n, 3) until the UAV has come to rest at the path's end."""
    vehicle = PointMass(path[0], VehicleOptions(speed, acceleration, climb))
    vehicle.velocity = np.array(velocity)
    guidance = PathFollower(speed, acceleration, cell=cell, max_climb=climb, step=step)
    guidance.follow(path)
    track, commands = [vehicle.position], []
    for _ in range(steps):
        command = guidance.command(vehicle.position, vehicle.velocity)
        assert np.linalg.norm(command - vehicle.velocity) <= acceleration * step * (1 + 1e-9)
        assert abs(command[2]) <= climb * (1 + 1e-9) or abs(vehicle.velocity[2]) > climb
        vehicle.step(command, step)
        np.testing.assert_allclose(vehicle.velocity, command, atol=1e-9)
        track.append(vehicle.position)
        commands.append(command)
        left = np.linalg.norm(vehicle.position - path[-1])
        if left < 0.02 * cell and np.linalg.norm(command) < 0.05:
            break
    return np.array(track), np.array(commands)


def deviation(track: np.ndarray, path: np.ndarray) -> float:
    """The largest distance from the path, also between steps [m]."""
    between = np.concatenate([np.linspace(a, b, 5) for a, b in itertools.pairwise(track)])
    return max(closest_point(path, point)[2] for point in between)


def corner(degrees: float, leg: float = 30.0) -> np.ndarray:
    turn = math.radians(degrees)
    end = (leg * (1 + math.cos(turn)), leg * math.sin(turn), 50.0)
    return np.array([[0.0, 0.0, 50.0], [leg, 0.0, 50.0], end])


def grid_path(seed: int, cell: float) -> np.ndarray:
    random = np.random.default_rng(seed)
    pick = random.integers(0, len(HEADINGS), 14)
    steps = np.repeat(HEADINGS[pick] * cell, random.integers(1, 9, 14), axis=0)
    return np.cumsum(np.vstack([[0, 0, 50], steps]), axis=0).astype(float)


@pytest.mark.parametrize("cell", [0.25, 0.5, 2.0])
@pytest.mark.parametrize("speed", [3.0, 10.0])
@pytest.mark.parametrize("degrees", [10, 45, 90, 135, 180])
def test_a_corner_is_flown_within_half_a_cell(cell: float, speed: float, degrees: float) -> None:
    path = corner(degrees)
    track, _ = fly(path, cell=cell, speed=speed)
    assert deviation(track, path) <= 0.5 * cell
    np.testing.assert_allclose(track[-1], path[-1], atol=0.05 * cell + 0.01)


@pytest.mark.parametrize("cell", [0.25, 1.0, 2.0, 8.0])
@pytest.mark.parametrize("seed", range(4))
def test_a_grid_path_is_flown_within_half_a_cell(cell: float, seed: int) -> None:
    path = grid_path(seed, cell)
    track, _ = fly(path, cell=cell)
    assert deviation(track, path) <= 0.5 * cell
    np.testing.assert_allclose(track[-1], path[-1], atol=0.05 * cell + 0.01)


@pytest.mark.parametrize("cell", [0.25, 2.0])
def test_a_curve_and_a_staircase_are_flown_within_half_a_cell(cell: float) -> None:
    turn = np.linspace(0.0, 4.0, 200)
    radius = 6 * cell
    circle = np.stack([radius * np.cos(turn), radius * np.sin(turn), 50 + 0 * turn], axis=1)
    steps = np.arange(50)
    stairs = np.stack([cell * ((steps + 1) // 2), cell * (steps // 2), 50 + 0 * steps], axis=1)
    for path in (circle, stairs.astype(float)):
        assert deviation(fly(path, cell=cell)[0], path) <= 0.5 * cell


@pytest.mark.parametrize(("acceleration", "step"), [(1.0, 0.1), (6.0, 0.1), (3.0, 0.05)])
def test_other_vehicles_keep_to_the_path_too(acceleration: float, step: float) -> None:
    path = grid_path(7, 1.0)
    track, _ = fly(path, cell=1.0, acceleration=acceleration, step=step, steps=8000)
    assert deviation(track, path) <= 0.5


def test_straight_stretches_are_flown_at_full_speed() -> None:
    for cell, speed in ((0.25, 3.0), (2.0, 10.0)):
        path = np.array([[0.0, 0, 50], [150.0, 0, 50]])
        _, commands = fly(path, cell=cell, speed=speed)
        speeds = np.linalg.norm(commands, axis=1)
        assert (speeds > 0.999 * speed).sum() > 0.5 * len(speeds)


def test_wide_bends_over_coarse_cells_do_not_slow_the_paper_s_vehicle() -> None:
    _, commands = fly(corner(45))
    speeds = np.linalg.norm(commands, axis=1)
    assert speeds[12:150].min() > 2.5


def test_a_path_that_passes_by_itself_is_not_cut_short() -> None:
    # There and back, 1 m apart: the way back is nearer than the corner that it may cut to.
    for gap in (0.0, 0.2, 1.0):
        path = np.array([[0.0, 0, 50], [40, 0, 50], [40, gap, 50], [0, gap, 50], [0, 20, 50]])
        track, _ = fly(path)
        assert track[:, 0].max() > 39.0
        assert path_length(track) > 0.93 * path_length(path)


def test_a_loop_is_flown_whole() -> None:
    path = np.array([[0.0, 0, 50], [30, 0, 50], [30, 30, 50], [15, 30, 50], [15, -30, 50]])
    track, _ = fly(path)
    assert track[:, 1].max() > 29.0


def test_a_uav_that_comes_in_fast_from_aside_turns_within_its_limits() -> None:
    path = np.array([[0.0, 0, 50], [60.0, 0, 50]])
    track, _ = fly(path, speed=10.0, velocity=(0.0, 10.0, 0.0))
    np.testing.assert_allclose(track[-1], path[-1], atol=0.2)
    assert track[:, 1].max() < 10.0**2 / (2 * 3.0) + 6.0  # braking distance, and some


def test_a_steep_path_is_flown_at_the_climb_limit() -> None:
    path = np.array([[0.0, 0, 10], [10.0, 0, 60]])
    _, commands = fly(path, climb=1.0)
    assert np.abs(commands[:, 2]).max() == pytest.approx(1.0)


def wall_ahead(x: int) -> OccupancyGrid:
    blocked = np.zeros((40, 20, 4), dtype=bool)
    blocked[x] = True
    return OccupancyGrid.from_array(
        blocked, GridFrame((0.0, -20.0, 40.0), (2.0, 2.0, 4.0), (40, 20, 4))
    )


@pytest.mark.parametrize("speed", [3.0, 6.0, 10.0])
def test_it_never_flies_faster_than_it_can_stop_before_what_was_hit(speed: float) -> None:
    # A path that leads through a wall: a planner's mistake, or a wall seen this moment.
    occupied = wall_ahead(30)
    vehicle = PointMass(np.array([2.0, 0, 50]), VehicleOptions(speed, 3.0, 2.0))
    guidance = PathFollower(speed, 3.0)
    guidance.follow(np.array([[2.0, 0, 50], [78.0, 0, 50]]))
    fastest = 0.0
    for _ in range(600):
        vehicle.step(guidance.command(vehicle.position, vehicle.velocity, occupied), 0.1)
        assert vehicle.position[0] < 60.0
        fastest = max(fastest, float(np.linalg.norm(vehicle.velocity)))
    assert fastest == pytest.approx(speed)
    assert vehicle.position[0] > 57.0


def test_a_wall_seen_late_is_braked_for_as_hard_as_can_be() -> None:
    guidance = PathFollower(10.0, 3.0)
    guidance.follow(np.array([[2.0, 0, 50], [78.0, 0, 50]]))
    velocity = np.array([10.0, 0.0, 0.0])
    command = guidance.command(np.array([50.0, 0, 50]), velocity, wall_ahead(30))
    np.testing.assert_allclose(command, [9.7, 0.0, 0.0])


def test_guidance_without_a_path_brakes() -> None:
    guidance = PathFollower(3.0, 3.0)
    guidance.follow(np.empty((0, 3)))
    np.testing.assert_array_equal(guidance.command(np.ones(3)), np.zeros(3))
    velocity = np.array([3.0, 0.0, 0.0])
    np.testing.assert_allclose(guidance.command(np.ones(3), velocity), [2.7, 0.0, 0.0])


def test_without_a_velocity_it_goes_by_its_last_command() -> None:
    guidance = PathFollower(3.0, 2.0)
    guidance.follow(np.array([[0.0, 0, 50], [50.0, 0, 50]]))
    commands = [guidance.command(np.array([0.0, 0, 50])) for _ in range(20)]
    np.testing.assert_allclose([c[0] for c in commands[:4]], [0.2, 0.4, 0.6, 0.8])
    assert commands[-1][0] == pytest.approx(3.0)


@pytest.mark.parametrize("path", [[[1.0, 2, 3]], [[1.0, 2, 3], [1, 2, 3]]])
def test_a_path_of_one_place_is_stayed_at(path: list[list[float]]) -> None:
    guidance = PathFollower(3.0, 3.0)
    guidance.follow(np.array(path))
    np.testing.assert_array_equal(guidance.command(np.array(path[0])), np.zeros(3))


def test_what_is_no_path_is_refused_and_the_old_one_flown_on() -> None:
    guidance = PathFollower(3.0, 3.0)
    guidance.follow([[0.0, 0, 0], [30, 0, 0]])
    for wrong in (np.zeros((3, 4)), np.zeros((4, 2)), np.zeros(3), np.zeros((2, 2, 3))):
        with pytest.raises(ValueError, match=r"path.shape = \(.*\): expected \(n, 3\)"):
            guidance.follow(wrong)
    with pytest.raises(ValueError, match="path: expected finite"):
        guidance.follow([[0.0, 0, 0], [math.nan, 0, 0]])
    assert guidance.command(np.zeros(3))[0] > 0.0
    for nothing in ([], np.empty((0, 3))):
        guidance.follow(nothing)
        np.testing.assert_array_equal(guidance.command(np.zeros(3), np.zeros(3)), np.zeros(3))


@pytest.mark.parametrize("name", ["speed", "max_acceleration", "look_ahead", "cell", "step"])
@pytest.mark.parametrize("value", [0.0, -1.0, math.nan, math.inf])
def test_a_strange_setting_is_refused_by_name(name: str, value: float) -> None:
    settings = {"speed": 3.0, "max_acceleration": 3.0, name: value}
    with pytest.raises(ValueError, match=name):
        PathFollower(**settings)


@pytest.mark.parametrize(
    ("name", "value"),
    [
        ("look_ahead", 0.0),
        ("tolerance", -1.0),
        ("tolerance", math.nan),
        ("lateral_share", 1.5),
        ("braking_share", 0.0),
        ("stop_margin", -0.1),
        ("stop_margin", math.inf),
        ("tolerance", True),
        ("look_ahead", "far"),
    ],
)
def test_strange_options_are_refused_by_name(name: str, value: object) -> None:
    with pytest.raises(ValueError, match=f"guidance.{name}"):
        GuidanceOptions(**{name: value})


def test_the_options_are_settings_of_a_mission() -> None:
    config = ltp.MissionConfig.from_toml("[guidance]\ntolerance = 0.25\nstop_margin = 1.0")
    assert config.guidance == GuidanceOptions(tolerance=0.25, stop_margin=1.0)
    assert ltp.MissionConfig.from_toml(config.to_toml()).guidance == config.guidance
    with pytest.raises(ValueError, match=r"guidance\.tolerence"):
        ltp.MissionConfig.from_toml("[guidance]\ntolerence = 0.25")
    path, tracks = corner(90), []
    for tolerance in (0.1, 0.5):
        guidance = PathFollower(3.0, 3.0, options=GuidanceOptions(tolerance=tolerance))
        guidance.follow(path)
        vehicle = PointMass(path[0], VehicleOptions())
        tracks.append([vehicle.position])
        for _ in range(250):
            vehicle.step(guidance.command(vehicle.position, vehicle.velocity), 0.1)
            tracks[-1].append(vehicle.position)
    close, wide = (deviation(np.array(track), path) for track in tracks)
    assert close <= 0.2 < wide <= 1.0


def test_follower_and_vehicle_are_public_and_say_what_they_are() -> None:
    assert ltp.PathFollower is PathFollower
    assert ltp.PointMass is PointMass
    guidance = PathFollower(3.0, 3.0, cell=0.5)
    guidance.follow(corner(90))
    assert "speed=3" in repr(guidance)
    assert "60.0 m" in repr(guidance)
    assert "position=(1, 2, 3)" in repr(PointMass(np.array([1.0, 2, 3]), VehicleOptions()))
