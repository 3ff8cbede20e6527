# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenStreetMap extracts become a world: buildings, streets, water; damaged ones an error."""

import importlib
import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ltp.installed import pip_install
from ltp.world import LandClass, World
from ltp.world.importers import osm
from tests.python.world.importers.osm_extract import BOUNDS, CRS, SOUTH, WEST, Extract, at, box


@pytest.fixture
def read(tmp_path: Path) -> Callable[..., World]:
    """Write an extract and read it back as a world of 100 m x 100 m."""

    def write_and_read(extract: Extract, **options: Any) -> World:
        path = extract.write_xml(tmp_path / "a.osm")
        return osm.read(path, **{"bounds": BOUNDS, "crs": CRS, **options})

    return write_and_read


def town() -> Extract:
    extract = Extract()
    extract.way(box(10, 70, 30, 90), {"building": "yes", "height": "12"})
    extract.way(box(60, 10, 90, 40), {"leisure": "park"})
    extract.way([(-20, 50), (120, 50)], {"highway": "residential"})
    extract.node(75, 25, {"natural": "tree", "height": "9"})
    return extract


def test_a_town_lies_where_it_was_drawn(read: Callable[..., World]) -> None:
    world = read(town())
    assert world.shape == (100, 100)
    building = np.zeros((100, 100), dtype=bool)
    building[10:30, 70:90] = True
    assert np.array_equal(world.classes == LandClass.BUILDING, building)
    assert (world.surface[building] == 12.0).all()
    assert (world.classes[:, 46:54] == LandClass.ROAD).all()
    assert np.count_nonzero(world.classes == LandClass.ROAD) == 800
    assert at(world, 61, 11) == (0.0, LandClass.GRASS)
    assert at(world, 75, 25) == (9.0, LandClass.TREES)
    assert at(world, 5, 5) == (0.0, LandClass.UNKNOWN)
    assert not world.ground.any()
    assert (world.datum.crs, world.datum.easting, world.datum.northing) == (CRS, WEST, SOUTH)
    assert world.datum.vertical == "flat ground"
    assert (world.origin, world.cell) == ((0.0, 0.0), 1.0)
    assert "OpenStreetMap contributors, ODbL" in world.attribution
    assert world.name == "a"


def test_both_formats_and_every_run_give_the_same_world(tmp_path: Path) -> None:
    paths = [town().write_xml(tmp_path / "a.osm"), town().write_pbf(tmp_path / "a.osm.pbf")]
    worlds = [osm.read(path, bounds=BOUNDS, crs=CRS) for path in (*paths, paths[0])]
    for other in worlds[1:]:
        assert np.array_equal(worlds[0].surface, other.surface)
        assert np.array_equal(worlds[0].classes, other.classes)


def test_the_cell_size_is_a_choice(read: Callable[..., World]) -> None:
    world = read(town(), cell=5.0)
    assert world.shape == (20, 20)
    assert np.count_nonzero(world.classes == LandClass.BUILDING) == 16


def test_a_building_without_a_height_gets_the_default(read: Callable[..., World]) -> None:
    extract = Extract()
    extract.way(box(10, 10, 20, 20), {"building": "yes"})
    extract.way(box(30, 10, 40, 20), {"building": "garage"})
    world = read(extract, default_height=14.0)
    assert at(world, 15, 15) == (14.0, LandClass.BUILDING)
    assert at(world, 35, 15) == (3.0, LandClass.BUILDING)


def test_parts_come_before_an_outline_that_restates_the_tower(read: Callable[..., World]) -> None:
    extract = Extract()
    extract.way(box(10, 10, 60, 60), {"building": "yes", "height": "200"})
    extract.way(box(10, 10, 30, 60), {"building:part": "yes", "height": "200"})
    extract.way(box(30, 10, 50, 60), {"building:part": "yes", "building:levels": "5"})
    world = read(extract)
    assert at(world, 20, 30) == (200.0, LandClass.BUILDING)
    assert at(world, 40, 30) == (15.0, LandClass.BUILDING)
    assert at(world, 55, 30) == (15.0, LandClass.BUILDING)  # uncovered: the lowest part


