# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What surveys say of their CRS and units, wherever and however they say it: read, or refused."""

import re
import struct
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ltp.world import World
from ltp.world.importers import las

laspy = pytest.importorskip("laspy")
pyproj = pytest.importorskip("pyproj")

FOOT, US_FOOT = 0.3048, 1200.0 / 3937.0
Keys = Sequence[tuple[int, int | float | str]]
Survey = Callable[..., Path]


def geokeys(keys: Keys) -> list[Any]:
    """The records of GeoKeys; a float goes to the second one, a text to the third."""
    texts = "".join(f"{value}|" for _, value in keys if isinstance(value, str))
    doubles = [value for _, value in keys if isinstance(value, float)]
    directory = struct.pack("<4H", 1, 1, 0, len(keys))
    for key, value in sorted(keys):
        if isinstance(value, float):
            directory += struct.pack("<4H", key, 34736, 1, doubles.index(value))
        elif isinstance(value, str):
            directory += struct.pack("<4H", key, 34737, len(value) + 1, texts.index(value))
        else:
            directory += struct.pack("<4H", key, 0, 1, value)
    records = [laspy.VLR("LASF_Projection", 34735, "GeoKeys", directory)]
    if doubles:
        packed = struct.pack(f"<{len(doubles)}d", *doubles)
        records.append(laspy.VLR("LASF_Projection", 34736, "doubles", packed))
    if texts:
        records.append(laspy.VLR("LASF_Projection", 34737, "texts", texts.encode() + b"\0"))
    return records


def wkt_record(wkt: str) -> Any:
    return laspy.VLR("LASF_Projection", 2112, "OGC WKT", wkt.encode() + b"\0")


@pytest.fixture
def survey(tmp_path: Path) -> Survey:
    """A house of 10 m x 10 m x 30 m in the middle of 30 m x 30 m of ground at 10 m."""

    def write(
        records: Sequence[Any] = (),
        *,
        plan: float = 1.0,
        height: float = 1.0,
        west: float = 500000.0,
        south: float = 4600000.0,
        version: str = "1.4",
        extended: bool = False,
        scale: float = 0.01,
        name: str = "survey.las",
    ) -> Path:
        side = np.arange(0.25, 30.0, 0.5)
        x, y = (axis.ravel() for axis in np.meshgrid(side, side, indexing="ij"))
        roof = (x >= 10) & (x < 20) & (y >= 10) & (y < 20)
        header = laspy.LasHeader(version=version, point_format=6 if version == "1.4" else 1)
        header.scales, header.offsets = [scale, scale, 0.001], [west, south, 0.0]
        if extended:
            header.evlrs = laspy.vlrs.vlrlist.VLRList(list(records))
        else:
            header.vlrs.extend(records)
        cloud = laspy.LasData(header)
        cloud.x, cloud.y = west + x / plan, south + y / plan
        cloud.z = np.where(roof, 40.0, 10.0) / height
        cloud.classification = np.where(roof, 6, 2).astype(np.uint8)
        path = tmp_path / name
        cloud.write(path)
        return path

    return write


def assert_true_to_scale(world: World) -> None:
    assert world.shape == (30, 30)
    assert world.cell == 1.0
    assert world.height_above_ground.max() == pytest.approx(30.0, abs=0.01)
    assert world.ground.min() == pytest.approx(10.0, abs=0.01)
    assert np.count_nonzero(world.height_above_ground > 29.0) == 100


VERTICAL = {
    "EPSG:26918+6360": US_FOOT,
    "EPSG:26918+8228": FOOT,
    "EPSG:26918+5703": 1.0,
    "EPSG:27700+5701": 1.0,
    "+proj=utm +zone=18 +datum=NAD83 +vunits=us-ft +type=crs": US_FOOT,
    "+proj=utm +zone=18 +datum=NAD83 +geoidgrids=g.gtx +vto_meter=0.9144 +type=crs": 0.9144,
    "+proj=utm +zone=18 +datum=NAD83 +geoidgrids=g.gtx +vto_meter=1000 +type=crs": 1000.0,
    "+proj=utm +zone=18 +datum=NAD83 +geoidgrids=g.gtx +vto_meter=0.304797 +type=crs": 0.304797,
}


