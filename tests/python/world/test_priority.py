# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The priority maps agree with slow, obvious versions of themselves."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
from numpy.typing import NDArray

import ltp
from ltp.world import (
    LandClass,
    World,
    binary_priority,
    footprint,
    landable_mask,
    lowpass_priority,
    priority_map,
)
from ltp.world.box_mean import box_mean
from ltp.world.priority import binary_values, ground_values, seen_priority

LANDABLE = sorted(set(LandClass) - {LandClass.TREES})


def flat_world(classes: NDArray[Any], cell: float = 1.0, **changes: Any) -> World:
    ground = np.zeros(classes.shape)
    arguments: dict[str, Any] = {"name": "flat", "ground": ground, "surface": ground}
    return World(**{**arguments, "classes": classes, "cell": cell, **changes})


def rough_world(seed: int, shape: tuple[int, int] = (14, 11), cell: float = 1.0) -> World:
    """Grass on a slope, with ponds, humps just under and over the limits, and trees."""
    rng = np.random.default_rng(seed)
    ground = 30.0 + 0.1 * np.add.outer(np.arange(shape[0]), np.arange(shape[1]))
    hump = rng.choice([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3, 0.49, 0.51, 4.0], shape)
    kinds = [LandClass.GRASS] * 12 + [LandClass.ROAD, LandClass.WATER, LandClass.TREES]
    return World("rough", ground, ground + hump, rng.choice(kinds, shape), cell, origin=(3.0, -5.0))


# --- the binary map ---


@pytest.mark.parametrize(
    ("fine", "coarse", "origin"),
    [
        (1.0, 2.0, (0.0, 0.0)),
        (1.0, 2.0, (3.0, -5.0)),  # a coarse cell sticks out on each side
        (0.5, 2.0, (0.25, 7.0)),
        (1.0, 1.0, (0.0, 0.0)),
        (3.0, 2.0, (1.0, 1.0)),  # coarse cells smaller than fine ones
        (0.7, 2.0, (-2.1, 0.3)),  # a ratio that does not divide
    ],
)
def test_a_coarse_cell_needs_all_its_fine_cells(
    fine: float, coarse: float, origin: tuple[float, float]
) -> None:
    rng = np.random.default_rng(11)
    kinds = [LandClass.GRASS] * 30 + [LandClass.WATER]
    world = flat_world(rng.choice(kinds, (17, 12)), fine, origin=origin)
    mask = landable_mask(world)
    values, (x, y) = binary_values(world, coarse)
    assert x / coarse == round(x / coarse)
    assert y / coarse == round(y / coarse)
    x_min, y_min, x_max, y_max = world.extent
    for a in range(values.shape[0]):
        for b in range(values.shape[1]):
            west, south = x + a * coarse, y + b * coarse
            inside = west > x_min - 1e-6 and west + coarse < x_max + 1e-6
            inside &= south > y_min - 1e-6 and south + coarse < y_max + 1e-6
            good = inside
            for i in range(mask.shape[0]):
                for j in range(mask.shape[1]):
                    u, v = x_min + i * fine, y_min + j * fine
                    shared_x = min(u + fine, west + coarse) - max(u, west)
                    shared_y = min(v + fine, south + coarse) - max(v, south)
                    if min(shared_x, shared_y) > 1e-6:
                        good &= bool(mask[i, j])
            assert values[a, b] == float(good)
    assert 0.0 < values.mean() < 1.0
    assert x <= x_min < x + coarse
    assert x + (values.shape[0] - 1) * coarse < x_max <= x + values.shape[0] * coarse + 1e-9


def test_the_raster_has_the_frame_of_the_values() -> None:
    world = rough_world(1)
    values, origin = binary_values(world, 2.0, landable="strict")
    raster = binary_priority(world, 2.0, landable="strict")
    assert isinstance(raster, ltp.Raster)
    np.testing.assert_array_equal(raster.values, values)
    assert tuple(raster.origin) == origin == (2.0, -6.0)
    assert raster.cell == 2.0


@pytest.mark.parametrize("cell", [0.0, -2.0, math.nan, math.inf, 1e-6])
def test_a_bad_cell_is_named(cell: float) -> None:
    with pytest.raises(ValueError, match="cell must"):
        binary_priority(rough_world(0), cell)


# --- the box mean ---


