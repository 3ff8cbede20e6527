# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The measurements behind `scale`: each function makes one point of a series, in a new process."""

import functools
import statistics
import time
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

import ltp
from ltp import (
    GridFrame,
    HeightSurface,
    Lidar,
    LocalTrajectoryPlanner,
    MissionConfig,
    ObstacleMap,
    ObstacleMapOptions,
    OccupancyGrid,
    PenaltyWeights,
    Pose,
    Query,
    Raster,
    Scene,
    World,
    make_planner,
)
from ltp.world import priority_map
from ltp.world.city import make_city

from .memory import peak, resident
from .workload import SEED, lidar_options

Row = dict[str, Any]
Dims = tuple[int, int, int]
_Point = NDArray[np.float64]  # (3,)

_CORNER = np.array([300.0, 300.0, 0.0])  # of the window, in the middle of the city [m]
_EXTENT = np.array([400.0, 400.0, 160.0])  # of the window [m]
_ALTITUDE = 50.0  # [m]
_STEP = np.array([0.3, 0.0, 0.0])  # of a flight, from scan to scan [m]
_PATH = np.array([300.0, 400.0, 0.0])  # from start to end of a global path [m]


def cells(dims: Dims, queries: int) -> Row:
    """Plans, distance field and snapshot of a window of so many cells."""
    world = make_city(seed=1)
    frame = GridFrame(_CORNER, _EXTENT / dims, dims)
    surface = HeightSurface(world.surface_raster())
    priority = priority_map(world, "binary", altitude=_ALTITUDE)
    before = resident()
    grid = surface.occupancy(frame)
    planner = make_planner("auto")
    scene = Scene(grid, priority)
    times, found = [], 0
    for start, goal in _queries(grid, queries):
        begin = time.process_time()
        plan = planner.plan(scene, Query(start, goal))
        times.append((time.process_time() - begin) * 1e3)
        found += plan.status.name == "FOUND"
    planned = (peak() - before) / 1e6
    shortest = make_planner("auto", weights=PenaltyWeights(length=1.0, priority=0.0))
    nowhere = Scene(grid, Raster(np.zeros((1, 1))))
    lengths = [
        _ms(functools.partial(shortest.plan, nowhere, Query(*ends)))
        for ends in _queries(grid, queries)
    ]
    row = {
        "dims": list(dims),
        "cells": int(np.prod(dims)),
        "plan_median_ms": statistics.median(times),
        "plan_worst_ms": max(times),
        "shortest_median_ms": statistics.median(lengths),
        "plans_found": found,
        "times_ms": times,
        "memory_mb": planned,
    }
    field = getattr(ltp, "distance_field", None)
    if field is not None:
        row["field_ms"] = _ms(lambda: field(grid, _queries(grid, 1)[0][0]))
    return row


def sensing(rows: int, azimuths: int, max_range: float) -> Row:
    """Scan and map update along 100 m of a flight."""
    world = make_city(seed=1)
    surface = HeightSurface(world.surface_raster())
    lidar = Lidar(lidar_options(rows, azimuths, max_range))
    start = _street(world)
    built = ObstacleMap(ObstacleMapOptions(max_range=max_range), start)
    scan_ms, map_ms, hits = [], [], 0
    for step in range(50):
        position = start + step * _STEP
        begin = time.process_time()
        scan = lidar.scan(surface, Pose(position), step)
        scanned = time.process_time()
        built.recentre(position)
        built.insert(scan.origin, scan.hits)
        mapped = time.process_time()
        scan_ms.append((scanned - begin) * 1e3)
        map_ms.append((mapped - scanned) * 1e3)
        hits += len(scan.hits)
    return {
        "range_m": max_range,
        "rays": rows * azimuths,
        "returns": hits // 50,
        "scan_ms": statistics.median(scan_ms),
        "map_ms": statistics.median(map_ms),
    }


def waypoints(count: int) -> Row:
    """Taking a global path of so many waypoints over, and one decision on it."""
    world = make_city(seed=1)
    start = _street(world)
    path = np.linspace(start, start + _PATH, count + 1)[1:]
    planner = LocalTrajectoryPlanner(Raster(np.zeros((1, 1))), start)
    taken = _ms(lambda: planner.set_waypoints(np.ascontiguousarray(path)), 9)
    begin = time.process_time()
    planner.update(start)
    decided = (time.process_time() - begin) * 1e3
    again = _ms(lambda: planner.update(start), 9)
    return {"waypoints": count, "set_ms": taken, "first_update_ms": decided, "update_ms": again}


def memory() -> Row:
    """What the whole LTP at the paper's size adds to a process that has everything loaded."""
    world = make_city(seed=1)
    surface = HeightSurface(world.surface_raster())
    config = MissionConfig(lidar=lidar_options())
    lidar = Lidar(config.lidar)
    start = _street(world)
    priority = priority_map(world, "binary", altitude=_ALTITUDE)
    scans = [lidar.scan(surface, Pose(start + i * _STEP), i) for i in range(20)]
    before = resident()
    planner = LocalTrajectoryPlanner(
        priority,
        start,
        planner=config.planner,
        planner_options=config.planner_options,
        map_options=config.mapping,
        options=config.navigation,
    )
    planner.set_waypoints(start + np.array([[100.0, 50.0, 0.0], [150.0, 75.0, 0.0]]))
    for scan in scans:
        planner.sense(scan.origin, scan.hits)
        planner.update(scan.origin)
    return {"memory_mb": (peak() - before) / 1e6}


def _queries(grid: OccupancyGrid, count: int) -> list[tuple[_Point, _Point]]:
    """Pairs of free points, 100 m to 200 m apart at 50 m, the same for every cell size."""
    rng = np.random.default_rng(SEED)
    pairs: list[tuple[_Point, _Point]] = []
    while len(pairs) < count:
        ends = _CORNER + rng.uniform(0.02, 0.98, (2, 3)) * _EXTENT
        ends[:, 2] = _ALTITUDE
        apart = float(np.linalg.norm(ends[1] - ends[0]))
        if 100.0 <= apart <= 200.0 and not grid.blocked_at(ends).any():
            pairs.append((ends[0], ends[1]))
    return pairs


def _street(world: World) -> _Point:
    """A point at 30 m with 20 m of free way to the east and the highest city round it."""
    best, highest = (0, 0), -1.0
    for x, y in np.ndindex(20, 20):
        i, j = 300 + 20 * x, 300 + 20 * y
        round_it = float(world.surface[i - 40 : i + 40, j - 40 : j + 40].mean())
        if round_it > highest and world.surface[i : i + 20, j].max() < 10.0:
            best, highest = (i, j), round_it
    return np.array([best[0] + 0.5, best[1] + 0.5, 30.0])


def _ms(call: Callable[[], Any], repeats: int = 3) -> float:
    """Median CPU time of some calls [ms]."""
    times = []
    for _ in range(repeats):
        begin = time.process_time()
        call()
        times.append((time.process_time() - begin) * 1e3)
    return statistics.median(times)
