# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Seeded straight global paths across a world, through buildings on purpose, as in the paper."""

import math
from collections import Counter
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp.brief import brief
from ltp.world import LandClass, World

if TYPE_CHECKING:
    from ltp._core import Raster

_REFERENCES = ("ground", "datum")
_STANDS = 0.5  # what is no higher above the bare ground is part of it, see `LandingLimits` [m]
_MOST_WAYPOINTS = 100_000  # of a path; the paper's have ten
_SPACING_TOLERANCE = 1e-9  # of a spacing: no waypoint this close before the end


@dataclass(frozen=True, kw_only=True)
class ScenarioOptions:
    """What the global paths look like; the paper's experiment is the default.

    Raises:
        ValueError: naming the field that is out of range.
    """

    count: int = 50
    seed: int = 1
    length: float = 500.0  # of a global path, over the ground [m]
    spacing: float = 50.0  # of its waypoints, over the ground [m]
    altitude: float = 50.0  # height of the waypoints above `reference` [m]
    reference: str = "ground"  # "ground": above the bare ground beneath each; "datum": z itself
    margin: float = 20.0  # kept between a path and the edge of the world [m]
    clearance: float = 10.0  # of the start, from all that stands on the ground [m]
    through_buildings: float = 1.0  # share of the paths that must cross a building, 0...1
    tries: int = 5000  # random lines tried for one path before giving up

    def __post_init__(self) -> None:
        for name in ("count", "tries"):
            value = getattr(self, name)
            if isinstance(value, bool) or not isinstance(value, int | np.integer) or value < 1:
                raise ValueError(f"{name} must be a whole number >= 1, not {value!r}")
        if isinstance(self.seed, bool) or not isinstance(self.seed, int | np.integer):
            raise ValueError(f"seed must be a whole number >= 0, not {self.seed!r}")
        if self.seed < 0:
            raise ValueError(f"seed must be a whole number >= 0, not {self.seed!r}")
        for name in ("length", "spacing"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) > 0.0):
                raise ValueError(f"{name} must be above zero [m], not {getattr(self, name)!r}")
        if not self.length / self.spacing <= _MOST_WAYPOINTS:
            raise ValueError(
                f"spacing must cut length = {self.length:g} m into at most {_MOST_WAYPOINTS:,} "
                f"pieces, not {self.spacing!r}"
            )
        for name in ("margin", "clearance"):
            if not (math.isfinite(getattr(self, name)) and getattr(self, name) >= 0.0):
                raise ValueError(f"{name} must be >= 0 [m], not {getattr(self, name)!r}")
        if not math.isfinite(self.altitude):
            raise ValueError(f"altitude must be a finite number [m], not {self.altitude!r}")
        if self.reference not in _REFERENCES:
            raise ValueError(f"reference must be one of {_REFERENCES}, not {self.reference!r}")
        if not 0.0 <= self.through_buildings <= 1.0:
            raise ValueError(
                f"through_buildings must be a share in [0, 1], not {self.through_buildings!r}"
            )


@dataclass(frozen=True, eq=False)
class Scenario:
    """One global path to fly."""

    index: int
    seed: int  # of the whole set
    global_path: NDArray[np.float64]  # (n, 3) waypoints, the start first, world frame [m]
    crosses_building: bool  # whether the straight global path touches a building

    __repr__ = brief


def make_scenarios(world: World, options: ScenarioOptions | None = None) -> list[Scenario]:
    """Draw the global paths; path i depends on the world, the options and i, not on how many.

    Start and direction are uniform; a line is refused and drawn again if its end leaves the world
    less the margin, if its start is not `clearance` away from all that stands on the ground, or if
    it must cross a building and does not (exact test, waypoint to waypoint). The ground itself only
    has to be half as far from the start as it lies below it, `clearance` at most: one may start
    low. Waypoints other than the start may lie anywhere, inside buildings too.

    Raises:
        ValueError: if no line is found in `tries` draws; the message says what they failed at.
    """
    options = options or ScenarioOptions()
    maker = _Maker(world, options)
    return [maker.scenario(index) for index in range(options.count)]


def make_scenario(world: World, options: ScenarioOptions, index: int) -> Scenario:
    """Path `index` of the set, without the others."""
    return _Maker(world, options).scenario(index)


