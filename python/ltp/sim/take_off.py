# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whether a mission's start lies high enough above the ground to get away from it."""

import math

import numpy as np
from numpy.typing import NDArray

from ltp.config import MissionConfig
from ltp.world import World

_HIT_DEPTH = 1e-3  # a LiDAR's hit lies so far inside the ground [m]


def check_take_off(world: World, config: MissionConfig, path: NDArray[np.float64]) -> None:
    """Refuse a start whose cell the ground will block as soon as it is seen.

    Where the band of altitudes leaves a free cell above open, the UAV climbs to it: not refused.

    Raises:
        ValueError: naming the altitude and the least one that works.
    """
    x, y, altitude = (float(value) for value in path[0])
    ground = float(world.ground_raster().at(x, y))
    if not math.isfinite(ground) or not _over(world, x, y):
        return
    height = float(config.mapping.cell[2])
    radius = config.mapping.inflation_radius + config.mapping.margin
    # Levels are counted from the datum; inflation blocks every cell that comes within its radius.
    whole = config.mapping.inflate_whole_cells
    source = height if whole else float(min(config.mapping.cell))
    top = math.floor((ground - _HIT_DEPTH) / source) + _reach(radius, source)
    least = (math.floor(top * source / height + 1e-9) + 1) * height
    first = float(path[1, 2])
    ceiling = max(altitude, first) + config.navigation.band_from(altitude, first)[1]
    if altitude < least and ceiling < least:
        raise ValueError(
            f"global_path[0]: the start's altitude is {altitude:g} m, {altitude - ground:g} m "
            f"above the ground, in a cell that the ground blocks (cells {height:g} m high, "
            f"inflation radius and margin {radius:g} m): expected at least {least:g} m, "
            f"{least - ground:g} m above the ground, or a smaller mapping.cell"
        )


def _over(world: World, x: float, y: float) -> bool:
    west, south, east, north = world.extent
    return west <= x < east and south <= y < north


def _reach(radius: float, height: float) -> int:
    """How many levels of `height` above an occupied one inflation blocks: those within reach."""
    return 0 if radius == 0.0 else 1 + math.floor(radius / height)
