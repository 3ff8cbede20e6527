# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Libraries that search paths: each function makes a solver for a map and its queries.

A raw answer is a path's cells (n, 3), none for no path; the compared one its length [m].
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..contest import Solver
from ..graph import STEPS, Blocked, length_of, sparse_graph, voxel_graph
from ..workload import CELL, DIMS, Pairs

_NONE = np.empty((0, 3), dtype=np.int64)


def _length(cells: NDArray[np.integer]) -> float:
    return length_of(cells, CELL)


def dijkstra3d_binary(blocked: Blocked, pairs: Pairs) -> Solver:
    """Its Dijkstra on a binary map; squeezes past blocked cells."""
    import dijkstra3d

    free = np.asfortranarray(~blocked)

    def solve(query: int) -> NDArray[np.integer]:
        start, goal = pairs[query].tolist()
        path: NDArray[np.integer] = dijkstra3d.binary_dijkstra(free, start, goal, anisotropy=CELL)
        return path

    return Solver(solve, _length)


def dijkstra3d_weighted(
    blocked: Blocked, pairs: Pairs, a_star: bool, our_graph: bool = False
) -> Solver:
    """Its Dijkstra or A* on a map of weights; on our graph, or past blocked cells."""
    import dijkstra3d

    weights = np.asfortranarray(np.where(blocked, np.inf, 1.0).astype(np.float32))
    settings: dict[str, Any] = {"anisotropy": CELL, "compass": a_star}
    if our_graph:
        settings["voxel_graph"] = voxel_graph(blocked)

    def solve(query: int) -> NDArray[np.integer]:
        start, goal = pairs[query].tolist()
        path: NDArray[np.integer] = dijkstra3d.dijkstra(weights, start, goal, **settings)
        return path

    def answer(path: NDArray[np.integer]) -> float:  # a "path" through walls is none
        return float("inf") if np.isinf(weights[tuple(path.T)]).any() else _length(path)

    return Solver(solve, answer)


def scikit_image(blocked: Blocked, pairs: Pairs) -> Solver:
    """Its minimum cost path; squeezes past blocked cells."""
    from skimage.graph import MCP_Geometric

    costs = np.where(blocked, -1.0, 1.0)  # negative: impassable

    def solve(query: int) -> NDArray[np.integer]:
        start, goal = map(tuple, pairs[query].tolist())
        search = MCP_Geometric(costs, sampling=CELL)
        distances, _ = search.find_costs([start], [goal])
        return np.array(search.traceback(goal)) if np.isfinite(distances[goal]) else _NONE

    return Solver(solve, _length)


def scipy_dijkstra(blocked: Blocked, pairs: Pairs) -> Solver:
    """Its Dijkstra over the whole of our graph, in double precision."""
    from scipy.sparse.csgraph import dijkstra

    graph = sparse_graph(blocked, CELL)
    ends = np.ravel_multi_index(tuple(np.moveaxis(pairs, -1, 0)), DIMS)
    return Solver(lambda i: float(dijkstra(graph, indices=ends[i, 0])[ends[i, 1]]))


def tcod_graph(blocked: Blocked, pairs: Pairs, a_star: bool) -> Solver:
    """Its pathfinder, with whole numbers for lengths; squeezes past blocked cells."""
    import tcod.path

    free = np.ascontiguousarray(~blocked.T).astype(np.int8)  # its axes are z, y, x
    graph = tcod.path.CustomGraph(free.shape, order="C")
    for step in STEPS:
        metres = float(np.linalg.norm(np.multiply(step, CELL)))
        graph.add_edge(step[::-1], round(14.5 * metres), cost=free)
    if a_star:  # lower bounds: a level more costs 71 - 41 at least
        graph.set_heuristic(cardinal=29, diagonal=41, z=30)

    def solve(query: int) -> NDArray[np.integer]:
        start, goal = pairs[query].tolist()
        search = tcod.path.Pathfinder(graph)
        search.add_root(tuple(start[::-1]))
        path: NDArray[np.integer] = search.path_to(tuple(goal[::-1]))
        return path[:, ::-1] if len(path) > 1 else _NONE

    return Solver(solve, _length)


def scikit_fmm(blocked: Blocked, pairs: Pairs) -> Solver:
    """Its fast marching (no path: the arrival time at the goal); any-angle, first order."""
    import skfmm

    def solve(query: int) -> float:
        start, goal = map(tuple, pairs[query].tolist())
        seed = np.ma.MaskedArray(np.ones(DIMS), blocked)
        seed[start] = -1.0
        times = skfmm.travel_time(seed, np.ones(DIMS), dx=CELL)
        return float(times[goal]) if times[goal] is not np.ma.masked else float("inf")

    return Solver(solve)


def ompl_bit_star(blocked: Blocked, pairs: Pairs, seconds: float) -> Solver:
    """Its BIT* with a budget of wall time: any-angle, checked every metre."""
    from ompl import base, geometric, util

    util.setLogLevel(util.LogLevel.LOG_NONE)
    space = base.RealVectorStateSpace(3)
    bounds = base.RealVectorBounds(3)
    size = np.multiply(DIMS, CELL)
    for axis in range(3):
        bounds.setLow(axis, 0.0)
        bounds.setHigh(axis, float(size[axis]))
    space.setBounds(bounds)
    free = (~blocked).tolist()

    def valid(state: Any) -> bool:
        x, y, z = int(state[0] // 2.0), int(state[1] // 2.0), int(state[2] // 4.0)
        return 0 <= x < DIMS[0] and 0 <= y < DIMS[1] and 0 <= z < DIMS[2] and free[x][y][z]

    def solve(query: int) -> float:
        setup = geometric.SimpleSetup(space)
        setup.setStateValidityChecker(valid)
        information = setup.getSpaceInformation()
        information.setStateValidityCheckingResolution(1.0 / float(space.getMaximumExtent()))
        ends = []
        for cell in pairs[query]:
            state = space.allocState()
            for axis in range(3):
                state[axis] = float((cell[axis] + 0.5) * CELL[axis])
            ends.append(state)
        setup.setStartAndGoalStates(*ends)
        setup.setPlanner(geometric.BITstar(information))
        setup.solve(seconds)
        return setup.getSolutionPath().length() if setup.haveExactSolutionPath() else float("inf")

    return Solver(solve)
