# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What rasters say of their CRS and units, and rasters of several grids: read, refused, aligned."""

import re
import struct
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ltp.world import LandClass, World
from ltp.world.importers import geotiff

rasterio = pytest.importorskip("rasterio")
pyproj = pytest.importorskip("pyproj")

N = 30
FOOT, US_FOOT = 0.3048, 1200.0 / 3937.0
Write = Callable[..., Path]


def house(unit: float = 1.0) -> Any:
    """10 m of ground and a house of 10 m x 10 m x 30 m; in image order."""
    image = np.full((N, N), 10.0 / unit, dtype=np.float64)
    image[5:15, 10:20] = 40.0 / unit
    return image


def ground(unit: float = 1.0) -> Any:
    return np.full((N, N), 10.0 / unit, dtype=np.float64)


@pytest.fixture
def write(tmp_path: Path) -> Write:
    def write_raster(
        name: str,
        image: Any,
        crs: Any = "EPSG:26918",
        *,
        west: float = 500000.0,
        north: float = 4600030.0,
        cell: float = 1.0,
        transform: Any = None,
        units: str | None = None,
        **options: Any,
    ) -> Path:
        path = tmp_path / name
        rows, columns = image.shape
        with rasterio.open(
            path,
            "w",
            driver="GTiff",
            width=columns,
            height=rows,
            count=1,
            dtype=image.dtype,
            crs=None if crs is None else rasterio.CRS.from_user_input(crs),
            transform=transform or rasterio.Affine(cell, 0.0, west, 0.0, -cell, north),
            **options,
        ) as dataset:
            dataset.write(image, 1)
            if units is not None:
                dataset.units = (units,)
        return path

    return write_raster


def lawn(write: Write) -> dict[str, Any]:
    """Land classes: all grass, as open ground without any is UNKNOWN."""
    codes = write("lawn.tif", np.ones((N, N), dtype=np.uint8))
    return {"classes": codes, "class_table": {1: "grass"}}


def assert_true_to_scale(world: World) -> None:
    assert (world.shape, world.cell) == ((N, N), 1.0)
    assert world.height_above_ground.max() == pytest.approx(30.0, abs=1e-6)
    assert world.ground.min() == pytest.approx(10.0, abs=1e-6)
    assert np.argwhere(world.height_above_ground > 29.0).min(axis=0).tolist() == [10, 15]
    assert np.count_nonzero(world.height_above_ground > 29.0) == 100


SAME_GRID = {
    "compound": "EPSG:26918+5703",
    "WKT 1": pyproj.CRS("EPSG:26918").to_wkt("WKT1_GDAL"),
    "ESRI's WKT": pyproj.CRS("EPSG:26918").to_wkt("WKT1_ESRI"),
    "WKT 2": pyproj.CRS("EPSG:26918").to_wkt(),
    "PROJ": "+proj=utm +zone=18 +datum=NAD83 +units=m",
    "another way to say it": "+proj=tmerc +lon_0=-75 +k=0.9996 +x_0=500000 +datum=NAD83 +units=m",
    "meter": pyproj.CRS("EPSG:26918").to_wkt("WKT1_GDAL").replace('"metre"', '"meter"'),
}


@pytest.mark.parametrize("spelling", SAME_GRID)
def test_one_grid_is_one_grid_however_it_is_spelt(write: Write, spelling: str) -> None:
    plain, other = write("plain.tif", house()), write("other.tif", house(), SAME_GRID[spelling])
    dem = write("dem.tif", ground(), SAME_GRID[spelling])
    for dsm in (plain, other):
        world = geotiff.read(dsm=dsm, dem=dem)
        assert_true_to_scale(world)
        assert world.datum.crs == "EPSG:26918"
        assert world.report[0].startswith("CRS: EPSG:26918 (NAD83 / UTM zone 18N")


