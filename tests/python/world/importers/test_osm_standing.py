# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever stands counts by its height, as a point, a line or an area; nothing else does."""

from pathlib import Path

import numpy as np
import pytest

from ltp.world import LandClass
from ltp.world.importers.osm.standing import tall
from tests.python.world.importers.osm_extract import Extract, Tags, at, box, read

KNOWN: list[Tags] = [
    {"power": "generator", "generator:source": "wind"},
    {"man_made": "lighthouse"},
    {"man_made": "windmill"},
    {"man_made": "gasometer"},
    {"man_made": "obelisk"},
    {"man_made": "cooling_tower"},
    {"man_made": "antenna"},
    {"man_made": "storage_tank"},
    {"man_made": "silo"},
    {"man_made": "chimney"},
    {"man_made": "mast"},
    {"man_made": "crane"},
    {"man_made": "flagpole"},
    {"man_made": "water_tower"},
    {"man_made": "tower", "tower:type": "communication"},
    {"historic": "monument"},
    {"attraction": "big_wheel"},
    {"attraction": "drop_tower"},
    {"bridge:support": "pylon"},
    {"aerialway": "pylon"},
    {"power": "tower"},
    {"power": "pole"},
    {"aeroway": "control_tower"},
    {"building": "yes"},
]
OTHERS: list[Tags] = [
    {"man_made": "something_new"},
    {"historic": "memorial"},
    {"historic": "city_gate"},
    {"tourism": "attraction"},
    {"tourism": "artwork"},
    {"attraction": "swing_carousel"},
    {"power": "insulator"},
    {"advertising": "column"},
    {"amenity": "clock"},
    {"natural": "stone"},
    {"highway": "street_lamp"},
    {"waterway": "dam"},
    {"railway": "signal"},
    {"ruins": "yes"},
    {"landmark": "statue"},
    {"sport": "climbing"},
    {"leisure": "bungee_jumping"},
    {"disused:man_made": "chimney"},
]
NOT_STANDING: list[Tags] = [
    {"barrier": "height_restrictor"},
    {"barrier": "gate"},
    {"barrier": "lift_gate"},
    {"barrier": "kerb"},
    {"highway": "residential"},
    {"highway": "crossing"},
    {"natural": "peak"},
    {"natural": "cliff"},
    {"natural": "water"},
    {"waterway": "waterfall"},
    {"entrance": "main"},
    {"door": "hinged"},
    {"railway": "rail"},
    {"power": "line"},
    {"aerialway": "gondola"},
    {"landuse": "quarry"},
    {"leisure": "park"},
    {"place": "square"},
    {"boundary": "administrative"},
    {"tourism": "viewpoint"},
    {"man_made": "cutline"},
    {"amenity": "fountain"},
    {"demolished:man_made": "chimney"},
    {"proposed:building": "yes"},
    {"amenity": "parking_entrance"},
]


def town() -> Extract:
    extract = Extract()
    extract.way(box(90, 90, 95, 95), {"building": "yes", "height": "7"})
    return extract


@pytest.mark.parametrize("tags", [*KNOWN, *OTHERS], ids=str)
def test_whatever_stands_counts_by_its_height(tmp_path: Path, tags: Tags) -> None:
    told = {**tags, "height": "80"}
    point, area, ring, line = town(), town(), town(), town()
    point.node(40.5, 40.5, told)
    area.way(box(30, 30, 50, 50), told)
    ring.multipolygon([(ring.way(box(30, 30, 50, 50)), "outer")], told)
    line.way([(20, 40.5), (60, 40.5)], told)
    for extract in (point, area, ring, line):
        if extract is line and "building" in tags:
            continue
        world = read(extract.write_xml(tmp_path / "a.osm"))
        assert at(world, 40, 40) == (80.0, LandClass.BUILDING)
        assert at(world, 5, 5) == (0.0, LandClass.UNKNOWN)


@pytest.mark.parametrize("tags", KNOWN, ids=str)
def test_known_kinds_have_a_usual_height_which_is_reported_as_a_guess(
    tmp_path: Path, tags: Tags
) -> None:
    extract = town()
    extract.node(40.5, 40.5, tags)
    world = read(extract.write_xml(tmp_path / "a.osm"), default_height=11.0)
    height, kind = at(world, 40, 40)
    assert kind == LandClass.BUILDING
    assert 5.0 < height <= 100.0
    if "building" in tags:
        assert height == 11.0
        assert any("1 are guessed (usual for the kind, else 11 m)" in s for s in world.report)
    else:
        assert "Heights of other tall things: 1 of 1 are guessed." in world.report


