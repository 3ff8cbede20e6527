# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Following a path: near it, round its corners, and to rest at its end."""

import numpy as np

from ltp._core import closest_point
from ltp.config import VehicleOptions
from ltp.sim.guidance import PathFollower
from ltp.sim.vehicle import PointMass


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