@pytest.mark.parametrize("extended", [False, True])
@pytest.mark.parametrize(
    ("crs", "dialect"),
    [
        (crs, dialect)
        for crs in VERTICAL
        for dialect in ("WKT1_GDAL", "WKT2_2019")
        # A projected CRS with heights of its own has no WKT 1.
        if not (crs.endswith("us-ft +type=crs") and dialect == "WKT1_GDAL")
    ],
)
def test_heights_are_in_metres_or_refused_or_scaled(
    survey: Survey, crs: str, dialect: str, extended: bool
) -> None:
    unit = VERTICAL[crs]
    place = {"west": 500000.0, "south": 200000.0} if "27700" in crs else {}
    wkt = pyproj.CRS(crs).to_wkt(dialect)
    path = survey([wkt_record(wkt)], height=unit, extended=extended, **place)
    if unit != 1.0:
        with pytest.raises(ValueError, match=r"survey\.las must hold heights in metres, not in "):
            las.read(path, cell=1.0)
    world = las.read(path, cell=1.0, convert_heights=True)
    assert_true_to_scale(world)
    assert world.datum.crs == ("EPSG:27700" if "27700" in crs else "EPSG:26918")
    expected = "heights are in metres" if unit == 1.0 else "heights were scaled from"
    assert any(line.startswith(expected) for line in world.report)


FEET_IN_PLAN: dict[str, Keys] = {
    "user-defined, US feet": [(1024, 1), (3072, 32767), (3074, 32767), (3075, 8), (3076, 9003)],
    "user-defined, feet": [(1024, 1), (3072, 32767), (3076, 9002)],
    "user-defined beside a geographic CRS": [(1024, 1), (2048, 4269), (3072, 32767), (3076, 9003)],
    "a metric code in US feet": [(1024, 1), (3072, 26918), (3076, 9003)],
    "Clarke's feet": [(1024, 1), (3072, 26918), (3076, 9005)],
    "yards": [(1024, 1), (3072, 26918), (3076, 9096)],
    "kilometres": [(1024, 1), (3072, 26918), (3076, 9036)],
    "a unit of one's own": [(1024, 1), (3072, 32767), (3076, 32767), (3077, 0.3048)],
    "a UTM zone in feet": [(1024, 1), (2048, 4269), (3072, 32767), (3074, 16018), (3076, 9002)],
}


@pytest.mark.parametrize("kind", FEET_IN_PLAN)
@pytest.mark.parametrize("version", ["1.2", "1.4"])
def test_a_plan_that_is_not_in_metres_is_refused_by_the_key(
    survey: Survey, kind: str, version: str
) -> None:
    path = survey(geokeys(FEET_IN_PLAN[kind]), version=version)
    with pytest.raises(ValueError, match=r"survey\.las .*3076"):
        las.read(path, cell=1.0, convert_heights=True)


@pytest.mark.parametrize("crs", ["EPSG:2263", "EPSG:2263+6360", "EPSG:2994", "EPSG:2264"])
@pytest.mark.parametrize("extended", [False, True])
def test_a_map_in_feet_is_refused_with_a_cure(survey: Survey, crs: str, extended: bool) -> None:
    wkt = pyproj.CRS(crs).to_wkt("WKT1_GDAL")
    path = survey([wkt_record(wkt)], plan=US_FOOT, west=984e3, south=196e3, extended=extended)
    with pytest.raises(
        ValueError, match=r"survey\.las must be .* foot .*reproject it first, to EPSG"
    ):
        las.read(path, cell=1.0)