def test_axis_order_makes_no_other_grid(write: Write) -> None:
    place = {"west": 1750000.0, "north": 5426000.0}
    dsm = write("dsm.tif", house(), "EPSG:2193", **place)
    wkt = re.sub(r',AUTHORITY\["[^]]*\]', "", pyproj.CRS("EPSG:2193").to_wkt("WKT1_GDAL"))
    world = geotiff.read(dsm=dsm, dem=write("dem.tif", ground(), wkt, **place))
    assert_true_to_scale(world)
    assert world.datum.crs == "EPSG:2193"


HEIGHTS: dict[str, tuple[dict[str, Any], float]] = {
    "US feet by the vertical CRS": ({"crs": "EPSG:26918+6360"}, US_FOOT),
    "feet by the vertical CRS": ({"crs": "EPSG:26918+8228"}, FOOT),
    "metres by the vertical CRS": ({"crs": "EPSG:26918+5703"}, 1.0),
    "GDAL's own words": ({"units": "US survey foot"}, US_FOOT),
    "ft": ({"units": "ft"}, FOOT),
    "feet": ({"units": "feet"}, FOOT),
    "us-ft": ({"units": "us-ft"}, US_FOOT),
    "ftUS": ({"units": "ftUS"}, US_FOOT),
    "US_survey_foot": ({"units": "US_survey_foot"}, US_FOOT),
    "yards": ({"units": "yards"}, 0.9144),
    "cm": ({"units": "cm"}, 0.01),
    "centimeters": ({"units": "centimeters"}, 0.01),
    "km": ({"units": "km"}, 1000.0),
    "m": ({"units": "m"}, 1.0),
    "Meter": ({"units": "Meter"}, 1.0),
    "metres": ({"units": "metres"}, 1.0),
    "the band over the vertical CRS": ({"crs": "EPSG:26918+5703", "units": "ft"}, FOOT),
    "the band and the vertical CRS": (
        {"crs": "EPSG:26918+6360", "units": "US survey foot"},
        US_FOOT,
    ),
}


@pytest.mark.parametrize("kind", HEIGHTS)
def test_heights_are_in_metres_or_refused_or_scaled(write: Write, kind: str) -> None:
    options, unit = HEIGHTS[kind]
    dsm, dem = write("dsm.tif", house(unit), **options), write("dem.tif", ground(unit), **options)
    if unit != 1.0:
        with pytest.raises(ValueError, match=r"dsm\.tif must hold heights in metres, not in "):
            geotiff.read(dsm=dsm, dem=dem)
    world = geotiff.read(dsm=dsm, dem=dem, convert_heights=True)
    assert_true_to_scale(world)
    expected = "heights are in metres (" if unit == 1.0 else "heights were scaled from"
    assert f"dsm.tif, dem.tif: {expected}" in world.report[-1]


def test_each_file_counts_in_its_own_unit(write: Write) -> None:
    dsm = write("dsm.tif", house(US_FOOT), "EPSG:26918+6360")
    metric = write("dem.tif", ground(), "EPSG:26918+5703")
    assert_true_to_scale(geotiff.read(dsm=dsm, dem=metric, convert_heights=True))
    silent = write("silent.tif", ground())
    with pytest.raises(ValueError, match=r"silent\.tif does not say in which unit"):
        geotiff.read(dsm=dsm, dem=silent, convert_heights=True)
    with pytest.raises(ValueError, match=r"silent\.tif does not say in which unit"):
        geotiff.read(dsm=dsm, dem=metric, canopy=silent, convert_heights=True)


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"units": "furlongs per fortnight"}, "heights in metres, not in 'furlongs"),
        ({"units": "degree"}, "heights in metres, not in 'degree'"),
        ({"crs": "EPSG:26918+6360", "units": "m"}, "contradicts itself"),
        ({"crs": "EPSG:26918+6360", "units": "yd"}, "contradicts itself"),
        ({"crs": "EPSG:32618+5831"}, "heights, not depths"),
    ],
)
def test_heights_that_make_no_sense_are_refused(
    write: Write, options: dict[str, Any], message: str
) -> None:
    dsm = write("dsm.tif", house(), **options)
    with pytest.raises(ValueError, match=message):
        geotiff.read(dsm=dsm, dem=dsm, convert_heights=True)


