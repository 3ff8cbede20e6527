# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How steep and how rough the surface is under a landing gear, whatever the size of its cells.

Slope and roughness are those of hazard detection: fit a plane to the footprint by least squares;
its inclination is the slope, the largest distance from it the roughness (S. Scherer, L. Chamberlain
and S. Singh, "Autonomous landing at unprepared sites by a full-scale helicopter", Robotics and
Autonomous Systems 60 (12), 2012, section on coarse evaluation).
"""

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

_MOST_CELLS_ACROSS = 512  # of a footprint: its every cell is looked at for every cell of the map
_BLOCK = 1 << 15  # cells worked on at a time: what they need stays in the processor's cache


class Flatness(NamedTuple):
    """Of each cell's footprint, (nx, ny)."""

    slope: NDArray[np.float64]  # of the plane that fits best, from the horizontal [deg]
    roughness: NDArray[np.float64]  # largest distance from that plane, along the vertical [m]


def flatness(surface: NDArray[np.float64], cell: float, radius: float) -> Flatness:
    """Slope and roughness of the surface under a disc round the middle of each cell.

    The disc covers the cells whose middles lie in it, and never less than the 3 x 3 cells round its
    own: a plane has the same slope and no roughness at any size of the cells. What lies beyond the
    border does not count.

    Args:
        surface: heights (nx, ny), finite [m].
        cell: edge of a cell [m].
        radius: of the disc [m].

    Raises:
        ValueError: if the disc is more than 512 cells wide.
    """
    reach = max(1, math.floor(radius / cell + 1e-9))
    if 2 * reach + 1 > _MOST_CELLS_ACROSS:
        raise ValueError(
            f"gear_radius must be at most {_MOST_CELLS_ACROSS // 2} cells of {cell:g} m, "
            f"not {radius:g} m"
        )
    steps = np.arange(-reach, reach + 1)
    inside = np.add.outer(steps**2, steps**2) * cell**2 <= radius**2 * (1.0 + 1e-9)
    inside |= np.maximum.outer(abs(steps), abs(steps)) <= 1
    half = (inside.sum(axis=0) - 1) // 2  # cells to each side, by the distance from the middle row
    middle = float(surface.mean())  # of large heights little is lost by summing what differs
    padded = np.pad(surface - middle, reach, mode="edge")
    # A whole footprint is symmetric: the sums of dx, dy and dx dy over it vanish, and the normal
    # equations fall apart into one for the height and one for each slope.
    moment = float((half * 2 + 1) @ steps**2)
    mean = _column_sums(padded, half, np.ones(len(steps))) / inside.sum()
    step_x = _column_sums(padded, half, steps) / moment
    step_y = _column_sums(padded.T, half, steps).T / moment
    found = Flatness(_slope(step_x, step_y, cell), _farthest(padded, mean, step_x, step_y, half))
    _mend_border(found, surface - middle, cell, np.argwhere(inside) - reach)
    return found


def _slope(
    step_x: NDArray[np.float64], step_y: NDArray[np.float64], cell: float
) -> NDArray[np.float64]:
    """Of planes that rise by so much a cell [deg]."""
    return np.asarray(np.degrees(np.arctan(np.hypot(step_x, step_y) / cell)))


def _mend_border(
    found: Flatness, surface: NDArray[np.float64], cell: float, offsets: NDArray[np.int64]
) -> None:
    """Do the cells over whose footprints the border runs, by the cells (n, 2) that are there."""
    reach = int(offsets.max())
    at_border = np.ones(surface.shape, dtype=bool)
    at_border[reach:-reach, reach:-reach] = False
    powers = np.column_stack((np.ones(len(offsets)), offsets))
    products = powers[:, :, None] * powers[:, None, :]
    cells = np.argwhere(at_border)
    for part in np.array_split(cells, 1 + cells.size * len(offsets) // (16 * _BLOCK)):
        around = part[:, None, :] + offsets
        there = ((around >= 0) & (around < surface.shape)).all(axis=2)
        around = np.clip(around, 0, np.array(surface.shape) - 1)
        rise = surface[around[..., 0], around[..., 1]] - surface[part[:, 0], part[:, 1], None]
        normal = np.tensordot(there.astype(np.float64), products, axes=1)
        for axis, length in enumerate(surface.shape, 1):
            if length == 1:  # nothing is known of the slope along it
                normal[:, axis, axis] = 1.0
        plane = np.asarray(np.linalg.solve(normal, ((rise * there) @ powers)[..., None]))[..., 0]
        rest = np.abs(rise - plane @ powers.T) * there
        where = (part[:, 0], part[:, 1])
        found.slope[where] = _slope(plane[:, 1], plane[:, 2], cell)
        found.roughness[where] = rest.max(axis=1)


def _column_sums(
    padded: NDArray[np.float64], half: NDArray[np.int64], weights: NDArray[np.generic]
) -> NDArray[np.float64]:
    """Sum over each footprint, its columns dx weighted by `weights`."""
    reach = len(half) // 2
    nx, ny = padded.shape[0] - 2 * reach, padded.shape[1] - 2 * reach
    below = np.zeros((padded.shape[0], padded.shape[1] + 1))
    np.cumsum(padded, axis=1, out=below[:, 1:])
    total = np.zeros((nx, ny))
    for column, (side, weight) in enumerate(zip(half, weights, strict=True)):
        if weight != 0:
            rows = below[column : column + nx]
            first, last = reach - side, reach + side + 1
            total += weight * (rows[:, last : last + ny] - rows[:, first : first + ny])
    return total


def _farthest(
    padded: NDArray[np.float64],
    mean: NDArray[np.float64],
    step_x: NDArray[np.float64],
    step_y: NDArray[np.float64],
    half: NDArray[np.int64],
) -> NDArray[np.float64]:
    """Largest distance of each footprint's cells from its plane, that rises by `step_x` a cell."""
    reach, (nx, ny) = len(half) // 2, mean.shape
    farthest = np.zeros((nx, ny))
    tall = max(1, _BLOCK // ny)
    for start in range(0, nx, tall):
        rows = slice(start, min(nx, start + tall))
        high, low = np.zeros_like(mean[rows]), np.zeros_like(mean[rows])
        rest = np.empty_like(high)
        for column, side in enumerate(half):
            there = padded[start + column : rows.stop + column]
            plane = mean[rows] + (column - reach) * step_x[rows] - side * step_y[rows]
            for row in range(reach - side, reach + side + 1):
                np.subtract(there[:, row : row + ny], plane, out=rest)
                np.maximum(high, rest, out=high)
                np.minimum(low, rest, out=low)
                plane += step_y[rows]
        np.maximum(high, -low, out=farthest[rows])
    return farthest