def test_an_outline_lower_than_its_tower_keeps_its_height_beside_it(
    read: Callable[..., World],
) -> None:
    extract = Extract()
    extract.way(box(10, 10, 60, 60), {"building": "yes", "height": "18"})
    extract.way(box(20, 20, 40, 40), {"building:part": "yes", "height": "90"})
    extract.way(box(25, 25, 35, 35), {"building:part": "yes", "height": "95", "min_height": "90"})
    world = read(extract)
    assert [at(world, *xy)[0] for xy in ((30, 30), (22, 22), (50, 50))] == [95.0, 90.0, 18.0]


def test_a_part_lower_than_its_outline_lowers_it(read: Callable[..., World]) -> None:
    extract = Extract()
    extract.way(box(10, 10, 40, 40), {"building": "yes", "height": "80"})
    extract.way(box(10, 10, 40, 40), {"building:part": "yes", "height": "12"})
    extract.way(box(50, 10, 60, 20), {"building:part": "yes", "height": "7.5"})  # no outline
    world = read(extract)
    assert at(world, 20, 20)[0] == 12.0
    assert at(world, 55, 15) == (7.5, LandClass.BUILDING)


def test_an_outline_higher_than_its_parts_stays_so_beside_them(
    read: Callable[..., World],
) -> None:
    extract = Extract()
    extract.way(box(10, 10, 40, 40), {"building": "yes", "height": "80"})
    extract.way(box(10, 10, 25, 40), {"building:part": "yes", "height": "20"})
    world = read(extract)
    assert at(world, 20, 20)[0] == 20.0
    assert at(world, 35, 20)[0] == 80.0  # something must be so high, and it is not the part


def test_multipolygons_have_holes_and_several_rings(read: Callable[..., World]) -> None:
    extract = Extract()
    # The outer ring in two halves, as mappers cut them.
    half = extract.way([(10, 10), (50, 10), (50, 50)])
    other = extract.way([(50, 50), (10, 50), (10, 10)])
    hole = extract.way(box(20, 20, 40, 40))
    far = extract.way(box(70, 70, 80, 80))
    roles = [(half, "outer"), (hole, "inner"), (other, "outer"), (far, "")]
    extract.multipolygon(roles, {"building": "yes", "height": "20"})
    world = read(extract)
    expected = np.zeros((100, 100), dtype=bool)
    expected[10:50, 10:50] = True
    expected[20:40, 20:40] = False
    expected[70:80, 70:80] = True
    assert np.array_equal(world.surface == 20.0, expected)


def test_a_multipolygon_that_the_extract_cuts_open_is_left_out(read: Callable[..., World]) -> None:
    extract = town()
    half = extract.way([(10, 10), (50, 10), (50, 20)])
    extract.multipolygon([(half, "outer"), (999, "outer")], {"natural": "water"})
    assert not (read(extract).classes == LandClass.WATER).any()


def test_what_lies_underground_is_dropped(read: Callable[..., World]) -> None:
    extract = town()
    extract.way(box(10, 10, 20, 20), {"building": "yes", "location": "underground"})
    extract.way([(0, 20), (100, 20)], {"highway": "primary", "tunnel": "yes"})
    extract.way([(0, 22), (100, 22)], {"railway": "subway", "location": "underground"})
    ring = extract.way(box(5, 5, 25, 25))
    extract.multipolygon([(ring, "outer")], {"highway": "pedestrian", "indoor": "yes"})
    bare, full = read(town()), read(extract)
    assert np.array_equal(bare.classes, full.classes)
    assert np.array_equal(bare.surface, full.surface)


def test_what_lies_on_top(read: Callable[..., World]) -> None:
    extract = Extract()
    extract.way(box(0, 0, 100, 100), {"leisure": "park"})
    extract.way(box(40, 40, 80, 80), {"natural": "water"})
    extract.way(box(50, 50, 60, 60), {"leisure": "pitch"})
    extract.way(box(48, 48, 62, 62), {"place": "islet"})
    extract.way([(0, 70), (100, 70)], {"railway": "rail"})
    extract.way([(20, 0), (20, 100)], {"highway": "footway"})
    extract.way([(0, 20), (100, 20)], {"highway": "residential", "bridge": "yes", "layer": "1"})
    extract.way(box(85, 15, 95, 25), {"building": "yes", "height": "6"})
    world = read(extract)
    expected = {
        (5, 5): LandClass.GRASS,
        (45, 45): LandClass.WATER,
        (55, 55): LandClass.PITCH,
        (60, 70): LandClass.RAIL,
        (20, 70): LandClass.PATH,
        (20, 20): LandClass.ROAD,
        (90, 20): LandClass.BUILDING,
    }
    assert {xy: at(world, *xy)[1] for xy in expected} == expected