def must_cross(index: int, share: float) -> bool:
    """Whether path `index` is one of the given share: spread evenly, the same for any count."""
    return math.floor((index + 1) * share + 1e-9) > math.floor(index * share + 1e-9)


def buildings_raster(world: World) -> "Raster":
    """Heights of the buildings alone, bare ground elsewhere [m]: no trees."""
    from ltp._core import Raster

    built = world.classes == LandClass.BUILDING
    heights = np.where(built, world.surface, world.ground)
    return Raster(heights, origin=world.origin, cell=world.cell)


def _standing_raster(world: World, clearance: float) -> "Raster":
    """Heights of what stands on the ground [m]; the ground itself out of a clearance's reach."""
    from ltp._core import Raster

    lowest = float(world.ground.min()) - 2.0 * clearance - 1.0
    heights = np.where(world.height_above_ground > _STANDS, world.surface, lowest)
    return Raster(heights, origin=world.origin, cell=world.cell, outside=lowest)


class _Maker:
    """Draws one scenario at a time over one world."""

    def __init__(self, world: World, options: ScenarioOptions) -> None:
        from ltp._core import HeightSurface

        self._options = options
        self._surface: HeightSurface = HeightSurface(world.surface_raster())
        self._standing: HeightSurface = HeightSurface(_standing_raster(world, options.clearance))
        self._buildings: HeightSurface = HeightSurface(buildings_raster(world))
        self._ground = world.ground_raster()
        self._world = world
        x0, y0, x1, y1 = world.extent
        inset = options.margin
        self._low = np.array([x0 + inset, y0 + inset])
        self._high = np.array([x1 - inset, y1 - inset])
        room = self._high - self._low
        if room.min() < 0.0 or float(np.hypot(*room)) < options.length:
            raise ValueError(
                f"length = {options.length:g} m with margin = {options.margin:g} m does not fit "
                f"into {world.name} ({x1 - x0:g} m x {y1 - y0:g} m)"
            )

    def scenario(self, index: int) -> Scenario:
        options = self._options
        rng = np.random.default_rng(np.random.SeedSequence(options.seed, spawn_key=(index,)))
        needed = must_cross(index, options.through_buildings)
        refused: Counter[str] = Counter()
        for _ in range(options.tries):
            path = self._draw(rng)
            if path is None:
                refused["left the world"] += 1
                continue
            if not self._is_clear(path[:1]):
                near = f"started too near to something solid (clearance = {options.clearance:g} m)"
                refused[near] += 1
                continue
            crosses = self._buildings.first_collision(path) is not None
            if needed and not crosses:
                refused["crossed no building"] += 1
                continue
            return Scenario(index, options.seed, path, crosses)
        reasons = ", ".join(f"{count} {reason}" for reason, count in refused.most_common())
        raise ValueError(
            f"no global path number {index} in {self._world.name} at altitude = "
            f"{options.altitude:g} m above {options.reference}: of {options.tries} lines "
            f"{reasons}. Change altitude, length, margin or through_buildings"
        )

    def _is_clear(self, start: NDArray[np.float64]) -> bool:
        """Whether a flight may start at a point (1, 3)."""
        wanted = self._options.clearance
        height = float(start[0, 2] - self._ground.at(start[0, 0], start[0, 1]))
        room = min(wanted, height / 2.0)
        return bool(
            height > 0.0
            and self._standing.clearance(start, wanted)[0] >= wanted
            and self._surface.clearance(start, wanted)[0] >= room
        )

    def _draw(self, rng: np.random.Generator) -> NDArray[np.float64] | None:
        start = rng.uniform(self._low, self._high)
        heading = rng.uniform(0.0, 2.0 * math.pi)
        direction = np.array([math.cos(heading), math.sin(heading)])
        end = start + self._options.length * direction
        if np.any(end < self._low) or np.any(end > self._high):
            return None
        return self._waypoints(start, direction)

    def _waypoints(
        self, start: NDArray[np.float64], direction: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        options = self._options
        whole = math.ceil(options.length / options.spacing - _SPACING_TOLERANCE)
        along = np.append(np.arange(whole) * options.spacing, options.length)
        path = np.empty((len(along), 3))
        path[:, :2] = start + along[:, None] * direction
        path[:, 2] = options.altitude
        if options.reference == "ground":
            path[:, 2] += self._ground.at(path[:, 0], path[:, 1])
        return path
