# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The landing mask: the same ground is judged alike at every cell size, in every direction."""

import dataclasses
import math
from typing import Any

import numpy as np
import pytest
from numpy.typing import ArrayLike, NDArray

from ltp.world import LANDABLE_PRESETS, LandClass, LandingLimits, LandingRules, World, landable_mask
from ltp.world.flatness import flatness

CELLS = [0.1, 0.25, 0.5, 1.0, 2.0, 5.0]


def lawn(surface: ArrayLike, cell: float = 1.0, **changes: Any) -> World:
    """Grass all over, its ground the surface itself."""
    heights = np.asarray(surface, dtype=np.float64)
    arguments: dict[str, Any] = {
        "name": "lawn",
        "ground": heights,
        "surface": heights,
        "classes": np.full(heights.shape, LandClass.GRASS, np.uint8),
        "cell": cell,
    }
    return World(**{**arguments, **changes})


def middles(cell: float, size: int = 40) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """x and y of the middles of size x size cells round the origin [m]."""
    along = (np.arange(size) + 0.5 - size / 2) * cell
    return np.meshgrid(along, along, indexing="ij")


# --- slopes ---


@pytest.mark.parametrize("cell", CELLS)
@pytest.mark.parametrize("heading", [0.0, 45.0, 160.0, 270.0])
@pytest.mark.parametrize("degrees", [0.0, 5.0, 9.9, 10.0, 10.1, 14.0, 45.0, 80.0])
def test_a_slope_is_one_at_every_cell_size_and_in_every_direction(
    cell: float, heading: float, degrees: float
) -> None:
    x, y = middles(cell)
    uphill = x * np.cos(np.radians(heading)) + y * np.sin(np.radians(heading))
    mask = landable_mask(lawn(1200.0 + np.tan(np.radians(degrees)) * uphill, cell), "strict")
    assert (mask == (degrees <= 10.0)).all()  # also along the border


@pytest.mark.parametrize("cell", CELLS)
@pytest.mark.parametrize("limit", [0.0, 3.0, 20.0, 44.0, 89.0])
def test_how_steep_is_up_to_the_limit(cell: float, limit: float) -> None:
    x, _ = middles(cell, 20)
    for degrees in (limit - 0.5, limit, limit + 0.5):
        if 0.0 <= degrees < 90.0:
            world = lawn(np.tan(np.radians(degrees)) * x, cell)
            assert (landable_mask(world, max_slope=limit) == (degrees <= limit)).all()


@pytest.mark.parametrize("cell", [0.5, 1.0, 2.0, 5.0])
def test_a_round_hill_is_landed_on_where_it_is_not_steep(cell: float) -> None:
    x, y = middles(cell, 80)
    radius = 400.0  # of the hill's curvature: 10 degrees steep at 70 m from its top
    away = np.minimum(np.hypot(x, y), 300.0)
    mask = landable_mask(lawn(np.sqrt(radius**2 - away**2), cell))
    steep = np.degrees(np.arcsin(away / radius))
    sure = (abs(steep - 10.0) > 0.5) & (away < 290.0)
    inner = np.zeros_like(mask)
    inner[1:-1, 1:-1] = True
    assert mask[sure & inner].any()
    np.testing.assert_array_equal(mask[sure & inner], steep[sure & inner] < 10.0)


def test_a_ramp_is_not_landed_on_and_the_levels_beside_it_are() -> None:
    for cell in (0.25, 0.5, 1.0):
        x, _ = middles(cell, round(40 / cell))
        mask = landable_mask(lawn(np.clip(x, -5.0, 5.0) * math.tan(math.radians(20.0)), cell))
        assert not mask[abs(x) < 5.0].any()
        assert mask[abs(x) > 5.0 + max(1.0, cell) + cell].all()


# --- rough ground and steps ---


@pytest.mark.parametrize("cell", CELLS)
def test_rough_ground_is_not_landed_on_and_a_meadow_is(cell: float) -> None:
    noise = np.random.default_rng(5).uniform(-1.0, 1.0, (60, 60))
    x, _ = middles(cell, 60)
    tilted = 0.05 * x
    assert landable_mask(lawn(tilted + 0.03 * noise, cell)).all()
    assert landable_mask(lawn(tilted + 1.5 * noise, cell)).mean() < 0.01


@pytest.mark.parametrize("cell", CELLS)
def test_a_stone_keeps_the_gear_away(cell: float) -> None:
    surface = np.zeros((61, 61))
    surface[30, 30] = 0.45  # lower than what stands "above the ground"
    mask = landable_mask(lawn(surface, cell))
    away = np.hypot(*np.mgrid[-30:31, -30:31]) * cell
    under = (away <= 1.0 + 1e-9) | (np.abs(np.mgrid[-30:31, -30:31]).max(axis=0) <= 1)
    np.testing.assert_array_equal(mask, ~under)


