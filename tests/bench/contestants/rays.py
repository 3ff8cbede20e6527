# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The sensing works: 64 x 1024 rays, level or tilted, to 50 m over the height raster."""

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from ltp import Pose, Scan

from ..contest import Shared, Solver, Unavailable, Work
from ..judges import Judge, Verdict, finite, near
from ..mesh import Triangles, box_mesh, raster_mesh
from ..workload import EDGE, MAX_RANGE, TILT
from . import ray_peers
from .ray_peers import Cast

_RAYS = 64 * 1024
_NEAR, _GRAZING = 0.01, 1e-3  # [m]; the share of rays that graze an edge in single precision


def _rate(ms: float) -> float:
    return _RAYS / ms / 1e3


def _work(name: str, title: str) -> Work:
    return Work(name, title, lambda shared: len(shared.sensing.positions), "M rays/s", _rate)


level = _work("lidar_level", "LiDAR, level sensor")
tilted = _work("lidar_tilted", "LiDAR, any attitude")
_ALL_RAYS = near(_NEAR, _GRAZING)


def _returns(ours: list[NDArray[np.float64]], theirs: list[NDArray[np.float64]]) -> Verdict:
    """A scan has no range for each ray, but its returns: as many, and as far."""
    mine = [np.sort(answer[np.isfinite(answer)]) for answer in ours]
    other = [np.sort(answer[np.isfinite(answer)]) for answer in theirs]
    more = sum(len(b) - len(a) for a, b in zip(mine, other, strict=True))
    apart = max(abs(float(a.mean()) - float(b.mean())) for a, b in zip(mine, other, strict=True))
    total = sum(map(len, mine))
    ok = abs(more) <= _GRAZING * total and apart <= _NEAR
    return Verdict(ok, f"{more:+d} of {total} returns, mean ranges within {apart * 1e3:.2f} mm")


def _scanner(shared: Shared, attitude: dict[str, float]) -> Solver:
    sensing = shared.sensing
    poses = [Pose(position, **attitude) for position in sensing.positions]

    def ranges(scan: Scan) -> NDArray[np.float64]:
        return np.asarray(np.linalg.norm(scan.hits - scan.origin, axis=1))

    # The peers list no misses either.
    return Solver(lambda i: sensing.lidar.scan(sensing.surface, poses[i], i, misses=False), ranges)


def _caster(shared: Shared, is_tilted: bool) -> Solver:
    sensing = shared.sensing
    cast = getattr(sensing.surface, "cast_rays", None)
    if cast is None:
        raise Unavailable("this ltp has no HeightSurface.cast_rays")
    rays = sensing.directions(is_tilted)
    origins = [np.tile(position, (len(rays), 1)) for position in sensing.positions]
    return Solver(
        lambda i: cast(origins[i], rays, MAX_RANGE), lambda ranges: finite(ranges, MAX_RANGE)
    )


def _enter(work: Work, is_tilted: bool, judge: Judge) -> None:
    """The peers, each over the best mesh of the surface and over the one that a raster gives."""

    def peer(scene: Callable[[Triangles], Cast], label: str) -> Callable[[Shared], Solver]:
        def prepare(shared: Shared) -> Solver:
            sensing = shared.sensing
            boxes = label == "boxes"
            cast = scene(box_mesh(sensing.boxes, EDGE) if boxes else raster_mesh(sensing.heights))
            rays = sensing.directions(is_tilted).astype(np.float32)
            return Solver(
                lambda i: cast(sensing.positions[i], rays), lambda found: finite(found, MAX_RANGE)
            )

        return prepare

    for label in ("boxes", "raster"):
        embreex = peer(lambda mesh: ray_peers.embreex_scene(mesh, MAX_RANGE), label)
        work.enter(f"embreex, mesh of the {label}", "embreex", judge)(embreex)
        open3d = peer(ray_peers.open3d_scene, label)
        work.enter(f"Open3D, mesh of the {label}", "open3d", judge)(open3d)


level.enter("ltp Lidar.scan")(lambda shared: _scanner(shared, {}))
level.enter("ltp cast_rays", judge=_returns)(lambda shared: _caster(shared, False))
_enter(level, False, _returns)
tilted.enter("ltp cast_rays")(lambda shared: _caster(shared, True))
tilted.enter("ltp Lidar.scan", judge=_returns)(lambda shared: _scanner(shared, TILT))
_enter(tilted, True, _ALL_RAYS)
