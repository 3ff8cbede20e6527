# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What stands on the ground of an OpenStreetMap world: trees, buildings, and all that is tall."""

from dataclasses import dataclass
from typing import Any

from ltp.world.classes import LandClass

from ..optional import require
from . import tags
from .buildings import Block, Origin, blocks, told_or_guessed
from .canvas import Canvas
from .cover import area_cover
from .shapes import Shape, Shapes
from .standing import Standing, tall

_BUILDING_NODE = 10.0  # width of a building that is mapped as a point, *assumed* [m]
_WIDEST_LINE = 10.0  # of a tall thing that is mapped as a line, *assumed* [m]
_ROOFS = frozenset({"roof", "rooftop"})


@dataclass(frozen=True)
class Solids:
    """What was raised within the bounds."""

    buildings: list[Block]
    standing: list[Block]
    trees: list[Block]


def raise_solids(canvas: Canvas, shapes: Shapes, default_height: float) -> Solids:
    """Put up trees first, then buildings, then tall things in every cell that they touch."""
    trees = _trees(shapes)
    canvas.raise_to([(b.area, b.height) for b in trees], LandClass.TREES)
    houses = blocks(shapes.areas, default_height)
    canvas.raise_to([(b.area, b.height) for b in houses], LandClass.BUILDING)
    nodes = _building_nodes(shapes, default_height)
    standing = _standing(canvas, shapes)
    thin = [(block.area, block.height) for block in (*nodes, *standing)]
    canvas.raise_to(thin, LandClass.BUILDING, thin=True)
    return Solids(
        *(
            [b for b in kind if b.area.intersects(canvas.box)]
            for kind in (houses + nodes, standing, trees)
        )
    )


def _trees(shapes: Shapes) -> list[Block]:
    found = [
        Block(shape.geometry, tags.wood_height(shape.tags), _origin(tags.plant_height(shape.tags)))
        for shape in shapes.areas
        if area_cover(shape.tags) == LandClass.TREES
    ]
    for shape in (*shapes.points, *shapes.lines):
        if (size := tags.tree(shape.tags)) is not None:
            crown = shape.geometry.buffer(size[1] / 2)
            found.append(Block(crown, size[0], _origin(tags.plant_height(shape.tags))))
    return found


def _origin(told: float | None) -> Origin:
    return Origin.GUESS if told is None else Origin.TAG


def _building_nodes(shapes: Shapes, default_height: float) -> list[Block]:
    """Buildings mapped as points; without a height, only where no outline holds them."""
    shapely = require("shapely", "reading OpenStreetMap files")
    points = [shape for shape in shapes.points if tags.stands_over(shape.tags)]
    if not points:
        return []
    outlines = shapely.STRtree([s.geometry for s in shapes.areas if tags.stands_over(s.tags)])
    found = []
    for shape in points:
        height, origin = told_or_guessed(shape.tags, default_height)
        size = tall(shape.tags)
        if origin == Origin.GUESS and len(outlines.query(shape.geometry, "intersects")):
            continue
        width = max(_BUILDING_NODE, size.width if size else 0.0)
        found.append(Block(shape.geometry.buffer(width / 2), height, origin))
    return found


def _standing(canvas: Canvas, shapes: Shapes) -> list[Block]:
    found = []
    for shape in (*shapes.points, *shapes.areas, *shapes.lines):
        size = None if tags.stands_over(shape.tags) else tall(shape.tags)
        if size is not None:
            origin = Origin.TAG if size.told else Origin.GUESS
            base = _roof(canvas, shape)
            found.append(Block(_extent(shape, size), base + size.height, origin))
    return found


def _extent(shape: Shape, size: Standing) -> Any:
    """A point as a disc, a line as a wall, an area as it is."""
    if shape.geometry.geom_type == "Point":
        return shape.geometry.buffer(size.width / 2)
    if shape.geometry.geom_type == "LineString":
        return shape.geometry.buffer(min(size.width, _WIDEST_LINE) / 2)
    return shape.geometry


def _roof(canvas: Canvas, shape: Shape) -> float:
    """The roof that it stands on, if it says so [m]."""
    if shape.tags.get("location") not in _ROOFS:
        return 0.0
    centre = shape.geometry.representative_point()
    i = int((centre.x - canvas.bounds[0]) // canvas.cell)
    j = int((centre.y - canvas.bounds[1]) // canvas.cell)
    inside = 0 <= i < canvas.shape[0] and 0 <= j < canvas.shape[1]
    return float(canvas.surface[i, j]) if inside else 0.0
