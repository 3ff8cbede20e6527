# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""ltp's graph for libraries that can search any graph: 26 steps, none past a blocked cell."""

import itertools
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from scipy.sparse import csr_array

Blocked = NDArray[np.bool_]
Step = tuple[int, int, int]

STEPS: tuple[Step, ...] = tuple(
    (x, y, z) for x, y, z in itertools.product((-1, 0, 1), repeat=3) if x or y or z
)

#: The bits of dijkstra3d's voxel graph, lowest first.
_DIJKSTRA3D_BITS: tuple[Step, ...] = (
    *((1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)),
    *((1, 1, 0), (-1, 1, 0), (1, -1, 0), (-1, -1, 0)),
    *((1, 0, 1), (-1, 0, 1), (0, 1, 1), (0, -1, 1)),
    *((1, 0, -1), (-1, 0, -1), (0, 1, -1), (0, -1, -1)),
    *((1, 1, 1), (-1, 1, 1), (1, -1, 1), (-1, -1, 1)),
    *((1, 1, -1), (-1, 1, -1), (1, -1, -1), (-1, -1, -1)),
)


def legal(blocked: Blocked, step: Step) -> Blocked:
    """The free cells from which a step is legal: its whole bounding box is free."""
    padded = np.pad(blocked, 1, constant_values=True)
    taken = np.zeros_like(blocked)
    for corner in itertools.product(*({0, offset} for offset in step)):
        window = tuple(slice(1 + c, 1 + c + n) for c, n in zip(corner, blocked.shape, strict=True))
        taken |= padded[window]
    return ~taken


def voxel_graph(blocked: Blocked) -> NDArray[np.uint32]:
    """The graph as dijkstra3d wants it: one bit a legal step, Fortran order."""
    graph = np.zeros(blocked.shape, dtype=np.uint32, order="F")
    for bit, step in enumerate(_DIJKSTRA3D_BITS):
        graph |= legal(blocked, step).astype(np.uint32) << np.uint32(bit)
    return graph


def sparse_graph(blocked: Blocked, cell: tuple[float, float, float]) -> "csr_array":
    """The graph as scipy wants it: step lengths [m] between cells numbered in C order."""
    from scipy.sparse import coo_array

    numbers = np.arange(blocked.size, dtype=np.int32).reshape(blocked.shape)
    rows, columns, lengths = [], [], []
    for step in STEPS:
        start = numbers[legal(blocked, step)]
        shift = int(np.dot(step, [n // numbers.itemsize for n in numbers.strides]))
        rows.append(start)
        columns.append(start + np.int32(shift))
        lengths.append(np.full(len(start), np.linalg.norm(np.multiply(step, cell))))
    data = np.concatenate(lengths), (np.concatenate(rows), np.concatenate(columns))
    return coo_array(data, shape=(blocked.size, blocked.size)).tocsr()


def length_of(cells: NDArray[np.integer], cell: tuple[float, float, float]) -> float:
    """Length of a path through the centres of cells (n, 3) [m]; inf for no path."""
    if len(cells) == 0:
        return float("inf")
    steps = np.diff(np.asarray(cells, dtype=np.int64), axis=0) * cell
    return float(np.linalg.norm(steps, axis=1).sum())
