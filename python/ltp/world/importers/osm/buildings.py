# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Solid blocks out of OpenStreetMap buildings: parts before outlines."""

from typing import Any

from ..optional import require
from . import tags
from .shapes import Shape

Block = tuple[Any, float]  # shapely area, height of its top above the ground [m]

_RESTATES = 0.5  # an outline this close to its tallest part repeats the height of the tower [m]


def blocks(areas: list[Shape], default_height: float) -> list[Block]:
    """The buildings among `areas` as solid blocks that stand on the ground.

    Where parts cover an outline, they count. What they leave of it gets the outline's own height,
    but if that only restates the tallest part (the tower's height, tagged on the whole block) or is
    missing, the height of the lowest part. A part without a height takes the outline's.
    """
    outlines = [shape for shape in areas if tags.building(shape.tags)]
    parts = [shape for shape in areas if tags.part(shape.tags) and not tags.building(shape.tags)]
    owner = _owners(outlines, parts)
    found: list[Block] = []
    heights_in: dict[int, list[Block]] = {}
    for index, part in enumerate(parts):
        outline = outlines[owner[index]] if index in owner else None
        height = tags.tagged_height(part.tags)
        if height is None:
            height = _outline_height(outline or part, default_height)
        found.append((part.geometry, height))
        if outline is not None:
            heights_in.setdefault(owner[index], []).append(found[-1])
    for index, outline in enumerate(outlines):
        inside = heights_in.get(index, [])
        if not inside:
            found.append((outline.geometry, _outline_height(outline, default_height)))
            continue
        shapely = require("shapely", "reading OpenStreetMap files")
        rest = outline.geometry.difference(shapely.union_all([area for area, _ in inside]))
        tops = [height for _, height in inside]
        own = tags.tagged_height(outline.tags)
        podium = own if own is not None and own < max(tops) - _RESTATES else min(tops)
        found.append((rest, podium))
    return [(area, height) for area, height in found if not area.is_empty]


def _outline_height(shape: Shape, default_height: float) -> float:
    return tags.tagged_height(shape.tags) or tags.usual_height(shape.tags, default_height)


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
