# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tags of OpenStreetMap say of what stands on the ground: heights, and what is buried."""

import re
from collections.abc import Mapping
from typing import NamedTuple

from .lengths import TALLEST, count, length

Tags = Mapping[str, str]

LEVEL_HEIGHT = 3.0  # *assumed*, the usual reading of building:levels [m]

# Without any height: usual heights [m], *assumed*. All others get the caller's default.
_USUAL_HEIGHTS = {
    **dict.fromkeys(("carport", "garage", "garages", "hut", "kiosk", "shed"), 3.0),
    **dict.fromkeys(("bungalow", "greenhouse", "roof"), 5.0),
    **dict.fromkeys(("detached", "house", "semidetached_house", "terrace"), 9.0),
    **dict.fromkeys(("apartments", "church", "dormitory", "hotel"), 15.0),
    **dict.fromkeys(("silo", "storage_tank", "grain_silo", "digester"), 15.0),
    **dict.fromkeys(("tower", "bell_tower", "lighthouse", "windmill", "gasometer"), 30.0),
    **dict.fromkeys(("cathedral", "water_tower", "stadium", "skyscraper", "chimney"), 30.0),
    "cooling_tower": 80.0,
}
_HEIGHT_KEYS = ("height", "building:height", "est_height", "estimated_height")
_ABOUT_THE_HEIGHT = ("source", "accuracy", "date", "note", "ele", "eaves", "min", "hub")
_READ_AS_LENGTHS = (*_HEIGHT_KEYS, "min_height", "roof:height")
_READ_AS_COUNTS = ("building:levels", "roof:levels", "building:min_level")

_TREE_HEIGHT, _SCRUB_HEIGHT = 10.0, 2.0  # *assumed* [m]
_CROWN_PER_HEIGHT = 0.45  # *assumed*

_BURIED_PLACES = frozenset({"underground", "underwater", "indoor", "indoors", "subsea"})
# Values of `tunnel` that lead something through or below a building, which stands itself.
_PASSAGES = frozenset({"building_passage", "avalanche_protector", "covered", "arcade"})


class Told(NamedTuple):
    """A height that the tags tell, and whether they tell it in storeys."""

    height: float  # of the top above the ground [m]
    by_levels: bool


def buried(tags: Tags) -> bool:
    """Whether it lies below the ground or inside of something: tunnels, rooms, cellars.

    `layer` only says what lies over what where two things cross: a lake with layer=-1 is a lake.
    Water that lies under water is water.
    """
    if tags.get("tunnel", "no") != "no" and not (stands_over(tags) and _passage(tags)):
        return True
    if _basement(tags) or any(tags.get(key, "no") != "no" for key in ("indoor", "underground")):
        return True
    places = {place.strip() for place in tags.get("location", "").split(";")}
    if _wet(tags):
        places -= {"underwater"}
    return bool(places) and places <= _BURIED_PLACES


def stands_over(tags: Tags) -> bool:
    """Whether it is a building or a part of one."""
    return building(tags) or part(tags)


def _passage(tags: Tags) -> bool:
    return tags["tunnel"] in _PASSAGES


def _basement(tags: Tags) -> bool:
    """Whether it lies on floors below the ground, as `level` counts them."""
    if stands_over(tags) or _wet(tags) or "railway" in tags:  # no landing ground, wherever it is
        return False
    floors = re.findall(r"-?\d+", tags.get("level", ""))
    return bool(floors) and all(floor.startswith("-") for floor in floors)


def _wet(tags: Tags) -> bool:
    return (
        tags.get("natural") in {"water", "wetland", "bay", "strait"}
        or tags.get("leisure") == "swimming_pool"
        or tags.get("amenity") == "fountain"
        or any(key in tags for key in ("water", "waterway"))
    )


def building(tags: Tags) -> bool:
    """Whether it is the outline of a building."""
    return tags.get("building", "no") != "no"


