# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Solid blocks out of OpenStreetMap buildings: parts before outlines."""

import enum
from typing import Any, NamedTuple

from ..optional import require
from . import tags
from .shapes import Shape


class Origin(enum.Enum):
    """Where a height comes from."""

    TAG = "a height tag"
    LEVELS = "the number of storeys"
    PARTS = "other parts of the same building"
    GUESS = "a guess"


class Block(NamedTuple):
    """A solid that stands on the ground."""

    area: Any  # shapely, in the CRS of the world [m]
    height: float  # of its top above the ground [m]
    origin: Origin


_RESTATES = 0.5  # an outline this close to its tallest part repeats the height of the tower [m]


def blocks(areas: list[Shape], default_height: float) -> list[Block]:
    """The buildings among `areas` as solid blocks that stand on the ground.

    Where parts cover an outline, they count. What they leave of it gets the outline's own height,
    but if that only restates the tallest part (the tower's height, tagged on the whole block) or is
    missing, the height of the lowest part. An outline that is higher than all its parts keeps its
    height where no part is: something there must be so high. A part without a height takes the
    outline's.
    """
    outlines = [shape for shape in areas if tags.building(shape.tags)]
    parts = [shape for shape in areas if tags.part(shape.tags) and not tags.building(shape.tags)]
    owner = _owners(outlines, parts)
    found: list[Block] = []
    heights_in: dict[int, list[Block]] = {}
    for index, part in enumerate(parts):
        outline = outlines[owner[index]] if index in owner else None
        height, origin = told_or_guessed(part.tags, default_height)
        if origin == Origin.GUESS and outline is not None:
            height, origin = told_or_guessed(outline.tags, default_height)
            height = max(height, tags.floor_height(part.tags))
            origin = Origin.PARTS if origin != Origin.GUESS else origin
        found.append(Block(part.geometry, height, origin))
        if outline is not None:
            heights_in.setdefault(owner[index], []).append(found[-1])
    for index, outline in enumerate(outlines):
        inside = heights_in.get(index, [])
        height, origin = told_or_guessed(outline.tags, default_height)
        if not inside:
            found.append(Block(outline.geometry, height, origin))
            continue
        shapely = require("shapely", "reading OpenStreetMap files")
        rest = outline.geometry.difference(shapely.union_all([block.area for block in inside]))
        tops = [block.height for block in inside]
        if origin == Origin.GUESS or abs(height - max(tops)) <= _RESTATES:
            lowest = min(inside, key=lambda block: block.height)
            height = lowest.height
            origin = Origin.GUESS if lowest.origin == Origin.GUESS else Origin.PARTS
        found.append(Block(rest, height, origin))
    return [block for block in found if not block.area.is_empty]


def told_or_guessed(given: tags.Tags, default_height: float) -> tuple[float, Origin]:
    """The height that the tags of a building or part tell, or what is usual for its kind [m]."""
    told = tags.told_height(given)
    if told is None:
        return tags.usual_height(given, default_height), Origin.GUESS
    return told.height, Origin.LEVELS if told.by_levels else Origin.TAG


def _owners(outlines: list[Shape], parts: list[Shape]) -> dict[int, int]:
    """For each part the outline that holds more than half of it."""
    if not outlines or not parts:
        return {}
    shapely = require("shapely", "reading OpenStreetMap files")
    tree = shapely.STRtree([outline.geometry for outline in outlines])
    held: dict[int, tuple[float, int]] = {}
    part_index, outline_index = tree.query([part.geometry for part in parts], "intersects")
    for p, o in sorted(zip(part_index.tolist(), outline_index.tolist(), strict=True)):
        area = parts[p].geometry.intersection(outlines[o].geometry).area
        if area > 0.5 * parts[p].geometry.area and area > held.get(p, (0.0, 0))[0]:
            held[p] = (area, o)
    return {p: o for p, (_, o) in held.items()}
