# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where rasters hold no height, tagged or not, and the sentences that say so."""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from ..fill import fill_linear
from ..limits import HEIGHTS, HIGHEST_BUILT, HIGHEST_TREE
from ..optional import require
from .fills import Fill, find_fills, is_code
from .raster import TiffRaster

Mask = NDArray[np.bool_]
Heights = NDArray[np.float64]

#: A surface this far below the bare ground contradicts it: one of them is wrong [m]. *Assumed*;
#: models of one place made in different ways differ by a few metres along walls.
BELOW_GROUND = 5.0
#: A roof that is also a usual fill value (999) is only believed up to here [m]. *Assumed*.
_TALL = 200.0
_LOWEST_CROWN = -5.0  # canopy heights are differences, and noisy [m]; *assumed*
_BLENDED = 10.0  # how far beyond all other heights a cell beside a lost hole may reach [m]
_MOST_NAMED = 5  # values in a sentence
_MANY = 4


@dataclass
class Layer:
    """Heights of one raster without holes, where they were, and what to say about them."""

    heights: Heights  # (nx, ny), holes filled [m]
    unknown: Mask  # (nx, ny) holes, and what is too doubtful to land on
    fills: tuple[float, ...] = ()  # values that were taken for fills [m]
    report: list[str] = field(default_factory=list)


def terrain(raster: TiffRaster) -> Layer:
    """The bare ground of a raster.

    Raises:
        ValueError: naming the file, if it holds no height at all.
    """
    values, report = _plausible(raster, *HEIGHTS)
    lost = _lost(values, raster)
    fills = find_fills(
        values, raster.grid.cell, scale=raster.scale, offset=raster.offset, largest=raster.largest
    )
    values[fills.holes] = np.nan
    for fill in fills.found:
        report.append(
            f"{raster.path.name}: {_cells(fill.n_cells)} hold {fill.value:.7g}, {_beside(fill)}: "
            "no ground jumps like that, so they are taken for holes whose no-data tag was lost"
        )
    for fill in fills.doubted:
        report.append(
            f"{raster.path.name}: {_cells(fill.n_cells)} hold {fill.value:.7g}, {_beside(fill)}: "
            "holes or towers, nobody knows; their height stays, their class is UNKNOWN"
        )
    _drop_blended(values, lost | fills.holes, raster, report)
    unknown = np.isnan(values) | fills.doubtful
    return Layer(_filled(values, raster), unknown, tuple(f.value for f in fills.found), report)


def surface(raster: TiffRaster, ground: Layer) -> Layer:
    """The surface of a raster, above the `ground` of another.

    Raises:
        ValueError: naming the file, if it holds no height at all.
    """
    values, report = _plausible(raster, *HEIGHTS)
    lost = _lost(values, raster)
    with np.errstate(invalid="ignore"):
        same = np.isin(values, ground.fills) & ground.unknown
        above = values - ground.heights
        below, beyond = above < -BELOW_GROUND, above > HIGHEST_BUILT
        tall = (above > _TALL) & ~beyond & ~same
    for where, why in (
        (same, "which is a fill value of the bare ground"),
        (below & ~same, f"more than {BELOW_GROUND:g} m below the bare ground"),
        (beyond & ~same, f"more than {HIGHEST_BUILT:g} m above the ground, higher than any tower"),
    ):
        if where.any():
            report.append(
                f"{raster.path.name}: {_cells(where)} hold "
                f"{_named(values[where])}, {why}: taken for holes"
            )
            values[where] = np.nan
    doubtful = _coded(values, tall, raster, report)
    _drop_blended(values, lost, raster, report, only_below=True)
    return Layer(_filled(values, raster), np.isnan(values) | doubtful, (), report)


def canopy(raster: TiffRaster) -> Layer:
    """Heights of crowns above the ground: where the raster says it has none, there is no tree."""
    values, report = _plausible(raster, _LOWEST_CROWN, HIGHEST_TREE, "no tree there")
    unknown = _lost(values, raster)
    return Layer(np.where(np.isnan(values), 0.0, values), unknown, (), report)


