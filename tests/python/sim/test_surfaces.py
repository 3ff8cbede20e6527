# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flights over surfaces that no height raster can say: a window in a wall, wires, an overhang."""

import numpy as np
import pytest

import ltp
from ltp.sim import MissionSetup, Outcome

EDGE = 0.5  # of a voxel [m]


def box(x0: float, x1: float, y0: float, y1: float, z0: float, z1: float) -> np.ndarray:
    """The centres of the voxels of a solid box (n, 3) [m]."""
    axes = [np.arange(low + EDGE / 2, high, EDGE) for low, high in ((x0, x1), (y0, y1), (z0, z1))]
    return np.stack([axis.ravel() for axis in np.meshgrid(*axes, indexing="ij")], axis=1)


def octree(*boxes: np.ndarray) -> ltp.OctreeSurface:
    return ltp.OctreeSurface(np.concatenate(boxes), EDGE)


def window(low: float = 30.0, high: float = 50.0) -> ltp.OctreeSurface:
    """A wall across x = 40 m, 80 m high and 140 m wide, with a window round (40, 0, 40)."""
    return octree(
        box(40, 41, -70, -10, 0, 80),
        box(40, 41, 10, 70, 0, 80),
        box(40, 41, -10, 10, 0, low),
        box(40, 41, -10, 10, high, 80),
    )


def config(**values) -> ltp.MissionConfig:
    settings = ltp.MissionConfig(**values)
    settings.mapping.dims = [80, 80, 30]
    settings.lidar.pattern.azimuths = 120
    settings.lidar.pattern.rows = 16
    settings.lidar.pattern.elevation_from_deg = -30.0
    settings.lidar.pattern.elevation_to_deg = 30.0
    return settings


def path(z: float = 40.0, y: float = 0.0) -> np.ndarray:
    return np.array([[0.0, y, z], [80.0, y, z]])


def test_a_window_in_a_wall_is_flown_through() -> None:
    record = ltp.fly(window(), config(), path(y=6.0))
    assert record.outcome is Outcome.REACHED
    assert record.length_ratio < 1.2
    crossing = record.positions[np.abs(record.positions[:, 0] - 40.5).argmin()]
    assert abs(crossing[1]) < 10.0
    assert 1.0 < record.min_clearance < 10.0
    assert record.world_name == "octree"


def test_a_wall_without_a_window_is_flown_round() -> None:
    wall = octree(box(40, 41, -30, 30, 0, 80))
    record = ltp.fly(wall, config(), path())
    assert record.outcome is Outcome.REACHED
    crossing = record.positions[np.abs(record.positions[:, 0] - 40.5).argmin()]
    assert abs(crossing[1]) > 30.0


def test_wires_are_flown_over_or_under_and_touching_one_is_a_collision() -> None:
    wires = octree(
        box(40, 40.5, -60, 60, 41.5, 42.5),
        box(42, 42.5, -60, 60, 45, 45.5),
        box(0, 80, -60, 60, 0, 0.5),
    )
    settings = config()
    settings.navigation.band = (12.0, 12.0)
    record = ltp.fly(wires, settings, path(z=42.0))
    assert record.outcome is Outcome.REACHED
    assert record.min_clearance > 1.0
    assert np.abs(record.positions[:, 2] - 42.0).max() > 3.0
    assert record.length_ratio < 1.3
    blind = config()
    blind.lidar.max_range = 0.5
    struck = ltp.fly(wires, blind, path(z=42.0))
    assert struck.outcome is Outcome.COLLIDED
    assert struck.collision is not None
    np.testing.assert_allclose(struck.collision[::2], (40.0, 42.0), atol=1e-6)


def test_an_overhang_is_flown_under() -> None:
    bridge = octree(box(30, 50, -60, 60, 60, 64), box(30, 50, -60, -50, 0, 60))
    record = ltp.fly(bridge, config(), path(z=30.0))
    assert record.outcome is Outcome.REACHED
    assert record.length_ratio < 1.05


def test_a_height_surface_flies_as_its_world_does() -> None:
    heights = np.zeros((120, 120))
    heights[50:60, 30:80] = 60.0
    raster = ltp.Raster(heights, origin=(-20.0, -60.0), cell=1.0)
    priority = ltp.Raster(np.zeros((1, 1)))
    world = ltp.World(
        "boxes",
        np.zeros_like(heights),
        heights,
        np.ones_like(heights, dtype=np.uint8),
        cell=1.0,
        origin=(-20.0, -60.0),
    )
    bare = ltp.fly(ltp.HeightSurface(raster), config(), path())
    whole = ltp.fly(world, config(), path(), priority=priority)
    np.testing.assert_array_equal(bare.positions, whole.positions)
    assert bare.min_clearance == whole.min_clearance


def test_a_priority_map_may_be_given() -> None:
    priority = ltp.Raster(np.ones((200, 200)), origin=(-50.0, -100.0), cell=1.0)
    empty = octree(box(40, 41, -70, -60, 0, 10))
    assert ltp.fly(empty, config(), path()).mean_priority == 0.0
    assert ltp.fly(empty, config(), path(), priority=priority).mean_priority == 1.0


def test_the_scenery_of_an_octree_is_its_tops() -> None:
    setup = MissionSetup.of(window(), config(), path())
    assert setup.world.extent == (40.0, -70.0, 41.0, 70.0)
    assert setup.world.surface.max() == 80.0
    assert (setup.world.ground == 0.0).all()


def test_an_octree_answers_what_a_height_surface_does() -> None:
    solid = octree(box(10, 20, 5, 15, 0, 12))
    points = np.array(
        [[0.0, 10, 6], [15, 10, 20], [15, 10, 6], [0, 0, 30], [23, 19, 6], [15, 10, 12]]
    )
    np.testing.assert_allclose(solid.clearance(points, 50.0), [10, 8, 0, np.sqrt(449), 5, 0])
    np.testing.assert_allclose(solid.clearance(points[:1], 3.0), [3.0])
    assert solid.first_collision(np.array([[0.0, 10, 6], [30, 10, 6]])) == pytest.approx(10.0)
    assert solid.first_collision(np.array([[0.0, 10, 13], [30, 10, 13]])) is None
    assert solid.first_collision(np.array([[15.0, 10, 6]])) == 0.0
