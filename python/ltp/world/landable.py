# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where one may land: the mask of allowed, low, flat and treeless cells."""

import math
from collections.abc import Iterable
from typing import TypedDict

import numpy as np
from numpy.typing import NDArray

from .checks import not_negative
from .classes import LANDABLE_PRESETS, LandClass
from .world import World


class LandingRules(TypedDict, total=False):
    """What `landable_mask` asks for; every key is one of its arguments."""

    landable: str | Iterable[LandClass]
    max_height_above_ground: float
    max_roughness: float
    clearance: float


def landable_mask(
    world: World,
    landable: str | Iterable[LandClass] = "wide",
    max_height_above_ground: float = 0.5,
    max_roughness: float = 0.5,
    clearance: float = 0.0,
) -> NDArray[np.bool_]:
    """Mark the cells one may land on: of an allowed class, low, flat and without trees.

    Args:
        world: where.
        landable: a name in `LANDABLE_PRESETS` or the allowed classes; TREES cannot be among them.
        max_height_above_ground: how high the surface may stand above the bare ground [m].
        max_roughness: how much the surface may vary within the 3 x 3 cells round a cell [m].
        clearance: least distance to a cell that is not landable, or to the map's border [m].
            Measured per axis, so never less than asked for.

    Returns:
        bool, shape (nx, ny) of the world.

    Raises:
        ValueError: naming the argument that is out of range.
    """
    allowed = _allowed(landable)
    highest = not_negative("max_height_above_ground", max_height_above_ground)
    roughest = not_negative("max_roughness", max_roughness)
    margin = math.ceil(not_negative("clearance", clearance) / world.cell - 1e-9)
    mask = np.isin(world.classes, np.array(sorted(allowed), dtype=np.uint8))
    mask &= world.height_above_ground <= highest
    mask &= _roughness(world.surface) <= roughest
    if margin > 0:
        i, j = (np.arange(length) for length in mask.shape)
        mask = all_within(mask, i - margin, i + margin + 1, j - margin, j + margin + 1)
    return mask


def all_within(
    mask: NDArray[np.bool_],
    first_i: NDArray[np.int64],
    last_i: NDArray[np.int64],
    first_j: NDArray[np.int64],
    last_j: NDArray[np.int64],
) -> NDArray[np.bool_]:
    """For each pair of index ranges [first, last): inside the mask and true throughout it."""
    nx, ny = mask.shape
    count = np.zeros((nx + 1, ny + 1), dtype=np.int64)
    count[1:, 1:] = mask.cumsum(axis=0).cumsum(axis=1)
    i0, i1 = np.clip(first_i, 0, nx), np.clip(last_i, 0, nx)
    j0, j1 = np.clip(first_j, 0, ny), np.clip(last_j, 0, ny)
    found = count[np.ix_(i1, j1)] - count[np.ix_(i0, j1)]
    found += count[np.ix_(i0, j0)] - count[np.ix_(i1, j0)]
    return np.asarray(found == np.outer(last_i - first_i, last_j - first_j))


def _allowed(landable: str | Iterable[LandClass]) -> frozenset[LandClass]:
    if isinstance(landable, str):
        if landable not in LANDABLE_PRESETS:
            known = ", ".join(LANDABLE_PRESETS)
            raise ValueError(f"landable must be one of {known} or land classes, not {landable!r}")
        return LANDABLE_PRESETS[landable]
    try:
        allowed = frozenset(LandClass(item) for item in landable)
    except (TypeError, ValueError) as error:
        raise ValueError(f"landable must be land classes: {error}") from error
    if LandClass.TREES in allowed:
        raise ValueError("landable must not contain TREES: nothing lands on a canopy")
    return allowed


def _roughness(surface: NDArray[np.float64]) -> NDArray[np.float64]:
    """Highest minus lowest surface of the 3 x 3 cells round each cell, clipped at the border."""
    padded = np.pad(surface, 1, mode="edge")
    highest = np.maximum(np.maximum(padded[:-2], padded[1:-1]), padded[2:])
    lowest = np.minimum(np.minimum(padded[:-2], padded[1:-1]), padded[2:])
    highest = np.maximum(np.maximum(highest[:, :-2], highest[:, 1:-1]), highest[:, 2:])
    lowest = np.minimum(np.minimum(lowest[:, :-2], lowest[:, 1:-1]), lowest[:, 2:])
    return np.asarray(highest - lowest)
