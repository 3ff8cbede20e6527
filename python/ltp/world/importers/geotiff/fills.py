# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""No-data values whose tag was lost: blocks of one value that bare ground cannot have.

Bare ground is continuous. A lake, the sea, a terrace or a field in a coarse raster of whole metres
also holds one value in many cells, but somewhere along its rim it meets the land around; a fill
value meets it nowhere. A connected block of one exact value is therefore a fill if nearly all of
its rim jumps the same way by more than a wall of rock does:

* down by 30 m, if the value is one that files are filled with (0, -1, -99, 255, ...) or below the
  sea's level; by 100 m, whatever the value;
* up by 100 m, if the value is one that files are filled with (999, 8888, 255, the largest of its
  type); by more than anything built (830 m), whatever the value. Up by 200 m, the block is
  doubtful: it may be a tower in a model of "bare" ground, so its height stays, and nobody lands
  on it.

All of these thresholds are *assumed*, and grow with the cell: at least three times its size.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..limits import HIGHEST_BUILT
from ..optional import require

Mask = NDArray[np.bool_]
Heights = NDArray[np.float64]

_DOWN_CODE, _DOWN_ANY = 30.0, 100.0  # [m]
_UP_CODE, _UP_DOUBTFUL, _UP_ANY = 100.0, 200.0, HIGHEST_BUILT  # [m]
_STEEPEST = 3.0  # rise over run of a wall of rock: 72 degrees
_RIM = 0.9  # share of the rim that must jump; the rest may touch another hole
_ONE_SIDED = 0.7  # the same of all the cells beside walls that hold the value, at a first look
_BYTE = 255.0  # fill of a byte, which outlives a conversion; of bare ground only, as a roof may be
_MANY = 4  # cells that hold a value before it is more than chance
_MOST_VALUES = 16  # that are looked at before one is found, the commonest first
_MOST_FILLS = 8  # that one raster is filled with; more are found only in noise
_MINORITY = 0.5  # a value that is no usual fill must not be the rule


@dataclass(frozen=True)
class Fill:
    """A value that was taken for a fill."""

    value: float  # [m]
    n_cells: int
    jump: float  # median height of the rim above the value [m]


@dataclass(frozen=True)
class Fills:
    """What was found in one raster."""

    holes: Mask  # (nx, ny)
    doubtful: Mask  # (nx, ny) too high to believe, too likely a tower to drop
    found: tuple[Fill, ...]
    doubted: tuple[Fill, ...]


def is_code(stored: float, largest: float | None = None) -> bool:
    """Whether `stored` is a number that files are filled with, as stored (without its scale).

    Nines or eights only (-99, -9999.9, 999, 8888), or the `largest` number of an integer type.
    """
    if largest is not None and abs(stored) in (largest, largest + 1):
        return True
    text = f"{abs(stored):.7g}"
    digits = text.partition("e")[0].replace(".", "")
    least = 2 if stored < 0.0 else 3
    return len(digits) >= least and set(digits) in ({"9"}, {"8"})


def find_fills(
    heights: Heights,
    cell: float,
    *,
    scale: float = 1.0,
    offset: float = 0.0,
    largest: float | None = None,
) -> Fills:
    """Find the blocks of one improbable value in a model of the bare ground.

    Args:
        heights: (nx, ny), NaN where there is none [m].
        cell: edge of a cell [m].
        scale, offset: a height is a stored number times `scale` plus `offset`.
        largest: largest number that an integer type of the file can store.
    """
    values = heights.copy()
    holes, doubtful = np.zeros((2, *values.shape), dtype=bool)
    found: list[Fill] = []
    doubted: list[Fill] = []
    for _ in range(_MOST_FILLS):
        for value, code in _candidates(values, cell, scale, offset, largest):
            middle = float(np.nanmedian(values))
            where, sure = _judge(values, value, middle, cell, code)
            if where.any():
                break
        else:
            break
        rim = _jumps(values, where)[1]
        jump = float(np.median(rim)) if rim.size else middle - value
        (found if sure else doubted).append(Fill(value, int(np.count_nonzero(where)), jump))
        (holes if sure else doubtful)[where] = True
        values[where] = np.nan  # what stood beside it may show now
    return Fills(holes, doubtful, tuple(found), tuple(doubted))


