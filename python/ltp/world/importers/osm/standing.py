# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Which things of OpenStreetMap stand though they are no buildings, and how high they are."""

from typing import NamedTuple

from .lengths import length
from .tags import Tags, told_height


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


class Standing(NamedTuple):
    """The size of a thing that stands."""

    height: float  # of its top above the ground [m]
    width: float  # of what is mapped as a point, or thickness of a line [m]
    told: bool  # whether its tags tell the height


# Things that are known to be tall: height without a height tag, width of one that is mapped as a
# point [m]. Both are *assumed*, as usual for their kind.
_KNOWN = {
    ("man_made", "antenna"): (15.0, 1.0),
    ("man_made", "chimney"): (30.0, 3.0),
    ("man_made", "communications_tower"): (100.0, 10.0),
    ("man_made", "cooling_tower"): (80.0, 50.0),
    ("man_made", "crane"): (40.0, 4.0),
    ("man_made", "cross"): (8.0, 2.0),
    ("man_made", "flagpole"): (12.0, 0.5),
    ("man_made", "flare"): (50.0, 3.0),
    ("man_made", "gantry"): (8.0, 2.0),
    ("man_made", "gasometer"): (30.0, 40.0),
    ("man_made", "kiln"): (10.0, 5.0),
    ("man_made", "lighthouse"): (30.0, 8.0),
    ("man_made", "mast"): (30.0, 1.0),
    ("man_made", "minaret"): (30.0, 4.0),
    ("man_made", "monitoring_station"): (3.0, 2.0),
    ("man_made", "obelisk"): (15.0, 4.0),
    ("man_made", "offshore_platform"): (50.0, 60.0),
    ("man_made", "oil_gas_separator"): (8.0, 4.0),
    ("man_made", "pylon"): (30.0, 6.0),
    ("man_made", "pumpjack"): (8.0, 6.0),
    ("man_made", "silo"): (15.0, 6.0),
    ("man_made", "storage_tank"): (8.0, 6.0),
    ("man_made", "tower"): (25.0, 5.0),
    ("man_made", "utility_pole"): (10.0, 0.5),
    ("man_made", "water_tower"): (30.0, 8.0),
    ("man_made", "windmill"): (20.0, 25.0),
    ("man_made", "windpump"): (12.0, 4.0),
    ("power", "catenary_mast"): (8.0, 0.5),
    ("power", "pole"): (10.0, 0.5),
    ("power", "portal"): (12.0, 12.0),
    ("power", "tower"): (30.0, 6.0),
    ("aerialway", "pylon"): (15.0, 3.0),
    ("bridge:support", "pylon"): (50.0, 8.0),
    ("bridge:support", "tower"): (50.0, 8.0),
    ("attraction", "big_wheel"): (40.0, 40.0),
    ("attraction", "drop_tower"): (40.0, 6.0),
    ("attraction", "roller_coaster"): (20.0, 10.0),
    ("aeroway", "control_tower"): (30.0, 10.0),
    ("historic", "monument"): (10.0, 6.0),
    ("historic", "tower"): (20.0, 8.0),
    ("historic", "obelisk"): (15.0, 4.0),
    ("landmark", "chimney"): (30.0, 3.0),
    ("railway", "water_tower"): (15.0, 6.0),
}
_KEYS = tuple(dict.fromkeys(key for key, _ in _KNOWN))
_WIND_TURBINE = 100.0  # [m], *assumed*
_ROTOR_PER_HEIGHT = 2 / 3  # tip height to rotor diameter, *assumed*; blades sweep all of it
_WIDTH_PER_HEIGHT, _THINNEST, _WIDEST = 0.05, 1.0, 10.0  # of any other thing, *assumed* [m]
_WALL_WIDTH = 0.3  # *assumed* [m]

