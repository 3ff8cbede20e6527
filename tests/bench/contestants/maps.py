# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mapping works: a scan's returns into the map, and whether points lie in occupied voxels."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp import ObstacleMap, ObstacleMapOptions

from ..contest import Shared, Solver, Work
from ..judges import near
from ..workload import ALTITUDE, MAX_RANGE, SEED

_POINTS = 100_000  # of a query
_EDGE = 2.0  # of a voxel [m]
_ROUNDED = 1e-3  # share of voxels that points on their faces fall beside


def _nanoseconds(ms: float) -> float:
    return ms * 1e6 / _POINTS


update = Work("map_update", "map update per scan", lambda shared: len(shared.sensing.scans))
update.once = True
query = Work("point_query", "point query from numpy", lambda _: 9, "ns", _nanoseconds)


def _probe(shared: Shared, question: int) -> NDArray[np.float64]:
    """Random points round the end of the flight, seen by the last scans."""
    rng = np.random.default_rng((SEED, question))
    half = np.array([MAX_RANGE, MAX_RANGE, MAX_RANGE - 2.0])
    middle = [*shared.sensing.positions[-1, :2], ALTITUDE]
    return np.ascontiguousarray(middle + rng.uniform(-half, half, (_POINTS, 3)))


def _our_map(shared: Shared) -> ObstacleMap:
    options = ObstacleMapOptions(max_range=2.0 * MAX_RANGE)  # every return counts
    return ObstacleMap(options, shared.sensing.positions[0])


@update.enter("ltp ObstacleMap")
def _(shared: Shared) -> Solver:
    built, scans = _our_map(shared), shared.sensing.scans
    points = _probe(shared, 0)

    def solve(i: int) -> None:
        built.recentre(scans[i].origin)
        built.insert(scans[i].origin, scans[i].hits)

    return Solver(solve, lambda _: built.voxels.blocked_at(points))


def _octree(shared: Shared, module: Any) -> Solver:
    """Endpoints only, by the quickest call that these wrappers have."""
    tree, scans = module.OcTree(_EDGE), shared.sensing.scans
    points = _probe(shared, 0)
    return Solver(
        lambda i: tree.updateNodes(scans[i].hits, True),
        lambda _: np.asarray(tree.getLabels(points)) == 1,
    )


@update.enter("pyoctomap updateNodes", "pyoctomap", near(0, _ROUNDED))
def _(shared: Shared) -> Solver:
    import pyoctomap

    return _octree(shared, pyoctomap)


@update.enter("octomap-python updateNodes", "octomap-python", near(0, _ROUNDED))
def _(shared: Shared) -> Solver:
    import octomap

    return _octree(shared, octomap)


@query.enter("ltp blocked_at")
def _(shared: Shared) -> Solver:
    built = _our_map(shared)
    for scan in shared.sensing.scans:
        built.recentre(scan.origin)
        built.insert(scan.origin, scan.hits)
    grid = built.voxels
    probes = [_probe(shared, i) for i in range(9)]
    return Solver(lambda i: grid.blocked_at(probes[i]))


def _labels(shared: Shared, module: Any) -> Solver:
    tree = module.OcTree(_EDGE)
    for scan in shared.sensing.scans:
        tree.updateNodes(scan.hits, True)
    probes = [_probe(shared, i) for i in range(9)]
    return Solver(lambda i: tree.getLabels(probes[i]), lambda labels: np.asarray(labels) == 1)


@query.enter("pyoctomap getLabels", "pyoctomap", near(0, _ROUNDED))
def _(shared: Shared) -> Solver:
    import pyoctomap

    return _labels(shared, pyoctomap)


@query.enter("octomap-python getLabels", "octomap-python", near(0, _ROUNDED))
def _(shared: Shared) -> Solver:
    import octomap

    return _labels(shared, octomap)
