# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Shapes out of an OpenStreetMap file: points, lines and areas with their tags, projected."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..optional import require
from .cover import is_area
from .tags import buried

Box = tuple[float, float, float, float]
_SUFFIXES = (".osm", ".pbf")


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


@dataclass(frozen=True)
class _Way:
    number: int
    tags: dict[str, str]
    lonlat: NDArray[np.float64]  # (n, 2)


@dataclass(frozen=True)
class _Relation:
    number: int
    tags: dict[str, str]
    outer: tuple[int, ...]
    inner: tuple[int, ...]


def read_shapes(path: Path, crs: Any, near: Box) -> Shapes:
    """Read what lies within `near` (lon_min, lat_min, lon_max, lat_max) and project it to `crs`.

    Buried things are left out. Areas of a multipolygon whose rings the file does not close are
    left out too: nobody can tell their inside.

    Raises:
        ImportError: if osmium, shapely or pyproj are not installed.
        ValueError: naming the file, if it cannot be read to its end or holds nothing there.
    """
    osmium = require("osmium", "reading OpenStreetMap files")
    if not path.is_file():  # also keeps osmium from taking the name for a URL
        raise FileNotFoundError(f"{path} is not a file")
    if path.suffix not in _SUFFIXES:
        raise ValueError(f"{path} must end in .osm or .osm.pbf")
    try:
        relations = _read_relations(osmium, path)
        nodes, ways, seen = _read_ways(osmium, path, relations, near)
    except (OSError, ImportError):
        raise
    except Exception as error:  # osmium's own errors share no better base
        raise ValueError(f"{path} cannot be read as an OpenStreetMap file: {error}") from error
    if not ways:
        where = "no way with its nodes" if seen is None else f"its ways lie within lon/lat {seen}"
        raise ValueError(f"{path} holds nothing in the bounds (lon/lat {_short(near)}): {where}")
    return _project(crs, nodes, ways, relations)


def _short(box: Box) -> str:
    return "(" + ", ".join(f"{value:.5f}" for value in box) + ")"


def _read_relations(osmium: Any, path: Path) -> list[_Relation]:
    relations = []
    for relation in osmium.FileProcessor(str(path.resolve()), osmium.osm.RELATION):
        tags = {tag.k: tag.v for tag in relation.tags}
        if tags.get("type") != "multipolygon" or buried(tags):
            continue
        ways = [(m.ref, m.role) for m in relation.members if m.type == "w"]
        outer = tuple(ref for ref, role in ways if role != "inner")
        inner = tuple(ref for ref, role in ways if role == "inner")
        relations.append(_Relation(relation.id, tags, outer, inner))
    return relations


def _read_ways(
    osmium: Any, path: Path, relations: list[_Relation], near: Box
) -> tuple[list[_Way], dict[int, _Way], str | None]:
    """Tagged nodes (as ways of one node) and ways near the box, and where the file's ways lie."""
    members = {ref for relation in relations for ref in (*relation.outer, *relation.inner)}
    low, high = np.array(near[:2]), np.array(near[2:])
    seen = np.array([np.inf, np.inf, -np.inf, -np.inf])
    nodes: list[_Way] = []
    ways: dict[int, _Way] = {}
    untagged = osmium.filter.EmptyTagFilter().enable_for(osmium.osm.NODE)
    entities = osmium.osm.NODE | osmium.osm.WAY
    source = osmium.FileProcessor(str(path.resolve()), entities).with_locations()
    for item in source.with_filter(untagged):
        is_node = item.is_node()
        points = [item.location] if is_node else [node.location for node in item.nodes]
        lonlat = np.array([(p.lon, p.lat) for p in points if p.valid()]).reshape(-1, 2)
        if len(lonlat) < (1 if is_node else 2):
            continue
        first, last = lonlat.min(axis=0), lonlat.max(axis=0)
        within = bool((last >= low).all() and (first <= high).all())
        if not is_node:
            seen = np.array([*np.minimum(seen[:2], first), *np.maximum(seen[2:], last)])
        if within or (not is_node and item.id in members):
            way = _Way(item.id, {tag.k: tag.v for tag in item.tags}, lonlat)
            if is_node:
                nodes.append(way)
            else:
                ways[item.id] = way
    found = None if np.isinf(seen).any() else _short((seen[0], seen[1], seen[2], seen[3]))
    return nodes, ways, found


def _project(
    crs: Any, nodes: list[_Way], ways: dict[int, _Way], relations: list[_Relation]
) -> Shapes:
    shapely = require("shapely", "reading OpenStreetMap files")
    pyproj = require("pyproj", "reading OpenStreetMap files")
    everything = [*nodes, *ways.values()]
    lonlat = np.concatenate([way.lonlat for way in everything])
    transformer = pyproj.Transformer.from_crs("EPSG:4326", crs, always_xy=True)
    xy = np.column_stack(transformer.transform(lonlat[:, 0], lonlat[:, 1]))
    pieces = np.split(xy, np.cumsum([len(way.lonlat) for way in everything])[:-1])

    shapes = Shapes()
    lines: dict[int, Any] = {}
    for way, piece in zip(everything[: len(nodes)], pieces, strict=False):
        if np.isfinite(piece).all() and not buried(way.tags):
            shapes.points.append(Shape(f"n{way.number}", way.tags, shapely.Point(piece[0])))
    for way, piece in zip(ways.values(), pieces[len(nodes) :], strict=True):
        if not np.isfinite(piece).all():
            continue
        lines[way.number] = line = shapely.LineString(piece)
        if not way.tags or buried(way.tags):
            continue
        key = f"w{way.number}"
        closed_area = len(piece) >= 4 and line.is_closed and is_area(way.tags)
        if closed_area:
            area = _sound_area(shapely, shapely.Polygon(piece))
            if not area.is_empty:
                shapes.areas.append(Shape(key, way.tags, area))
        if not closed_area or way.tags.get("natural") == "coastline":  # an island that is a park
            shapes.lines.append(Shape(key, way.tags, line))
    for relation in relations:
        area = _assemble(shapely, relation, lines)
        if not area.is_empty:
            shapes.areas.append(Shape(f"r{relation.number}", relation.tags, area))
    return shapes


def _assemble(shapely: Any, relation: _Relation, lines: dict[int, Any]) -> Any:
    """The area of a multipolygon: rings of the outer ways minus rings of the inner ones."""

    def rings(refs: tuple[int, ...]) -> Any:
        closed = shapely.polygonize([lines[ref] for ref in refs if ref in lines])
        return shapely.union_all([_sound_area(shapely, ring) for ring in closed.geoms])

    return _sound_area(shapely, rings(relation.outer).difference(rings(relation.inner)))


def _sound_area(shapely: Any, geometry: Any) -> Any:
    """The same area without self-crossings; lines and points that remain of them are dropped."""
    valid = shapely.make_valid(geometry)
    parts = [p for p in shapely.get_parts(valid) if p.geom_type in ("Polygon", "MultiPolygon")]
    return shapely.union_all(parts)
