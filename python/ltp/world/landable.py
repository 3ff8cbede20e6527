# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where one may land: the mask of allowed, low, flat, even and treeless cells."""

import math
from dataclasses import asdict, dataclass
from typing import Annotated, TypedDict
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from .checks import finite, not_negative, positive
from .classes import Landable, landable_classes
from .flatness import flatness
from .world import World

_LEVEL: WeakKeyDictionary[World, dict[tuple[float, ...], NDArray[np.bool_]]] = WeakKeyDictionary()
_SLACK = 1e-6  # rounding of a slope [deg] or a height [m]: a limit itself is within the limit


@dataclass(frozen=True, kw_only=True)
class LandingLimits:
    """How level ground must be for this vehicle to land on it; the same for every land class.

    Sources: 10 degrees is the limit of an unprepared pad in P. Ermakov, V. Evdokimenkov and
    A. Gogolev, Trudy MAI, article 176860 (US Army FM 3-21.38 lets every helicopter land at 7
    degrees, those on wheels with a warning at 15, none above); 0.2 m is what PX4-Avoidance lets the
    heights of a landing cell scatter (`safe_landing_planner_node.cfg`), here the most that any
    point under the gear may stand out. The other two are *assumed*.

    Raises:
        ValueError: naming the field that is out of range.
    """

    max_slope: Annotated[float, "steepest plane through the ground under the gear [deg]"] = 10.0
    max_roughness: Annotated[float, "farthest that ground may lie off that plane [m]"] = 0.2
    gear_radius: Annotated[float, "of the disc that the landing gear stands on [m]"] = 1.0
    max_height_above_ground: Annotated[
        float, "how high the surface may stand above the bare ground [m]"
    ] = 0.5
    clearance: Annotated[
        float, "least distance to what is not landable, and to the world's edge [m]"
    ] = 0.0

    def __post_init__(self) -> None:
        for name in ("max_roughness", "max_height_above_ground", "clearance"):
            not_negative(name, getattr(self, name))
        positive("gear_radius", self.gear_radius)
        if not 0.0 <= finite("max_slope", self.max_slope) < 90.0:
            raise ValueError(f"max_slope must lie in [0, 90) degrees, not {self.max_slope!r}")

    def __str__(self) -> str:
        return (
            f"at most {self.max_slope:g} degrees steep and {self.max_roughness:g} m rough within "
            f"{self.gear_radius:g} m, {self.max_height_above_ground:g} m above the bare ground"
        )

    def rules(self, landable: Landable = "wide") -> "LandingRules":
        """With the classes that may be landed on, the arguments of `landable_mask`."""
        return LandingRules(landable=landable, **asdict(self))  # type: ignore[no-any-return, typeddict-item]


class LandingRules(TypedDict, total=False):
    """What `landable_mask` asks for; every key is one of its arguments."""

    landable: Landable
    max_slope: float
    max_roughness: float
    gear_radius: float
    max_height_above_ground: float
    clearance: float


def landable_mask(
    world: World,
    landable: Landable = "wide",
    max_height_above_ground: float = LandingLimits.max_height_above_ground,
    max_roughness: float = LandingLimits.max_roughness,
    clearance: float = LandingLimits.clearance,
    *,
    max_slope: float = LandingLimits.max_slope,
    gear_radius: float = LandingLimits.gear_radius,
) -> NDArray[np.bool_]:
    """Mark the cells one may land on: of an allowed class, low, flat, even and without trees.

    Slope and roughness are those of `flatness`: of the plane through the surface under the landing
    gear, so the same slope is judged alike on cells of 0.1 m and of 5 m.

    Args:
        world: where.
        landable: a name in `LANDABLE_PRESETS`, or the allowed classes, by name or number; TREES
            cannot be among them.
        max_height_above_ground: how high the surface may stand above the bare ground [m].
        max_roughness: how far the surface may lie off the plane through it, within `gear_radius`
            and within the 3 x 3 cells round a cell [m].
        clearance: least distance to a cell that is not landable, or to the map's border [m].
            Measured per axis, so never less than asked for.
        max_slope: how steep that plane may be, in [0, 90) [deg].
        gear_radius: of the disc that the landing gear stands on [m].

    Returns:
        bool, shape (nx, ny) of the world.

    Raises:
        ValueError: naming the argument that is out of range.
    """
    allowed = landable_classes(landable)
    limits = LandingLimits(
        max_slope=max_slope,
        max_roughness=max_roughness,
        gear_radius=gear_radius,
        max_height_above_ground=max_height_above_ground,
        clearance=clearance,
    )
    mask = np.isin(world.classes, np.array(sorted(allowed), dtype=np.uint8))
    mask &= world.height_above_ground <= limits.max_height_above_ground + _SLACK
    mask &= _is_level(world, limits)
    margin = math.ceil(limits.clearance / world.cell - 1e-9)
    if margin > 0:
        i, j = (np.arange(length) for length in mask.shape)
        mask = all_within(mask, i - margin, i + margin + 1, j - margin, j + margin + 1)
    return mask


def _is_level(world: World, limits: LandingLimits) -> NDArray[np.bool_]:
    """Where slope and roughness are within the limits; kept as long as the world, which stays."""
    key = (limits.max_slope, limits.max_roughness, limits.gear_radius)
    known = _LEVEL.setdefault(world, {})
    if (level := known.get(key)) is None:
        flat = flatness(world.surface, world.cell, limits.gear_radius)
        level = flat.slope <= limits.max_slope + _SLACK
        level &= flat.roughness <= limits.max_roughness + _SLACK
        known.clear()  # one is enough: a campaign asks the same for every flight
        known[key] = level
    return level


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
