# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes out of an OpenStreetMap file: points, lines and areas with their tags, projected."""

from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass
from ltp.world.crs import any_crs
from ltp.world.whereabouts import elsewhere

from ..optional import require
from .cover import area_cover, deck, is_area, island, line_cover
from .relations import Area, Meaning, understand
from .rings import Places, assemble, sound_area
from .source import Box, Source, Way, read_source
from .standing import tall
from .tags import buried, stands_over, tree

_PURPOSE = "reading OpenStreetMap files"
# Half of an area of these is worse than none: what it lacks would look free, or dry.
_NEEDED = frozenset({LandClass.WATER, LandClass.TREES, LandClass.RAIL, LandClass.CONSTRUCTION})
_NAMED = 5  # so many are named in a message


@dataclass(frozen=True)
class Shape:
    """One thing on the map."""

    key: str  # "w123": type and number, to sort by and to name in messages
    tags: dict[str, str]
    geometry: Any  # shapely geometry in the CRS of the world [m]


@dataclass
class Shapes:
    """Everything that a file holds near the box asked for, in the order of the file."""

    points: list[Shape] = field(default_factory=list)
    lines: list[Shape] = field(default_factory=list)
    areas: list[Shape] = field(default_factory=list)
    dropped: Counter[str] = field(default_factory=Counter)  # what was left out or mended, and why
    examples: dict[str, list[str]] = field(default_factory=dict)  # of those, by the same words

    def note(self, what: str, key: str) -> None:
        """Count something that is left out or mended."""
        self.dropped[what] += 1
        named = self.examples.setdefault(what, [])
        if len(named) < _NAMED:
            named.append(key)


def read_shapes(path: Path, crs: Any, near: Box, box: Any) -> tuple[Source, Shapes]:
    """Read what lies within `near` (lon_min, lat_min, lon_max, lat_max) and project it to `crs`.

    Buried things are left out, and multipolygons that nothing closes: nobody can tell their inside.
    `box` is the area of the world, a shapely polygon in `crs`.

    Raises:
        ImportError: if osmium, shapely or pyproj are not installed.
        ValueError: naming the file, if it cannot be read to its end, holds nothing there, or lacks
            nodes of something in the box that must not be missed: a building, a lake, a wood.
    """
    source = read_source(path, near)
    drawing = _Drawing(source, crs, near, box)
    if source.extent is None or not (source.near or source.nodes or drawing.made):
        where = (
            "no way with its nodes"
            if source.extent is None
            else f"its ways lie within lon/lat {_short(source.extent)}"
            f"{elsewhere(any_crs('EPSG:4326', path.name), source.extent, box.bounds)}"
        )
        raise ValueError(f"{path} holds nothing in the bounds (lon/lat {_short(near)}): {where}")
    try:
        drawing.draw()
    except ImportError:
        raise
    except Exception as error:  # GEOS's own, of hostile coordinates
        raise ValueError(f"{path} cannot be read as an OpenStreetMap file: {error}") from error
    if drawing.lacking:
        some = ", ".join(drawing.lacking[:_NAMED])
        rest = len(drawing.lacking) - _NAMED
        more = f" and {rest} more" if rest > 0 else ""
        raise ValueError(
            f"{path} lacks nodes of what lies in the bounds ({some}{more}): nobody can tell how "
            "far it reaches; cut the extract with osmium extract --strategy smart, or "
            "choose bounds that lie further inside"
        )
    return source, drawing.shapes


def _short(box: Box) -> str:
    return "(" + ", ".join(f"{value:.5f}" for value in box) + ")"


