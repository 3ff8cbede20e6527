# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The distance from one cell to all others of the solid town [m]; inf where none can be reached."""

import numpy as np
from numpy.typing import NDArray

import ltp

from ..contest import Shared, Solver, Unavailable, Work
from ..graph import voxel_graph
from ..judges import fields, finite
from ..workload import CELL, DIMS, centres

_SINGLE = 1e-4  # what single precision adds up to over a path, relative

field = Work("distance_field", "distance field of the whole map", lambda shared: 5)


@field.enter("ltp")
def _(shared: Shared) -> Solver:
    make = getattr(ltp, "distance_field", None)
    if make is None:
        raise Unavailable("this ltp has no distance_field")
    sources = centres(shared.town.pairs[:, 0])
    return Solver(lambda i: make(shared.town.solid_grid, sources[i]))


@field.enter("dijkstra3d, our graph", "dijkstra3d", fields(1 - _SINGLE, 1 + _SINGLE))
def _(shared: Shared) -> Solver:
    return _dijkstra3d(shared, our_graph=True)


@field.enter("dijkstra3d", "dijkstra3d", fields(1 - _SINGLE, 1.5))
def _(shared: Shared) -> Solver:
    return _dijkstra3d(shared, our_graph=False)


@field.enter("scikit-fmm (first order)", "scikit-fmm", fields(0.9, 1.5))
def _(shared: Shared) -> Solver:
    import skfmm

    def solve(question: int) -> NDArray[np.float64]:
        seed = np.ma.MaskedArray(np.ones(DIMS), shared.town.solid)
        seed[tuple(shared.town.pairs[question, 0])] = -1.0
        times = skfmm.travel_time(seed, np.ones(DIMS), dx=CELL)
        return np.ma.filled(times, np.inf)

    return Solver(solve)


def _dijkstra3d(shared: Shared, our_graph: bool) -> Solver:
    import dijkstra3d

    free = np.asfortranarray(~shared.town.solid)
    graph = voxel_graph(shared.town.solid) if our_graph else None

    def solve(question: int) -> NDArray[np.float32]:
        source = shared.town.pairs[question, 0].tolist()
        distances: NDArray[np.float32] = dijkstra3d.euclidean_distance_field(
            free, source, anisotropy=CELL, voxel_graph=graph
        )
        return distances

    return Solver(solve, lambda distances: finite(distances, 1e9))
