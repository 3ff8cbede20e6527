# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Areas out of the rings of multipolygons: by libosmium's own assembler, or mended by shapely."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..optional import require

Places = NDArray[np.int64]  # (n, 2) longitude and latitude [1e-7 degrees]
Points = NDArray[np.float64]  # (n, 2) projected [m]

_PURPOSE = "reading OpenStreetMap files"


def assemble(
    relations: Sequence[Sequence[Places]],
    whole: Sequence[bool],
    project: Callable[[list[Places]], list[Points]],
) -> tuple[list[Any], list[int], list[int]]:
    """The area of each multipolygon, given as the lines of its ways, in any order and any role.

    What lies within an odd number of rings is inside (even-odd), as libosmium's area assembler has
    it. Rings that it refuses (they cross, or do not close) are mended: the same rule over all that
    encloses something, lines that end nowhere left out. Where then nothing is left of a relation
    that is `whole` in the file, its lines are closed by straight ones.

    Returns:
        The areas (shapely, projected; empty where nothing encloses anything), and the indices of
        those that were mended and of those that stay empty.
    """
    shapely = require("shapely", _PURPOSE)
    built = _by_libosmium(relations)
    areas: list[Any] = [shapely.Polygon()] * len(relations)
    flat = [ring for rings in built.values() for polygon in rings for ring in polygon]
    points = iter(project(flat))
    for index, rings in built.items():
        polygons = [[next(points) for _ in polygon] for polygon in rings]
        areas[index] = sound_area(
            shapely.union_all([sound_area(shapely.Polygon(p[0], p[1:])) for p in polygons])
        )
    mended: list[int] = []
    empty: list[int] = []
    for index, lines in enumerate(relations):
        if not areas[index].is_empty:
            continue
        points_of_lines = project([line for line in lines if len(line) > 1])
        areas[index] = even_odd(points_of_lines)
        if areas[index].is_empty and whole[index]:
            areas[index] = even_odd(_closed(points_of_lines))
        (empty if areas[index].is_empty else mended).append(index)
    return areas, mended, empty


def _by_libosmium(relations: Sequence[Sequence[Places]]) -> dict[int, list[list[Places]]]:
    """For each relation that libosmium can assemble its polygons: rings, the outer one first."""
    osmium = require("osmium", _PURPOSE)
    text = _as_opl(relations)
    if not text:
        return {}
    found: dict[int, list[list[Places]]] = {}
    buffer = osmium.io.FileBuffer(text, "opl")
    for item in osmium.FileProcessor(buffer).with_areas():
        if item.is_area() and not item.from_way() and item.num_rings()[0] > 0:
            found[item.orig_id() - 1] = [
                [_places(outer), *(_places(inner) for inner in item.inner_rings(outer))]
                for outer in item.outer_rings()
            ]
    return dict(sorted(found.items()))


def _places(ring: Iterable[Any]) -> Places:
    return np.array([(node.x, node.y) for node in ring], dtype=np.int64).reshape(-1, 2)


def _as_opl(relations: Sequence[Sequence[Places]]) -> bytes:
    """The relations in osmium's text format, renumbered: one node a place, one way a line."""
    nodes: dict[tuple[int, int], int] = {}
    ways, members = [], []
    for number, lines in enumerate(relations, 1):
        refs = []
        for line in lines:
            path = [nodes.setdefault((x, y), len(nodes) + 1) for x, y in line.tolist()]
            if len(path) > 1:
                ways.append("N" + ",".join(f"n{node}" for node in path))
                refs.append(f"w{len(ways)}@")
        if refs:
            members.append(f"r{number} Ttype=multipolygon M" + ",".join(refs))
    if not members:
        return b""
    texts = [f"n{n} x{_degrees(x)} y{_degrees(y)}" for (x, y), n in nodes.items()]
    texts += [f"w{n} {way}" for n, way in enumerate(ways, 1)]
    return ("\n".join([*texts, *members]) + "\n").encode()


def _degrees(value: int) -> str:
    whole, rest = divmod(abs(value), 10_000_000)
    return f"{'-' if value < 0 else ''}{whole}.{rest:07d}"


def even_odd(lines: Sequence[Points]) -> Any:
    """What lies within an odd number of the closed rings that `lines` make, crossing or not."""
    shapely = require("shapely", _PURPOSE)
    if not lines:
        return shapely.Polygon()
    pieces = _odd_pieces(np.concatenate([np.hstack([a[:-1], a[1:]]) for a in lines]))
    noded = shapely.union_all(shapely.linestrings(pieces.reshape(-1, 2, 2)))
    faces = shapely.get_parts(shapely.polygonize([noded]))
    if not len(faces):
        return shapely.Polygon()
    # Only what bounds a face counts: an end that hangs loose has no inside.
    edges = np.concatenate(
        [
            np.hstack([(ring := shapely.get_coordinates(ring_line))[:-1], ring[1:]])
            for face in faces
            for ring_line in (face.exterior, *face.interiors)
        ]
    )
    edges = np.unique(_ordered(edges), axis=0)
    inside = [face for face in faces if _parity(face.representative_point(), edges)]
    return sound_area(shapely.union_all(inside))


def _closed(lines: Sequence[Points]) -> list[Points]:
    """Lines joined where they meet, and closed where they do not."""
    shapely = require("shapely", _PURPOSE)
    if not lines:
        return []
    joined = shapely.get_parts(shapely.line_merge(shapely.MultiLineString(list(lines))))
    chains = [shapely.get_coordinates(line) for line in joined]
    return [np.vstack([chain, chain[:1]]) for chain in chains if len(chain) > 2]


def _ordered(pieces: Points) -> Points:
    """Pieces x0, y0, x1, y1 with their lesser end first."""
    turned = (pieces[:, 0] > pieces[:, 2]) | (
        (pieces[:, 0] == pieces[:, 2]) & (pieces[:, 1] > pieces[:, 3])
    )
    return np.where(turned[:, None], pieces[:, [2, 3, 0, 1]], pieces)


def _odd_pieces(pieces: Points) -> Points:
    """Without pieces of no length, and without those drawn an even number of times."""
    moving = (pieces[:, :2] != pieces[:, 2:]).any(axis=1)
    unique, counts = np.unique(_ordered(pieces[moving]), axis=0, return_counts=True)
    return np.asarray(unique[counts % 2 == 1])


def _parity(point: Any, edges: Points) -> bool:
    """Whether a ray from `point` crosses an odd number of edges."""
    x0, y0, x1, y1 = edges.T
    spans = (y0 > point.y) != (y1 > point.y)
    x = x0[spans] + (point.y - y0[spans]) * (x1 - x0)[spans] / (y1 - y0)[spans]
    return bool(np.count_nonzero(x > point.x) % 2)


def sound_area(geometry: Any) -> Any:
    """The same area without self-crossings; lines and points that remain of them are dropped."""
    shapely = require("shapely", _PURPOSE)
    if geometry.geom_type in ("Polygon", "MultiPolygon") and geometry.is_valid:
        return geometry
    valid = shapely.make_valid(geometry)
    parts = [p for p in shapely.get_parts(valid) if p.geom_type in ("Polygon", "MultiPolygon")]
    return shapely.union_all(parts)