def _candidates(
    values: Heights, cell: float, scale: float, offset: float, largest: float | None
) -> list[tuple[float, bool]]:
    """Values that many cells at the foot or on top of a wall hold, and whether each is a code.

    The least probable stands first: once it is gone, the ground around it no longer looks odd.
    """
    wall = max(_DOWN_CODE, _STEEPEST * cell)
    beside = np.zeros(values.shape, dtype=bool)
    with np.errstate(invalid="ignore"):
        for here, there in _pairs(values.shape):
            high = np.abs(values[there] - values[here]) >= wall
            beside[here] |= high
            beside[there] |= high
    if not beside.any():
        return []
    held, of, counts = np.unique(values[beside], return_inverse=True, return_counts=True)
    beside[beside] = (counts >= _MANY)[of.ravel()]  # a value held by few is no fill
    if not beside.any():
        return []
    held, of, counts = np.unique(values[beside], return_inverse=True, return_counts=True)
    one_sided = _one_sided(values, beside, of.ravel(), held.size, wall)
    order = np.argsort(-counts, kind="stable")
    likely = [k for k in order if one_sided[k]][:_MOST_VALUES]
    middle = float(np.nanmedian(values))
    stored = {v: (v - offset) / scale for v in map(float, held[likely])}
    ranked = [(v, n == _BYTE or is_code(n, largest)) for v, n in stored.items()]
    return sorted(ranked, key=lambda pair: (not pair[1], -abs(pair[0] - middle)))


def _one_sided(
    values: Heights, beside: Mask, of: NDArray[np.intp], n: int, wall: float
) -> NDArray[np.bool_]:
    """Of each of `n` values: is the wall the same way all around the cells that hold it?

    A quick look at the cells beside walls only; in steep land nearly every value fails it.
    """
    down, up, rim = np.zeros((3, n))
    for jump in _around(values, beside):
        known = ~np.isnan(jump) & (jump != 0.0)
        down += np.bincount(of[known & (jump >= wall)], minlength=n)
        up += np.bincount(of[known & (jump <= -wall)], minlength=n)
        rim += np.bincount(of[known], minlength=n)
    return np.asarray(np.maximum(down, up) >= _ONE_SIDED * rim)


def _judge(
    values: Heights, value: float, middle: float, cell: float, code: bool
) -> tuple[Mask, bool]:
    """The cells that hold `value` as a fill, and whether that is beyond doubt."""
    ndimage = require("scipy.ndimage", "finding holes in a raster")
    same = values == value
    share = np.count_nonzero(same) / np.count_nonzero(~np.isnan(values))
    nothing = np.zeros_like(same)
    if share > _MINORITY and not code:
        return nothing, True
    labels, n = ndimage.label(same, np.ones((3, 3), dtype=bool))
    owners, jumps = _jumps(values, same, labels)
    rim = np.bincount(owners, minlength=n + 1)
    alone = rim == 0  # an island among other holes: the rest of the raster is its rim
    steepest = _STEEPEST * cell

    def blocks(least: float, sign: float) -> Mask:
        least = max(least, steepest)
        beyond = np.bincount(owners[sign * jumps >= least], minlength=n + 1)
        fits = np.where(alone, sign * (middle - value) >= least, beyond >= _RIM * rim)
        fits[0] = False
        return np.asarray(fits[labels])

    usual = code or value <= 0.0
    sure = blocks(_DOWN_CODE if usual else _DOWN_ANY, 1.0) | blocks(
        _UP_CODE if code else _UP_ANY, -1.0
    )
    if np.count_nonzero(sure) >= (1 if code else _MANY):
        return sure, True
    doubtful = blocks(_UP_DOUBTFUL, -1.0)
    return (doubtful if np.count_nonzero(doubtful) >= _MANY else nothing), False


def _jumps(
    values: Heights, block: Mask, labels: NDArray[np.int32] | None = None
) -> tuple[NDArray[np.int32], Heights]:
    """Label of the block and height of the neighbour above it, for each pair across its rim."""
    names = block.astype(np.int32) if labels is None else labels
    of = names[block]
    owners, jumps = [], []
    for jump in _around(values, block):
        across = ~np.isnan(jump) & (jump != 0.0)  # all of the block holds one value
        owners.append(of[across])
        jumps.append(jump[across])
    return np.concatenate(owners), np.concatenate(jumps)


def _around(values: Heights, cells: Mask) -> Iterator[Heights]:
    """Height of each of the eight neighbours above each of the `cells`, NaN where there is none."""
    padded = np.pad(values, 1, constant_values=np.nan)
    i, j = np.nonzero(cells)
    here = values[cells]
    for di, dj in ((a, b) for a in range(3) for b in range(3) if (a, b) != (1, 1)):
        yield padded[i + di, j + dj] - here


def _pairs(shape: tuple[int, ...]) -> list[tuple[tuple[slice, slice], tuple[slice, slice]]]:
    """Views of all pairs of cells that share an edge or a corner, each pair once."""
    nx, ny = shape
    return [
        (
            (slice(0, nx - dx), slice(max(0, -dy), ny - max(0, dy))),
            (slice(dx, nx), slice(max(0, dy), ny - max(0, -dy))),
        )
        for dx, dy in ((1, 0), (0, 1), (1, 1), (1, -1))
    ]