@pytest.mark.parametrize("tags", NOT_STANDING, ids=str)
def test_what_does_not_stand_is_not_raised(tmp_path: Path, tags: Tags) -> None:
    told = {**tags, "height": "4.5", "maxheight": "4.5"}
    del told["maxheight" if tags.get("barrier") != "height_restrictor" else "height"]
    extract = town()
    extract.node(40.5, 40.5, told)
    extract.way([(20, 20), (60, 20)], told)
    extract.way(box(20, 60, 40, 80), told)
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert np.count_nonzero(world.surface) == 25  # the house alone


@pytest.mark.parametrize("key", ["est_height", "building:height", "height:total", "height:tip"])
def test_other_keys_tell_a_height_too(tmp_path: Path, key: str) -> None:
    extract = town()
    extract.node(40.5, 40.5, {"man_made": "chimney", key: "55 m"})
    extract.way(box(10, 10, 20, 20), {"building": "yes", key: "180 ft"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 40, 40)[0] == 55.0
    assert at(world, 15, 15)[0] == pytest.approx(54.864)


def test_a_wind_turbine_sweeps_its_rotor(tmp_path: Path) -> None:
    extract = town()
    turbine = {"power": "generator", "generator:source": "wind"}
    extract.node(40.5, 40.5, {**turbine, "height:hub": "60", "rotor:diameter": "40"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 40, 40)[0] == 80.0
    assert at(world, 57, 40)[0] == 80.0
    assert at(world, 65, 40)[0] == 0.0


def test_a_diameter_is_taken_at_its_word(tmp_path: Path) -> None:
    extract = town()
    extract.node(40.5, 40.5, {"man_made": "storage_tank", "height": "12", "diameter": "30"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert np.count_nonzero(world.surface == 12.0) == pytest.approx(np.pi * 15**2, rel=0.15)


def test_a_tree_is_a_tree(tmp_path: Path) -> None:
    extract = town()
    extract.node(40.5, 40.5, {"natural": "tree", "height": "18", "man_made": "no"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 40, 40) == (18.0, LandClass.TREES)
    assert tall({"natural": "tree", "height": "18"}) is None
    assert tall({"natural": "tree_row", "height": "18"}) is None


def test_a_bench_below_a_tree_is_below_a_tree(tmp_path: Path) -> None:
    extract = town()
    extract.node(40.5, 40.5, {"natural": "tree", "height": "18"})
    extract.node(41.5, 40.5, {"amenity": "bench", "height": "0.8"})
    extract.node(60.5, 40.5, {"amenity": "bench", "height": "0.8"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 41, 40) == (18.0, LandClass.TREES)
    assert at(world, 60, 40) == (0.8, LandClass.BUILDING)


def test_a_wall_round_a_yard_is_no_block(tmp_path: Path) -> None:
    extract = town()
    extract.way(box(10, 10, 50, 50), {"barrier": "wall", "height": "3"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 10, 30)[0] == 3.0
    assert at(world, 30, 30)[0] == 0.0


def test_a_building_node_without_a_height_leaves_its_outline_alone(tmp_path: Path) -> None:
    extract = town()
    extract.way(box(10, 10, 50, 50), {"building": "yes", "height": "6"})
    extract.node(30.5, 30.5, {"building": "yes", "shop": "yes"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 30, 30)[0] == 6.0


def test_what_stands_on_a_roof_stands_on_top_of_it(tmp_path: Path) -> None:
    extract = town()
    extract.way(box(10, 10, 50, 50), {"building": "yes", "height": "20"})
    extract.node(30.5, 30.5, {"man_made": "mast", "height": "6", "location": "roof"})
    assert at(read(extract.write_xml(tmp_path / "a.osm")), 30, 30)[0] == 26.0


def test_a_part_in_the_air_is_higher_than_where_it_begins(tmp_path: Path) -> None:
    extract = town()
    extract.way(box(10, 10, 30, 30), {"building:part": "yes", "min_height": "40"})
    extract.way(box(40, 10, 60, 30), {"building": "yes", "building:min_level": "12"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 20, 20)[0] == 43.0
    assert at(world, 50, 20)[0] == 39.0


def test_wires_are_not_raised_and_the_report_says_so(tmp_path: Path) -> None:
    extract = town()
    extract.way([(0, 20), (100, 20)], {"power": "line", "height": "30"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 50, 20)[0] == 0.0
    assert any("1 wires and ropes between pylons, such as w2" in line for line in world.report)
