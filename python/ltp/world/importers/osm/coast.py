# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sea out of coast lines: OpenStreetMap draws them with the land on the left."""

from typing import Any

from ..optional import require

_SIDE = 0.01  # how far beside the line its sides are asked [m]


def sea(lines: list[Any], box: Any) -> list[Any]:
    """The areas of `box` (a shapely polygon) that lie to the right of the coast lines.

    The lines are cut at the box and closed along its rim. A piece whose rim holds as much left
    side as right, because a line ends within it, is nobody's and left out; so is a box that no
    coast line crosses.
    """
    shapely = require("shapely", "reading OpenStreetMap files")
    inside = [
        piece
        for line in lines
        for piece in shapely.get_parts(line.intersection(box))
        if piece.geom_type == "LineString" and piece.length > 2 * _SIDE
    ]
    if not inside:
        return []
    faces = list(shapely.polygonize([shapely.union_all([box.boundary, *inside])]).geoms)
    tree = shapely.STRtree(faces)
    right, left = [0.0] * len(faces), [0.0] * len(faces)
    for line in inside:
        for (x0, y0), (x1, y1) in zip(line.coords[:-1], line.coords[1:], strict=True):
            length = ((x1 - x0) ** 2 + (y1 - y0) ** 2) ** 0.5
            if length == 0.0:
                continue
            x, y = (x0 + x1) / 2, (y0 + y1) / 2
            dx, dy = _SIDE * (y1 - y0) / length, _SIDE * (x0 - x1) / length  # to the right
            for face in tree.query(shapely.Point(x + dx, y + dy), "within"):
                right[face] += length
            for face in tree.query(shapely.Point(x - dx, y - dy), "within"):
                left[face] += length
    return [face for face, r, w in zip(faces, right, left, strict=True) if r > w]