def test_two_height_datums_are_two(write: Write) -> None:
    dsm = write("dsm.tif", house(), "EPSG:26918+5703")
    dem = write("dem.tif", ground(), "EPSG:26918+5773")
    with pytest.raises(ValueError, match=r"dem\.tif has heights above EGM96 geoid, .*dsm\.tif"):
        geotiff.read(dsm=dsm, dem=dem)


PLANS = {
    "EPSG:2263": r"US survey foot .* reproject it first, to EPSG:32618",
    "EPSG:2263+6360": "US survey foot",
    "EPSG:2994": "foot",
    "EPSG:4326": "in degrees",
    "EPSG:4979": "in degrees",
    "EPSG:4326+5773": "in degrees",
    "+proj=utm +zone=18 +datum=WGS84 +units=us-ft": "US survey foot",
    "+proj=tmerc +lon_0=-74 +datum=WGS84 +to_meter=0.9144": "0.9144",
    "EPSG:3857": "more than 1% off; use EPSG:32618",
    "EPSG:3395": "more than 1% off; use EPSG:32618",
    "EPSG:32610": "more than 1% off; use EPSG:32618",
    "EPSG:4087": "more than 1% off; use EPSG:32618",
    "ESRI:54009": "more than 1% off; use EPSG:32618",
    "EPSG:27700": "more than 1% off; use EPSG:32618",
}


@pytest.mark.parametrize("crs", PLANS)
def test_a_plan_whose_metre_is_none_is_refused(write: Write, crs: str) -> None:
    to_map = pyproj.Transformer.from_crs(4326, pyproj.CRS(crs).to_2d(), always_xy=True)
    west, north = to_map.transform(-74.0, 40.7)
    cell = 1e-5 if abs(west) < 180.0 else 1.0
    options = {"west": west, "north": north, "cell": cell}
    dsm, dem = write("dsm.tif", house(), crs, **options), write("dem.tif", ground(), crs, **options)
    with pytest.raises(ValueError, match=rf"dsm\.tif.*{PLANS[crs]}"):
        geotiff.read(dsm=dsm, dem=dem)


@pytest.mark.parametrize("crs", [None, "EPSG:32618"])
@pytest.mark.parametrize(
    ("west", "north", "cell"),
    [
        (-74.01, 40.71, 1e-5),
        (285.99, 40.71, 1e-5),
        (-74.01, 40.71, 1 / 3600),
        (5.0, 50.0, 1 / 120),
        (5.0, 50.0, 1 / 24),
        (0.0, 0.0, 1e-4),
        (-180.0, 90.0, 1 / 12),
    ],
)
def test_degrees_are_refused_with_and_without_a_crs(
    write: Write, crs: str | None, west: float, north: float, cell: float
) -> None:
    dsm = write("dsm.tif", house(), crs, west=west, north=north, cell=cell)
    with pytest.raises(ValueError, match=r"dsm\.tif must be in metres; .* looks like degrees"):
        geotiff.read(dsm=dsm, dem=dsm)


@pytest.mark.parametrize(
    ("west", "north", "cell"),
    [(0.0, 30.0, 1.0), (-15.0, 15.0, 1.0), (0.0, 3.0, 0.1), (100.0, 60.0, 0.5), (0.0, 0.6, 0.05)],
)
def test_a_local_frame_is_none_in_degrees(
    write: Write, west: float, north: float, cell: float
) -> None:
    options = {"west": west, "north": north, "cell": cell}
    dsm = write("dsm.tif", house(), None, **options)
    world = geotiff.read(dsm=dsm, dem=write("dem.tif", ground(), None, **options))
    assert (world.datum.crs, world.cell) == (None, cell)
    assert world.report[0] == "CRS: none is named; x and y are taken for metres, east and north"


