# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How far what was flown is from the global path: the paper's first criterion."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp.sim.record import FlightRecord

_CHUNK = 1_000_000  # pairs of a point and a segment at once: bounds the memory


@dataclass(frozen=True)
class OffPath:
    """Horizontal distance of a flown path from its global path [m]."""

    mean: float  # weighted by the length flown
    largest: float


def off_path(record: FlightRecord) -> OffPath:
    """The distance of a flight's positions from its global path.

    The mean is over the length flown, not over time: a UAV that hovers adds nothing. Along a move
    the distance counts as the mean of those at its two ends. A flight that never moved is as far
    off as it stood.
    """
    away = distances_to_path(record.positions, record.global_path)
    moves = np.linalg.norm(np.diff(record.positions, axis=0), axis=1)
    if not moves.sum() > 0.0:
        return OffPath(float(away.mean()), float(away.max()))
    mean = np.average(0.5 * (away[1:] + away[:-1]), weights=moves)
    return OffPath(float(mean), float(away.max()))


def distances_to_path(points: ArrayLike, path: ArrayLike) -> NDArray[np.float64]:
    """The horizontal distance of each point from the nearest point of a polyline, (n,) [m].

    Args:
        points: (n, 2) or (n, 3) [m]; heights do not count.
        path: (m, 2) or (m, 3), m >= 1 [m].
    """
    at = np.asarray(points, dtype=np.float64)[:, :2]
    corners = np.asarray(path, dtype=np.float64)[:, :2]
    if len(corners) == 1:
        corners = np.repeat(corners, 2, axis=0)
    chunk = max(1, _CHUNK // len(corners))
    parts = [_nearest(at[i : i + chunk], corners) for i in range(0, len(at), chunk)]
    return np.concatenate([np.empty(0), *parts])


def _nearest(points: NDArray[np.float64], corners: NDArray[np.float64]) -> NDArray[np.float64]:
    begins, ways = corners[:-1], np.diff(corners, axis=0)  # (m - 1, 2)
    offsets = points[:, None] - begins  # (n, m - 1, 2)
    squared = np.square(ways).sum(axis=1)
    along = np.einsum("nmi,mi->nm", offsets, ways) / np.where(squared > 0.0, squared, 1.0)
    feet = np.clip(along, 0.0, 1.0)[..., None] * ways
    return np.asarray(np.sqrt(np.square(offsets - feet).sum(axis=2).min(axis=1)))