FEET_IN_HEIGHT: dict[str, tuple[Keys, float]] = {
    "4099 US feet": ([(4099, 9003)], US_FOOT),
    "4099 feet": ([(4099, 9002)], FOOT),
    "4099 yards": ([(4099, 9096)], 0.9144),
    "4096 in metres, 4099 in US feet": ([(4096, 5703), (4099, 9003)], US_FOOT),
    "4096 in US feet": ([(4096, 6360)], US_FOOT),
    "4096 in feet": ([(4096, 8228)], FOOT),
    "4096 and 4099 in US feet": ([(4096, 6360), (4099, 9003)], US_FOOT),
}


@pytest.mark.parametrize("kind", FEET_IN_HEIGHT)
def test_keys_of_heights_in_feet_are_named(survey: Survey, kind: str) -> None:
    keys, unit = FEET_IN_HEIGHT[kind]
    plan: Keys = [(1024, 1), (3072, 26918), (3076, 9001)]
    path = survey(geokeys([*plan, *keys]), height=unit, version="1.2")
    with pytest.raises(ValueError, match=r"heights in metres, not in .* as GeoKey 409[69]"):
        las.read(path, cell=1.0)
    assert_true_to_scale(las.read(path, cell=1.0, convert_heights=True))


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ([(4096, 6360), (4099, 9001)], "contradicts itself"),
        ([(4099, 32767)], "4099 .* is no known unit"),
        ([(4099, 9102)], "4099 .* is no known unit"),  # a degree
        ([(3076, 9102)], "3076 .* is no known unit"),
    ],
)
def test_keys_that_make_no_sense_are_refused(survey: Survey, keys: Keys, message: str) -> None:
    path = survey(geokeys([(1024, 1), (3072, 26918), *keys]))
    with pytest.raises(ValueError, match=message):
        las.read(path, cell=1.0, convert_heights=True)


def test_a_wkt_in_metres_beside_keys_in_feet_is_refused(survey: Survey) -> None:
    wkt = pyproj.CRS("EPSG:26918+5703").to_wkt("WKT1_GDAL")
    keys = geokeys([(1024, 1), (3072, 26918), (4099, 9003)])
    with pytest.raises(ValueError, match="not in US survey foot"):
        las.read(survey([wkt_record(wkt), *keys]), cell=1.0)
    other = geokeys([(1024, 1), (3072, 26919)])
    with pytest.raises(ValueError, match=r"two CRSs: .* 18N in its WKT, .* 19N in its GeoKeys"):
        las.read(survey([wkt_record(wkt), *other]), cell=1.0)
    same = geokeys([(1024, 1), (3072, 26918), (3076, 9001)])
    assert las.read(survey([wkt_record(wkt), *same]), cell=1.0).datum.crs == "EPSG:26918"


METRIC: dict[str, tuple[Keys, str | None]] = {
    "a code": ([(1024, 1), (3072, 26918)], "EPSG:26918"),
    "a code and its unit": ([(1024, 1), (3072, 26918), (3076, 9001)], "EPSG:26918"),
    "a code and heights": (
        [(1024, 1), (3072, 26918), (4096, 5703), (4099, 9001)],
        "EPSG:26918",
    ),
    "a datum's old code for heights": ([(1024, 1), (3072, 26918), (4096, 5103)], "EPSG:26918"),
    "a UTM zone beside WGS 84": (
        [(1024, 1), (2048, 4326), (3072, 32767), (3074, 16018), (3076, 9001)],
        "EPSG:32618",
    ),
    "a UTM zone beside NAD 83": (
        [(1024, 1), (2048, 4269), (3072, 32767), (3074, 16018), (3076, 9001)],
        "EPSG:26918",
    ),
    "a UTM zone alone": ([(1024, 1), (3072, 32767), (3074, 16018), (3076, 9001)], "PROJCRS"),
    "transverse Mercator, number by number": (
        [
            (1024, 1),
            (2048, 4326),
            (3072, 32767),
            (3074, 32767),
            (3075, 1),
            (3076, 9001),
            (3080, -75.0),
            (3081, 0.0),
            (3082, 500000.0),
            (3083, 0.00001),
            (3092, 0.9996),
        ],
        "PROJCRS",
    ),
    "nothing but metres": ([(1024, 1), (3072, 32767), (3074, 32767), (3076, 9001)], None),
    "nothing but metres, beside WGS 84": (
        [(1024, 1), (2048, 4326), (3072, 32767), (3076, 9001)],
        None,
    ),
    "no projection at all": ([(1024, 1)], None),
}