@pytest.mark.parametrize("cell", CELLS)
@pytest.mark.parametrize("axis", [0, 1])
def test_a_wall_and_a_terrace_keep_the_gear_away_and_a_low_kerb_does_not(
    cell: float, axis: int
) -> None:
    x = middles(cell, 60)[axis]
    near = abs(x) < max(1.0, cell)  # the footprint reaches over the edge at x = 0
    for step in (1.0, 2.5, 40.0):
        mask = landable_mask(lawn(np.where(x > 0.0, step, 0.0), cell))
        assert not mask[near].any()
        assert mask[abs(x) > max(1.0, cell) + cell].all()  # a terrace is landed on, too
    assert landable_mask(lawn(np.where(x > 0.0, 0.1, 0.0), cell)).all()


@pytest.mark.parametrize("cell", CELLS)
def test_stairs_are_not_landed_on(cell: float) -> None:
    x, _ = middles(cell)
    assert not landable_mask(lawn(np.floor(x / 0.29) * 0.17, cell)).any()  # 30 degrees


def test_a_building_keeps_the_gear_away_as_far_as_it_reaches() -> None:
    for cell in (0.25, 0.5, 1.0):
        size = round(20 / cell)
        x, y = middles(cell, size)
        inside = (abs(x) < 4.0) & (abs(y) < 4.0)
        world = lawn(
            np.where(inside, 6.0, 0.0),
            cell,
            ground=np.zeros((size, size)),
            classes=np.where(inside, LandClass.BUILDING, LandClass.GRASS).astype(np.uint8),
        )
        gap = np.maximum(abs(x), abs(y)) - 4.0
        for radius in (1.0, 2.0):
            mask = landable_mask(world, gear_radius=radius)
            beside = (abs(y) < 3.0) & (gap > 0.0)
            reach = max(radius, cell)
            assert not mask[inside | (beside & (gap < reach - cell / 2))].any()
            assert mask[gap > reach + cell].all()


# --- the whole rule, against a slow one ---


def calm_world(seed: int, cell: float) -> World:
    """Grass on a gentle slope, with few ponds, trees, low humps and high ones."""
    rng = np.random.default_rng(seed)
    shape = (46, 37)
    ground = 30.0 + 0.05 * cell * np.add.outer(np.arange(shape[0]), np.arange(shape[1]))
    hump = np.where(rng.random(shape) < 0.002, rng.choice([0.1, 0.45, 0.6, 4.0], shape), 0.0)
    kinds = rng.choice([LandClass.ROAD, LandClass.WATER, LandClass.TREES], shape)
    classes = np.where(rng.random(shape) < 0.002, kinds, LandClass.GRASS)
    return lawn(ground + hump, cell, ground=ground, classes=classes, origin=(3.0, -5.0))


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("landable", ["strict", "wide", [LandClass.WATER, "Grass"]])
@pytest.mark.parametrize("clearance", [0.0, 0.5, 1.0, 2.5, 4.0])
@pytest.mark.parametrize("cell", [0.5, 1.0, 2.0])
def test_the_mask_is_allowed_low_flat_and_clear(
    seed: int, landable: Any, clearance: float, cell: float
) -> None:
    world = calm_world(seed, cell)
    nx, ny = world.shape
    allowed = {LandClass.WATER, LandClass.GRASS}
    if isinstance(landable, str):
        allowed = set(LANDABLE_PRESETS[landable])
    flat = flatness(world.surface, cell, 1.0)
    plain = np.isin(world.classes, list(allowed)) & (world.surface - world.ground <= 0.5)
    plain &= (flat.slope <= 10.0 + 1e-6) & (flat.roughness <= 0.2 + 1e-6)
    good, bad = np.argwhere(plain), np.argwhere(~plain)
    gap = np.abs(good[:, None] - bad).max(axis=2).min(axis=1) - 1.0  # between the cells' edges
    gap = np.minimum(gap, np.minimum(good, np.array([nx, ny]) - 1 - good).min(axis=1))
    expected = np.zeros_like(plain)
    expected[tuple(good.T)] = (gap * cell >= clearance) | (clearance == 0.0)
    assert 0 < expected.sum() <= plain.sum() < plain.size
    assert clearance == 0.0 or expected.sum() < plain.sum()
    np.testing.assert_array_equal(landable_mask(world, landable, clearance=clearance), expected)


@pytest.mark.parametrize("cell", [0.5, 1.0, 2.0])
@pytest.mark.parametrize("clearance", [0.0, 0.3, 0.5, 1.0, 1.5, 2.0, 2.1, 4.0])
def test_the_clearance_is_as_wide_as_asked_for(cell: float, clearance: float) -> None:
    classes = np.full((41, 41), LandClass.GRASS)
    classes[20, 20] = LandClass.WATER
    mask = landable_mask(lawn(np.zeros((41, 41)), cell, classes=classes), clearance=clearance)
    assert not mask[20, 20]
    first = int(np.argmax(mask[21:, 20]))  # cells left free beside the pond
    assert first * cell >= clearance > (first - 1) * cell or first == clearance == 0.0
    border = int(np.argmax(mask[:, 5 + 5]))
    assert border == first
    assert mask.any()


