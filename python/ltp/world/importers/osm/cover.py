# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tags of OpenStreetMap say about the ground: its cover, and how wide a line of it is."""

import re

from ltp.world.classes import LandClass

from .lengths import count, length
from .standing import tall, thin
from .tags import Tags, building, part

_LANE_WIDTH = 3.25  # [m]
_WIDEST = 100.0  # a width above this is a slip of the keyboard [m]

# Kerb to kerb, with the usual parked cars [m]; a `width`, or more lanes than that, comes first.
_ROAD_WIDTHS = {
    **dict.fromkeys(("motorway", "trunk", "primary"), 12.0),
    **dict.fromkeys(("secondary", "tertiary", "raceway"), 10.0),
    **dict.fromkeys(("residential", "unclassified", "road", "busway"), 8.0),
    **dict.fromkeys(("motorway_link", "trunk_link", "primary_link"), 6.0),
    **dict.fromkeys(("secondary_link", "tertiary_link", "living_street"), 6.0),
    "service": 4.0,
}
_PATH_WIDTHS = {
    "pedestrian": 6.0,
    "track": 3.0,
    **dict.fromkeys(("footway", "cycleway"), 2.5),
    **dict.fromkeys(("path", "bridleway"), 1.5),
}
_STEPS_WIDTH = 2.5
_RAIL_WIDTHS = dict.fromkeys(("rail", "light_rail", "subway", "tram", "narrow_gauge"), 3.5)
_STREAM_WIDTHS = {"river": 12.0, "canal": 8.0, "stream": 2.0, "ditch": 1.5, "drain": 1.5}

# Cover of an area. Whatever is not here stays UNKNOWN: graveyards, back yards, beds of roses.
_AREAS: dict[LandClass, dict[str, tuple[str, ...]]] = {
    LandClass.GRASS: {
        "landuse": ("grass", "meadow", "village_green", "recreation_ground"),
        "leisure": ("park", "garden", "golf_course", "dog_park"),
        "natural": ("grassland",),
    },
    LandClass.BARE: {"landuse": ("farmland",), "natural": ("sand", "beach")},
    LandClass.PITCH: {"leisure": ("pitch", "playground", "track")},
    LandClass.SQUARE: {
        "place": ("square",),
        "highway": ("pedestrian", "footway"),
        "amenity": ("marketplace",),
    },
    LandClass.PARKING: {"amenity": ("parking", "parking_space")},
    LandClass.PAVED: {"aeroway": ("apron", "runway", "taxiway", "helipad")},
    LandClass.ROAD: {"highway": tuple(_ROAD_WIDTHS)},
    LandClass.WATER: {
        "natural": ("water", "wetland", "bay", "strait", "mud", "hot_spring", "reef", "shoal"),
        "waterway": (
            *("riverbank", "dock", "river", "canal", "stream", "ditch", "drain", "fairway"),
            *("rapids", "waterfall", "fish_pass"),
        ),
        "landuse": ("reservoir", "basin", "pond", "salt_pond", "aquaculture"),
        "leisure": ("swimming_pool", "swimming_area"),
        "amenity": ("fountain", "swimming_pool"),
        "man_made": ("salt_pond",),
        "place": ("sea", "ocean"),
        "crop": ("rice",),
    },
    LandClass.TREES: {"natural": ("wood", "scrub"), "landuse": ("forest",)},
    LandClass.RAIL: {"landuse": ("railway",)},
    LandClass.CONSTRUCTION: {"landuse": ("construction", "brownfield", "landfill", "quarry")},
}
_COVER = {
    (key, value): kind
    for kind, keys in _AREAS.items()
    for key, values in keys.items()
    for value in values
}
_KEYS = tuple(dict.fromkeys(key for key, _ in _COVER))
# What says that an area is wet beside any other tag.
_WET = {
    "tidal": frozenset({"yes"}),
    "water": frozenset(
        [
            "lake",
            "river",
            "pond",
            "reservoir",
            "basin",
            "moat",
            "canal",
            "lagoon",
            "oxbow",
            "yes",
            "tidal",
            "stream",
        ]
    ),
}
# A closed way with one of these is a ring road or a loop of track unless it says area=yes.
_LOOPS = frozenset({"highway", "aeroway"})
_STREAMS = frozenset(_STREAM_WIDTHS)
_MARSHES = frozenset({"wetland", "mud"})
_ISLANDS = frozenset({"island", "islet"})
# What stands in the water or over it: what lies on it is dry.
_DECKS = frozenset({"pier", "bridge", "breakwater", "groyne", "quay", "dyke", "embankment"})
_DAMS = frozenset({"dam", "weir", "lock_gate"})
_SEALED = frozenset(
    {LandClass.SQUARE, LandClass.ROAD, LandClass.PARKING, LandClass.PAVED, LandClass.RAIL}
)
_PARKED_ELSEWHERE = frozenset({"underground", "multi-storey", "rooftop", "sheds", "carports"})


