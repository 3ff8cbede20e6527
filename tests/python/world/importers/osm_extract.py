# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small OpenStreetMap extracts to draw on, and worlds read from them."""

from collections.abc import Collection
from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import pytest

from ltp.world import LandClass, World
from ltp.world.importers import osm

osmium = pytest.importorskip("osmium")
mutable = pytest.importorskip("osmium.osm.mutable")
pyproj = pytest.importorskip("pyproj")
pytest.importorskip("rasterio")
pytest.importorskip("shapely")

CRS = "EPSG:32632"
WEST, SOUTH = 500_000.0, 5_400_000.0
_TO_DEGREES = pyproj.Transformer.from_crs(CRS, "EPSG:4326", always_xy=True)

Corners = list[tuple[float, float]]
Tags = dict[str, str]


def box(x0: float, y0: float, x1: float, y1: float) -> Corners:
    """A closed rectangle, anticlockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]


class Extract:
    """A small map to draw on: x east, y north, in metres from (WEST, SOUTH) in UTM zone 32."""

    def __init__(self) -> None:
        self.nodes: dict[tuple[float, float], tuple[int, Tags]] = {}
        self.ways: list[tuple[int, list[int], Tags]] = []
        self.relations: list[tuple[int, list[tuple[int, str]], Tags]] = []

    def node(self, x: float, y: float, tags: Tags | None = None) -> int:
        """Add a node; the same place is the same node."""
        number, known = self.nodes.setdefault((x, y), (len(self.nodes) + 1, {}))
        known.update(tags or {})
        return number

    def way(self, corners: Corners, tags: Tags | None = None) -> int:
        """Add a way through these corners."""
        refs = [self.node(x, y) for x, y in corners]
        if corners[0] == corners[-1]:
            refs[-1] = refs[0]
        self.ways.append((len(self.ways) + 1, refs, tags or {}))
        return self.ways[-1][0]

    def multipolygon(self, members: list[tuple[int, str]], tags: Tags) -> None:
        """Add a multipolygon of (way, role)."""
        self.relation(members, {"type": "multipolygon", **tags})

    def relation(self, members: list[tuple[int, str]], tags: Tags) -> None:
        """Add a relation of (way, role)."""
        self.relations.append((len(self.relations) + 1, members, tags))

    def write_xml(
        self,
        path: Path,
        *,
        order: str = "nwr",
        without: Collection[int] = (),
        attributes: dict[tuple[str, int], str] | None = None,
        sign: int = 1,
    ) -> Path:
        """Write as .osm: kinds in this `order`, `without` these nodes, ids times `sign`."""

        def tagged(tags: Tags) -> str:
            pairs = tags.items()
            return "".join(f"<tag k={quoteattr(k)} v={quoteattr(v)}/>" for k, v in pairs)

        def opened(kind: str, number: int) -> str:
            more = (attributes or {}).get((kind[0], number), "")
            return f'<{kind} id="{sign * number}" version="1" {more}'

        parts: dict[str, list[str]] = {"n": [], "w": [], "r": []}
        for number, (lon, lat), tags in self._placed():
            if number not in without:
                place = f'lat="{lat:.9f}" lon="{lon:.9f}"'
                parts["n"].append(f"{opened('node', number)} {place}>{tagged(tags)}</node>")
        for number, refs, tags in self.ways:
            nodes = "".join(f'<nd ref="{sign * ref}"/>' for ref in refs)
            parts["w"].append(f"{opened('way', number)}>{nodes}{tagged(tags)}</way>")
        for number, members, tags in self.relations:
            inner = "".join(f'<member type="way" ref="{sign * r}" role="{s}"/>' for r, s in members)
            parts["r"].append(f"{opened('relation', number)}>{inner}{tagged(tags)}</relation>")
        lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6">']
        lines += [line for kind in order for line in parts[kind]]
        path.write_text("\n".join([*lines, "</osm>"]), encoding="utf-8")
        return path

    def write_pbf(self, path: Path) -> Path:
        """Write as .osm.pbf."""
        writer = osmium.SimpleWriter(str(path), overwrite=True)
        for number, place, tags in self._placed():
            writer.add_node(mutable.Node(id=number, location=place, tags=tags, version=1))
        for number, refs, tags in self.ways:
            writer.add_way(mutable.Way(id=number, nodes=refs, tags=tags, version=1))
        for number, members, tags in self.relations:
            inner = [("w", ref, role) for ref, role in members]
            writer.add_relation(mutable.Relation(id=number, members=inner, tags=tags, version=1))
        writer.close()
        return path

    def _placed(self) -> list[tuple[int, tuple[float, float], Tags]]:
        placed: list[Any] = []
        for (x, y), (number, tags) in self.nodes.items():
            placed.append((number, _TO_DEGREES.transform(WEST + x, SOUTH + y), tags))
        return placed


SIZE = 100.0
BOUNDS = (WEST, SOUTH, WEST + SIZE, SOUTH + SIZE)


def read(path: Path, **options: Any) -> World:
    """A world of 100 m x 100 m out of a file."""
    return osm.read(path, **{"bounds": BOUNDS, "crs": CRS, **options})


def at(world: World, x: float, y: float) -> tuple[float, LandClass]:
    """Height of the surface and class at a place [m]."""
    cell = int(x // world.cell), int(y // world.cell)
    return world.surface[cell], LandClass(world.classes[cell])
