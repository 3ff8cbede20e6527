# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small OpenStreetMap files for the tests, drawn in metres on a corner of UTM zone 32."""

from pathlib import Path
from typing import Any
from xml.sax.saxutils import quoteattr

import pyproj

CRS = "EPSG:32632"
WEST, SOUTH = 500_000.0, 5_400_000.0
_TO_DEGREES = pyproj.Transformer.from_crs(CRS, "EPSG:4326", always_xy=True)

Corners = list[tuple[float, float]]
Tags = dict[str, str]


def box(x0: float, y0: float, x1: float, y1: float) -> Corners:
    """A closed rectangle, anticlockwise."""
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)]


class Extract:
    """A map to draw on: x east, y north, in metres from (WEST, SOUTH)."""

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
        number = len(self.relations) + 1
        self.relations.append((number, members, {"type": "multipolygon", **tags}))

    def write_xml(self, path: Path) -> Path:
        """Write as .osm."""

        def tagged(tags: Tags) -> str:
            pairs = tags.items()
            return "".join(f"<tag k={quoteattr(k)} v={quoteattr(v)}/>" for k, v in pairs)

        lines = ['<?xml version="1.0" encoding="UTF-8"?>', '<osm version="0.6">']
        for number, (lon, lat), tags in self._placed():
            place = f'lat="{lat:.9f}" lon="{lon:.9f}"'
            lines.append(f'<node id="{number}" version="1" {place}>{tagged(tags)}</node>')
        for number, refs, tags in self.ways:
            nodes = "".join(f'<nd ref="{ref}"/>' for ref in refs)
            lines.append(f'<way id="{number}" version="1">{nodes}{tagged(tags)}</way>')
        for number, members, tags in self.relations:
            inner = "".join(f'<member type="way" ref="{r}" role="{s}"/>' for r, s in members)
            lines.append(f'<relation id="{number}" version="1">{inner}{tagged(tags)}</relation>')
        path.write_text("\n".join([*lines, "</osm>"]))
        return path

    def write_pbf(self, path: Path) -> Path:
        """Write as .osm.pbf."""
        import osmium
        from osmium.osm import mutable

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
