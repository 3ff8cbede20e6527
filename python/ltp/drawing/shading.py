# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sunlight on a height raster, for pictures: shaded slopes and cast shadows."""

import math

import numpy as np
from numpy.typing import NDArray

_SUN_ELEVATION = math.radians(42.0)
_LONGEST_SHADOW = 250  # cells along the diagonal


def sunlight(surface: NDArray[np.float64], cell: float) -> NDArray[np.float64]:
    """Brightness of each cell under a sun in the north-west.

    Args:
        surface: heights [ix, iy], x east, y north [m].
        cell: edge of a cell [m].

    Returns:
        (nx, ny), about 1 on level sunlit ground, less on slopes turned away and in shadows.
    """
    if min(surface.shape) < 2:
        return np.ones_like(surface)
    east, north = np.gradient(surface, cell)
    steepest = np.hypot(east, north)
    soften = 1.0 / (1.0 + 0.35 * steepest)  # walls would be black and white otherwise
    light = math.cos(_SUN_ELEVATION) * math.sqrt(0.5)
    facing = math.sin(_SUN_ELEVATION) + light * (east - north) * soften  # sun at (-1, 1)
    facing /= np.sqrt(1.0 + (steepest * soften) ** 2) * math.sin(_SUN_ELEVATION)
    lit = np.where(_shadowed(surface, cell), 0.62, 1.0)
    return np.asarray(np.clip(facing, 0.35, 1.25) * lit)


def _shadowed(surface: NDArray[np.float64], cell: float) -> NDArray[np.bool_]:
    """Whether something to the north-west hides the sun from a cell, stepping cell by cell."""
    fall = math.sqrt(2.0) * cell * math.tan(_SUN_ELEVATION)
    reach = min(_LONGEST_SHADOW, *(n - 1 for n in surface.shape))
    reach = min(reach, math.ceil((surface.max() - surface.min()) / fall))
    shadow = np.zeros(surface.shape, dtype=np.bool_)
    for step in range(1, reach + 1):
        shadow[step:, :-step] |= surface[:-step, step:] - step * fall > surface[step:, :-step]
    return shadow