def test_trees_stand_over_roads_and_below_roofs(read: Callable[..., World]) -> None:
    extract = town()
    extract.node(50, 50, {"natural": "tree", "height": "40'", "diameter_crown": "6"})
    extract.node(20, 80, {"natural": "tree", "height": "5"})
    extract.way([(40, 95), (60, 95)], {"natural": "tree_row"})
    extract.way(box(90, 90, 100, 100), {"natural": "wood", "height": "15"})
    world = read(extract)
    assert at(world, 50, 50) == (pytest.approx(12.192), LandClass.TREES)
    assert np.count_nonzero(world.classes[45:56, 45:56] == LandClass.TREES) == pytest.approx(
        np.pi * 9, abs=4
    )
    assert at(world, 20, 80) == (12.0, LandClass.BUILDING)
    assert at(world, 50, 95) == (10.0, LandClass.TREES)
    assert at(world, 95, 95) == (15.0, LandClass.TREES)


def test_thin_tall_objects_are_obstacles(read: Callable[..., World]) -> None:
    extract = town()
    extract.node(40.5, 10.5, {"man_made": "mast", "height": "35", "diameter": "0.2"})
    extract.way(box(70, 70, 80, 80), {"man_made": "storage_tank"})
    world = read(extract, cell=4.0)
    assert at(world, 40.5, 10.5) == (35.0, LandClass.BUILDING)
    assert at(world, 75, 75) == (8.0, LandClass.BUILDING)


def _sea_share(read: Callable[..., World], *coasts: list[tuple[float, float]]) -> World:
    extract = Extract()
    for coast in coasts:
        extract.way(coast, {"natural": "coastline"})
    return read(extract)


def test_the_sea_lies_right_of_the_coast(read: Callable[..., World]) -> None:
    north_going = [(40.0, -30.0), (40.0, 50.0), (60.0, 50.0), (60.0, 130.0)]
    sea_in_the_east = _sea_share(read, north_going).classes == LandClass.WATER
    expected = np.zeros((100, 100), dtype=bool)
    expected[40:, :50] = True
    expected[60:, 50:] = True
    assert np.array_equal(sea_in_the_east, expected)
    sea_in_the_west = _sea_share(read, north_going[::-1]).classes == LandClass.WATER
    assert np.array_equal(sea_in_the_west, ~expected)


def test_an_island_is_dry_and_the_sea_goes_round_it(read: Callable[..., World]) -> None:
    water = _sea_share(read, box(30, 30, 60, 60)).classes == LandClass.WATER  # land on the left
    expected = np.ones((100, 100), dtype=bool)
    expected[30:60, 30:60] = False
    assert np.array_equal(water, expected)


def test_a_coast_in_pieces_counts_as_one(read: Callable[..., World]) -> None:
    pieces = [[(40.0, 50.0), (40.0, 130.0)], [(40.0, -30.0), (40.0, 50.0)]]
    water = _sea_share(read, *pieces).classes == LandClass.WATER
    assert water[40:].all()
    assert not water[:40].any()


def test_a_coast_that_ends_nowhere_floods_nothing(read: Callable[..., World]) -> None:
    water = _sea_share(read, [(40.0, -30.0), (40.0, 50.0)]).classes == LandClass.WATER
    assert not water.any()


def test_an_island_that_is_a_park_still_has_a_coast(read: Callable[..., World]) -> None:
    extract = Extract()
    extract.way(box(30, 30, 60, 60), {"natural": "coastline", "leisure": "park"})
    world = read(extract)
    assert at(world, 45, 45)[1] == LandClass.GRASS
    assert at(world, 10, 10)[1] == LandClass.WATER