def slow_box_mean(field: NDArray[np.float64], sides: NDArray[np.float64]) -> NDArray[np.float64]:
    nx, ny = field.shape
    mean = np.empty_like(field)
    for i in range(nx):
        for j in range(ny):
            half = max(sides[i, j], 1e-3) / 2
            weights = np.zeros_like(field)
            for a in range(nx):
                for b in range(ny):
                    dx = min(a + 1, i + 0.5 + half) - max(a, i + 0.5 - half)
                    dy = min(b + 1, j + 0.5 + half) - max(b, j + 0.5 - half)
                    weights[a, b] = max(dx, 0.0) * max(dy, 0.0)
            mean[i, j] = (weights * field).sum() / weights.sum()
    return mean


@pytest.mark.parametrize("side", [0.0, 0.4, 1.0, 1.2, 1.7, 2.0, 3.0, 5.25, 9.0, 11.3, 40.0])
def test_the_box_mean_is_the_area_weighted_mean(side: float) -> None:
    field = np.random.default_rng(2).uniform(-3.0, 8.0, (9, 7))
    expected = slow_box_mean(field, np.full(field.shape, side))
    np.testing.assert_allclose(box_mean(field, side), expected, atol=1e-12)


@given(data=st.data())
@settings(max_examples=30, deadline=None)
def test_the_box_mean_with_a_side_per_cell(data: st.DataObject) -> None:
    shape = data.draw(hnp.array_shapes(min_dims=2, max_dims=2, max_side=7))
    field = data.draw(hnp.arrays(np.float64, shape, elements=st.floats(0.0, 1.0)))
    sides = data.draw(hnp.arrays(np.float64, shape, elements=st.floats(0.0, 20.0)))
    mean = box_mean(field, sides)
    np.testing.assert_allclose(mean, slow_box_mean(field, sides), atol=1e-9)
    assert field.min() <= mean.min()
    assert mean.max() <= field.max()


def test_the_box_mean_stays_exact_on_a_large_map() -> None:
    field = (np.random.default_rng(4).random((1200, 1000)) < 0.5).astype(float)
    mean = box_mean(field, 25.0)
    for i, j in ((0, 0), (3, 999), (600, 500), (1199, 7)):
        window = field[max(0, i - 12) : i + 13, max(0, j - 12) : j + 13]
        assert mean[i, j] == pytest.approx(window.mean(), abs=1e-9)


