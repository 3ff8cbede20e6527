# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Worlds by hand: boxes, cylinders and prisms fill the cells that they reach into."""

import math
from typing import Any

import numpy as np
import pytest

import ltp
from ltp.world import Box, Cylinder, LandClass, Prism, World, boxes

SQUARE = Prism([(10.0, 10.0), (20.0, 10.0), (20.0, 20.0), (10.0, 20.0)], 5.0)
TRIANGLE = Prism([(3.3, 4.1), (21.7, 8.2), (9.9, 17.5)], 12.0)
HOOK = Prism([(2, 2), (18, 2), (18, 18), (14, 18), (14, 6), (6, 6), (6, 12), (2, 12)], 7.0)


def holds(shape: Any, x: Any, y: Any) -> Any:
    """Plain and obvious: which of the points the shape covers."""
    if isinstance(shape, Box):
        return (shape.x_min < x) & (x < shape.x_max) & (shape.y_min < y) & (y < shape.y_max)
    if isinstance(shape, Cylinder):
        return np.hypot(x - shape.x, y - shape.y) < shape.radius
    inside, corners = np.zeros(np.broadcast(x, y).shape, bool), shape.corners
    for (ax, ay), (bx, by) in zip(corners, (*corners[1:], corners[0]), strict=True):
        if ay != by:
            inside ^= ((ay > y) != (by > y)) & (x < ax + (y - ay) / (by - ay) * (bx - ax))
    return inside


@pytest.mark.parametrize(
    "shape",
    [
        Box(3.2, 4.0, 17.9, 9.5, 8.0),
        Box(8.1, 8.1, 8.3, 8.2, 8.0),  # smaller than a cell
        Cylinder(12.3, 9.8, 4.4, 30.0),
        Cylinder(8.2, 8.3, 0.1, 30.0),
        SQUARE,
        TRIANGLE,
        Prism(TRIANGLE.corners[::-1], 12.0),  # the other way round
        HOOK,
    ],
)
@pytest.mark.parametrize("cell", [0.5, 2.0])
@pytest.mark.parametrize("origin", [(0.0, 0.0), (-3.5, 1.0)])
def test_a_cell_that_a_shape_reaches_into_is_as_high(
    shape: Any, cell: float, origin: tuple[float, float]
) -> None:
    x, y = origin
    world = World.from_shapes([shape], extent=(x, y, x + 26, y + 24), cell=cell, ground=40.0)
    assert world.shape == (round(26 / cell), round(24 / cell)) and world.origin == origin
    assert (world.ground == 40.0).all()
    filled = world.height_above_ground > 0.0
    assert (world.height_above_ground[filled] == shape.height).all()
    assert (world.classes == np.where(filled, LandClass.BUILDING, LandClass.GRASS)).all()
    n = 20  # samples along the edge of a cell
    u, v = (
        low + (np.arange(n * k) + 0.5) / n * cell
        for low, k in zip(origin, world.shape, strict=True)
    )
    inside = holds(shape, u[:, None], v[None, :])
    sampled = inside.reshape(world.shape[0], n, world.shape[1], n).any(axis=(1, 3))
    if sampled.any():
        assert (filled >= sampled).all()  # never a cell too few
        assert filled.sum() <= sampled.sum() + 12  # and none too many, but for slivers
    else:
        assert filled.sum() == 1


def test_edges_on_the_lattice_fill_no_cell_beyond() -> None:
    for shape in (SQUARE, Box(10, 10, 20, 20, 5.0)):
        filled = World.from_shapes([shape], size=(30, 30), cell=1.0).height_above_ground > 0
        expected = np.zeros((30, 30), bool)
        expected[10:20, 10:20] = True
        np.testing.assert_array_equal(filled, expected)


def test_the_highest_of_several_shapes_counts_and_gives_the_class() -> None:
    low = Box(2, 2, 9, 9, 3.0)
    tree = Cylinder(5.5, 5.5, 1.5, 8.0, kind="trees")
    for order in ([low, tree], [tree, low]):
        world = World.from_shapes(order, size=(12, 12), land="bare")
        assert world.surface[5, 5] == 8.0 and world.classes[5, 5] == LandClass.TREES
        assert world.surface[2, 2] == 3.0 and world.classes[2, 2] == LandClass.BUILDING
        assert world.surface[0, 0] == 0.0 and world.classes[0, 0] == LandClass.BARE


