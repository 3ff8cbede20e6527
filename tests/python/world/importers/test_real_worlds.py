# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Three real cities, imported as docs/worlds.md says, show what is known about them."""

from pathlib import Path

import numpy as np
import pytest

from ltp.world import LandClass, World
from ltp.world.importers import geotiff, las, osm

for library in ("laspy", "osmium", "pyproj", "rasterio", "shapely"):
    pytest.importorskip(library)

# The data has its own licences and is no part of the repository: it is read where it lies.
DATA = Path(__file__).resolve().parents[5] / "shared" / "worlds"


def _folder(name: str) -> Path:
    if not (DATA / name).is_dir():
        pytest.skip(f"needs the data set {name} in ../shared/worlds beside the repository")
    return DATA / name


def share(world: World, *kinds: LandClass) -> float:
    return float(np.isin(world.classes, kinds).mean())


def share_above(world: World, height: float) -> float:
    return float((world.height_above_ground > height).mean())


@pytest.fixture(scope="module")
def london() -> World:
    folder = _folder("london_barbican")
    return geotiff.read(
        dsm=folder / "dsm_1m.tif",
        dem=folder / "dem_1m.tif",
        canopy=folder / "cdsm_1m.tif",
        classes=folder / "landcover_1m.tif",
        class_table={1: "paved", 2: "grass", 3: "water", 4: "building"},
    )


@pytest.fixture(scope="module")
def lamballe() -> World:
    return las.read(_folder("lamballe_lidar") / "lamballe_0292_6833.laz")


@pytest.fixture(scope="module")
def manhattan() -> World:
    return osm.read(
        _folder("manhattan_hudson") / "manhattan_hudson.osm.pbf",
        crs="EPSG:32618",
        bounds=(583950, 4511100, 584950, 4512100),
    )


def test_london_lies_where_its_rasters_say(london: World) -> None:
    assert (london.shape, london.cell) == ((651, 601), 1.0)
    assert london.datum.crs == "EPSG:27700"
    assert (london.datum.easting, london.datum.northing) == (531999.0, 181359.0)
    assert (london.ground.min(), london.ground.max()) == pytest.approx((9.0, 25.05), abs=0.01)


def test_london_stands_as_high_as_it_does(london: World) -> None:
    assert share_above(london, 30.0) == pytest.approx(0.20, abs=0.005)
    assert share_above(london, 50.0) == pytest.approx(0.047, abs=0.001)
    assert london.height_above_ground.max() == pytest.approx(126.0, abs=0.5)
    # Three triangular towers of 120 m stand in a row along the north of the estate.
    for x, y in ((140.0, 462.0), (268.0, 510.0), (413.0, 550.0)):
        near = london.height_above_ground[int(x) - 8 : int(x) + 8, int(y) - 8 : int(y) + 8]
        assert near.max() > 110.0


def test_london_is_covered_by_what_lies_there(london: World) -> None:
    assert share(london, LandClass.BUILDING) == pytest.approx(0.462, abs=0.0005)
    # Trees stand on ground that the raster calls paved, grass or water.
    rest = share(london, LandClass.PAVED, LandClass.GRASS, LandClass.WATER, LandClass.TREES)
    assert rest == pytest.approx(0.447 + 0.070 + 0.021, abs=0.001)
    assert share(london, LandClass.WATER) == pytest.approx(0.021, abs=0.001)
    assert share(london, LandClass.GRASS) == pytest.approx(0.05, abs=0.01)
    roofs = london.height_above_ground[london.classes == LandClass.BUILDING]
    assert np.median(roofs) == pytest.approx(27.0, abs=0.5)
    pavement = london.height_above_ground[london.classes == LandClass.PAVED]
    assert np.median(pavement) == pytest.approx(0.0, abs=0.1)