@pytest.mark.parametrize("kind", METRIC)
@pytest.mark.parametrize("version", ["1.2", "1.4"])
def test_metric_keys_are_read(survey: Survey, kind: str, version: str) -> None:
    pytest.importorskip("rasterio")
    keys, crs = METRIC[kind]
    world = las.read(survey(geokeys(keys), version=version), cell=1.0)
    assert_true_to_scale(world)
    assert (world.datum.crs or "").startswith(crs or "")
    assert (world.datum.crs is None) == (crs is None)
    assert world.report[0].startswith("CRS: " + ("none is named" if crs is None else crs))


@pytest.mark.parametrize(
    ("keys", "message"),
    [
        ([(1024, 2), (2048, 4326)], "not in degrees"),
        ([(1024, 2), (2048, 4269), (4096, 5703)], "not in degrees"),
        ([(1024, 1), (3072, 1)], "CRS that nobody knows.*3072"),
        ([(1024, 1), (3072, 32767)], "neither it nor its unit; give crs"),
        ([(1024, 1), (3072, 3857), (3076, 9001)], "more than 1% off"),
    ],
)
def test_other_keys_are_refused(survey: Survey, keys: Keys, message: str) -> None:
    pytest.importorskip("rasterio")
    with pytest.raises(ValueError, match=message):
        las.read(survey(geokeys(keys)), cell=1.0)


@pytest.mark.parametrize("unit", ["metre", "meter", "Meter", "METERS", "m", "mètre"])
def test_a_metre_is_a_metre_by_any_name(survey: Survey, unit: str) -> None:
    wkt = pyproj.CRS("EPSG:6341+5703").to_wkt("WKT1_GDAL").replace('"metre"', f'"{unit}"')
    world = las.read(survey([wkt_record(wkt)]), cell=1.0)
    assert_true_to_scale(world)
    assert world.datum.crs == "EPSG:6341"


def test_a_foot_is_a_foot_by_any_name(survey: Survey) -> None:
    wkt = pyproj.CRS("EPSG:26918+6360").to_wkt("WKT1_GDAL")
    wkt = re.sub(r'"US survey foot",[0-9.]+', '"metre",0.3048', wkt)
    with pytest.raises(ValueError, match=r"not in metre \(0.3048 m\)"):
        las.read(survey([wkt_record(wkt)]), cell=1.0)


def test_an_extended_record_may_be_long(survey: Survey) -> None:
    wkt = pyproj.CRS("EPSG:32618").to_wkt("WKT1_GDAL")
    path = survey([wkt_record(wkt + " " * 100_000)], extended=True)
    assert las.read(path, cell=1.0).datum.crs == "EPSG:32618"
    data = bytearray(path.read_bytes())
    path.write_bytes(data[:-50_000])
    with pytest.raises(ValueError, match=r"survey\.las ends early"):
        las.read(path, cell=1.0)


def test_an_empty_wkt_says_nothing(survey: Survey) -> None:
    assert las.read(survey([wkt_record("")]), cell=1.0).datum.crs is None


def test_a_wkt_that_nobody_understands_is_refused_unless_the_crs_is_given(survey: Survey) -> None:
    path = survey([wkt_record("PROJCS[hm")])
    with pytest.raises(ValueError, match=r"nobody knows.*give crs"):
        las.read(path, cell=1.0)
    assert las.read(path, cell=1.0, crs="EPSG:32618").datum.crs == "EPSG:32618"


