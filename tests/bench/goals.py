# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The one table of goals: what ltp does, beside whom, and how many times better it is to be.

Names are looked up here and nowhere else: those of Google Benchmark, and `work`, `name` of `peers`.
"""

from .results import figure
from .scoring import Goal, cpp, python, scale

_RAYS = "rays_per_second"

GOALS: tuple[Goal, ...] = (
    Goal(
        "shortest path, one query",
        python("shortest", "ltp auto"),
        (python("shortest", "dijkstra3d A*"), python("shortest", "dijkstra3d A*, our graph")),
        factor=100,
    ),
    Goal(
        "Dijkstra, one query",
        python("dijkstra", "ltp lp-dijkstra"),
        (python("dijkstra", "dijkstra3d"), python("dijkstra", "dijkstra3d, our graph")),
        factor=7,
    ),
    Goal(
        "distance field, 1.6 M cells",
        python("distance_field", "ltp"),
        (python("distance_field", "dijkstra3d"), python("distance_field", "dijkstra3d, our graph")),
        factor=5,
    ),
    Goal(
        "GGWP, one query",
        cpp("ltp", "ggwp/ltp", each="a_query"),
        (cpp("scalar wave", "ggwp/scalar_wave", each="a_query"),),
        factor=8,
    ),
    Goal(
        "proof that a goal is unreachable",
        python("unreachable", "ltp auto"),
        (python("unreachable", "dijkstra3d A*"), python("unreachable", "tcod A*")),
        factor=50,
    ),
    Goal(
        "LiDAR, level, rays (C++)",
        cpp("ltp", "lidar/level/ltp", _RAYS),
        (
            cpp("Embree packets, boxes", "lidar/level/embree_box", _RAYS),
            cpp("Embree packets, raster", "lidar/level/embree_raster", _RAYS),
        ),
        factor=1.5,
    ),
    Goal(
        "LiDAR, level, rays (Python)",
        python("lidar_level", "ltp Lidar.scan"),
        (
            python("lidar_level", "embreex, mesh of the boxes"),
            python("lidar_level", "embreex, mesh of the raster"),
        ),
        factor=10,
    ),
    Goal(
        "LiDAR, any attitude, rays (Python)",
        python("lidar_tilted", "ltp Lidar.scan"),
        (
            python("lidar_tilted", "embreex, mesh of the boxes"),
            python("lidar_tilted", "embreex, mesh of the raster"),
        ),
        factor=3,
    ),
    *(
        Goal(
            f"LiDAR over voxels, {attitude}, rays (C++)",
            cpp("ltp", f"voxels/{attitude}/ltp", _RAYS),
            (
                cpp("OctoMap castRay", f"voxels/{attitude}/octomap", _RAYS),
                cpp("Embree packets, the voxels' faces", f"voxels/{attitude}/embree", _RAYS),
            ),
            factor=2,
            limit=figure(10.0, "M rays/s"),
        )
        for attitude in ("level", "tilted")
    ),
    Goal(
        "map update per scan, endpoints",
        cpp("ltp", "map_insert/ltp"),
        (cpp("OctoMap", "map_insert/octomap"),),
        factor=5,
    ),
    Goal(
        "the same, beside a sparse grid",
        cpp("ltp", "map_insert/ltp"),
        (cpp("OpenVDB", "map_insert/openvdb"),),
        factor=1,
    ),
    Goal(
        "map update per scan, endpoints (Python)",
        python("map_update", "ltp ObstacleMap"),
        (
            python("map_update", "pyoctomap updateNodes"),
            python("map_update", "octomap-python updateNodes"),
        ),
        factor=5,
    ),
    Goal(
        "map update per scan, carving",
        cpp("ltp", "map_carve/ltp"),
        (cpp("OctoMap", "map_carve/octomap"),),
        factor=10,
    ),
    Goal(
        "point query, random",
        cpp("ltp", "point_query/random/ltp", each="a_point"),
        (cpp("OctoMap", "point_query/random/octomap", each="a_point"),),
        factor=5,
    ),
    Goal(
        "point query, along a segment",
        cpp("ltp", "point_query/segment/ltp", each="a_point"),
        (cpp("OctoMap", "point_query/segment/octomap", each="a_point"),),
        factor=5,
    ),
    Goal(
        "point query from numpy",
        python("point_query", "ltp blocked_at"),
        (python("point_query", "pyoctomap getLabels"),),
        limit=figure(5.0, "ns"),
    ),
    *(
        Goal(
            f"roll by one cell along {axis}",
            cpp("ltp", f"roll/{axis}/ltp"),
            (cpp("memmove, the floor", "roll/floor_memmove"),),
            limit=figure(rog_map / 10.0, "us"),
        )
        for axis, rog_map in (("x", 75.0), ("y", 107.0), ("z", 590.0))  # what ROG-Map takes [us]
    ),
    Goal(
        "inflate by 4 m, a new cell",
        cpp("ltp", "inflate/cell/ltp", each="a_cell"),
        limit=figure(100.0, "ns"),
    ),
    Goal("inflate by 4 m, the window", cpp("ltp", "inflate/window/ltp"), limit=figure(0.25, "ms")),
    Goal(
        "inflate by 4 m, the window (Python)",
        python("inflate", "ltp inflate"),
        (python("inflate", "scipy binary_dilation"),),
        factor=10,
    ),
    Goal(
        "a whole 500 m flight",
        python("flight", "ltp, sense, map, plan and fly"),
        (
            python("flight", "Open3D + pyoctomap, sense and map"),
            python("flight", "embreex + pyoctomap, sense and map"),
        ),
        limit=figure(2.0, "s"),
    ),
    Goal("12.8 M cells, median plan", scale("plan_12.8M_median"), limit=figure(100.0, "ms")),
    Goal("12.8 M cells, worst plan", scale("plan_12.8M_worst"), limit=figure(100.0, "ms")),
    Goal("memory of the whole LTP", scale("memory"), limit=figure(32.0, "MB")),
)
