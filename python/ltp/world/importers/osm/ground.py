# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What lies on the ground of an OpenStreetMap world: land, water over it, lines on top."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass

from ..optional import require
from .canvas import Canvas
from .coast import sea
from .cover import area_cover, concourse, deck, island, line_cover, marsh
from .shapes import Shape, Shapes

# Lines lie on top of areas, in this order: a crossing belongs to the road.
_LINE_ORDER = (
    LandClass.WATER,
    LandClass.RAIL,
    LandClass.PATH,
    LandClass.UNKNOWN,
    LandClass.ROAD,
)
_BANKS = (LandClass.ROAD, LandClass.PATH)  # what may overhang open water only as a bridge


def paint_ground(canvas: Canvas, shapes: Shapes) -> None:
    """Paint classes: of areas the smallest on top, water over all of them, then lines.

    Land in the water is what the water leaves out, what is tagged as an island, and what stands in
    it (piers) or leads over it (bridges). Roads and paths that do neither end at open water: their
    width is a guess.
    """
    kinds = [(s, area_cover(s.tags)) for s in shapes.areas]
    land = [(s, k) for s, k in kinds if k not in (None, LandClass.TREES, LandClass.WATER)]
    for shape, _ in land:
        if concourse(shape.tags) and shape.geometry.intersects(canvas.box):
            shapes.note("a pedestrian area on a layer below the ground: not painted", shape.key)
    land = [(shape, kind) for shape, kind in land if not concourse(shape.tags)]
    land.sort(key=lambda item: _by_size(item[0]))
    canvas.paint([(shape.geometry, kind) for shape, kind in land if kind is not None])

    coast = [s.geometry for s in shapes.lines if s.tags.get("natural") == "coastline"]
    flood = sea(coast, canvas.box)
    if coast and not flood and any(line.intersects(canvas.box) for line in coast):
        shapes.note("a coast line that ends within the bounds: no sea read", "the coast")
    wet = [s for s, kind in kinds if kind == LandClass.WATER]
    at_sea = _sea(canvas, flood, coast, shapes.areas)
    canvas.classes[at_sea | _lakes(canvas, wet, shapes.areas)] = LandClass.WATER
    open_water = at_sea | _lakes(canvas, [s for s in wet if not marsh(s.tags)], shapes.areas)

    lines = _strips(shapes.lines)
    for wanted in _LINE_ORDER:
        canvas.paint([(strip, kind) for strip, kind, _ in lines if kind == wanted])
    canvas.classes[open_water & np.isin(canvas.classes, _BANKS)] = LandClass.WATER
    for wanted in _BANKS[::-1]:
        bridges = [(strip, kind) for strip, kind, over in lines if kind == wanted and over]
        canvas.paint(bridges, where=open_water)


def _sea(
    canvas: Canvas, flood: list[Any], coast: list[Any], areas: list[Shape]
) -> NDArray[np.bool_]:
    """The cells of the sea: decks are dry, and islands that have no coast line to decide it."""
    shapely = require("shapely", "reading OpenStreetMap files")
    shore = shapely.union_all(coast)
    dry = [s for s in areas if deck(s.tags) or (island(s.tags) and s.geometry.disjoint(shore))]
    return canvas.mask([*((area, True) for area in flood), *((s.geometry, False) for s in dry)])


def _lakes(canvas: Canvas, wet: list[Shape], areas: list[Shape]) -> NDArray[np.bool_]:
    """The cells of other water: of lakes and islands the smallest decides, and decks are dry."""
    nested = [(s, True) for s in wet]
    nested += [(s, False) for s in areas if island(s.tags)]
    nested.sort(key=lambda item: _by_size(item[0]))
    decks = [(s.geometry, False) for s in areas if deck(s.tags)]
    return canvas.mask([*((s.geometry, flag) for s, flag in nested), *decks])


def _by_size(shape: Shape) -> tuple[float, str]:
    return -shape.geometry.area, shape.key


def _strips(lines: list[Shape]) -> list[tuple[Any, LandClass, bool]]:
    """Lines as wide as they are, and whether they lead over water."""
    shapely = require("shapely", "reading OpenStreetMap files")
    found = [(s, cover) for s in lines if (cover := line_cover(s.tags)) is not None]
    if not found:
        return []
    half_widths = [cover[1] / 2 for _, cover in found]
    strips = shapely.buffer([s.geometry for s, _ in found], half_widths, quad_segs=4)
    return [
        (strip, cover[0], deck(s.tags)) for strip, (s, cover) in zip(strips, found, strict=True)
    ]