def test_a_given_crs_does_not_hide_feet(survey: Survey) -> None:
    wkt = pyproj.CRS("EPSG:2263").to_wkt("WKT1_GDAL")
    with pytest.raises(ValueError, match=r"x and y in metres, not in US survey foot .* its WKT"):
        las.read(survey([wkt_record(wkt)]), cell=1.0, crs="EPSG:32618")
    broken = survey([wkt_record("hm"), *geokeys([(1024, 1), (4099, 9003)])], height=US_FOOT)
    with pytest.raises(ValueError, match=r"not in US survey foot .* GeoKey 4099"):
        las.read(broken, cell=1.0, crs="EPSG:32618")
    plan = survey(geokeys(FEET_IN_PLAN["user-defined, US feet"]))
    with pytest.raises(ValueError, match="3076"):
        las.read(plan, cell=1.0, crs="EPSG:32618")
    height = survey(geokeys([(1024, 1), (3072, 26918), (4099, 9003)]), height=US_FOOT)
    with pytest.raises(ValueError, match="4099"):
        las.read(height, cell=1.0, crs="EPSG:32618")
    world = las.read(height, cell=1.0, crs="EPSG:32618", convert_heights=True)
    assert_true_to_scale(world)
    assert "as given, not EPSG:26918 as in its GeoKeys" in world.report[0]
    bare = survey(height=FOOT)
    with pytest.raises(ValueError, match=r"not in foot .* as crs says"):
        las.read(bare, cell=1.0, crs="EPSG:26918+8228")
    assert_true_to_scale(las.read(bare, cell=1.0, crs="EPSG:26918+8228", convert_heights=True))


@pytest.mark.parametrize("crs", [None, "EPSG:32618"])
@pytest.mark.parametrize(("west", "south"), [(-74.01, 40.71), (285.99, 40.71), (0.0, 0.0)])
def test_degrees_are_refused_with_and_without_a_crs(
    survey: Survey, crs: str | None, west: float, south: float
) -> None:
    path = survey(plan=111e3, west=west, south=south, scale=1e-7)
    with pytest.raises(ValueError, match=r"survey\.las must be in metres; .* looks like degrees"):
        las.read(path, cell=1.0, crs=crs)


def test_a_local_frame_is_none_in_degrees(survey: Survey) -> None:
    for west, south in ((0.0, 0.0), (-15.0, -15.0), (100.0, 50.0)):
        assert_true_to_scale(las.read(survey(west=west, south=south), cell=1.0))


def test_bounds_off_the_survey_are_refused(survey: Survey) -> None:
    path = survey([wkt_record(pyproj.CRS("EPSG:32618").to_wkt("WKT1_GDAL"))])
    for bounds in (
        (583950.0, 4511100.0, 584950.0, 4512100.0),
        (500030.0, 4600000.0, 500060.0, 4600030.0),
        (0.0, 0.0, 30.0, 30.0),
    ):
        with pytest.raises(ValueError, match=r"lie outside of .*survey\.las, which covers .*32618"):
            las.read(path, cell=1.0, bounds=bounds)
    with pytest.raises(ValueError, match=r"bounds must be in metres.*in EPSG:32618 that is"):
        las.read(path, cell=1.0, bounds=(-75.0, 41.55, -74.99, 41.56))


@pytest.mark.parametrize("crs", ["EPSG:3857", "EPSG:3395", "EPSG:32610", "ESRI:54009"])
def test_a_map_whose_metre_is_none_is_refused(survey: Survey, crs: str) -> None:
    flat = pyproj.CRS(crs)
    x, y = pyproj.Transformer.from_crs(4326, flat, always_xy=True).transform(-75.0, 41.5)
    path = survey([wkt_record(flat.to_wkt())], west=round(x), south=round(y))
    with pytest.raises(ValueError, match=r"more than 1% off; use EPSG:32618"):
        las.read(path, cell=1.0)
    assert_true_to_scale(las.read(survey(), cell=1.0, crs="EPSG:32618"))


