# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Surfaces as triangles, for ray casters that know nothing else."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

Triangles = NDArray[np.float32]  # (n, 3, 3): corners [m]
_Axis = NDArray[Any]  # (n,) coordinates

# A box's corners, numbered by bits x, y, z, and its walls and top as quadrilaterals.
_SIDES = ((0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6), (4, 5, 7, 6))


def box_mesh(boxes: NDArray[np.float64], edge: float) -> Triangles:
    """Boxes (n, 2, 3), lowest and highest corners, on a ground of `edge` x `edge` m at z = 0."""
    bits = np.arange(8)[:, None] >> np.arange(3) & 1
    corners = np.where(bits, boxes[:, 1, None, :], boxes[:, 0, None, :])  # (n, 8, 3)
    sides = corners[:, np.array(_SIDES)].reshape(-1, 4, 3)
    ground = np.array([[[0, 0, 0], [edge, 0, 0], [edge, edge, 0], [0, edge, 0]]], dtype=float)
    return _split(np.concatenate([sides, ground]))


def raster_mesh(heights: NDArray[np.float64], cell: float = 1.0) -> Triangles:
    """A raster of flat tops (nx, ny) with the walls between them: what a real surface gives."""
    i, j = (index.ravel() for index in np.indices(heights.shape))
    z = heights.ravel()
    tops = _quads((i, j, z), (i + 1, j, z), (i + 1, j + 1, z), (i, j + 1, z))
    i, j = np.nonzero(heights[1:, :] != heights[:-1, :])
    walls_along_y = _wall((i + 1, j), (i + 1, j + 1), heights[i, j], heights[i + 1, j])
    i, j = np.nonzero(heights[:, 1:] != heights[:, :-1])
    walls_along_x = _wall((i, j + 1), (i + 1, j + 1), heights[i, j], heights[i, j + 1])
    quads = np.concatenate([tops, walls_along_y, walls_along_x])
    quads[..., :2] *= cell
    return _split(quads)


def _wall(
    a: tuple[_Axis, _Axis], b: tuple[_Axis, _Axis], low: _Axis, high: _Axis
) -> NDArray[np.float64]:
    return _quads((*a, low), (*b, low), (*b, high), (*a, high))


def _quads(*corners: tuple[_Axis, _Axis, _Axis]) -> NDArray[np.float64]:
    """Quadrilaterals (n, 4, 3) from the columns of their four corners."""
    return np.stack([np.column_stack(corner).astype(np.float64) for corner in corners], axis=1)


def _split(quads: NDArray[np.float64]) -> Triangles:
    """Two triangles each."""
    halves = quads[:, [[0, 1, 2], [0, 2, 3]]]
    return np.ascontiguousarray(halves.reshape(-1, 3, 3), dtype=np.float32)