def test_a_self_crossing_building_still_stands(read: Callable[..., World]) -> None:
    extract = Extract()
    bow_tie = [(10.0, 10.0), (30.0, 30.0), (30.0, 10.0), (10.0, 30.0), (10.0, 10.0)]
    extract.way(bow_tie, {"building": "yes", "height": "8"})
    world = read(extract)
    assert at(world, 12, 20)[0] == 8.0
    assert np.count_nonzero(world.surface) == pytest.approx(200, abs=20)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"crs": "EPSG:4326"}, "crs must be a projected CRS in metres"),
        ({"crs": "EPSG:2263"}, "crs must be a projected CRS in metres"),
        ({"crs": "nowhere"}, "crs must be a known CRS"),
        ({"cell": 0.0}, "cell must be above zero"),
        ({"cell": np.nan}, "cell must be above zero"),
        ({"cell": 3.0}, "bounds must span whole cells"),
        ({"cell": 0.001}, "bounds hold 10000000000 cells"),
        ({"bounds": (WEST, SOUTH, WEST, SOUTH)}, "bounds must span whole cells"),
        ({"bounds": (WEST + 9, SOUTH, WEST, SOUTH + 9)}, "bounds must span whole cells"),
        ({"bounds": (np.nan, 0.0, 1.0, 1.0)}, "bounds must be x_min"),
        ({"bounds": (0.0, 1.0, 1.0)}, "bounds must be x_min"),
        ({"default_height": -1.0}, "default_height must be above zero"),
    ],
    ids=str,
)
def test_senseless_arguments_are_named(
    read: Callable[..., World], options: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        read(town(), **options)


def test_bounds_beside_the_map_say_where_the_map_is(read: Callable[..., World]) -> None:
    away = tuple(value + 5000.0 for value in BOUNDS)
    with pytest.raises(ValueError, match=r"a\.osm holds nothing in the bounds .* lie within lon"):
        read(town(), bounds=away)


def test_a_file_cut_anywhere_is_an_error_with_its_name(tmp_path: Path) -> None:
    rng = np.random.default_rng(1)
    for sound in (town().write_xml(tmp_path / "a.osm"), town().write_pbf(tmp_path / "a.osm.pbf")):
        data = sound.read_bytes()
        cut = tmp_path / sound.name.replace("a.", "cut.")
        for length in (0, 3, len(data) - 8, *rng.integers(0, len(data) - 8, 40).tolist()):
            cut.write_bytes(data[:length])
            with pytest.raises(ValueError, match=r"cut\.osm"):
                osm.read(cut, bounds=BOUNDS, crs=CRS)


@pytest.mark.parametrize("name", ["a.osm", "a.osm.pbf"])
def test_damage_never_does_worse_than_an_error(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    data = (town().write_xml if path.suffix == ".osm" else town().write_pbf)(path).read_bytes()
    rng = np.random.default_rng(2)
    refused = 0
    for _ in range(100):
        broken = bytearray(data)
        start = int(rng.integers(len(broken)))
        broken[start : start + 3] = rng.bytes(3)
        path.write_bytes(broken)
        try:
            osm.read(path, bounds=BOUNDS, crs=CRS)
        except ValueError as error:
            refused += 1
            assert name in str(error)
    assert refused > 20


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.osm.pbf", "no protocol buffer at all" * 20),
        ("a.osm", "not <xml"),
        ("a.osm", '<!DOCTYPE x [<!ENTITY a "b">]><osm version="0.6">&a;</osm>'),
        ("a.osm", '<osm version="0.6"></osm>'),
        ("a.txt", "<osm/>"),
    ],
)
def test_other_files_are_refused(tmp_path: Path, name: str, text: str) -> None:
    path = tmp_path / name
    path.write_text(text)
    with pytest.raises(ValueError, match=name):
        osm.read(path, bounds=BOUNDS, crs=CRS)


def test_a_name_that_osmium_would_take_for_an_address_is_a_file() -> None:
    with pytest.raises(FileNotFoundError):
        osm.read("http://localhost:9/a.osm", bounds=BOUNDS, crs=CRS)


@pytest.mark.parametrize("missing", ["osmium", "shapely", "pyproj", "rasterio"])
def test_a_missing_library_is_named_with_its_cure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, missing: str
) -> None:
    path = town().write_xml(tmp_path / "a.osm")
    found = importlib.import_module

    def without(name: str, package: str | None = None) -> Any:
        if name.partition(".")[0] == missing:
            raise ModuleNotFoundError(f"No module named {name!r}")
        return found(name, package)

    monkeypatch.setattr(importlib, "import_module", without)
    with pytest.raises(ImportError, match=re.escape(f"needs {missing}: {pip_install('geo')}")):
        osm.read(path, bounds=BOUNDS, crs=CRS)
