# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Filling the holes of a survey: heights by interpolation, kinds of ground by their neighbours."""

import numpy as np
from numpy.typing import NDArray

from .optional import require

_PURPOSE = "filling holes in a survey"


def fill_linear(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Replace every NaN of `values` (nx, ny) by linear interpolation between the cells around it.

    Holes on the rim of the raster, where nothing lies on the far side, take the nearest value.

    Raises:
        ValueError: if there is no value at all.
    """
    missing = np.isnan(values)
    if not missing.any():
        return values
    if missing.all():
        raise ValueError("values must hold at least one number, all of them are missing")
    ndimage = require("scipy.ndimage", _PURPOSE)
    interpolate = require("scipy.interpolate", _PURPOSE)
    spatial = require("scipy.spatial", _PURPOSE)

    # Only cells that touch a hole can be corners of a triangle over it.
    rim = ~missing & ndimage.binary_dilation(missing, np.ones((3, 3), dtype=bool))
    known = np.argwhere(rim).astype(np.float64)
    holes = np.argwhere(missing)
    filled = values.copy()
    try:
        linear = interpolate.LinearNDInterpolator(known, values[rim])
        filled[missing] = linear(holes.astype(np.float64))
    except (ValueError, spatial.QhullError):
        pass  # fewer than three known cells, or all on one line: the nearest value is all there is
    return fill_nearest(filled)


def fill_nearest(values: NDArray[np.float64]) -> NDArray[np.float64]:
    """Replace every NaN of `values` (nx, ny) by the value of the nearest cell that has one."""
    missing = np.isnan(values)
    if not missing.any():
        return values
    ndimage = require("scipy.ndimage", _PURPOSE)
    i, j = ndimage.distance_transform_edt(missing, return_distances=False, return_indices=True)
    return np.asarray(values[i, j])


def wide_gaps(empty: NDArray[np.bool_], width: float) -> NDArray[np.bool_]:
    """The parts of `empty` (nx, ny) that a disc of diameter `width` [cells] fits into.

    A thin survey leaves many single cells empty by chance; a gap as wide as this is no chance.
    What lies outside the raster counts as empty too, or else a gap on its rim would look narrow.
    """
    if empty.all() or not empty.any():
        return empty
    ndimage = require("scipy.ndimage", _PURPOSE)
    # From the centre of a cell to the edge of the nearest full cell is half a cell less.
    core = ndimage.distance_transform_edt(empty) - 0.5 >= width / 2
    if not core.any():
        return np.zeros_like(empty)
    reached = ndimage.distance_transform_edt(~core) <= width / 2
    gaps: NDArray[np.bool_] = empty & reached
    return gaps


def grow(
    kinds: NDArray[np.uint8],
    heights: NDArray[np.float64],
    known: NDArray[np.bool_],
    holes: NDArray[np.bool_],
    solid: tuple[int, ...],
) -> tuple[NDArray[np.uint8], NDArray[np.float64]]:
    """Give each hole the commonest kind among its eight neighbours, ring by ring.

    Args:
        kinds: (nx, ny) kind of ground per cell.
        heights: (nx, ny) height above ground per cell [m].
        known: (nx, ny) cells whose neighbours may take after them.
        holes: (nx, ny) cells to fill; those that no ring reaches stay as they are.
        solid: kinds that win a tie, the first before the second; then the smaller number wins.

    Returns:
        New kinds and heights. A filled cell is as high as the highest of the neighbours that share
        its kind: towards obstacles, an error is on the safe side.
    """
    kinds, heights, known = kinds.copy(), heights.copy(), known.copy()
    holes = holes & ~known
    ranks = {int(kind): rank for rank, kind in enumerate(reversed(solid), start=1)}
    while holes.any():
        votes = np.zeros(kinds.shape, dtype=np.int16)
        winner, top = kinds.copy(), heights.copy()
        for kind in np.unique(kinds[known])[::-1]:
            is_kind = known & (kinds == kind)
            # The rank sits below the votes, so that it decides ties only.
            count = _neighbours(is_kind) * 16
            count[count > 0] += ranks.get(int(kind), 0)
            wins = holes & (count >= votes) & (count > 0)
            votes[wins], winner[wins] = count[wins], kind
            top[wins] = _highest_neighbour(np.where(is_kind, heights, -np.inf))[wins]
        filled = votes > 0
        if not filled.any():
            break
        kinds, heights = winner, top
        known, holes = known | filled, holes & ~filled
    return kinds, heights


def _shifts(padded: NDArray[np.generic]) -> list[NDArray[np.generic]]:
    n, m = padded.shape[0] - 2, padded.shape[1] - 2
    return [padded[i : i + n, j : j + m] for i in range(3) for j in range(3) if (i, j) != (1, 1)]


def _neighbours(mask: NDArray[np.bool_]) -> NDArray[np.int16]:
    total = np.zeros(mask.shape, dtype=np.int16)
    for shifted in _shifts(np.pad(mask, 1)):
        total += shifted.astype(np.int16)
    return total


def _highest_neighbour(heights: NDArray[np.float64]) -> NDArray[np.float64]:
    top = np.full(heights.shape, -np.inf)
    for shifted in _shifts(np.pad(heights, 1, constant_values=-np.inf)):
        top = np.maximum(top, shifted.astype(np.float64))
    return top