def _plausible(
    raster: TiffRaster, lowest: float, highest: float, nothing: str = "holes"
) -> tuple[Heights, list[str]]:
    """Heights as float64, NaN where the raster has none that can be true, and why."""
    with np.errstate(invalid="ignore"):  # of numbers that are none
        values = raster.values.astype(np.float64)
        absurd = ~raster.missing & ((values < lowest) | (values > highest))
    report = []
    none = raster.missing | (raster.values != raster.values)
    if none.any():
        report.append(
            f"{raster.path.name}: {_cells(none)} hold no value (no-data tag, mask or NaN): "
            f"{nothing}"
        )
    if absurd.any():
        report.append(
            f"{raster.path.name}: {_cells(absurd)} hold "
            f"{_named(values[absurd])}, outside of {lowest:g} ... {highest:g} m: taken for holes"
        )
    values[raster.missing | absurd] = np.nan
    return values, report


def _lost(values: Heights, raster: TiffRaster) -> Mask:
    """Where `_plausible` made a hole of a number that the raster holds."""
    return np.asarray(np.isnan(values) & ~raster.missing & (raster.values == raster.values))


def _drop_blended(
    values: Heights, lost: Mask, raster: TiffRaster, report: list[str], only_below: bool = False
) -> None:
    """Make holes of the cells beside a lost one that a resampling mixed with its fill value."""
    if not lost.any():
        return
    ndimage = require("scipy.ndimage", "finding holes in a raster")
    near = ndimage.binary_dilation(lost, np.ones((3, 3), dtype=bool), iterations=2)
    rest = values[~near & ~np.isnan(values)]
    if rest.size == 0:
        return
    with np.errstate(invalid="ignore"):
        mixed = near & (values < rest.min() - _BLENDED)
        if not only_below:
            mixed |= near & (values > rest.max() + _BLENDED)
    if mixed.any():
        values[mixed] = np.nan
        report.append(
            f"{raster.path.name}: {_cells(mixed)} beside these holes lie beyond "
            "all other heights, mixed with the fill value: taken for holes"
        )


def _coded(values: Heights, tall: Mask, raster: TiffRaster, report: list[str]) -> Mask:
    """The tall cells that hold a usual fill value: towers or holes, so obstacles and UNKNOWN."""
    held, counts = np.unique(values[tall], return_counts=True)
    codes = [
        float(v)
        for v in held[counts >= _MANY]
        if is_code((float(v) - raster.offset) / raster.scale, raster.largest)
    ]
    doubtful = tall & np.isin(values, codes)
    if codes:
        report.append(
            f"{raster.path.name}: {_cells(doubtful)} hold "
            f"{_named(values[doubtful])}: holes or towers, nobody knows; their height stays, their "
            "class is UNKNOWN"
        )
    return np.asarray(doubtful)


def _filled(values: Heights, raster: TiffRaster) -> Heights:
    if np.isnan(values).all():
        raise ValueError(f"{raster.path} holds no height in {HEIGHTS[0]:g}...{HEIGHTS[1]:g} m")
    return fill_linear(values)


def _beside(fill: Fill) -> str:
    side = "below" if fill.jump > 0.0 else "above"
    return f"{abs(fill.jump):.0f} m {side} the ground around them"


def _cells(where: Mask | int) -> str:
    n = where if isinstance(where, int) else int(np.count_nonzero(where))
    return f"{n:,} cell" + ("" if n == 1 else "s")


def _named(values: Heights) -> str:
    """The commonest values, and how many hold each."""
    held, counts = np.unique(values, return_counts=True)
    order = np.argsort(-counts, kind="stable")
    if counts[order[0]] == 1 and held.size > 1:
        return f"{held[0]:.7g} ... {held[-1]:.7g}"
    named = [f"{held[k]:.7g}" for k in order[:_MOST_NAMED]]
    return ", ".join(named) + (", ..." if held.size > _MOST_NAMED else "")