def test_a_site_grid_in_metres_has_no_crs(write: Write) -> None:
    site = 'LOCAL_CS["site",UNIT["metre",1]]'
    dsm, dem = write("dsm.tif", house(), site), write("dem.tif", ground(), site)
    world = geotiff.read(dsm=dsm, dem=dem)
    assert_true_to_scale(world)
    assert world.datum.crs is None


def test_other_grids_are_refused_with_the_way_out(write: Write) -> None:
    dsm, dem = write("dsm.tif", house()), write("dem.tif", ground(), west=500000.5)
    with pytest.raises(ValueError, match=r"dem\.tif lies on another grid .*; with align it is"):
        geotiff.read(dsm=dsm, dem=dem)


def slope(x: Any, y: Any) -> Any:
    return 20.0 + 0.1 * (x - 500000.0) + 0.05 * (y - 4600000.0)


def sampled(crs: str, transform: Any, shape: tuple[int, int]) -> Any:
    """Heights of a slope in EPSG:26918 at the cell centres of another grid."""
    columns, rows = np.meshgrid(np.arange(shape[1]) + 0.5, np.arange(shape[0]) + 0.5)
    x = transform.a * columns + transform.b * rows + transform.c
    y = transform.d * columns + transform.e * rows + transform.f
    to_utm = pyproj.Transformer.from_crs(crs, "EPSG:26918", always_xy=True)
    return slope(*to_utm.transform(x, y))


OTHER_GRIDS = {
    "half a cell off": ("EPSG:26918", (1.0, 0.0, 499980.5, 0.0, -1.0, 4600050.5), 80),
    "larger cells": ("EPSG:26918", (3.0, 0.0, 499981.0, 0.0, -3.0, 4600052.0), 30),
    "smaller cells": ("EPSG:26918", (0.4, 0.0, 499980.0, 0.0, -0.4, 4600050.0), 180),
    "oblong cells": ("EPSG:26918", (1.5, 0.0, 499980.0, 0.0, -1.0, 4600050.0), 80),
    "from the south": ("EPSG:26918", (1.0, 0.0, 499980.3, 0.0, 1.0, 4599980.0), 80),
    "turned": ("EPSG:26918", (0.8, 0.6, 499960.0, 0.6, -0.8, 4600020.0), 90),
    "another zone": ("EPSG:26917", None, 90),
    "feet": ("EPSG:2263", None, 90),
    "degrees": ("EPSG:4269", None, 90),
    "Web Mercator": ("EPSG:3857", None, 90),
}


@pytest.mark.parametrize("kind", OTHER_GRIDS)
def test_a_terrain_of_another_grid_is_aligned(write: Write, kind: str) -> None:
    crs, numbers, n = OTHER_GRIDS[kind]
    if numbers is None:
        to_map = pyproj.Transformer.from_crs("EPSG:26918", crs, always_xy=True)
        west, south, east, north = to_map.transform_bounds(499970, 4599970, 500060, 4600060)
        numbers = ((east - west) / n, 0.0, west, 0.0, (south - north) / n, north)
    transform = rasterio.Affine(*numbers)
    dem = write("dem.tif", sampled(crs, transform, (n, n)), crs, transform=transform)
    here = rasterio.Affine(1.0, 0.0, 500000.0, 0.0, -1.0, 4600030.0)
    dsm = write("dsm.tif", sampled("EPSG:26918", here, (N, N)) + 7.0)
    with pytest.raises(ValueError, match=r"dem\.tif"):
        geotiff.read(dsm=dsm, dem=dem)
    world = geotiff.read(dsm=dsm, dem=dem, align=True)
    x, y = np.meshgrid(np.arange(N) + 500000.5, np.arange(N) + 4600000.5, indexing="ij")
    np.testing.assert_allclose(world.ground, slope(x, y), atol=0.02)
    np.testing.assert_allclose(world.height_above_ground, 7.0, atol=0.02)
    assert (world.datum.crs, world.datum.easting) == ("EPSG:26918", 500000.0)
    assert (world.classes != LandClass.UNKNOWN).all()
    assert sum("dem.tif: resampled from" in line for line in world.report) == 1