def part(tags: Tags) -> bool:
    """Whether it is a part of a building, with a height of its own."""
    return tags.get("building:part", "no") != "no"


def told_height(tags: Tags) -> Told | None:
    """Top of something above the ground, if its tags tell it: a height first, then storeys.

    min_height does not come off: whatever floats counts as solid down to the ground.
    """
    for key in (*_HEIGHT_KEYS, *_special_heights(tags)):
        if (height := length(tags.get(key))) is not None:
            return Told(height, by_levels=False)
    hub, rotor = length(tags.get("height:hub")), length(tags.get("rotor:diameter"))
    if hub is not None:
        return Told(hub + (rotor or 0.0) / 2.0, by_levels=False)
    roof = length(tags.get("roof:height"))
    if roof is None:
        roof = LEVEL_HEIGHT * (count(tags.get("roof:levels")) or 0.0)
    if (eaves := length(tags.get("height:eaves"))) is not None:
        return Told(eaves + roof, by_levels=False)
    levels = count(tags.get("building:levels"))
    if levels is None:
        return None
    height = LEVEL_HEIGHT * levels + roof
    return Told(height, by_levels=True) if 0.0 < height <= TALLEST else None


def tagged_height(tags: Tags) -> float | None:
    """Top of a building or part above the ground [m], if its tags tell one."""
    told = told_height(tags)
    return None if told is None else told.height


def usual_height(tags: Tags, default: float) -> float:
    """Height of a building of that kind that has no height tag [m].

    What begins at a `min_height` is at least a storey higher than that.
    """
    kind = tags.get("building", "")
    usual = _USUAL_HEIGHTS.get(kind, _USUAL_HEIGHTS.get(tags.get("man_made", ""), default))
    return max(usual, floor_height(tags))


def floor_height(tags: Tags) -> float:
    """The least top that something with a `min_height` or `building:min_level` has [m], else 0."""
    lowest = length(tags.get("min_height")) or 0.0
    lowest = max(lowest, LEVEL_HEIGHT * (count(tags.get("building:min_level")) or 0.0))
    return min(lowest + LEVEL_HEIGHT, TALLEST) if lowest > 0.0 else 0.0


def not_understood(tags: Tags) -> list[str]:
    """The tags about heights that nobody could read, as "height='tall'"."""
    lengths = (*_READ_AS_LENGTHS, *_special_heights(tags))
    odd = [key for key in lengths if key in tags and length(tags[key]) is None]
    odd += [key for key in _READ_AS_COUNTS if key in tags and count(tags[key]) is None]
    zero = {"min_height", "roof:height"}  # where nothing is a height, too
    return [f"{key}={tags[key]!r}" for key in odd if not (key in zero and _is_zero(tags[key]))]


def _is_zero(text: str) -> bool:
    return count(text) == 0.0


def _special_heights(tags: Tags) -> list[str]:
    """Keys such as height:total, which count where there is no plain height."""
    keys = [key for key in tags if key.startswith(("height:", "building:height:"))]
    return sorted(key for key in keys if key.rpartition(":")[2] not in _ABOUT_THE_HEIGHT)


def tree(tags: Tags) -> tuple[float, float] | None:
    """Height and crown diameter [m] of a tree or a row of trees; else None."""
    if tags.get("natural") not in {"tree", "tree_row"}:
        return None
    height = plant_height(tags) or _TREE_HEIGHT
    return height, length(tags.get("diameter_crown")) or _CROWN_PER_HEIGHT * height


def wood_height(tags: Tags) -> float:
    """Height of an area of TREES [m]."""
    usual = _SCRUB_HEIGHT if tags.get("natural") == "scrub" else _TREE_HEIGHT
    return plant_height(tags) or usual


def plant_height(tags: Tags) -> float | None:
    """Height of a tree or a wood [m], if its tags tell one."""
    return length(tags.get("height")) or length(tags.get("est_height"))