class _Drawing:
    """Shapes while they are made of the objects of a file."""

    def __init__(self, source: Source, crs: Any, near: Box, box: Any) -> None:
        self.source = source
        self.box = box
        self.meaning: Meaning = understand(source)
        self.made = [area for area in self.meaning.areas if self._near(area, near)]
        self.shapes = Shapes()
        self.lacking: list[str] = []  # things in the box that must not be missed, but lack nodes
        pyproj = require("pyproj", _PURPOSE)
        self.transformer = pyproj.Transformer.from_crs("EPSG:4326", crs, always_xy=True)

    def _near(self, area: Area, near: Box) -> bool:
        """Whether an area that a relation makes comes near the box, all its ways together."""
        if not area.ways or not _matters(area.tags):
            return False
        places = np.concatenate([self.source.ways[ref].places for ref in area.ways]) / 1e7
        return bool(
            (places.max(axis=0) >= near[:2]).all() and (places.min(axis=0) <= near[2:]).all()
        )

    def draw(self) -> None:
        shapely = require("shapely", _PURPOSE)
        nodes = list(self.source.nodes.values())
        for node, point in zip(nodes, self._project([n.place[None] for n in nodes]), strict=True):
            if np.isfinite(point).all() and self._shown(f"n{node.number}", node.tags):
                self.shapes.points.append(
                    Shape(f"n{node.number}", node.tags, shapely.Point(point[0]))
                )
        relations, spent = self._areas()
        ways = [w for n, w in self.source.ways.items() if n in self.source.near]
        for way, points in zip(ways, self._project([w.places for w in ways]), strict=True):
            if np.isfinite(points).all():
                tags = self.meaning.tags.get(way.number, way.tags)
                self._way(way, tags, points, spent=way.number in spent)
            else:
                self.shapes.note("cannot be projected", f"w{way.number}")
        self.shapes.areas += relations

    def _shown(self, key: str, tags: dict[str, str]) -> bool:
        if not tags:
            return False
        if buried(tags):
            if _matters(tags):
                self.shapes.note("buried or indoors", key)
            return False
        return True

    def _way(
        self, way: Way, tags: dict[str, str], points: NDArray[np.float64], *, spent: bool
    ) -> None:
        shapely = require("shapely", _PURPOSE)
        key = f"w{way.number}"
        if not self._shown(key, tags):
            return
        closed = len(points) > 3 and bool((points[0] == points[-1]).all())
        wanted = is_area(tags) and not spent
        if way.lacks_nodes and _matters(tags):
            known = shapely.MultiPoint(points).convex_hull
            if wanted and self._needed(tags) and known.intersects(self.box):
                self.lacking.append(key)
                return
            self.shapes.note("some nodes are not in the file", key)
            wanted = False
        unsafe = stands_over(tags) or area_cover(tags) == LandClass.WATER
        mended = wanted and not closed and unsafe and line_cover(tags) is None and len(points) > 2
        if mended:
            self.shapes.note("an outline that is not closed: closed", key)
        elif wanted and not closed and (unsafe or area_cover(tags)) and not line_cover(tags):
            self.shapes.note("an outline that is not closed: left out", key)
        if wanted and (closed or mended):
            area = sound_area(shapely.Polygon(points))
            if area.is_empty:
                self.shapes.note("an area without extent", key)
            else:
                self.shapes.areas.append(Shape(key, tags, area))
        coast = tags.get("natural") == "coastline"  # an island that is a park
        if coast or not (closed and is_area(tags)):
            for piece in _stretches(way, tags, points):
                self.shapes.lines.append(Shape(key, tags, shapely.LineString(piece)))

    def _needed(self, tags: dict[str, str]) -> bool:
        return stands_over(tags) or tall(tags) is not None or area_cover(tags) in _NEEDED

    def _areas(self) -> tuple[list[Shape], set[int]]:
        """The areas that relations make, and the ways that are none beside them."""
        wanted, lines = [], []
        for area in self.made:
            pieces = [piece for ref in area.ways for piece in _pieces(self.source.ways[ref])]
            if all(np.isfinite(points).all() for points in self._project(pieces)):
                wanted.append(area)
                lines.append(pieces)
            else:
                self.shapes.note("cannot be projected", area.key)
        whole = [
            not area.missing and not any(self.source.ways[ref].lacks_nodes for ref in area.ways)
            for area in wanted
        ]
        built, mended, empty = assemble(lines, whole, self._project)
        shapes: list[Shape] = []
        spent: set[int] = set()
        for index, (area, geometry) in enumerate(zip(wanted, built, strict=True)):
            named = f"{area.key} {_kind(area.tags)}".strip()
            near = any(ref in self.source.near for ref in area.ways)
            if near and self._cut_in_the_box(area, geometry):
                self.lacking.append(area.key)
            if index in empty:
                if near:
                    why = "the file lacks members" if area.missing else "its rings do not close"
                    self.shapes.note(f"a multipolygon that is cut open ({why})", named)
                continue
            if near and index in mended:
                self.shapes.note("a multipolygon whose rings cross or do not close: mended", named)
            elif near and area.missing:
                self.shapes.note("a multipolygon without some of its members: the rest kept", named)
            shapes.append(Shape(area.key, area.tags, geometry))
            spent |= area.spent
        return shapes, spent

    def _cut_in_the_box(self, area: Area, geometry: Any) -> bool:
        """Whether what must not be missed lacks nodes, or a building members, in the box."""
        shapely = require("shapely", _PURPOSE)
        ways = [self.source.ways[ref] for ref in area.ways]
        cut = [way for way in ways if way.lacks_nodes]
        if area.missing and stands_over(area.tags) and geometry.is_empty:
            cut = ways
        if not cut or not self._needed(area.tags):
            return False
        known = [shapely.MultiPoint(p).convex_hull for p in self._project([w.places for w in cut])]
        return any(hull.intersects(self.box) for hull in known)

    def _project(self, pieces: list[Places]) -> list[NDArray[np.float64]]:
        if not pieces:
            return []
        degrees = np.concatenate(pieces) / 1e7
        xy = np.column_stack(self.transformer.transform(degrees[:, 0], degrees[:, 1]))
        return np.split(xy, np.cumsum([len(piece) for piece in pieces])[:-1])


def _matters(tags: dict[str, str]) -> bool:
    """Whether something with these tags leaves a trace in the world."""
    if stands_over(tags) or tree(tags) is not None or island(tags) or deck(tags):
        return True
    covers = area_cover(tags) is not None or line_cover(tags) is not None
    return covers or tall(tags) is not None


def _stretches(
    way: Way, tags: dict[str, str], points: NDArray[np.float64]
) -> list[NDArray[np.float64]]:
    """A line between the nodes that the file lacks; a stream or a wall goes straight on there."""
    cover = line_cover(tags)
    goes_on = tall(tags) is not None or (cover is not None and cover[0] == LandClass.WATER)
    pieces = [points] if goes_on else np.split(points, way.breaks)
    return [piece for piece in pieces if len(piece) > 1]


def _pieces(way: Way) -> list[Places]:
    """The stretches of a way between the nodes that the file lacks."""
    return [piece for piece in np.split(way.places, way.breaks) if len(piece) > 1]


def _kind(tags: dict[str, str]) -> str:
    """The tag that tells what an area is, and its name."""
    keys = ("building", "natural", "landuse", "leisure", "waterway", "man_made", "place")
    kind = next((f"{key}={tags[key]}" for key in keys if key in tags), "")
    return f"{kind} {tags.get('name', '')!r}" if "name" in tags else kind