# Where `height` is no height of something that stands but a clearance, a drop of the land, a wire:
# never with these keys; of these, only with these values; of these, all but with these values.
_NEVER = (
    "entrance",
    "door",
    "window",
    "landuse",
    "place",
    "boundary",
    "route",
    "area:highway",
    "ford",
    "mountain_pass",
    "cutting",
    "maxheight",
)
_GONE = ("proposed:", "planned:", "demolished:", "removed:", "razed:", "destroyed:", "was:")
_ONLY = {
    "highway": frozenset({"street_lamp", "elevator", "speed_camera", "toll_gantry"}),
    "natural": frozenset({"rock", "stone", "monolith", "arch"}),
    "waterway": frozenset({"dam", "weir", "lock_gate", "boat_lift"}),
    "railway": _words(
        "station halt platform signal signal_box water_tower water_crane gantry tower "
        "ventilation_shaft catenary_mast loading_ramp loading_rack"
    ),
    "aerialway": frozenset({"pylon", "station"}),
}
_EXCEPT = {
    "barrier": _words(
        "gate lift_gate swing_gate sliding_gate sliding_beam hampshire_gate kissing_gate "
        "wicket_gate height_restrictor kerb entrance cattle_grid stile cycle_barrier "
        "motorcycle_barrier horse_stile bump_gate chain rope border_control sally_port "
        "full-height_turnstile ditch spikes"
    ),
    "power": frozenset({"line", "minor_line", "cable"}),
    "man_made": _words(
        "cutline clearcut adit mineshaft embankment manhole tunnel survey_point "
        "reservoir_covered water_well petroleum_well borehole spoil_heap"
    ),
    "leisure": _words(
        "park garden pitch golf_course track playground nature_reserve common dog_park fishing "
        "swimming_pool swimming_area marina slipway beach_resort horse_riding"
    ),
    "tourism": frozenset({"viewpoint", "camp_site", "caravan_site", "picnic_site"}),
    "amenity": frozenset(
        {"fountain", "parking", "parking_space", "parking_entrance", "grave_yard"}
    ),
    "historic": frozenset({"battlefield", "district"}),
}
#: Wires and ropes: obstacles that no raster of heights can hold.
_WIRES = {
    "power": _EXCEPT["power"] - {"cable"},
    "aerialway": _words(
        "cable_car gondola mixed_lift chair_lift drag_lift t-bar j-bar platter rope_tow "
        "goods zip_line"
    ),
}
# Closed ways with one of these are loops of something thin.
_THIN = frozenset({"barrier", "roller_coaster"})
_THIN_MAN_MADE = frozenset({"pipeline", "goods_conveyor", "embankment", "dyke", "groyne"})


def tall(tags: Tags) -> Standing | None:
    """Size of something that is no building and stands on the ground, such as a chimney; else None.

    Known kinds have a usual height where none is told. Anything else stands if its tags tell a
    height and nothing says that it is not the height of something standing: the clearance of a
    gate or a road, the drop of a cliff, a tree, a wire.
    """
    kind = next((pair for key in _KEYS if (pair := (key, tags.get(key, ""))) in _KNOWN), None)
    told = told_height(tags)
    if _wind_turbine(tags):
        height = told.height if told else _WIND_TURBINE
        rotor = length(tags.get("rotor:diameter")) or _ROTOR_PER_HEIGHT * height
        return Standing(height, rotor, told is not None)
    if kind is not None:
        usual_height, usual_width = _KNOWN[kind]
        height = told.height if told else usual_height
        if kind == ("attraction", "big_wheel"):  # as wide as it is high, whichever way it faces
            usual_width = height
        return Standing(height, length(tags.get("diameter")) or usual_width, told is not None)
    if told is None or told.by_levels or not _may_stand(tags):
        return None
    usual = min(max(_WIDTH_PER_HEIGHT * told.height, _THINNEST), _WIDEST)
    usual = _WALL_WIDTH if "barrier" in tags else usual
    width = length(tags.get("diameter")) or length(tags.get("width")) or usual
    return Standing(told.height, width, told=True)


def thin(tags: Tags) -> bool:
    """Whether a closed way of a standing thing is a loop of it, such as a wall, and no area."""
    return any(key in tags for key in _THIN) or tags.get("man_made", "") in _THIN_MAN_MADE


def wire(tags: Tags) -> bool:
    """Whether it is a wire or rope between pylons: an obstacle that is not raised."""
    return any(tags.get(key, "") in values for key, values in _WIRES.items())


def _wind_turbine(tags: Tags) -> bool:
    source = tags.get("generator:source") == "wind" and tags.get("power") == "generator"
    return source or tags.get("man_made") == "wind_turbine"


def _may_stand(tags: Tags) -> bool:
    if any(tags.get(key, "no") != "no" for key in _NEVER):
        return False
    if any(key.startswith(_GONE) for key in tags):
        return False
    if any(key in tags and tags[key] not in values for key, values in _ONLY.items()):
        return False
    return not any(tags.get(key, "") in values for key, values in _EXCEPT.items())
