# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The whole flight: 500 m over the built-in city, every scan of 65,536 rays, all of it in Python.

ltp flies it: senses, maps, plans and follows its path. The peers only sense and map, at a sample of
the positions that ltp came through; their time is extrapolated to as many scans.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ltp import (
    HeightSurface,
    Lidar,
    MissionConfig,
    ObstacleMap,
    ObstacleMapOptions,
    Pose,
    World,
    fly,
)
from ltp.evaluation.scenarios import ScenarioOptions, make_scenario
from ltp.world.city import make_city

from ..mesh import raster_mesh
from ..workload import MAX_RANGE, lidar_options
from . import ray_peers

NAME, TITLE = "flight", "a whole 500 m flight, 1,667 scans of 65,536 rays"
SCANS = 1667  # 500 m at 3 m/s and 10 Hz
_INTO_THE_WALL = 1e-3  # a point on a face may be rounded to either side [m]

Row = dict[str, Any]


@dataclass(frozen=True)
class Flown:
    """Our flight, for those who sense and map along it."""

    world: World
    positions: NDArray[np.float64]  # (scans, 3)


def fly_ours(length: float = 500.0) -> tuple[Row, Flown]:
    """Fly; CPU seconds for everything after the world was made, as for 1,667 scans."""
    world = make_city(seed=1)
    path = make_scenario(world, ScenarioOptions(length=length), 0).global_path
    config = MissionConfig(lidar=lidar_options(azimuths=1024))
    begin = time.process_time()
    record = fly(world, config, path)
    seconds = time.process_time() - begin
    scans = len(record.times)
    note = (
        f"{record.outcome.value}: {record.length:.0f} m flown, {scans} scans, "
        f"{len(record.plans)} plans, {seconds:.2f} s in all"
    )
    row = _row("ltp, sense, map, plan and fly", "ltp", seconds * SCANS / scans, note)
    return row, Flown(world, record.positions)


def sense_and_map(flown: Flown, name: str, sample: int) -> Row:
    """The peers' part: "Open3D" or "embreex" for the rays, pyoctomap for the map."""
    import pyoctomap

    package, make = _CASTERS[name]
    cast = make(raster_mesh(flown.world.surface, flown.world.cell))
    lidar = Lidar(lidar_options())
    rays = lidar.directions.astype(np.float32)
    chosen = np.linspace(0, len(flown.positions) - 1, sample).astype(int)
    tree = pyoctomap.OcTree(2.0)
    cast(flown.positions[0], rays)  # builds what it searches
    seconds = 0.0
    for position in flown.positions[chosen]:
        begin = time.process_time()
        ranges = cast(position, rays)
        hit = ranges < MAX_RANGE
        hits = position + (ranges[hit, None].astype(np.float64) + _INTO_THE_WALL) * rays[hit]
        tree.updateNodes(hits, True)
        seconds += time.process_time() - begin
    row = _row(f"{name} + pyoctomap, sense and map", package, seconds * SCANS / sample)
    row["agreement"] = _agreement(flown, lidar, chosen, tree)
    row["note"] = f"extrapolated from {sample} scans; building the mesh is not counted"
    return row


def _row(name: str, package: str, seconds: float, note: str = "") -> Row:
    return {
        "work": NAME,
        "name": name,
        "package": package,
        "unit": "s",
        "median": seconds,
        "questions": 1,
        "note": note,
    }


def _agreement(flown: Flown, lidar: Lidar, chosen: NDArray[np.int64], tree: Any) -> str:
    """Our voxels after the same scans that are occupied in the tree too."""
    surface = HeightSurface(flown.world.surface_raster())
    corner, far = np.reshape(flown.world.extent, (2, 2))
    dims = [int(edge // 2.0) for edge in far - corner] + [40]
    options = ObstacleMapOptions(dims=dims, max_range=2.0 * MAX_RANGE)
    built = ObstacleMap(options, (*(corner + far) / 2.0, 80.0))
    for position in flown.positions[chosen]:
        scan = lidar.scan(surface, Pose(position))
        built.insert(scan.origin, scan.hits)
    frame = built.voxels.frame
    occupied = frame.origin + (np.argwhere(built.voxels.to_array()) + 0.5) * frame.cell
    share = float(np.mean(np.asarray(tree.getLabels(occupied)) == 1))
    return f"{share:.2%} of our {len(occupied)} voxels"


_CASTERS: dict[str, tuple[str, Callable[[NDArray[np.float32]], ray_peers.Cast]]] = {
    "Open3D": ("open3d", ray_peers.open3d_scene),
    "embreex": ("embreex", lambda triangles: ray_peers.embreex_scene(triangles, MAX_RANGE)),
}