def test_the_world_is_as_large_as_asked_for_or_as_the_shapes_need() -> None:
    box = Box(10, 20, 30, 45, 9.0)
    assert World.from_shapes([box], size=(50, 60)).extent == (0, 0, 50, 60)
    assert World.from_shapes([box], extent=(-5, 5, 50, 60)).extent == (-5, 5, 50, 60)
    assert World.from_shapes([box], margin=10).extent == (0, 10, 40, 55)
    assert World.from_shapes([box], margin=10, cell=4.0).extent == (0, 8, 40, 56)
    assert World.from_shapes([box], size=(50.5, 60), cell=1.0).extent == (0, 0, 51, 60)
    assert World.from_shapes([], size=(50, 60)).surface.max() == 0.0
    cropped = World.from_shapes([box], size=(15, 60))
    assert (cropped.height_above_ground[10:, 20:45] == 9.0).all()


def test_boxes_are_short_for_it() -> None:
    one = boxes([(6, 5, 9, 8, 40), Cylinder(20, 10, 3, 25)], size=(26, 22), cell=0.5)
    other = World.from_shapes(
        [Box(6, 5, 9, 8, 40), Cylinder(20, 10, 3, 25)], size=(26, 22), cell=0.5
    )
    assert one.name == "boxes" and boxes([], size=(9, 9), name="lawn").name == "lawn"
    np.testing.assert_array_equal(one.surface, other.surface)


def test_it_is_flown_over() -> None:
    world = boxes([(60, 40, 75, 80, 60), (90, 55, 100, 95, 60)], size=(160, 120))
    config = ltp.MissionConfig()
    config.mapping.dims = [80, 80, 20]
    record = ltp.fly(world, config, [(20, 60, 30), (140, 60, 30)])
    assert record.complete and record.outcome == "reached"
    assert record.min_clearance > 1.0 and record.length_ratio > 1.0


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: Box(0, 0, 0, 5, 3), r"Box.x_max must be above x_min = 0.0 \[m\], not 0.0"),
        (lambda: Box(0, 6, 1, 5, 3), "Box.y_max must be above y_min"),
        (lambda: Box(0, 0, 1, 5, 0), "Box.height must be above zero, not 0"),
        (lambda: Box(0, 0, 1, 5, math.inf), "Box.height must be a finite number"),
        (lambda: Box(0, math.nan, 1, 5, 2), "Box.y_min must be a finite number"),
        (lambda: Box(0, "1", 1, 5, 2), "Box.y_min must be a finite number, not '1'"),
        (lambda: Box(0, 0, 1, 1, 1, kind="castle"), "Box.kind: class must be one of unknown"),
        (lambda: Cylinder(0, 0, -1, 3), "Cylinder.radius must be above zero"),
        (lambda: Cylinder(0, 0, 1, -3), "Cylinder.height must be above zero"),
        (
            lambda: Prism([(0, 0), (1, 1)], 3),
            r"Prism.corners must be three points \(x, y\) or more",
        ),
        (lambda: Prism([(0, 0), (1, 1), (2, 2)], 3), "Prism.corners must enclose an area"),
        (lambda: Prism([(0, 0, 0), (1, 1, 0), (2, 0, 0)], 3), "Prism.corners must be points"),
        (lambda: Prism(7, 3), "Prism.corners must be points"),
        (lambda: Prism([(0, 0), (1, 1), (math.nan, 2)], 3), "Prism.corners must be three points"),
        (lambda: boxes([(0, 0, 1, 1)], size=(9, 9)), r"shapes\[0\] must be \(x_min, y_min"),
        (lambda: boxes([(0, 0, 1, 1, -2)], size=(9, 9)), r"shapes\[0\]: Box.height must be above"),
        (lambda: boxes([3], size=(9, 9)), r"shapes\[0\] must be a Box, Cylinder or Prism, not 3"),
        (lambda: boxes(["box"]), r"shapes\[0\] must be a Box, Cylinder or Prism, not 'box'"),
        (lambda: boxes([]), "shapes must not be empty where no size or extent is given"),
        (
            lambda: boxes([(20, 20, 30, 30, 5)], size=(9, 9)),
            r"shapes\[0\] = Box.*lies off the world",
        ),
        (lambda: boxes([], size=(9, 0)), r"size\[1\] must be above zero"),
        (lambda: boxes([], size=9), "size must be two lengths"),
        (lambda: boxes([], size=(9, 9), extent=(0, 0, 1, 1)), "size and extent must not both"),
        (lambda: boxes([], extent=(0, 0, -1, 1)), "extent must be"),
        (lambda: boxes([], extent=(0, 0, 1)), "extent must be"),
        (lambda: boxes([], size=(9, 9), cell=0), "cell must be above zero"),
        (lambda: boxes([], size=(1e6, 1e6)), "extent must hold at most 100,000,000 cells"),
        (lambda: boxes([(0, 0, 1, 1, 1)], margin=-1), "margin must not be negative"),
        (lambda: boxes([], size=(9, 9), ground=math.nan), "ground must be a finite number"),
        (lambda: boxes([], size=(9, 9), land="lava"), "class must be one of"),
    ],
)
def test_what_is_wrong_is_named(make: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        make()
