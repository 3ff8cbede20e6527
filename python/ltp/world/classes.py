# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What can lie on the ground, what of it may be landed on, and how pictures colour it."""

import enum
from collections.abc import Mapping
from types import MappingProxyType


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


_STRICT = frozenset({LandClass.GRASS, LandClass.BARE, LandClass.PITCH})

#: Which classes may be landed on. `strict`: soft, open and away from traffic. `wide`: also whatever
#: is sealed and level, roads included: in a city about as much landing ground as in the paper.
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
