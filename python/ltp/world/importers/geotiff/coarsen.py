# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fewer, larger cells that stay on the safe side of what stood in the small ones."""

import numpy as np
from numpy.typing import NDArray

from ltp.world.classes import LandClass


def coarsen(
    ground: NDArray[np.float64],
    surface: NDArray[np.float64],
    classes: NDArray[np.uint8],
    factor: int,
    unknown: NDArray[np.bool_] | None = None,
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.uint8]]:
    """Join `factor` x `factor` cells (nx, ny) into one.

    The ground is the mean, the surface the highest, the class the commonest (a tie goes to the
    larger number: buildings and trees before paved ground), but UNKNOWN where that is open ground
    and any cell lies in a hole (`unknown`). Blocks start in the south-west corner;
    cells that fill no whole block in the north and east are dropped.

    Raises:
        ValueError: if not one whole block fits.
    """
    nx, ny = ground.shape[0] // factor, ground.shape[1] // factor
    if nx == 0 or ny == 0:
        raise ValueError(f"factor must leave at least one cell of {ground.shape}, not {factor}")

    def blocks(array: NDArray[np.generic]) -> NDArray[np.generic]:
        part = array[: nx * factor, : ny * factor].reshape(nx, factor, ny, factor)
        return part.transpose(0, 2, 1, 3).reshape(nx, ny, -1)

    kinds = blocks(classes)
    best = np.zeros((nx, ny), dtype=np.intp)
    winner = np.zeros((nx, ny), dtype=np.uint8)
    for kind in np.unique(classes):
        count = np.count_nonzero(kinds == kind, axis=2)
        wins = count >= best
        best[wins], winner[wins] = count[wins], kind
    if unknown is not None:
        solid = np.isin(winner, (LandClass.BUILDING, LandClass.TREES))
        winner[blocks(unknown).any(axis=2) & ~solid] = LandClass.UNKNOWN
    coarse_ground = np.asarray(blocks(ground).astype(np.float64).mean(axis=2))
    coarse_surface = np.asarray(blocks(surface).astype(np.float64).max(axis=2))
    return coarse_ground, np.maximum(coarse_surface, coarse_ground), winner