def test_trees_are_never_landed_on() -> None:
    classes = np.full((6, 6), LandClass.GRASS)
    classes[2, 3] = LandClass.TREES  # a canopy in the classes that the surface does not show
    world = lawn(np.zeros((6, 6)), classes=classes)
    assert not landable_mask(world, "wide")[2, 3]
    for kinds in (LandClass, ["grass", "Trees"], [11]):
        with pytest.raises(ValueError, match="landable must not contain TREES"):
            landable_mask(world, kinds)


def test_water_and_roofs_are_landed_on_only_if_asked_for() -> None:
    classes = np.full((4, 4), LandClass.WATER)
    classes[2:] = LandClass.BUILDING  # level with the ground: the class alone forbids it
    world = lawn(np.zeros((4, 4)), classes=classes)
    assert not landable_mask(world, "wide").any()
    for kinds in ([LandClass.WATER], ["water"], ("WATER",), [9]):
        mask = landable_mask(world, kinds)
        assert mask[:2].all() and not mask[2:].any()


def test_the_presets_nest() -> None:
    assert LANDABLE_PRESETS["strict"] < LANDABLE_PRESETS["wide"]
    forbidden = {LandClass.WATER, LandClass.BUILDING, LandClass.TREES, LandClass.RAIL}
    assert not LANDABLE_PRESETS["wide"] & forbidden
    assert LandClass.UNKNOWN not in LANDABLE_PRESETS["wide"]


@pytest.mark.parametrize(
    ("rules", "message"),
    [
        ({"landable": "anything"}, "landable must be one of strict, wide .*not 'anything'"),
        ({"landable": [99]}, "landable must be land classes: 99"),
        (
            {"landable": ["grass", "gras"]},
            "landable must be land classes: 'gras' is none of .*path",
        ),
        ({"landable": [True]}, "landable must be land classes: True"),
        ({"landable": [None]}, "landable must be land classes: None"),
        ({"landable": 3}, "landable must be land classes"),
        ({"max_height_above_ground": -0.1}, "max_height_above_ground must not be negative"),
        ({"max_roughness": math.nan}, "max_roughness must be a finite number"),
        ({"max_roughness": -0.1}, "max_roughness must not be negative"),
        ({"max_slope": -1.0}, r"max_slope must lie in \[0, 90\) degrees, not -1"),
        ({"max_slope": 90.0}, "max_slope must lie in"),
        ({"max_slope": math.nan}, "max_slope must be a finite number"),
        ({"max_slope": "steep"}, "max_slope must be a finite number, not 'steep'"),
        ({"gear_radius": 0.0}, "gear_radius must be above zero"),
        ({"gear_radius": math.inf}, "gear_radius must be a finite number"),
        ({"gear_radius": 300.0}, "gear_radius must be at most 256 cells"),
        ({"clearance": -1.0}, "clearance must not be negative"),
    ],
)
def test_a_bad_rule_is_named(rules: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        landable_mask(lawn(np.zeros((3, 4))), **rules)
    limits = {name: value for name, value in rules.items() if name != "landable"}
    if limits and rules != {"gear_radius": 300.0}:
        with pytest.raises(ValueError, match=message):
            LandingLimits(**limits)


def test_the_limits_are_the_rules() -> None:
    world = calm_world(0, 1.0)
    limits = LandingLimits(max_slope=3.0, clearance=1.0)
    expected = landable_mask(world, max_slope=3.0, clearance=1.0)
    np.testing.assert_array_equal(landable_mask(world, **limits.rules()), expected)
    assert not landable_mask(world, **limits.rules(["water"])).any()
    assert landable_mask(world).sum() > 0 == expected.sum()
    names = {item.name for item in dataclasses.fields(LandingLimits)}
    assert limits.rules().keys() == {"landable", *names} == LandingRules.__annotations__.keys()
    assert str(LandingLimits()) == (
        "at most 10 degrees steep and 0.2 m rough within 1 m, 0.5 m above the bare ground"
    )


def test_what_is_kept_of_a_world_is_its_own() -> None:
    heights = np.tan(np.radians(7.0)) * middles(1.0)[0]
    for degrees, surface in ((7.0, heights), (0.0, np.zeros((40, 40))), (7.0, heights)):
        world = lawn(surface)
        for limit in (5.0, 10.0, 5.0):
            assert (landable_mask(world, max_slope=limit) == (degrees <= limit)).all()
            landable_mask(world, max_slope=limit)[:] = False  # nobody else's
        rough = landable_mask(world, max_slope=10.0, max_roughness=0.0)
        assert rough.all()
