# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The priority maps of the paper: binary, and low-passed by the footprint of the camera.

Source: Magrisso, Rivlin, Rotstein, "Local Trajectory Planning For UAV Autonomous Landing", section
on the simulation: binary map, and low-pass map with the footprint 2 h tan(FOV / 2), FOV = 53 deg.
"""

import math
from typing import TYPE_CHECKING, Literal, Unpack

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .box_mean import box_mean
from .checks import finite, positive, shares
from .landable import LandingRules, all_within, landable_mask
from .world import World

if TYPE_CHECKING:
    from ltp._core import Raster

CAMERA_FOV = 53.0  # the paper's look-down camera [deg]
PRIORITY_CELL = 2.0  # the paper's horizontal cell [m]
_SNAP = 1e-9  # cells: edges this close together are one edge
_MOST_CELLS = 100_000_000


def binary_values(
    world: World, cell: float = PRIORITY_CELL, **rules: Unpack[LandingRules]
) -> tuple[NDArray[np.float64], tuple[float, float]]:
    """The binary map as an array: 1 where every cell of the world under a cell is landable.

    Args:
        world: where.
        cell: edge of the map's cells [m]; the cells lie on multiples of it.
        rules: see `landable_mask`.

    Returns:
        Values (nx, ny), 0 or 1, covering the world and, where `cell` does not divide it, a little
        more (0 there); and the (x, y) of the outer corner of cell (0, 0) [m].
    """
    x_min, y_min, x_max, y_max = world.extent
    if (x_max - x_min) / positive("cell", cell) * ((y_max - y_min) / cell) > _MOST_CELLS:
        raise ValueError(f"cell must not cut the world into over {_MOST_CELLS} cells: {cell!r}")
    mask = landable_mask(world, **rules)
    (x, first_i, last_i), (y, first_j, last_j) = (_fine_cells(world, axis, cell) for axis in (0, 1))
    values = all_within(mask, first_i, last_i, first_j, last_j).astype(np.float64)
    return values, (x, y)


def footprint(height: ArrayLike, fov_deg: float = CAMERA_FOV) -> NDArray[np.float64]:
    """Edge of the square of ground that the camera sees, 2 h tan(FOV / 2) [m].

    Args:
        height: above the ground below, any shape, finite and not negative [m].
        fov_deg: full opening angle of the camera, in (0, 180) [deg].
    """
    heights = np.asarray(height, dtype=np.float64)
    if not (np.isfinite(heights) & (heights >= 0.0)).all():
        raise ValueError(f"height above ground must be finite and not negative, not {height!r}")
    if not 0.0 < finite("fov_deg", fov_deg) < 180.0:
        raise ValueError(f"fov_deg must lie in (0, 180) degrees, not {fov_deg!r}")
    return np.asarray(2.0 * heights * math.tan(math.radians(fov_deg) / 2.0))


def ground_values(world: World, cell: float = PRIORITY_CELL) -> NDArray[np.float64]:
    """Bare ground at the middle of each cell of a priority map [m], shape as `binary_values`."""
    indices = []
    for axis in (0, 1):
        corner, first, _ = _fine_cells(world, axis, positive("cell", cell))
        middle = corner + (np.arange(first.size) + 0.5) * cell
        nearest = np.floor((middle - world.origin[axis]) / world.cell).astype(int)
        indices.append(np.clip(nearest, 0, world.shape[axis] - 1))
    return np.asarray(world.ground[np.ix_(*indices)])


def binary_priority(
    world: World, cell: float = PRIORITY_CELL, **rules: Unpack[LandingRules]
) -> "Raster":
    """The binary priority map; see `binary_values`."""
    values, origin = binary_values(world, cell, **rules)
    return _raster(values, origin, cell)


def lowpass_priority(
    world: World,
    altitude_above_ground: ArrayLike,
    fov_deg: float = CAMERA_FOV,
    cell: float = PRIORITY_CELL,
    **rules: Unpack[LandingRules],
) -> "Raster":
    """The low-pass priority map: the landable share of what the camera would see below it.

    Args:
        world: where.
        altitude_above_ground: h [m]; one number, or one per cell of the map (`ground_values` has
            its shape).
        fov_deg: full opening angle of the camera [deg].
        cell: edge of the map's cells [m].
        rules: see `landable_mask`.

    Returns:
        `binary_values` averaged over the square footprint, clipped at the map's border.
    """
    values, origin = binary_values(world, cell, **rules)
    side = footprint(altitude_above_ground, fov_deg) / cell
    if side.shape not in ((), values.shape):
        raise ValueError(
            f"altitude_above_ground must be a number or of shape {values.shape}, found {side.shape}"
        )
    return _raster(box_mean(values, side), origin, cell)


def priority_map(
    world: World,
    kind: Literal["binary", "lpf"] = "binary",
    altitude: float = 50.0,
    above: Literal["ground", "datum"] = "ground",
    fov_deg: float = CAMERA_FOV,
    cell: float = PRIORITY_CELL,
    **rules: Unpack[LandingRules],
) -> "Raster":
    """The priority map that a mission at one altitude flies with.

    Args:
        world: where.
        kind: "binary", or "lpf" for the low-pass map.
        altitude: of the flight [m]; only the low-pass map depends on it.
        above: what `altitude` counts from: the ground under each cell, or the world's height datum
            (the footprint then shrinks over high ground, to nothing where the ground is higher).
        fov_deg: full opening angle of the camera [deg].
        cell: edge of the map's cells [m].
        rules: see `landable_mask`.
    """
    if above not in ("ground", "datum"):
        raise ValueError(f'above must be "ground" or "datum", not {above!r}')
    if kind == "binary":
        return binary_priority(world, cell, **rules)
    if kind != "lpf":
        raise ValueError(f'kind must be "binary" or "lpf", not {kind!r}')
    if above == "ground":
        return lowpass_priority(world, positive("altitude", altitude), fov_deg, cell, **rules)
    height = np.maximum(0.0, finite("altitude", altitude) - ground_values(world, cell))
    return lowpass_priority(world, height, fov_deg, cell, **rules)


def seen_priority(
    priority: "Raster",
    kind: Literal["binary", "lpf"] = "binary",
    altitude_above_ground: float = 50.0,
    fov_deg: float = CAMERA_FOV,
) -> "Raster":
    """A priority map of one's own as a mission flies with it.

    Args:
        priority: values in [0, 1].
        kind: "binary" takes it as it is; "lpf" averages it over the camera's square footprint,
            clipped at the map's border.
        altitude_above_ground: h [m].
        fov_deg: full opening angle of the camera [deg].

    Raises:
        ValueError: if a value is no priority.
    """
    shares("priority", priority.values)
    if not 0.0 <= priority.outside <= 1.0:
        raise ValueError(f"priority.outside must be a share from 0 to 1, not {priority.outside:g}")
    if kind == "binary":
        return priority
    side = footprint(altitude_above_ground, fov_deg) / priority.cell
    values = box_mean(priority.values, side)
    return _raster(values, tuple(priority.origin), priority.cell, priority.outside)


def _raster(
    values: NDArray[np.float64], origin: tuple[float, float], cell: float, outside: float = 0.0
) -> "Raster":
    from ltp._core import Raster

    return Raster(values, origin=origin, cell=cell, outside=outside)


def _fine_cells(
    world: World, axis: int, cell: float
) -> tuple[float, NDArray[np.int64], NDArray[np.int64]]:
    """Along one axis: where the coarse cells start [m], and which fine cells [first, last) each
    overlaps; those beyond the world have indices beyond its array."""
    start = world.origin[axis]
    first_cell = math.floor(start / cell + _SNAP)
    last_cell = math.ceil((start + world.shape[axis] * world.cell) / cell - _SNAP)
    edges = (np.arange(first_cell, last_cell + 1) * cell - start) / world.cell
    first = np.floor(edges[:-1] + _SNAP).astype(np.int64)
    last = np.ceil(edges[1:] - _SNAP).astype(np.int64)
    return first_cell * cell, first, last
