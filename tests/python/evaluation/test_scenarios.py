# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The seeded global paths: straight, of their length, repeatable, through buildings on purpose."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ltp.evaluation.scenarios import (
    ScenarioOptions,
    buildings_raster,
    make_scenario,
    make_scenarios,
    must_cross,
)
from ltp.world import LandClass, World
from tests.python.scenes import box_world, town

SMALL = {"length": 150.0, "spacing": 40.0, "altitude": 30.0, "margin": 10.0}


def touches_building(world: World, path: np.ndarray) -> bool:
    """Slow and obvious: look every 2 cm."""
    count = int(np.linalg.norm(path[-1] - path[0]) / 0.02)
    points = path[0] + np.linspace(0.0, 1.0, count)[:, None] * (path[-1] - path[0])
    i, j = np.floor((points[:, :2] - world.origin) / world.cell).astype(int).T
    built = world.classes[i, j] == LandClass.BUILDING
    return bool(np.any(built & (world.surface[i, j] >= points[:, 2])))


@pytest.mark.parametrize("share", [0.0, 0.5, 1.0])
def test_paths_are_straight_inside_and_cross_as_told(share: float) -> None:
    world = town()
    options = ScenarioOptions(count=24, through_buildings=share, **SMALL)
    scenarios = make_scenarios(world, options)
    assert [scenario.index for scenario in scenarios] == list(range(24))
    for scenario in scenarios:
        path = scenario.global_path
        steps = np.linalg.norm(np.diff(path[:, :2], axis=0), axis=1)
        np.testing.assert_allclose(steps, [40.0, 40.0, 40.0, 30.0])
        assert np.linalg.norm(path[-1, :2] - path[0, :2]) == pytest.approx(150.0)
        assert np.all(path[:, 2] == 30.0)
        assert np.all(path[:, :2] >= 10.0) and np.all(path[:, :2] <= np.array([250.0, 210.0]))
        assert scenario.crosses_building == touches_building(world, path)
    required = [s for s in scenarios if must_cross(s.index, share)]
    assert len(required) == 24 * share
    assert all(scenario.crosses_building for scenario in required)


def test_the_start_is_clear_of_everything_solid() -> None:
    world = town()
    options = ScenarioOptions(count=40, clearance=15.0, **SMALL)
    solid = np.argwhere(world.surface >= 30.0)
    for scenario in make_scenarios(world, options):
        x, y = scenario.global_path[0, :2]
        away = np.maximum(np.maximum(solid - (x, y), (x, y) - solid - 1.0), 0.0)
        assert np.hypot(*away.T).min() >= 15.0 - 1e-9


@pytest.mark.parametrize("altitude", [1.0, 2.0, 5.0, 9.0, 15.0])
@pytest.mark.parametrize("tilt", [0.0, 0.2])
def test_the_ground_does_not_count(altitude: float, tilt: float) -> None:
    flat = town()
    rng = np.random.default_rng(2)
    slope = 40.0 + tilt * np.arange(float(flat.shape[0]))[:, None] * np.ones(flat.shape)
    grass = rng.uniform(0.0, 0.4, flat.shape)  # as a laser sees it: no obstacle
    world = World("low", slope, slope + np.maximum(flat.surface, grass), flat.classes, 1.0)
    options = ScenarioOptions(count=12, **(SMALL | {"altitude": altitude}))
    solid = np.argwhere(flat.surface > 0.0)
    for scenario in make_scenarios(world, options):
        x, y, z = scenario.global_path[0]
        assert z == pytest.approx(altitude + slope[int(x), 0])
        away = np.maximum(np.maximum(solid - (x, y), (x, y) - solid - 1.0), 0.0)
        assert np.hypot(*away.T).min() >= 10.0 - 1e-9
        assert scenario.crosses_building


def test_a_start_is_never_in_a_hillside() -> None:
    steps = np.where(np.arange(300)[:, None] < 150, 0.0, 60.0) * np.ones((300, 300))
    world = World("cliff", steps, steps, np.ones((300, 300), np.uint8), 1.0)
    options = ScenarioOptions(
        count=30, length=120.0, altitude=12.0, reference="datum", through_buildings=0.0
    )
    for scenario in make_scenarios(world, options):
        assert scenario.global_path[0, 0] <= 150.0 - 6.0  # half its height above the ground


