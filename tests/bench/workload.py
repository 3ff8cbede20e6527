# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The seeded work that everybody is given: two maps, their queries, a raster and its rays."""

import hashlib
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from ltp import (
    GridFrame,
    HeightSurface,
    Lidar,
    LidarOptions,
    LidarPattern,
    OccupancyGrid,
    Pose,
    Raster,
    Scan,
)

SEED = 20240611
CELL = (2.0, 2.0, 4.0)  # [m]
DIMS = (200, 200, 40)
BOXES = 85
LEVEL = 12  # z index of starts and goals: about 50 m
PAIRS = 50
NEAREST, FARTHEST = 104.0, 199.0  # between start and goal [m]

EDGE = 1000  # of the height raster [m]
ALTITUDE = 50.0  # of the scans above it [m]
MAX_RANGE = 50.0  # of a ray [m]
POSES = 34  # along 500 m
TILT = {"roll": 0.15, "pitch": -0.1}  # of the sensor that is not level [rad]

Pairs = NDArray[np.int64]  # (n, 2, 3): start and goal cells
Points = NDArray[np.float64]  # (n, 3)


@dataclass(frozen=True, eq=False)
class Town:
    """85 boxes on a ground layer, filled (`solid`) or as shells of one cell (`hollow`)."""

    solid: NDArray[np.bool_]  # DIMS, True: blocked
    hollow: NDArray[np.bool_]  # DIMS
    pairs: Pairs  # free start, free goal, a building on the line between them
    sealed: Pairs  # free start, goal inside a building of `hollow`: no path exists

    @property
    def frame(self) -> GridFrame:
        """Where the maps lie: their lowest corner is the world's origin."""
        return GridFrame((0.0, 0.0, 0.0), CELL, DIMS)

    @cached_property
    def solid_grid(self) -> OccupancyGrid:
        """`solid` as ltp has it."""
        return OccupancyGrid.from_array(self.solid, self.frame)

    @cached_property
    def hollow_grid(self) -> OccupancyGrid:
        """`hollow` as ltp has it."""
        return OccupancyGrid.from_array(self.hollow, self.frame)

    def digest(self) -> str:
        """A hash of all of it."""
        parts = (self.solid, self.hollow, self.pairs, self.sealed)
        return hashlib.sha1(b"".join(part.tobytes() for part in parts)).hexdigest()


def centres(cells: NDArray[np.int64]) -> Points:
    """The middle of cells (..., 3) [m]."""
    return np.asarray((cells + 0.5) * np.array(CELL))


def make_town() -> Town:
    """The town of the planning rows; the same for every call."""
    rng = np.random.default_rng(SEED)
    solid = np.zeros(DIMS, dtype=bool)
    hollow = np.zeros(DIMS, dtype=bool)
    solid[:, :, 0] = hollow[:, :, 0] = True
    for _ in range(BOXES):
        width, depth = rng.integers(7, 21, size=2)
        height = int(rng.integers(8, 37))
        x, y = (int(rng.integers(2, DIMS[i] - 2 - size)) for i, size in ((0, width), (1, depth)))
        box = np.s_[x : x + width, y : y + depth, :height]
        solid[box] = True
        shell = np.ones_like(hollow[box])
        shell[1:-1, 1:-1, 1:-1] = False
        hollow[box] |= shell
    pairs = _pairs(rng, solid)
    goals = np.argwhere(solid[:, :, LEVEL] & ~hollow[:, :, LEVEL])
    chosen = goals[rng.choice(len(goals), PAIRS, replace=False)]
    sealed = pairs.copy()
    sealed[:, 1, :2] = chosen
    return Town(solid, hollow, pairs, sealed)


def _pairs(rng: np.random.Generator, solid: NDArray[np.bool_]) -> Pairs:
    """Free cells at `LEVEL`, between 104 m and 199 m apart, a building on the line between them."""
    free = np.argwhere(~solid[:, :, LEVEL])
    found: list[NDArray[np.int64]] = []
    while len(found) < PAIRS:
        pair = np.full((2, 3), LEVEL, dtype=np.int64)
        pair[:, :2] = free[rng.choice(len(free), 2, replace=False)]
        start, goal = centres(pair)
        steps = np.linspace(start, goal, 200) / CELL
        blocked = solid[tuple(steps.astype(np.int64).T)].any()
        if blocked and NEAREST <= float(np.linalg.norm(goal - start)) <= FARTHEST:
            found.append(pair)
    return np.stack(found)


@dataclass(frozen=True, eq=False)
class Sensing:
    """A height raster of boxes, a LiDAR of 64 x 1024 rays, and where it scans from."""

    heights: NDArray[np.float64]  # (EDGE, EDGE) at 1 m [m]
    boxes: NDArray[np.float64]  # (n, 2, 3) lowest and highest corners: the same surface [m]
    positions: Points  # (POSES, 3), 500 m along a line 5.7 degrees off the axis

    @cached_property
    def surface(self) -> HeightSurface:
        """`heights` as ltp has it."""
        return HeightSurface(Raster(self.heights))

    @cached_property
    def lidar(self) -> Lidar:
        """The sensor."""
        return Lidar(lidar_options())

    @cached_property
    def scans(self) -> list[Scan]:
        """What the level sensor sees from each position."""
        return [
            self.lidar.scan(self.surface, Pose(position), number)
            for number, position in enumerate(self.positions)
        ]

    def directions(self, tilted: bool = False) -> Points:
        """The rays of a scan in the world (65536, 3), of unit length."""
        level = self.lidar.directions
        if not tilted:
            return level
        return np.ascontiguousarray(level @ Pose(self.positions[0], **TILT).rotation.T)

    def digest(self) -> str:
        """A hash of all of it."""
        return hashlib.sha1(self.heights.tobytes() + self.positions.tobytes()).hexdigest()


def lidar_options(
    rows: int = 64, azimuths: int = 1024, max_range: float = MAX_RANGE
) -> LidarOptions:
    """The sensor of the sensing rows: -45 to +45 degrees, all round, without noise."""
    pattern = LidarPattern(
        rows=rows, azimuths=azimuths, elevation_from_deg=-45.0, elevation_to_deg=45.0
    )
    return LidarOptions(pattern=pattern, max_range=max_range)


def make_sensing() -> Sensing:
    """The raster and flight of the sensing and mapping rows; the same for every call."""
    rng = np.random.default_rng(SEED + 1)
    along = np.linspace(0.0, 500.0, POSES)[:, None]
    line = np.array([250.0, 475.0]) + along * [np.cos(0.1), np.sin(0.1)]
    heights = np.zeros((EDGE, EDGE))
    boxes = np.zeros((761, 2, 3))
    for corners in boxes:
        width, depth = rng.integers(10, 41, size=2)
        x, y = (int(rng.integers(0, EDGE - size)) for size in (width, depth))
        height = rng.uniform(10.0, 80.0)
        near = (np.abs(line - [x + width / 2, y + depth / 2]) < [width / 2 + 9, depth / 2 + 9]).all(
            1
        )
        if near.any():  # the flight passes above
            height = min(height, ALTITUDE - 5.0)
        box = heights[x : x + width, y : y + depth]
        np.maximum(box, height, out=box)
        corners[:] = (x, y, 0.0), (x + width, y + depth, height)
    positions = np.column_stack([line, np.full(POSES, ALTITUDE)])
    return Sensing(heights, boxes, positions.round(3))  # the same for every libm
