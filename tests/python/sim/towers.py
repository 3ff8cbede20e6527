# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A small world with a tower, quick flights over it, and whether two of them are the same."""

import numpy as np

import ltp
from ltp.world import LandClass, World


def make_world(*boxes: tuple[int, int, int, int, float], size: int = 160) -> World:
    """Flat grass with buildings (x0, x1, y0, y1, height)."""
    surface = np.zeros((size, size))
    for x0, x1, y0, y1, height in boxes:
        surface[x0:x1, y0:y1] = height
    classes = np.where(surface > 0, LandClass.BUILDING, LandClass.GRASS).astype(np.uint8)
    return World("test", np.zeros_like(surface), surface, classes, cell=1.0)


TOWER = (70, 90, 40, 100, 60.0)

START = np.array([30.0, 70.0, 30.0])


def config(**values) -> ltp.MissionConfig:
    settings = ltp.MissionConfig(**values)
    settings.mapping.dims = [80, 80, 20]
    settings.lidar.pattern.azimuths, settings.lidar.pattern.rows = 120, 16
    return settings


def path(*points: tuple[float, float]) -> np.ndarray:
    return np.array([(x, y, 30.0) for x, y in points])


def same(one: ltp.FlightRecord, other: ltp.FlightRecord) -> bool:
    """Whether two records hold the same, to the last bit, but for wall times."""
    for name in ("times", "positions", "velocities", "plan_index", "waypoint_index", "global_path"):
        if getattr(one, name).tobytes() != getattr(other, name).tobytes():
            return False
    plans = [
        [(p.path.tobytes(), {**vars(p), "path": 0, "seconds": 0}) for p in record.plans]
        for record in (one, other)
    ]
    rest = [
        {k: v for k, v in vars(record).items() if not isinstance(v, np.ndarray | list)}
        | {"waypoints": record.waypoints, "config": record.config.to_toml()}
        for record in (one, other)
    ]
    return plans[0] == plans[1] and rest[0] == rest[1]