@pytest.mark.parametrize(
    ("values", "side", "message"),
    [
        (np.zeros(3), 1.0, "values must be finite, of shape"),
        (np.zeros((0, 3)), 1.0, "values must be finite, of shape"),
        (np.full((2, 2), np.nan), 1.0, "values must be finite"),
        (np.zeros((2, 2)), -1.0, "side must be finite and not negative"),
        (np.zeros((2, 2)), np.nan, "side must be finite"),
        (np.zeros((2, 2)), np.ones((2, 3)), r"side must be a number or of shape \(2, 2\)"),
    ],
)
def test_a_bad_box_is_named(values: Any, side: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        box_mean(values, side)


# --- the low-pass map ---


def test_the_footprint_of_the_paper() -> None:
    assert footprint(50.0) == pytest.approx(50.0, abs=0.2)  # "approximately 50 m x 50 m"
    assert footprint(10.0, 90.0) == pytest.approx(20.0)
    np.testing.assert_allclose(footprint([0.0, 25.0, 50.0]), footprint(50.0) * [0.0, 0.5, 1.0])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((-1.0,), "height above ground must be finite and not negative"),
        ((math.nan,), "height above ground must be finite"),
        ((50.0, 0.0), r"fov_deg must lie in \(0, 180\)"),
        ((50.0, 180.0), "fov_deg must lie in"),
        ((50.0, math.nan), "fov_deg must be a finite number"),
    ],
)
def test_a_bad_footprint_is_named(arguments: tuple[float, ...], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        footprint(*arguments)


@pytest.mark.parametrize("height", [3.0, 7.5])
def test_lowpass_is_the_mean_of_the_binary_map_under_the_camera(height: float) -> None:
    world = rough_world(7, (40, 30))
    binary = binary_priority(world)
    side = 2.0 * height * math.tan(math.radians(26.5)) / 2.0  # cells of 2 m
    expected = slow_box_mean(binary.values, np.full(binary.shape, side))
    raster = lowpass_priority(world, height)
    np.testing.assert_allclose(raster.values, expected, atol=1e-12)
    assert tuple(raster.origin) == tuple(binary.origin)
    assert raster.cell == 2.0


def test_height_may_differ_from_cell_to_cell() -> None:
    world = rough_world(7, (40, 30))
    shape = binary_priority(world).shape
    heights = np.where(np.arange(shape[0])[:, None] < 9, 4.0, 11.0) * np.ones(shape)
    mixed = lowpass_priority(world, heights).values
    np.testing.assert_array_equal(mixed[:9], lowpass_priority(world, 4.0).values[:9])
    np.testing.assert_array_equal(mixed[9:], lowpass_priority(world, 11.0).values[9:])
    with pytest.raises(ValueError, match="altitude_above_ground must be a number or of shape"):
        lowpass_priority(world, heights[1:])


def test_altitude_above_the_datum_narrows_the_view_over_high_ground() -> None:
    ground = np.repeat(np.linspace(0.0, 60.0, 40)[:, None], 30, axis=1)
    classes = np.random.default_rng(5).choice([LandClass.GRASS, LandClass.WATER], (40, 30))
    world = World("ramp", ground, ground, classes, 1.0)
    rules: dict[str, Any] = {"max_slope": 60.0}
    over_datum = priority_map(world, "lpf", altitude=50.0, above="datum", **rules)
    heights = np.maximum(0.0, 50.0 - ground_values(world))
    expected = lowpass_priority(world, heights, **rules).values
    np.testing.assert_array_equal(over_datum.values, expected)
    binary = binary_priority(world, **rules).values
    buried = heights[:, 0] == 0.0
    assert buried.any()
    np.testing.assert_array_equal(over_datum.values[buried], binary[buried])
    over_ground = priority_map(world, "lpf", altitude=50.0, **rules)
    np.testing.assert_array_equal(over_ground.values, lowpass_priority(world, 50.0, **rules).values)


def test_ground_values_are_those_under_the_middle_of_a_cell() -> None:
    world = rough_world(2)
    values = ground_values(world, 2.0)  # cells from x = 2, y = -6; world from x = 3, y = -5
    assert values.shape == binary_priority(world).shape
    assert values[1, 1] == world.ground[2, 2]  # the middle (5, -3)
    assert values[0, 0] == world.ground[0, 0]


def test_the_two_kinds_of_map() -> None:
    world = rough_world(3)
    np.testing.assert_array_equal(
        priority_map(world, "binary", altitude=9.0).values, binary_priority(world).values
    )
    for changes, message in (
        ({"kind": "low"}, "kind must be"),
        ({"above": "sea"}, "above must be"),
        ({"kind": "lpf", "altitude": 0.0}, "altitude must be above zero"),
        ({"kind": "lpf", "altitude": math.nan, "above": "datum"}, "altitude must be a finite"),
    ):
        with pytest.raises(ValueError, match=message):
            priority_map(world, **changes)


def test_a_map_of_ones_own_is_taken_as_it_is_or_as_the_camera_sees_it() -> None:
    values = np.random.default_rng(8).uniform(0.0, 1.0, (17, 12))
    own = ltp.Raster(values, origin=(3.0, -5.0), cell=1.5, outside=0.25)
    assert seen_priority(own) is own
    seen = seen_priority(own, "lpf", 6.0, 90.0)  # sees 12 m x 12 m
    np.testing.assert_allclose(seen.values, slow_box_mean(values, np.full((17, 12), 8.0)))
    assert (tuple(seen.origin), seen.cell, seen.outside) == ((3.0, -5.0), 1.5, 0.25)
    for bad in (1.01, -0.01, 255.0):
        values[3, 4] = bad
        with pytest.raises(ValueError, match=r"priority must hold shares .* \[3, 4\] is"):
            seen_priority(ltp.Raster(values))


@given(
    classes=hnp.arrays(np.uint8, (12, 10), elements=st.sampled_from(LANDABLE)),
    small=st.sets(st.sampled_from(LANDABLE)),
    more=st.sets(st.sampled_from(LANDABLE)),
    height=st.floats(0.1, 30.0),
)
@settings(max_examples=60, deadline=None)
def test_more_landable_classes_never_lower_a_priority(
    classes: NDArray[np.uint8], small: set[LandClass], more: set[LandClass], height: float
) -> None:
    world = flat_world(classes)
    for kind in ("binary", "lpf"):
        low = priority_map(world, kind, altitude=height, landable=small).values
        high = priority_map(world, kind, altitude=height, landable=small | more).values
        assert low.min() >= 0.0
        assert high.max() <= 1.0
        assert (high >= low - 1e-12).all()


def test_a_map_of_one_class_has_one_priority() -> None:
    for land, priority in ((LandClass.GRASS, 1.0), (LandClass.WATER, 0.0)):
        world = flat_world(np.full((20, 16), land))
        for kind in ("binary", "lpf"):
            np.testing.assert_array_equal(priority_map(world, kind).values, priority)