def test_where_the_other_raster_ends_the_world_is_unknown(write: Write) -> None:
    dsm = write("dsm.tif", house())
    dem = write("dem.tif", np.full((N, N), 10.0), west=500006.0)
    world = geotiff.read(dsm=dsm, dem=dem, align=True, **lawn(write))
    assert (world.classes[:6] == LandClass.UNKNOWN).all()
    assert (world.classes[7:] != LandClass.UNKNOWN).all()
    np.testing.assert_allclose(world.ground, 10.0)
    assert any("20.0% of the world lies outside of it" in line for line in world.report)


def test_holes_do_not_bleed_into_what_is_aligned(write: Write) -> None:
    heights = np.full((N + 10, N + 10), 10.0)
    heights[20:24, 20:24] = -9999.0
    for options in ({}, {"nodata": -9999.0}):
        dem = write("dem.tif", heights, west=499995.5, north=4600035.5, **options)
        dsm = write("dsm.tif", ground())
        world = geotiff.read(dsm=dsm, dem=dem, align=True, **lawn(write))
        np.testing.assert_allclose(world.ground, 10.0)
        hole = world.classes == LandClass.UNKNOWN
        assert 16 <= np.count_nonzero(hole) <= 36


def test_finer_crowns_keep_their_tops_and_classes_stay_codes(write: Write) -> None:
    crowns = np.zeros((4 * N, 4 * N))
    crowns[4 * 10 + 1, 4 * 20 + 2] = 15.0  # a quarter of a metre wide
    codes = np.full((N // 2 + 1, N // 2 + 1), 1, dtype=np.uint8)
    codes[:, 8:] = 9
    files = {
        "dsm": write("dsm.tif", ground()),
        "dem": write("dem.tif", ground()),
        "canopy": write("canopy.tif", crowns, cell=0.25),
        "classes": write("codes.tif", codes, cell=2.0, west=499999.0, north=4600031.0),
    }
    table = {1: "grass", 9: "water"}
    world = geotiff.read(**files, class_table=table, align=True)
    assert world.height_above_ground[20, N - 1 - 10] == pytest.approx(15.0, abs=0.1)
    assert world.classes[20, N - 1 - 10] == LandClass.TREES
    kinds = {LandClass(kind) for kind in np.unique(world.classes)}
    assert kinds == {LandClass.GRASS, LandClass.WATER, LandClass.TREES}
    assert (world.classes[:15] == LandClass.GRASS).all()
    assert (world.classes[15:] != LandClass.GRASS).all()


def test_what_lies_elsewhere_cannot_be_aligned(write: Write) -> None:
    dsm = write("dsm.tif", house())
    with pytest.raises(ValueError, match=r"far\.tif lies elsewhere than .*dsm\.tif"):
        geotiff.read(dsm=dsm, dem=write("far.tif", ground(), west=600000.0), align=True)
    with pytest.raises(ValueError, match=r"cannot be aligned .*bare\.tif names no CRS"):
        geotiff.read(dsm=dsm, dem=write("bare.tif", ground(), None, cell=2.0), align=True)


def test_two_rasters_without_a_crs_are_aligned_by_their_numbers(write: Write) -> None:
    dsm = write("dsm.tif", house(), None)
    dem = write("dem.tif", np.full((20, 20), 10.0), None, cell=2.0)
    assert_true_to_scale(geotiff.read(dsm=dsm, dem=dem, align=True))


def test_aligning_does_not_hide_feet(write: Write) -> None:
    dsm = write("dsm.tif", house(), "EPSG:26918+5703")
    dem = write("dem.tif", ground(FOOT), "EPSG:26918+8228", cell=2.0)
    with pytest.raises(ValueError, match=r"dem\.tif must hold heights in metres, not in foot"):
        geotiff.read(dsm=dsm, dem=dem, align=True)
    world = geotiff.read(dsm=dsm, dem=dem, align=True, convert_heights=True)
    assert_true_to_scale(world)


def patched(path: Path, old: tuple[int, int], new: tuple[int, int]) -> Path:
    """The same file with another GeoKey and value in place of one."""
    data = path.read_bytes()
    entries = [struct.pack("<4H", key, 0, 1, value) for key, value in (old, new)]
    assert data.count(entries[0]) == 1
    path.write_bytes(data.replace(*entries))
    return path


@pytest.mark.parametrize(("code", "unit"), [(9002, FOOT), (9003, US_FOOT), (9096, 0.9144)])
def test_keys_in_feet_beside_metric_codes_are_named(write: Write, code: int, unit: float) -> None:
    def vertical(name: str, image: Any) -> Path:
        return patched(write(name, image, "EPSG:26918+5703"), (4096, 5703), (4099, code))

    dsm, dem = vertical("dsm.tif", house(unit)), vertical("dem.tif", ground(unit))
    with pytest.raises(ValueError, match=r"dsm\.tif must hold heights in metres, not in "):
        geotiff.read(dsm=dsm, dem=dem)
    assert_true_to_scale(geotiff.read(dsm=dsm, dem=dem, convert_heights=True))
    plan = patched(write("plan.tif", house()), (3076, 9001), (3076, code))
    with pytest.raises(ValueError, match=r"plan\.tif .*GeoKey 3076 .* in metres"):
        geotiff.read(dsm=plan, dem=plan)


def test_keys_that_are_no_unit_are_refused(write: Write) -> None:
    plan = patched(write("plan.tif", house()), (3076, 9001), (3076, 9102))
    with pytest.raises(ValueError, match=r"plan\.tif: GeoKey 3076 .* is no known unit"):
        geotiff.read(dsm=plan, dem=plan)
    dsm = patched(write("dsm.tif", house(), "EPSG:26918+5703"), (4096, 5703), (4099, 9102))
    with pytest.raises(ValueError, match=r"dsm\.tif must hold heights in metres, not in 'degree'"):
        geotiff.read(dsm=dsm, dem=dsm)


def test_a_code_that_nobody_knows_is_refused(write: Write) -> None:
    path = patched(write("dsm.tif", house()), (3072, 26918), (3072, 1))
    with pytest.raises(ValueError, match=r"dsm\.tif has a CRS that nobody knows: GeoKey 3072 = 1"):
        geotiff.read(dsm=path, dem=path)


@pytest.mark.parametrize(
    ("tags", "band", "unit"),
    [
        ({"UNITS": "feet"}, None, 0.3048),
        ({"Z_UNITS": "US survey feet"}, None, 1200.0 / 3937.0),
        ({"VerticalUnit": "Foot_US"}, None, 1200.0 / 3937.0),
        ({}, "elevation (ft)", 0.3048),
        ({"UNITS": "metres"}, "height [m]", 1.0),
        ({"TIFFTAG_RESOLUTIONUNIT": "2 (pixels/inch)", "UNITS": "none"}, "band 1", 1.0),
    ],
)
def test_tags_and_names_of_bands_tell_units_too(
    write: Write, tags: dict[str, str], band: str | None, unit: float
) -> None:
    ground = np.full((N, N), 10.0)
    house = ground.copy()
    house[10:20, 10:20] = 40.0
    paths = []
    for name, heights in (("dsm.tif", house), ("dem.tif", ground)):
        paths.append(write(name, (heights / unit).astype(np.float32)))
        with rasterio.open(paths[-1], "r+") as dataset:
            dataset.update_tags(**tags)
            if band is not None:
                dataset.set_band_description(1, band)
    if unit != 1.0:
        with pytest.raises(
            ValueError, match=r"dsm\.tif must hold heights in metres, not in .*foot"
        ):
            geotiff.read(dsm=paths[0], dem=paths[1])
    world = geotiff.read(dsm=paths[0], dem=paths[1], convert_heights=True)
    assert world.height_above_ground.max() == pytest.approx(30.0, abs=0.01)
