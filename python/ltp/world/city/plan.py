# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The ground plan of the built-in city: streets, blocks, river, boulevard, roundabout.

Everything here is in the street frame (u, v): metres from the middle of the map, turned by
`CityPlan.angle` against (east, north), so that streets and blocks are axis-aligned rectangles.
"""

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

SMALLEST_WITH_LANDMARKS = 400.0  # a smaller map has neither river nor boulevard [m]
EMBANKMENT_ROAD = 11.0  # width of the road on each side of the river's corridor [m]


@dataclass(frozen=True)
class Rect:
    """An axis-aligned rectangle in the street frame [m]."""

    u0: float
    v0: float
    u1: float
    v1: float

    @property
    def width(self) -> float:
        """Extent along u [m]."""
        return self.u1 - self.u0

    @property
    def depth(self) -> float:
        """Extent along v [m]."""
        return self.v1 - self.v0

    @property
    def centre(self) -> tuple[float, float]:
        """Its middle (u, v) [m]."""
        return (self.u0 + self.u1) / 2, (self.v0 + self.v1) / 2

    def inset(self, margin: float) -> "Rect":
        """The rectangle that stays `margin` metres away from its edges."""
        return Rect(self.u0 + margin, self.v0 + margin, self.u1 - margin, self.v1 - margin)


@dataclass(frozen=True)
class Street:
    """A straight street: its area, and whether it runs along u (else along v)."""

    area: Rect
    along_u: bool


@dataclass(frozen=True)
class River:
    """A band of water that winds along u through its corridor; bridges cross it along v."""

    corridor: Rect
    width: float  # of the water [m]
    swing: float  # amplitude [m]
    wavelength: float  # [m]
    phase: float  # [rad]
    bridges: tuple[Rect, ...]

    def middle(self, u: NDArray[np.float64]) -> NDArray[np.float64]:
        """V of the middle of the water at `u`."""
        turn = 2.0 * np.pi / self.wavelength * u + self.phase
        return np.asarray(self.corridor.centre[1] + self.swing * np.sin(turn))


@dataclass(frozen=True)
class Boulevard:
    """The diagonal: a straight line through the roundabout at (u, v)."""

    u: float
    v: float
    direction: float  # [rad] against u
    width: float  # from house to house [m]
    roundabout: float  # outer radius [m]


@dataclass(frozen=True)
class CityPlan:
    """All lines of the city, before anything is built."""

    angle: float  # of the street frame against east [rad]
    blocks: tuple[Rect, ...]  # kerb to kerb
    parks: tuple[Rect, ...]  # whole quarters
    streets: tuple[Street, ...]  # avenues first
    river: River | None  # none on a small map
    boulevard: Boulevard | None


def draw_plan(rng: np.random.Generator, size: float) -> CityPlan:
    """Draw the lines of a square city of `size` metres: districts, quarters, blocks."""
    angle = rng.uniform(0.08, 0.30) * rng.choice([-1.0, 1.0])
    reach = 0.5 * size * (math.cos(angle) + abs(math.sin(angle))) + 30.0
    whole = Rect(-reach, -reach, reach, reach)
    corridor = _corridor(rng, size, whole) if size >= SMALLEST_WITH_LANDMARKS else None
    banks = [whole]
    if corridor is not None:
        south, north = replace(whole, v1=corridor.v0), replace(whole, v0=corridor.v1)
        banks = [bank for bank in (south, north) if bank.depth > 30.0]

    avenues: list[Street] = []
    streets: list[Street] = []
    quarters: list[Rect] = []
    for bank in banks:
        for district in _divide(rng, bank, 420.0, (19.0, 28.0), avenues):
            quarters += _divide(rng, district, 235.0, (12.0, 16.0), streets)

    parks = _choose_parks(quarters, size)
    blocks: list[Rect] = []
    for quarter in quarters:
        if quarter not in parks:
            blocks += _divide(rng, quarter, 112.0, (7.0, 11.0), streets)

    return CityPlan(
        angle=angle,
        blocks=tuple(blocks),
        parks=parks,
        streets=(*avenues, *streets),
        river=None if corridor is None else _draw_river(rng, corridor, avenues),
        boulevard=_draw_boulevard(rng, size) if size >= SMALLEST_WITH_LANDMARKS else None,
    )


def _corridor(rng: np.random.Generator, size: float, whole: Rect) -> Rect:
    middle = rng.uniform(-0.30, -0.22) * size
    return replace(whole, v0=middle - 56.0, v1=middle + 56.0)


def _draw_river(rng: np.random.Generator, corridor: Rect, avenues: list[Street]) -> River:
    return River(
        corridor=corridor,
        width=rng.uniform(44.0, 52.0),
        swing=rng.uniform(11.0, 15.0),
        wavelength=rng.uniform(480.0, 700.0),
        phase=rng.uniform(0.0, 2.0 * math.pi),
        bridges=_bridges(avenues, corridor),
    )


def _draw_boulevard(rng: np.random.Generator, size: float) -> Boulevard:
    return Boulevard(
        u=rng.uniform(-0.14, 0.02) * size,
        v=rng.uniform(0.04, 0.14) * size,
        direction=rng.uniform(0.55, 0.85) * rng.choice([-1.0, 1.0]),
        width=38.0,
        roundabout=52.0,
    )


def _divide(
    rng: np.random.Generator,
    area: Rect,
    longest: float,
    widths: tuple[float, float],
    streets: list[Street],
) -> list[Rect]:
    """Halve `area` by streets, across its longer side, until no side exceeds `longest`."""
    if max(area.width, area.depth) <= longest:
        return [area]
    along_u = area.depth > area.width  # the new street runs along the shorter side
    street = rng.uniform(*widths)
    length = max(area.width, area.depth)
    cut = rng.uniform(0.38, 0.62) * length
    if along_u:
        first = Rect(area.u0, area.v0, area.u1, area.v0 + cut - street / 2)
        second = Rect(area.u0, area.v0 + cut + street / 2, area.u1, area.v1)
        between = Rect(area.u0, first.v1, area.u1, second.v0)
    else:
        first = Rect(area.u0, area.v0, area.u0 + cut - street / 2, area.v1)
        second = Rect(area.u0 + cut + street / 2, area.v0, area.u1, area.v1)
        between = Rect(first.u1, area.v0, second.u0, area.v1)
    streets.append(Street(between, along_u))
    return [
        rect for part in (first, second) for rect in _divide(rng, part, longest, widths, streets)
    ]


def _choose_parks(quarters: list[Rect], size: float) -> tuple[Rect, ...]:
    """The quarters nearest to two spots: one west of the centre, one in the far north-east."""
    spots = ((-0.24 * size, -0.02 * size), (0.36 * size, 0.34 * size))
    count = len(quarters) // 6  # a small map needs its few quarters for houses
    nearest = [
        min(quarters, key=lambda rect: math.dist(rect.centre, spot)) for spot in spots[:count]
    ]
    return tuple(dict.fromkeys(nearest))


def _bridges(avenues: list[Street], corridor: Rect) -> tuple[Rect, ...]:
    """Carry the avenues that end at the corridor across it, where they are not too close."""
    bridges: list[Rect] = []
    for street in avenues:
        area = street.area
        touches = area.v1 == corridor.v0 or area.v0 == corridor.v1
        if street.along_u or not touches:
            continue
        deck = Rect(area.u0 + 3.0, corridor.v0, area.u1 - 3.0, corridor.v1)
        if all(abs(deck.centre[0] - other.centre[0]) > 130.0 for other in bridges):
            bridges.append(deck)
    return tuple(bridges)
