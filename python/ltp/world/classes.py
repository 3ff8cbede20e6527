# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What can lie on the ground, what of it may be landed on, and how pictures colour it."""

import enum
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import SupportsIndex


class LandClass(enum.IntEnum):
    """What lies on the ground as seen from above; stored as uint8."""

    UNKNOWN = 0
    GRASS = 1
    BARE = 2
    PAVED = 3  # sealed, use unknown: roads and yards together
    SQUARE = 4
    ROAD = 5
    PARKING = 6
    PITCH = 7
    PATH = 8
    WATER = 9
    BUILDING = 10
    TREES = 11  # anything under a canopy
    RAIL = 12
    CONSTRUCTION = 13
    GROUND = 14  # bare-earth return of a laser survey, cover unknown


def land_class(kind: LandClass | str | int) -> LandClass:
    """The class of that name (in any case) or number.

    Raises:
        ValueError: if there is none, naming those there are.
    """
    try:
        return LandClass[kind.upper()] if isinstance(kind, str) else LandClass(kind)
    except (KeyError, ValueError):
        names = ", ".join(c.name.lower() for c in LandClass)
        raise ValueError(f"class must be one of {names}, not {kind!r}") from None


_STRICT = frozenset({LandClass.GRASS, LandClass.BARE, LandClass.PITCH})

#: Which classes may be landed on. `strict`: soft, open and away from traffic. `wide`: also whatever
#: is sealed and level, roads included: in a city about as much landing ground as in the paper.
#: Neither says how steep or rough such ground may be: for both that is up to `LandingLimits`.
LANDABLE_PRESETS: Mapping[str, frozenset[LandClass]] = MappingProxyType(
    {
        "strict": _STRICT,
        "wide": _STRICT
        | {
            LandClass.PAVED,
            LandClass.SQUARE,
            LandClass.ROAD,
            LandClass.PARKING,
            LandClass.PATH,
            LandClass.GROUND,
        },
    }
)

#: RGB, each 0...255, for pictures and legends.
CLASS_COLOURS: Mapping[LandClass, tuple[int, int, int]] = MappingProxyType(
    {
        LandClass.UNKNOWN: (201, 196, 206),
        LandClass.GRASS: (164, 207, 126),
        LandClass.BARE: (222, 200, 156),
        LandClass.PAVED: (214, 211, 204),
        LandClass.SQUARE: (236, 222, 196),
        LandClass.ROAD: (150, 152, 158),
        LandClass.PARKING: (184, 190, 205),
        LandClass.PITCH: (104, 186, 148),
        LandClass.PATH: (240, 232, 214),
        LandClass.WATER: (126, 180, 222),
        LandClass.BUILDING: (186, 118, 100),
        LandClass.TREES: (70, 134, 76),
        LandClass.RAIL: (112, 98, 118),
        LandClass.CONSTRUCTION: (226, 164, 92),
        LandClass.GROUND: (230, 219, 190),
    }
)


#: A name in `LANDABLE_PRESETS`, or classes by name or number.
Landable = str | Iterable[LandClass | str | int]


def landable_classes(landable: Landable) -> frozenset[LandClass]:
    """The classes that may be landed on.

    Args:
        landable: a name in `LANDABLE_PRESETS`, or classes by name (in any case) or number.

    Raises:
        ValueError: naming what is neither; also for TREES, which nothing lands on.
    """
    if isinstance(landable, str):
        if landable not in LANDABLE_PRESETS:
            known = ", ".join(LANDABLE_PRESETS)
            raise ValueError(f"landable must be one of {known} or land classes, not {landable!r}")
        return LANDABLE_PRESETS[landable]
    if not isinstance(landable, Iterable):
        raise ValueError(f"landable must be land classes, not {landable!r}")
    allowed: set[LandClass] = set()
    for kind in landable:
        if (found := _class(kind)) is None:
            raise ValueError(f"landable must be land classes: {kind!r} is none of {_NAMES}")
        allowed.add(found)
    if LandClass.TREES in allowed:
        raise ValueError("landable must not contain TREES: nothing lands on a canopy")
    return frozenset(allowed)


_NAMES = ", ".join(kind.name.lower() for kind in LandClass)


def _class(kind: object) -> LandClass | None:
    """The class of a name or number, if there is one."""
    if isinstance(kind, str):
        return LandClass.__members__.get(kind.upper())
    if isinstance(kind, bool) or not isinstance(kind, SupportsIndex):
        return None
    known = {int(number): number for number in LandClass}
    return known.get(kind.__index__())
