# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tags of OpenStreetMap say about what stands on the ground: heights and sizes."""

import re
from collections.abc import Mapping

Tags = Mapping[str, str]

LEVEL_HEIGHT = 3.0  # [m]
_TALLEST = 1000.0  # a height above this is a slip of the keyboard [m]
_FOOT, _INCH = 0.3048, 0.0254

_LENGTH = re.compile(r"~?\s*(\d+(?:[.,]\d+)?)\s*(m|metres?|meters?|ft|feet|foot|')?", re.I)
_FEET_INCHES = re.compile(r"(\d+(?:\.\d+)?)\s*'\s*(\d+(?:\.\d+)?)\s*(?:\"|'')")

# Without any height: usual heights [m]. All others get the caller's default.
_USUAL_HEIGHTS = {
    **dict.fromkeys(("carport", "garage", "garages", "hut", "kiosk", "shed"), 3.0),
    **dict.fromkeys(("bungalow", "greenhouse", "roof"), 5.0),
    **dict.fromkeys(("detached", "house", "semidetached_house", "terrace"), 9.0),
    **dict.fromkeys(("apartments", "church", "dormitory", "hotel"), 15.0),
    "cathedral": 30.0,
}

# Objects that are tall but not buildings: height without a height tag, width of one that is mapped
# as a point [m].
_TALL = {
    ("man_made", "chimney"): (30.0, 3.0),
    ("man_made", "communications_tower"): (100.0, 10.0),
    ("man_made", "crane"): (40.0, 4.0),
    ("man_made", "flagpole"): (12.0, 0.5),
    ("man_made", "mast"): (30.0, 1.0),
    ("man_made", "silo"): (15.0, 6.0),
    ("man_made", "storage_tank"): (8.0, 6.0),
    ("man_made", "tower"): (25.0, 5.0),
    ("man_made", "water_tower"): (30.0, 8.0),
    ("power", "tower"): (30.0, 6.0),
}

_TREE_HEIGHT, _SCRUB_HEIGHT = 10.0, 2.0  # [m]
_CROWN_PER_HEIGHT = 0.45


def length(text: str | None) -> float | None:
    """A length in metres from "12", "12 m", "12,5", "40'", "40 ft", "5'10\\"" or a ;-list of such.

    Of several the largest counts. None if there is no number that makes sense.
    """
    found = [_one_length(part.strip()) for part in (text or "").split(";")]
    sound = [value for value in found if value is not None and 0.0 < value <= _TALLEST]
    return max(sound, default=None)


def _one_length(text: str) -> float | None:
    if match := _FEET_INCHES.fullmatch(text):
        return float(match[1]) * _FOOT + float(match[2]) * _INCH
    if match := _LENGTH.fullmatch(text):
        value, unit = float(match[1].replace(",", ".")), (match[2] or "m").lower()
        return value if unit.startswith("m") else value * _FOOT
    return None


def count(text: str | None) -> float | None:
    """The largest of the numbers in a text such as "3", "2.5" or "3-4"."""
    numbers = [float(n) for n in re.findall(r"\d{1,4}(?:\.\d{1,3})?", text or "")]
    return max(numbers, default=None)


def buried(tags: Tags) -> bool:
    """Whether it lies below the ground or inside of something: tunnels, negative layers, rooms."""
    if tags.get("tunnel", "no") != "no" or tags.get("indoor", "no") != "no":
        return True
    if tags.get("location") in {"underground", "underwater", "indoor"}:
        return True
    layers = re.findall(r"-?\d{1,3}", tags.get("layer", "0"))
    return bool(layers) and max(int(layer) for layer in layers) < 0


def building(tags: Tags) -> bool:
    """Whether it is the outline of a building."""
    return tags.get("building", "no") != "no"


def part(tags: Tags) -> bool:
    """Whether it is a part of a building, with a height of its own."""
    return tags.get("building:part", "no") != "no"


def tagged_height(tags: Tags) -> float | None:
    """Top of a building or part above the ground [m], if its tags give one.

    min_height is left out on purpose: whatever floats counts as solid down to the ground.
    """
    for key in ("height", "building:height", "est_height"):
        if (height := length(tags.get(key))) is not None:
            return height
    levels = count(tags.get("building:levels"))
    if levels is None:
        return None
    roof = length(tags.get("roof:height"))
    if roof is None:
        roof = LEVEL_HEIGHT * (count(tags.get("roof:levels")) or 0.0)
    height = LEVEL_HEIGHT * levels + roof
    return height if 0.0 < height <= _TALLEST else None


def usual_height(tags: Tags, default: float) -> float:
    """Height of a building of that kind that has no height tag [m]."""
    return _USUAL_HEIGHTS.get(tags.get("building", ""), default)


def tall(tags: Tags) -> tuple[float, float] | None:
    """Height and width [m] of a tall object that is no building, such as a chimney; else None."""
    for key in ("man_made", "power"):
        if (usual := _TALL.get((key, tags.get(key, "")))) is not None:
            return tagged_height(tags) or usual[0], length(tags.get("diameter")) or usual[1]
    return None


def tree(tags: Tags) -> tuple[float, float] | None:
    """Height and crown diameter [m] of a tree or a row of trees; else None."""
    if tags.get("natural") not in {"tree", "tree_row"}:
        return None
    height = length(tags.get("height")) or _TREE_HEIGHT
    return height, length(tags.get("diameter_crown")) or _CROWN_PER_HEIGHT * height


def wood_height(tags: Tags) -> float:
    """Height of an area of TREES [m]."""
    usual = _SCRUB_HEIGHT if tags.get("natural") == "scrub" else _TREE_HEIGHT
    return length(tags.get("height")) or usual