def is_area(tags: Tags) -> bool:
    """Whether a closed way with these tags is an area rather than a loop."""
    if "area" in tags:
        return tags["area"] != "no"
    if building(tags) or part(tags) or "area:highway" in tags or island(tags):
        return True
    if tags.get("man_made") in _DECKS - {"groyne", "dyke", "embankment"}:
        return True
    if tall(tags) is not None and not thin(tags):
        return True
    if tags.get("waterway") in _STREAMS and not {"natural", "landuse", "leisure"} & tags.keys():
        return False
    if "waterway" not in tags and "highway" not in tags and _wet(tags):
        return True
    return any((key, tags.get(key, "")) in _COVER for key in _KEYS if key not in _LOOPS)


def area_cover(tags: Tags) -> LandClass | None:
    """What covers an area with these tags, None where they do not say."""
    if tags.get("parking", "") in _PARKED_ELSEWHERE:
        return None
    found = [_COVER[pair] for key in _KEYS if (pair := (key, tags.get(key, ""))) in _COVER]
    if LandClass.WATER in found or _wet(tags):  # a park that is a wetland, too
        return LandClass.WATER
    if found:
        return found[0]
    return LandClass.ROAD if "area:highway" in tags else None


def _wet(tags: Tags) -> bool:
    return any(tags.get(key, "") in values for key, values in _WET.items())


def island(tags: Tags) -> bool:
    """Whether it is land in the water, which counts where a lake forgets to leave it out."""
    return tags.get("place") in _ISLANDS


def deck(tags: Tags) -> bool:
    """Whether it is an area or a line that stands in the water or over it, such as a pier."""
    if tags.get("man_made") in _DECKS or tags.get("waterway") in _DAMS:
        return True
    if tags.get("bridge", "no") != "no" or tags.get("floating") == "yes":
        return True
    above = (count(tags.get("layer")) or 0.0) > 0.0
    return above and ("highway" in tags or "railway" in tags or area_cover(tags) in _SEALED)


def concourse(tags: Tags) -> bool:
    """Whether it is a road or pedestrian area below the others: under a station, more often than
    not, and so no landing ground.
    """
    layers = re.findall(r"-?\d+", tags.get("layer", "0"))
    return "highway" in tags and bool(layers) and all(layer.startswith("-") for layer in layers)


def marsh(tags: Tags) -> bool:
    """Whether it is wet ground through which roads lead without a bridge."""
    return tags.get("natural") in _MARSHES


def line_cover(tags: Tags) -> tuple[LandClass, float] | None:
    """What covers a line with these tags, and how wide it is [m]; None where they do not say."""
    highway = tags.get("highway", "")
    if highway in _ROAD_WIDTHS:
        lanes = _LANE_WIDTH * min(count(tags.get("lanes")) or 0.0, 20.0)
        return LandClass.ROAD, _width(tags, max(lanes, _ROAD_WIDTHS[highway]))
    if highway in _PATH_WIDTHS:
        return LandClass.PATH, _width(tags, _PATH_WIDTHS[highway])
    if highway == "steps":  # neither flat nor known to be clear
        return LandClass.UNKNOWN, _width(tags, _STEPS_WIDTH)
    if tags.get("railway") in _RAIL_WIDTHS:
        return LandClass.RAIL, _RAIL_WIDTHS[tags["railway"]]
    if tags.get("waterway") in _STREAM_WIDTHS:
        return LandClass.WATER, _width(tags, _STREAM_WIDTHS[tags["waterway"]])
    return None


def _width(tags: Tags, usual: float) -> float:
    given = length(tags.get("width")) or length(tags.get("est_width"))
    return given if given is not None and given <= _WIDEST else usual