def test_the_clearance_is_as_wide_as_asked_for() -> None:
    world = box_world([(60, 140, 40, 120)])
    starts = {}
    for clearance in (0.0, 3.0, 20.0):
        made = make_scenarios(world, ScenarioOptions(count=60, clearance=clearance, **SMALL))
        x, y = np.array([scenario.global_path[0, :2] for scenario in made]).T
        gap = np.hypot(
            np.maximum(np.maximum(60 - x, x - 140), 0), np.maximum(np.maximum(40 - y, y - 120), 0)
        )
        starts[clearance] = gap.min()
        assert gap.min() >= clearance
    assert starts[0.0] < starts[3.0] + 1e-9 and starts[3.0] < 20.0


def test_the_same_seed_gives_the_same_paths_whatever_their_number() -> None:
    world = town()
    few = make_scenarios(world, ScenarioOptions(count=3, **SMALL))
    many = make_scenarios(world, ScenarioOptions(count=9, **SMALL))
    other = make_scenarios(world, ScenarioOptions(count=3, seed=2, **SMALL))
    for a, b, c in zip(few, many, other, strict=False):
        np.testing.assert_array_equal(a.global_path, b.global_path)
        assert not np.array_equal(a.global_path, c.global_path)
    alone = make_scenario(world, ScenarioOptions(**SMALL), 7)
    np.testing.assert_array_equal(alone.global_path, many[7].global_path)


def test_altitude_counts_from_the_ground_beneath_each_waypoint_or_from_the_datum() -> None:
    flat = town()
    slope = np.linspace(5.0, 25.0, flat.shape[0])[:, None] * np.ones(flat.shape)
    world = World("slope", slope, slope + flat.surface, flat.classes, 1.0)
    above_ground = make_scenarios(world, ScenarioOptions(count=5, **SMALL))
    above_datum = make_scenarios(world, ScenarioOptions(count=5, reference="datum", **SMALL))
    for scenario in above_ground:
        path = scenario.global_path
        beneath = slope[np.floor(path[:, 0]).astype(int), 0]
        np.testing.assert_allclose(path[:, 2] - beneath, 30.0)
    assert all(np.all(scenario.global_path[:, 2] == 30.0) for scenario in above_datum)


def test_trees_are_no_buildings() -> None:
    world = box_world([(40, 60, 40, 60)])
    classes = world.classes.copy()
    classes[50:, :] = LandClass.TREES
    half = World("half", world.ground, world.surface, classes, 1.0)
    heights = buildings_raster(half).values
    assert heights[45, 50] == 80.0 and heights[55, 50] == 0.0


@given(st.floats(0.0, 1.0), st.integers(1, 300))
def test_the_share_is_kept_for_every_count(share: float, count: int) -> None:
    crossing = sum(must_cross(index, share) for index in range(count))
    assert abs(crossing - share * count) <= 1.0


@settings(max_examples=30)
@given(st.floats(30.0, 190.0), st.floats(5.0, 100.0))
def test_waypoints_part_any_length(length: float, spacing: float) -> None:
    options = ScenarioOptions(count=1, length=length, spacing=spacing, through_buildings=0.0)
    path = make_scenario(box_world([], size=(320, 320)), options, 0).global_path
    steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
    assert steps.sum() == pytest.approx(length)
    assert len(steps) == max(1, math.ceil(length / spacing - 1e-9))
    assert np.all(steps <= spacing * (1.0 + 1e-9)) and np.all(steps > 0.0)


def test_what_cannot_be_found_is_told_with_its_reasons() -> None:
    world = town()
    with pytest.raises(ValueError, match=r"of 50 lines .*crossed no building"):
        make_scenarios(world, ScenarioOptions(tries=50, **(SMALL | {"altitude": 200.0})))
    with pytest.raises(ValueError, match=r"started too near"):
        make_scenarios(world, ScenarioOptions(tries=50, clearance=200.0, **SMALL))
    with pytest.raises(ValueError, match=r"length = 500 m .* does not fit into town"):
        make_scenarios(world, ScenarioOptions())


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("count", 0),
        ("count", 2.5),
        ("count", True),
        ("seed", -1),
        ("seed", "one"),
        ("length", 0.0),
        ("length", math.inf),
        ("spacing", -5.0),
        ("spacing", math.nan),
        ("altitude", math.nan),
        ("reference", "sea"),
        ("margin", -1.0),
        ("clearance", math.inf),
        ("through_buildings", 1.5),
        ("through_buildings", math.nan),
        ("tries", 0),
    ],
)
def test_a_bad_option_is_named(field: str, value: object) -> None:
    with pytest.raises(ValueError, match=field):
        ScenarioOptions(**{field: value})
