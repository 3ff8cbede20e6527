# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Ray casters over triangles: each function gives `cast(origin, directions) -> ranges`.

Directions are (n, 3) of unit length, ranges (n,) [m], at or beyond the largest range for a miss.
"""

import importlib
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..mesh import Triangles

Cast = Callable[[NDArray[np.float64], NDArray[np.float32]], NDArray[np.float32]]


def embreex_scene(triangles: Triangles, max_range: float) -> Cast:
    """Embree through its thinnest wrapper."""
    from embreex.mesh_construction import TriangleMesh
    from embreex.rtcore_scene import EmbreeScene

    scene = EmbreeScene()
    mesh = TriangleMesh(scene, triangles)

    def cast(origin: NDArray[np.float64], rays: NDArray[np.float32]) -> NDArray[np.float32]:
        assert mesh is not None  # the scene does not keep it alive
        origins = np.tile(origin.astype(np.float32), (len(rays), 1))
        farthest = np.full(len(rays), max_range, dtype=np.float32)
        ranges: NDArray[np.float32] = scene.run(origins, rays, dists=farthest, query="DISTANCE")
        return ranges

    return cast


def open3d_scene(triangles: Triangles) -> Cast:
    """Embree through Open3D, on one thread; it knows no largest range."""
    try:
        open3d: Any = importlib.import_module("open3d")
    except (ImportError, OSError) as reason:  # wants libusb
        raise ImportError(str(reason)) from reason

    tensor = open3d.core.Tensor
    scene = open3d.t.geometry.RaycastingScene(nthreads=1)
    indices = np.arange(3 * len(triangles), dtype=np.uint32).reshape(-1, 3)
    scene.add_triangles(tensor(triangles.reshape(-1, 3)), tensor(indices))

    def cast(origin: NDArray[np.float64], rays: NDArray[np.float32]) -> NDArray[np.float32]:
        both = np.empty((len(rays), 6), dtype=np.float32)
        both[:, :3] = origin
        both[:, 3:] = rays
        answer = scene.cast_rays(tensor(both), nthreads=1)
        ranges: NDArray[np.float32] = answer["t_hit"].numpy()
        return ranges

    return cast
