# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenStreetMap's water is never landable land, whatever reaches into it; and nothing is buried
that only lies on a lower layer."""

from pathlib import Path

import numpy as np
import pytest

from ltp.world import LandClass, World
from ltp.world.landable import landable_mask
from tests.python.world.importers.osm_extract import Extract, Tags, at, box, read

LAND: list[Tags] = [
    {"leisure": "park"},
    {"leisure": "garden"},
    {"leisure": "pitch"},
    {"leisure": "playground"},
    {"leisure": "golf_course"},
    {"leisure": "dog_park"},
    {"landuse": "grass"},
    {"landuse": "meadow"},
    {"landuse": "farmland"},
    {"landuse": "recreation_ground"},
    {"natural": "beach"},
    {"natural": "sand"},
    {"natural": "grassland"},
    {"amenity": "parking"},
    {"place": "square"},
    {"highway": "pedestrian", "area": "yes"},
    {"aeroway": "runway", "area": "yes"},
]
WATER: list[Tags] = [
    {"natural": "water"},
    {"natural": "water", "water": "river", "layer": "-1"},
    {"natural": "water", "location": "underwater"},
    {"natural": "wetland"},
    {"natural": "bay"},
    {"waterway": "riverbank"},
    {"waterway": "dock"},
    {"waterway": "canal", "area": "yes"},
    {"landuse": "reservoir"},
    {"landuse": "basin", "layer": "-2"},
    {"leisure": "swimming_pool", "layer": "-1"},
    {"amenity": "fountain"},
    {"leisure": "park", "natural": "water"},
    {"landuse": "pond"},
    {"landuse": "farmland", "crop": "rice"},
    {"natural": "beach", "tidal": "yes"},
    {"natural": "shoal"},
    {"place": "sea"},
    {"water": "lake"},
    {"amenity": "swimming_pool"},
]
PIERS: list[Tags] = [
    {"man_made": "pier"},
    {"man_made": "pier", "layer": "1"},
    {"man_made": "bridge"},
    {"man_made": "breakwater"},
    {"place": "island"},
    {"place": "islet"},
]


@pytest.fixture
def world_of(tmp_path: Path):  # type: ignore[no-untyped-def]
    """The world of an extract."""
    return lambda extract: read(extract.write_xml(tmp_path / "a.osm"))


def landable(world: World, preset: str = "wide") -> int:
    return int(landable_mask(world, preset).sum())


@pytest.mark.parametrize("land", LAND, ids=str)
def test_land_that_reaches_into_a_lake_is_wet_there(world_of, land: Tags) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 50), {"natural": "water"})
    extract.way(box(20, 20, 60, 80), land)
    world = world_of(extract)
    assert (world.classes[:, :50] == LandClass.WATER).all()
    assert at(world, 40, 60)[1] not in (LandClass.WATER, LandClass.UNKNOWN)
    assert not landable_mask(world, "wide")[:, :50].any()


@pytest.mark.parametrize("land", LAND[:-1], ids=str)
def test_land_that_reaches_into_the_sea_is_wet_there(world_of, land: Tags) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way([(-20, 50), (120, 50)], {"natural": "coastline"})
    extract.way(box(20, 20, 60, 80), land)
    world = world_of(extract)
    assert (world.classes[:, :50] == LandClass.WATER).all()
    assert at(world, 40, 60)[1] not in (LandClass.WATER, LandClass.UNKNOWN)


@pytest.mark.parametrize("water", WATER, ids=str)
@pytest.mark.parametrize("reach", [box(20, 20, 60, 60), box(-20, 20, 60, 60)], ids=["in", "out"])
def test_water_in_a_park_is_water(world_of, water: Tags, reach: list[tuple[float, float]]) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 100), {"leisure": "park"})
    extract.way(reach, water)
    world = world_of(extract)
    wet = world.classes == LandClass.WATER
    assert wet[20:60, 20:60].all()
    assert not wet[60:].any()
    assert not landable_mask(world, "wide")[21:59, 21:59].any()


@pytest.mark.parametrize("pier", PIERS, ids=str)
@pytest.mark.parametrize("sea", [False, True])
def test_a_park_on_a_pier_or_an_island_is_dry(world_of, pier: Tags, sea: bool) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    if sea:
        extract.way([(-20, 80), (120, 80)], {"natural": "coastline"})
    else:
        extract.way(box(0, 0, 100, 80), {"natural": "water"})
    extract.way(box(20, 20, 60, 60), pier)
    extract.way(box(10, 30, 70, 50), {"leisure": "park"})
    world = world_of(extract)
    grass = np.zeros((100, 100), dtype=bool)
    grass[20:60, 30:50] = True
    assert np.array_equal(world.classes == LandClass.GRASS, grass)
    assert at(world, 65, 40)[1] == LandClass.WATER
    assert at(world, 40, 25)[1] == LandClass.UNKNOWN  # a pier, of planks or stones


def test_a_pond_on_an_island_in_a_lake_is_wet(world_of) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 100), {"natural": "water"})
    extract.way(box(20, 20, 80, 80), {"place": "island", "leisure": "park"})
    extract.way(box(40, 40, 60, 60), {"natural": "water"})
    world = world_of(extract)
    places = ((10, 10), (30, 30), (50, 50))
    wet = [at(world, *xy)[1] for xy in places]
    assert wet == [LandClass.WATER, LandClass.GRASS, LandClass.WATER]


def test_a_sloppy_outline_of_an_island_dries_no_sea(world_of) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way([(-20, 30), (120, 30)], {"natural": "coastline"})
    extract.way(box(0, 0, 100, 100), {"place": "island"})
    extract.way(box(10, 10, 60, 60), {"leisure": "park"})
    world = world_of(extract)
    assert (world.classes[:, :30] == LandClass.WATER).all()
    assert at(world, 40, 40)[1] == LandClass.GRASS


@pytest.mark.parametrize("road", ["residential", "footway", "cycleway", "primary"])
def test_only_bridges_lead_over_open_water(world_of, road: str) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 60), {"natural": "water"})
    extract.way([(10, -10), (10, 110)], {"highway": road})
    extract.way([(30, -10), (30, 110)], {"highway": road, "bridge": "yes", "layer": "1"})
    extract.way([(50, -10), (50, 110)], {"highway": road, "bridge": "viaduct"})
    extract.way([(70, -10), (70, 110)], {"highway": road, "man_made": "pier"})
    extract.way([(90, -10), (90, 110)], {"highway": road, "tunnel": "yes", "layer": "-1"})
    world = world_of(extract)
    for x, wet in ((10, True), (30, False), (50, False), (70, False), (90, True)):
        assert (at(world, x, 30)[1] == LandClass.WATER) == wet
        assert at(world, x, 80)[1] in (
            {LandClass.UNKNOWN} if x == 90 else {LandClass.ROAD, LandClass.PATH}
        )


def test_a_promenade_does_not_overhang_its_river(world_of) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 50), {"natural": "water"})
    extract.way([(0, 52), (100, 52)], {"highway": "residential"})  # 8 m wide: 48 to 56
    world = world_of(extract)
    assert (world.classes[:, :50] == LandClass.WATER).all()
    assert (world.classes[:, 50:56] == LandClass.ROAD).all()


def test_a_road_leads_through_a_marsh(world_of) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 100), {"natural": "wetland"})
    extract.way([(-10, 50), (110, 50)], {"highway": "residential"})
    assert at(world_of(extract), 50, 50)[1] == LandClass.ROAD


# --- layers and what is buried -------------------------------------------------------------------


@pytest.mark.parametrize("layer", ["-1", "-5", "-1;0", "-2;-1", "1", "0"])
@pytest.mark.parametrize(
    ("tags", "there"),
    [
        ({"building": "yes", "height": "30"}, (30.0, LandClass.BUILDING)),
        ({"building:part": "yes", "height": "30"}, (30.0, LandClass.BUILDING)),
        ({"man_made": "storage_tank", "height": "12"}, (12.0, LandClass.BUILDING)),
        ({"natural": "wood", "height": "9"}, (9.0, LandClass.TREES)),
        ({"natural": "water"}, (0.0, LandClass.WATER)),
        ({"landuse": "railway"}, (0.0, LandClass.RAIL)),
        ({"landuse": "construction"}, (0.0, LandClass.CONSTRUCTION)),
    ],
    ids=str,
)
def test_a_layer_only_orders(world_of, tags: Tags, there: object, layer: str) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(0, 0, 100, 100), {"leisure": "park"})
    extract.way(box(20, 20, 60, 60), {**tags, "layer": layer})
    ring = extract.way(box(70, 70, 90, 90))
    extract.multipolygon([(ring, "outer")], {**tags, "layer": layer})
    world = world_of(extract)
    assert at(world, 40, 40) == there
    assert at(world, 80, 80) == there


@pytest.mark.parametrize(
    "how",
    [
        {"location": "underground"},
        {"location": "underground", "layer": "-1"},
        {"location": "indoor"},
        {"indoor": "yes"},
        {"indoor": "room"},
        {"underground": "yes"},
        {"tunnel": "yes"},
    ],
    ids=str,
)
@pytest.mark.parametrize(
    "tags",
    [
        {"building": "yes", "height": "30"},
        {"man_made": "storage_tank", "height": "12"},
        {"natural": "water"},
        {"leisure": "pitch"},
        {"natural": "wood"},
    ],
    ids=str,
)
def test_what_is_buried_leaves_no_trace_but_in_the_report(world_of, tags: Tags, how: Tags) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(90, 90, 95, 95), {"leisure": "park"})
    bare = world_of(extract)
    extract.way(box(20, 20, 60, 60), {**tags, **how})
    full = world_of(extract)
    assert np.array_equal(bare.classes, full.classes)
    assert np.array_equal(bare.surface, full.surface)
    assert any("1 x buried or indoors, such as w2" in line for line in full.report)


def test_a_concourse_below_a_square_is_no_landing_ground(world_of) -> None:  # type: ignore[no-untyped-def]
    extract = Extract()
    extract.way(box(10, 10, 30, 30), {"highway": "pedestrian", "area": "yes", "layer": "-1"})
    extract.way(box(50, 10, 70, 30), {"highway": "pedestrian", "area": "yes"})
    extract.way(box(10, 50, 30, 70), {"leisure": "pitch", "level": "-2;-1"})
    extract.way([(-10, 90), (110, 90)], {"highway": "residential", "layer": "-1"})  # a cutting
    world = world_of(extract)
    kinds = [at(world, *xy)[1] for xy in ((20, 20), (60, 20), (20, 60), (50, 90))]
    assert kinds == [LandClass.UNKNOWN, LandClass.SQUARE, LandClass.UNKNOWN, LandClass.ROAD]
    assert any("a pedestrian area on a layer below" in line for line in world.report)