@pytest.mark.parametrize(
    ("field", "at", "value"),
    [
        ("x_max", 179, 500029.746),  # half a step short
        ("x_max", 179, float(np.nextafter(500029.75, 0.0))),
        ("x_min", 187, 500000.254),
        ("y_max", 195, 4600029.746),
        ("y_min", 203, 4600000.254),
    ],
)
def test_an_extent_that_was_taken_before_rounding_is_read(
    survey: Survey, field: str, at: int, value: float
) -> None:
    # The rim of the returns lies at 0.25 and 29.75 m: cells of 0.25 m end exactly there.
    path = survey()
    data = bytearray(path.read_bytes())
    struct.pack_into("<d", data, at, value)
    path.write_bytes(data)
    world = las.read(path, cell=0.25, max_gap=8.0)
    assert np.count_nonzero(world.height_above_ground > 29.0) >= 400, field
    struct.pack_into("<d", data, at, value + (1.0 if "min" in field else -1.0))
    path.write_bytes(data)
    with pytest.raises(ValueError, match="outside of the extent in its header"):
        las.read(path, cell=0.25)


UTM_CITED = "NAD83 / UTM zone 18N"


@pytest.mark.parametrize(
    ("keys", "unit"),
    [
        ([(3072, 26918), (4097, "NAVD88 height (ftUS)")], US_FOOT),
        ([(3072, 26918), (4097, "NAVD88 (US Survey Feet)")], US_FOOT),
        ([(3072, 26918), (4097, "NAVD88 - Geoid12B (Feet)")], FOOT),
        ([(3072, 26918), (4096, 5103), (4097, "NAVD_1988_Foot_US")], US_FOOT),
        ([(3072, 26918), (1026, f"{UTM_CITED} + NAVD88 height (ft)")], FOOT),
        ([(3073, f"{UTM_CITED} + NAVD88 height (ftUS)")], US_FOOT),
    ],
)
def test_heights_in_feet_may_be_told_by_a_name_only(
    survey: Survey, keys: Keys, unit: float
) -> None:
    path = survey(geokeys([(1024, 1), *keys]), height=unit)
    with pytest.raises(ValueError, match=r"must hold heights in metres, not in .*foot.*GeoKey"):
        las.read(path, cell=1.0)
    world = las.read(path, cell=1.0, convert_heights=True)
    assert_true_to_scale(world)
    assert world.datum is not None
    assert world.datum.crs == "EPSG:26918"


@pytest.mark.parametrize(
    "name",
    [
        "NAD83 / New York Long Island (ftUS)",
        "NAD_1983_StatePlane_New_York_Long_Island_FIPS_3104_Feet",
        "site grid in feet",
    ],
)
@pytest.mark.parametrize("key", [1026, 3073])
@pytest.mark.parametrize("more", [(), ((3072, 32767),)])
def test_a_plan_in_feet_may_be_told_by_a_name_only(
    survey: Survey, name: str, key: int, more: Keys
) -> None:
    path = survey(geokeys([(1024, 1), *more, (key, name)]), plan=FOOT, height=FOOT)
    with pytest.raises(ValueError, match=r"metres, not .*foot"):
        las.read(path, cell=1.0)


@pytest.mark.parametrize("key", [1026, 3073])
@pytest.mark.parametrize(
    ("name", "crs"),
    [(UTM_CITED, "EPSG:26918"), ("site grid (metres)", None), ("PCS Name = UTM_18N", None)],
)
def test_a_metric_crs_may_be_told_by_its_name_only(
    survey: Survey, key: int, name: str, crs: str | None
) -> None:
    world = las.read(survey(geokeys([(1024, 1), (key, name), (4097, "NAVD88 (m)")])), cell=1.0)
    assert_true_to_scale(world)
    assert world.datum is not None
    assert world.datum.crs == crs