def test_lamballe_lies_where_its_survey_says(lamballe: World) -> None:
    assert (lamballe.shape, lamballe.cell) == ((500, 500), 2.0)
    assert lamballe.datum.crs == "EPSG:2154"
    assert (lamballe.datum.easting, lamballe.datum.northing) == (292000.0, 6832000.0)
    assert lamballe.ground.min() == pytest.approx(43.3, abs=0.1)
    assert lamballe.surface.max() < 108.0


def test_lamballe_stands_as_high_as_it_does(lamballe: World) -> None:
    assert share_above(lamballe, 15.0) == pytest.approx(0.022, abs=0.005)
    assert lamballe.height_above_ground.max() == pytest.approx(47.0, abs=0.5)


def test_lamballe_has_no_holes_but_its_water(lamballe: World) -> None:
    heights = lamballe.height_above_ground
    # Within the walls of two sheds, in the north-west and in the south, all is roof.
    for x, y in ((205, 895), (620, 310)):
        roof = np.s_[(x - 20) // 2 : (x + 20) // 2, (y - 20) // 2 : (y + 20) // 2]
        assert (lamballe.classes[roof] == LandClass.BUILDING).all()
        assert (heights[roof] > 3.0).all()
    # The strip near the north-east corner that returns nothing.
    strip = lamballe.classes[876 // 2 : 888 // 2, 940 // 2 : 954 // 2]
    assert (strip == LandClass.UNKNOWN).all()
    assert share(lamballe, LandClass.UNKNOWN) < 0.05


def test_manhattan_lies_where_it_was_asked_for(manhattan: World) -> None:
    assert (manhattan.shape, manhattan.cell) == ((1000, 1000), 1.0)
    assert manhattan.datum.crs == "EPSG:32618"
    assert (manhattan.datum.easting, manhattan.datum.northing) == (583950.0, 4511100.0)
    assert "OpenStreetMap contributors, ODbL 1.0" in manhattan.attribution
    assert not manhattan.ground.any()


def test_manhattan_stands_as_high_as_it_does(manhattan: World) -> None:
    assert share_above(manhattan, 30.0) == pytest.approx(0.248, abs=0.005)
    assert share_above(manhattan, 50.0) == pytest.approx(0.136, abs=0.002)
    # 30 Hudson Yards, in the north of the box.
    assert manhattan.surface.max() == 395.0
    i, j = np.unravel_index(manhattan.surface.argmax(), manhattan.shape)
    assert 330 < i < 480
    assert 760 < j < 880


def test_manhattan_is_covered_by_what_lies_there(manhattan: World) -> None:
    expected = {
        LandClass.BUILDING: (0.45, 0.01),
        LandClass.GRASS: (0.05, 0.005),
        LandClass.PITCH: (0.011, 0.001),
        LandClass.PARKING: (0.016, 0.001),
        LandClass.TREES: (0.008, 0.002),
        LandClass.RAIL: (0.03, 0.002),  # with the West Side Yard, which has layer=-1
        LandClass.CONSTRUCTION: (0.013, 0.001),
        # Lines have as much area as one gives them width.
        LandClass.ROAD: (0.15, 0.03),
        LandClass.UNKNOWN: (0.16, 0.02),
    }
    for kind, (value, slack) in expected.items():
        assert share(manhattan, kind) == pytest.approx(value, abs=slack), kind.name
    paths = share(manhattan, LandClass.PATH, LandClass.SQUARE)
    assert paths == pytest.approx(0.08, abs=0.02)


def test_manhattan_has_its_rail_yard_in_the_north_west(manhattan: World) -> None:
    yard = manhattan.classes[20:180, 860:980]
    assert (yard == LandClass.RAIL).mean() > 0.4


def test_manhattans_report_says_how_many_heights_are_guesses(manhattan: World) -> None:
    heights = [line for line in manhattan.report if line.startswith("Heights of buildings:")]
    assert len(heights) == 1
    assert "641 of 687 buildings tell theirs" in heights[0]
    assert "17 are guessed (usual for the kind, else 10 m): 1.7 % of the built area" in heights[0]
