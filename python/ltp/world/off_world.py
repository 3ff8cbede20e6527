# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Are points meant for this world? Those off it, in degrees or in map coordinates are refused."""

from importlib.util import find_spec

import numpy as np
from numpy.typing import NDArray

from .world import World

_SAME_PLACE = 0.1  # a whole path within so little is one in degrees, not in metres [m]
_EXACT = 1e-6  # less than this apart, points are one above the other [m]


def refuse_off_world(world: World, points: NDArray[np.float64], name: str = "global_path") -> None:
    """Demand that all points lie over the world, and that they are in its own metres.

    Args:
        world: that they should lie over.
        points: (n, 3), finite, x and y first, meant as world frame [m].
        name: of the points, for the message.

    Raises:
        ValueError: naming the first point off the world and what the world covers, and saying so
            where the points look like degrees or like coordinates of a map.
    """
    flat = points[:, :2]
    off = ~_inside(world, flat)
    if off.any():
        index = int(off.argmax())
        lies = f"lies off {world.name}"
    elif _in_degrees_of(world, flat) or (_may_be_degrees(flat) and _in_one_place(flat)):
        index = 0
        lies = f"is not in the metres of {world.name}"
    else:
        return
    x_min, y_min, x_max, y_max = world.extent
    x, y = flat[index]
    raise ValueError(
        f"{name}[{index}] = ({x:.10g}, {y:.10g}) {lies}, which covers x = {x_min:.10g} ... "
        f"{x_max:.10g} m, y = {y_min:.10g} ... {y_max:.10g} m{_hint(world, flat)}"
    )


def _inside(world: World, flat: NDArray[np.float64]) -> NDArray[np.bool_]:
    x_min, y_min, x_max, y_max = world.extent
    slack = 1e-9 * max(1.0, *(abs(edge) for edge in world.extent))
    low, high = np.array([x_min, y_min]) - slack, np.array([x_max, y_max]) + slack
    return np.asarray(((flat >= low) & (flat <= high)).all(axis=1))


def _hint(world: World, flat: NDArray[np.float64]) -> str:
    """What the points may have been meant as."""
    datum = world.datum
    corner = np.array([datum.easting, datum.northing])
    if datum.crs is not None and _inside(world, flat - corner).all():
        return (
            f"; these are coordinates of {datum.crs}: subtract ({datum.easting:.10g}, "
            f"{datum.northing:.10g})"
        )
    spread = float(np.ptp(flat, axis=0).max())
    if _in_degrees_of(world, flat) or (_may_be_degrees(flat) and spread < 1.0):
        return "; these look like degrees: give metres from the world's origin, x east, y north"
    if _may_be_projected(flat):
        return (
            "; these look like map coordinates (UTM or the like): give metres from the world's "
            "origin, x east, y north"
        )
    return ""


def _may_be_degrees(flat: NDArray[np.float64]) -> bool:
    """Longitudes and latitudes, in either order, that no one would give as metres: fractions."""
    low, high = np.sort(np.abs(flat).max(axis=0))
    fractions = bool((np.abs(flat - np.round(flat)) > 1e-9).any())
    return bool(low <= 90.0 and high <= 180.0 and fractions)


def _may_be_projected(flat: NDArray[np.float64]) -> bool:
    return bool((np.abs(flat).max(axis=1) >= 1e5).all() and np.abs(flat).max() <= 1e8)


def _in_one_place(flat: NDArray[np.float64]) -> bool:
    spread = float(np.ptp(flat, axis=0).max())
    return _EXACT < spread < _SAME_PLACE


def _in_degrees_of(world: World, flat: NDArray[np.float64]) -> bool:
    """Whether the points, taken as degrees in either order, lie over the world."""
    low, high = np.sort(np.abs(flat).max(axis=0))
    if world.datum.crs is None or low > 90.0 or high > 180.0 or find_spec("pyproj") is None:
        return False
    import pyproj

    corner = np.array([world.datum.easting, world.datum.northing])
    try:
        to_map = pyproj.Transformer.from_crs("EPSG:4326", world.datum.crs, always_xy=True)
    except pyproj.exceptions.ProjError:  # a CRS of the user's own making
        return False
    for lon, lat in (flat.T, flat.T[::-1]):
        there = np.column_stack(to_map.transform(lon, lat)) - corner
        if np.isfinite(there).all() and _inside(world, there).all():
            return True
    return False
