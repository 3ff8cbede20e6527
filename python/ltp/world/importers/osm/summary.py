# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The summary of an import: what was read, what was guessed, what was dropped and why."""

from collections import Counter
from typing import Any

from ltp.world.classes import LandClass

from ..optional import require
from . import tags
from .buildings import Block, Origin
from .cover import area_cover, line_cover
from .shapes import Shape, Shapes
from .solids import Solids
from .source import Source
from .standing import tall, wire

_EXAMPLES = 3


def summary(
    source: Source, shapes: Shapes, solids: Solids, box: Any, default_height: float
) -> tuple[str, ...]:
    """Sentences about everything that meets `box`, the area of the world (a shapely polygon)."""
    points, lines, areas = (
        [shape for shape in kind if shape.geometry.intersects(box)]
        for kind in (shapes.points, shapes.lines, shapes.areas)
    )
    inside = Shapes(points, lines, areas)
    return (
        _read(inside),
        *_heights(inside, solids, box, default_height),
        *_odd(inside),
        *_dropped(source, shapes, inside),
    )


def _read(inside: Shapes) -> str:
    everything = (*inside.points, *inside.areas)
    outlines = sum(tags.building(s.tags) for s in everything)
    parts = sum(tags.part(s.tags) and not tags.building(s.tags) for s in everything)
    covers = Counter(kind for s in inside.areas if (kind := area_cover(s.tags)) is not None)
    lines = Counter(cover[0] for s in inside.lines if (cover := line_cover(s.tags)) is not None)
    coast = sum(s.tags.get("natural") == "coastline" for s in inside.lines)
    wet = covers.pop(LandClass.WATER, 0)
    woods = covers.pop(LandClass.TREES, 0)
    trees = sum(tags.tree(s.tags) is not None for s in (*inside.points, *inside.lines))
    standing = sum(
        not tags.stands_over(s.tags) and tall(s.tags) is not None
        for s in (*everything, *inside.lines)
    )
    return (
        f"Read: {outlines} buildings and {parts} building parts; {standing} other tall things; "
        f"{trees} trees and rows of trees, {woods} woods; {wet} areas of water, "
        f"{lines[LandClass.WATER]} streams, {coast} coast lines; {lines[LandClass.ROAD]} roads, "
        f"{lines[LandClass.PATH]} paths, {lines[LandClass.RAIL]} rails; {covers.total()} other "
        "areas of ground."
    )


def _heights(inside: Shapes, solids: Solids, box: Any, default_height: float) -> list[str]:
    text = []
    if solids.buildings:
        found = Counter(block.origin for block in solids.buildings)
        guessed = _area([b for b in solids.buildings if b.origin == Origin.GUESS], box)
        built = _area(solids.buildings, box)
        share = guessed / built if built > 0.0 else 0.0
        outlines = [s for s in (*inside.points, *inside.areas) if tags.building(s.tags)]
        telling = sum(tags.told_height(s.tags) is not None for s in outlines)
        text.append(
            f"Heights of buildings: {telling} of {len(outlines)} buildings tell theirs. Of "
            f"{len(solids.buildings)} blocks (parts, and what they leave of their building), "
            f"{found[Origin.TAG]} have it from a height tag, {found[Origin.LEVELS]} from the "
            f"number of storeys (x {tags.LEVEL_HEIGHT:g} m), {found[Origin.PARTS]} from the rest "
            f"of their building; {found[Origin.GUESS]} are guessed (usual for the kind, else "
            f"{default_height:g} m): {_percent(share)} of the built area."
        )
    for what, blocks in (("other tall things", solids.standing), ("trees and woods", solids.trees)):
        guesses = sum(block.origin == Origin.GUESS for block in blocks)
        if guesses:
            text.append(f"Heights of {what}: {guesses} of {len(blocks)} are guessed.")
    return text


def _area(blocks: list[Block], box: Any) -> float:
    shapely = require("shapely", "reading OpenStreetMap files")
    if not blocks:
        return 0.0
    return float(shapely.area(shapely.intersection([b.area for b in blocks], box)).sum())


def _percent(share: float) -> str:
    return f"{100 * share:.1f} %" if share == 0.0 or share >= 0.0005 else "under 0.05 %"


def _odd(inside: Shapes) -> list[str]:
    """Values that nobody could read."""
    odd = [
        f"{text} ({shape.key})"
        for shape in (*inside.points, *inside.lines, *inside.areas)
        if _has_height(shape)
        for text in tags.not_understood(shape.tags)
    ]
    if not odd:
        return []
    return [f"Heights not understood, and left aside: {len(odd)}, such as {_some(odd)}."]


def _has_height(shape: Shape) -> bool:
    given = shape.tags
    if line_cover(given) is not None and tall(given) is None:
        return False  # clearances of roads
    return tags.stands_over(given) or any(key.endswith("height") for key in given)


def _dropped(source: Source, shapes: Shapes, inside: Shapes) -> list[str]:
    text = []
    for what, number in shapes.dropped.items():
        text.append(
            f"Left out or mended: {number} x {what}, such as {_some(shapes.examples[what])}."
        )
    wires = [s.key for s in inside.lines if wire(s.tags)]
    if wires:
        text.append(
            f"Not raised: {len(wires)} wires and ropes between pylons, such as {_some(wires)}."
        )
    for number, what in (
        (source.deleted, "deleted objects"),
        (source.repeated, "older versions of objects"),
        (source.empty, "ways without any of their nodes"),
    ):
        if number:
            text.append(f"Left out of the file: {number} {what}.")
    return text


def _some(names: list[str]) -> str:
    return ", ".join(names[:_EXAMPLES])
