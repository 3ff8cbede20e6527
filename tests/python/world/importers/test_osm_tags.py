# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the tags of OpenStreetMap say, in all the ways that people write them."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from ltp.world import LandClass
from ltp.world.importers.osm import cover as osm_cover
from ltp.world.importers.osm import standing
from ltp.world.importers.osm import tags as osm_tags


@given(st.text())
def test_no_text_is_too_odd_for_a_number(text: str) -> None:
    keys = ("height", "building:levels", "roof:levels", "width", "lanes", "layer", "diameter")
    tags = dict.fromkeys(keys, text) | {"highway": "primary", "man_made": "tower"}
    for height in (osm_tags.tagged_height(tags), standing.tall(tags)[0]):  # type: ignore[index]
        assert height is None or 0.0 < height <= 1000.0
    road = osm_cover.line_cover(tags)
    assert road is not None
    assert 0.0 < road[1] <= 100.0
    assert osm_tags.buried(tags) in (True, False)


@pytest.mark.parametrize(
    ("tags", "metres"),
    [
        ({"height": "21", "building:levels": "3"}, 21.0),
        ({"building:levels": "3"}, 9.0),
        ({"building:levels": "3", "roof:levels": "1"}, 12.0),
        ({"building:levels": "3", "roof:height": "2.5", "roof:levels": "1"}, 11.5),
        ({"building:levels": "3-4"}, 12.0),
        ({"height": "unknown", "building:levels": "2"}, 6.0),
        ({"min_height": "50", "height": "60"}, 60.0),
        ({"min_height": "50"}, None),
        ({"building:levels": "4000"}, None),
        ({"building:levels": "0"}, None),
        ({}, None),
    ],
)
def test_heights_of_buildings(tags: dict[str, str], metres: float | None) -> None:
    assert osm_tags.tagged_height(tags) == metres


def test_buildings_without_a_height_get_a_usual_one() -> None:
    assert osm_tags.usual_height({"building": "garage"}, 10.0) == 3.0
    assert osm_tags.usual_height({"building": "yes"}, 11.0) == 11.0


@pytest.mark.parametrize(
    ("tags", "buried"),
    [
        ({"tunnel": "yes"}, True),
        ({"tunnel": "building_passage"}, True),
        ({"tunnel": "no"}, False),
        ({"layer": "-1"}, False),
        ({"layer": "-5", "natural": "water"}, False),
        ({"location": "underground", "natural": "water"}, True),
        ({"location": "underwater", "natural": "water"}, False),
        ({"location": "underwater", "man_made": "pipeline"}, True),
        ({"location": "overground", "layer": "-1"}, False),
        ({"location": "underground;overground"}, False),
        ({"tunnel": "culvert", "waterway": "stream"}, True),
        ({"building": "yes", "tunnel": "building_passage"}, False),
        ({"underground": "yes"}, True),
        ({"highway": "footway", "level": "-1"}, True),
        ({"highway": "footway", "level": "-1;0"}, False),
        ({"railway": "rail", "level": "-2"}, False),
        ({"amenity": "fountain", "level": "-1"}, False),
        ({"building": "yes", "level": "-1"}, False),
        ({"indoor": "no"}, False),
        ({"layer": "-2;0"}, False),
        ({"layer": "1"}, False),
        ({"layer": "below"}, False),
        ({"location": "underground"}, True),
        ({"indoor": "yes"}, True),
        ({"bridge": "yes", "layer": "2"}, False),
        ({}, False),
    ],
)
def test_what_lies_below_the_ground(tags: dict[str, str], buried: bool) -> None:
    assert osm_tags.buried(tags) == buried


@pytest.mark.parametrize(
    ("tags", "kind", "width"),
    [
        ({"highway": "residential"}, LandClass.ROAD, 8.0),
        ({"highway": "residential", "lanes": "1"}, LandClass.ROAD, 8.0),
        ({"highway": "primary", "lanes": "6"}, LandClass.ROAD, 19.5),
        ({"highway": "primary", "lanes": "6", "width": "69.6 ft"}, LandClass.ROAD, 21.21408),
        ({"highway": "service", "width": "3"}, LandClass.ROAD, 3.0),
        ({"highway": "service", "width": "300"}, LandClass.ROAD, 4.0),
        ({"highway": "footway"}, LandClass.PATH, 2.5),
        ({"highway": "steps"}, LandClass.UNKNOWN, 2.5),
        ({"railway": "rail"}, LandClass.RAIL, 3.5),
        ({"waterway": "stream"}, LandClass.WATER, 2.0),
    ],
)
def test_widths_of_lines(tags: dict[str, str], kind: LandClass, width: float) -> None:
    cover = osm_cover.line_cover(tags)
    assert cover is not None
    assert cover[0] == kind
    assert cover[1] == pytest.approx(width)


@pytest.mark.parametrize(
    "tags",
    [
        {"highway": "proposed"},
        {"highway": "construction"},
        {"railway": "abandoned"},
        {"power": "line"},
        {"barrier": "wall"},
    ],
    ids=str,
)
def test_lines_that_cover_nothing(tags: dict[str, str]) -> None:
    assert osm_cover.line_cover(tags) is None


@pytest.mark.parametrize(
    ("tags", "kind"),
    [
        ({"leisure": "park"}, LandClass.GRASS),
        ({"landuse": "grass"}, LandClass.GRASS),
        ({"leisure": "pitch"}, LandClass.PITCH),
        ({"amenity": "parking"}, LandClass.PARKING),
        ({"amenity": "parking", "parking": "underground"}, None),
        ({"amenity": "parking", "parking": "multi-storey"}, None),
        ({"highway": "pedestrian"}, LandClass.SQUARE),
        ({"place": "square"}, LandClass.SQUARE),
        ({"natural": "water"}, LandClass.WATER),
        ({"natural": "beach"}, LandClass.BARE),
        ({"natural": "wood"}, LandClass.TREES),
        ({"landuse": "construction"}, LandClass.CONSTRUCTION),
        ({"landuse": "railway"}, LandClass.RAIL),
        ({"landuse": "residential"}, None),
        ({"landuse": "cemetery"}, None),
        ({"building": "yes"}, None),
    ],
)
def test_covers_of_areas(tags: dict[str, str], kind: LandClass | None) -> None:
    assert osm_cover.area_cover(tags) == kind


@pytest.mark.parametrize(
    ("tags", "area"),
    [
        ({"building": "yes"}, True),
        ({"building": "no"}, False),
        ({"building:part": "yes"}, True),
        ({"leisure": "park"}, True),
        ({"leisure": "park", "area": "no"}, False),
        ({"highway": "pedestrian"}, False),
        ({"highway": "pedestrian", "area": "yes"}, True),
        ({"highway": "residential", "junction": "roundabout"}, False),
        ({"railway": "rail"}, False),
        ({"natural": "coastline"}, False),
        ({"man_made": "storage_tank"}, True),
    ],
)
def test_closed_ways_that_are_areas(tags: dict[str, str], area: bool) -> None:
    assert osm_cover.is_area(tags) == area
