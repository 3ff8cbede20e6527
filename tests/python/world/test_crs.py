# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a CRS says about units, scale and name, over CRSs and spellings from all the world."""

import re

import numpy as np
import pytest

from ltp.world.crs import (
    any_crs,
    check_scale,
    crs_name,
    height_datum,
    height_unit,
    horizontal,
    looks_like_degrees,
    metric_crs,
    refuse_degrees,
    same_grid,
)
from ltp.world.geodesy import from_lon_lat, lon_lat, scales, utm_zone
from ltp.world.whereabouts import elsewhere

pyproj = pytest.importorskip("pyproj")

# National grids and zones, with a place (longitude, latitude) where they are in use.
GOOD = {
    "EPSG:27700": (-0.1, 51.5),
    "EPSG:2154": (-2.5, 48.47),
    "EPSG:25832": (8.5, 50.0),
    "EPSG:32618": (-74.0, 40.7),
    "EPSG:2056": (8.5, 47.4),
    "EPSG:28992": (4.9, 52.4),
    "EPSG:3414": (103.8, 1.35),
    "EPSG:6677": (139.7, 35.7),
    "EPSG:7856": (151.2, -33.9),
    "EPSG:3413": (-45.0, 70.0),
    "EPSG:3031": (10.0, -71.0),
    "EPSG:2193": (174.8, -41.3),
    "EPSG:5514": (14.4, 50.1),
    "EPSG:3035": (9.0, 50.0),
    "EPSG:27572": (2.3, 48.8),  # counts from Paris, in grads
    "EPSG:31467": (9.0, 48.5),
    "EPSG:5041": (20.0, 89.9999),  # a pole
    "+proj=tmerc +lat_0=52 +lon_0=13 +k=1 +ellps=WGS84 +units=m": (13.01, 52.01),
}
# Maps whose metre is none there.
BAD = [
    ("EPSG:3857", (-0.1, 51.5), 1.607),
    ("EPSG:3857", (103.8, 9.0), 1.019),
    ("EPSG:3395", (-0.1, 51.5), 1.603),
    ("EPSG:32618", (-0.1, 51.5), 1.250),
    ("EPSG:27700", (-74.0, 40.7), None),
    ("EPSG:4087", (-0.1, 51.5), 1.603),
    ("ESRI:54009", (-0.1, 51.5), None),
    ("EPSG:3413", (-45.0, 89.0), 0.970),
    ("EPSG:3031", (0.0, -50.0), None),
]
SPELLINGS = ("WKT1_GDAL", "WKT1_ESRI", "WKT2_2019", "JSON", "anonymous", "compound", "3d", "meter")


def around(crs: str, place: tuple[float, float], half: float = 500.0) -> tuple[float, ...]:
    x, y = from_lon_lat(horizontal(pyproj.CRS(crs)), *place)
    return x - half, y - half, x + half, y + half


def spelt(crs: str, spelling: str) -> str:
    known = pyproj.CRS(crs)
    wkt = known.to_wkt("WKT1_GDAL")
    return {
        "JSON": known.to_json,
        "anonymous": lambda: re.sub(r',AUTHORITY\["[^]]*\]', "", wkt).replace(known.name, "any"),
        "compound": lambda: f"{crs}+5773",
        "3d": lambda: known.to_3d().to_wkt(),
        "meter": lambda: re.sub(r',AUTHORITY\["[^]]*\]', "", wkt).replace('"metre"', '"Meter"'),
    }.get(spelling, lambda: known.to_wkt(spelling))()


@pytest.mark.parametrize("crs", GOOD)
def test_a_national_grid_is_true_at_home(crs: str) -> None:
    flat = metric_crs(crs, "crs")
    assert check_scale(flat, around(crs, GOOD[crs]), "bounds") < 0.007


@pytest.mark.parametrize(("crs", "place", "scale"), BAD)
def test_a_metre_that_is_none_is_refused_with_a_cure(
    crs: str, place: tuple[float, float], scale: float | None
) -> None:
    flat = metric_crs(crs, "crs")
    with pytest.raises(ValueError, match=r"here, more than 1% off; use EPSG:3[0-9]{4}") as caught:
        check_scale(flat, around(crs, place), "the map")
    assert str(caught.value).startswith("the map: a metre on the ground is")
    if scale is not None:
        assert f"{scale:.3f} m" in str(caught.value)
    cure = re.search(r"use (EPSG:\d+)", str(caught.value))
    assert cure is not None
    assert check_scale(pyproj.CRS(cure[1]), around(cure[1], place), "cure") < 0.01


def test_the_worst_spot_of_the_area_counts() -> None:
    zone = metric_crs("EPSG:32631", "crs")
    check_scale(zone, (400e3, 0.0, 600e3, 1000.0), "bounds")
    with pytest.raises(ValueError, match="more than 1% off"):
        check_scale(zone, (400e3, 0.0, 1500e3, 1000.0), "bounds")


def test_the_far_side_of_the_earth_is_refused_though_its_scale_is_true() -> None:
    zone = metric_crs("EPSG:32601", "crs")  # 177 degrees from London
    bounds = around("EPSG:32601", (-0.1, 51.5))
    with pytest.raises(ValueError, match=r"crs: north is down in .* use EPSG:32630"):
        check_scale(zone, bounds, "crs")


def test_a_file_that_lies_elsewhere_is_told_where() -> None:
    covered = (583950.0, 4511100.0, 584950.0, 4512100.0)
    utm, degrees = pyproj.CRS(32618), pyproj.CRS(4326)
    at = ": it lies at longitude -73.9996, latitude 40.7510, EPSG:32618"
    assert elsewhere(utm, covered, (0.0, 0.0, 9.0, 9.0)) == at
    lon, lat = lon_lat(utm, [covered[0], covered[2]], [covered[1], covered[3]])
    box = (float(lon[0]), float(lat[0]), float(lon[1]), float(lat[1]))
    said = elsewhere(degrees, box, covered)
    assert said.endswith("EPSG:32618, in which these bounds lie within it")
    state_plane = around("EPSG:32118", (-73.9995, 40.751))
    assert "bounds lie within it" in elsewhere(pyproj.CRS(32118), state_plane, covered)
    assert elsewhere(utm, (1e12, 1e12, 2e12, 2e12), covered) == ""


def test_bounds_off_the_map_are_refused() -> None:
    with pytest.raises(ValueError, match=r"bounds: .* does not lie in"):
        check_scale(metric_crs("EPSG:32618", "crs"), (1e12, 1e12, 2e12, 2e12), "bounds")


@pytest.mark.parametrize("crs", ["EPSG:27700", "EPSG:2154", "EPSG:3413", "EPSG:2056", "ESRI:54009"])
def test_the_scale_is_that_of_proj(crs: str) -> None:
    place = GOOD.get(crs, (-0.1, 51.5))
    x, y = from_lon_lat(pyproj.CRS(crs), *place)
    told = pyproj.Proj(crs).get_factors(*place)
    largest, smallest = scales(pyproj.CRS(crs), np.array([x]), np.array([y]))[0]
    # The national ellipsoid differs from that of WGS 84 by 1e-4, Mollweide's is a sphere.
    slack = 3e-3 if crs == "ESRI:54009" else 2e-4
    assert largest == pytest.approx(told.tissot_semimajor, abs=slack)
    assert smallest == pytest.approx(told.tissot_semiminor, abs=slack)


@pytest.mark.parametrize("spelling", SPELLINGS)
@pytest.mark.parametrize(
    "crs", ["EPSG:26918", "EPSG:27700", "EPSG:2154", "EPSG:2193", "EPSG:6341", "EPSG:6677"]
)
def test_a_grid_has_one_name_however_it_is_spelt(crs: str, spelling: str) -> None:
    text = spelt(crs, spelling)
    flat = metric_crs(text, "crs")
    assert crs_name(flat) == crs
    assert same_grid(text, crs)


def test_a_grid_that_only_looks_like_another_has_not_its_name() -> None:
    nameless = metric_crs("+proj=utm +zone=18 +ellps=GRS80 +units=m +type=crs", "crs")
    assert crs_name(nameless).startswith("PROJCRS")
    assert not same_grid("EPSG:26918", "EPSG:32618")
    assert not same_grid("EPSG:26918", "EPSG:26919")
    moved = pyproj.CRS(26918).to_wkt("WKT1_ESRI").replace("500000.0", "500001.0")
    assert not crs_name(metric_crs(moved, "crs")).startswith("EPSG")


@pytest.mark.parametrize(
    ("crs", "message"),
    [
        ("EPSG:2263", r"in US survey foot \(0.30480061 m\)"),
        ("EPSG:2264", "US survey foot"),
        ("EPSG:2994", r"foot \(0.3048 m\)"),
        ("+proj=utm +zone=31 +units=km", r"kilomet.. \(1000 m\)"),
        ("+proj=tmerc +lon_0=9 +to_meter=0.9144", r"0.9144 m"),
        ("+proj=tmerc +lon_0=9 +to_meter=0.3047972654", r"0.30479727 m"),  # Clarke's foot
        ("+proj=tmerc +lon_0=9 +units=ind-yd", r"0.91439523 m"),
        ("+proj=tmerc +lon_0=9 +units=us-ch", r"20.116"),
        ("EPSG:8044", "axes go east and north"),
        ("EPSG:4326", "not in degrees"),
        ("EPSG:4979", "not in degrees"),
        ("EPSG:4326+5773", "not in degrees"),
        ("EPSG:4978", "Geocentric"),
        ("EPSG:5773", "Vertical"),
        ('LOCAL_CS["site",UNIT["metre",1]]', "Engineering"),
        ("EPSG:5513", "axes go east and north"),
        ("EPSG:2048", "axes go east and north"),
        ("EPSG:1", "must be a known CRS"),
        ("nonsense", "must be a known CRS"),
        ("", "must be a known CRS"),
    ],
)
def test_what_is_no_metric_map_is_refused_by_name(crs: str, message: str) -> None:
    with pytest.raises(ValueError, match=message) as caught:
        metric_crs(crs, "--crs")
    assert str(caught.value).startswith("--crs must be")


def test_the_german_legal_metre_is_a_metre() -> None:
    assert metric_crs("EPSG:29333", "crs").is_projected  # Schwarzeck / UTM zone 33S


def test_feet_are_told_where_to_go() -> None:
    with pytest.raises(ValueError, match=r"reproject it first, to EPSG:32618 \(the place lies at"):
        metric_crs("EPSG:2263", "map.tif", around("EPSG:2263", (-74.0, 40.7)))
    with pytest.raises(ValueError, match="reproject it first, to EPSG:32618"):
        metric_crs("EPSG:4326", "map.tif", (-74.1, 40.6, -74.0, 40.7))


@pytest.mark.parametrize(
    ("crs", "metres", "datum"),
    [
        ("EPSG:26918", None, None),
        ("EPSG:26918+5703", 1.0, "North American Vertical Datum 1988"),
        ("EPSG:26918+6360", 1200 / 3937, "North American Vertical Datum 1988"),
        ("EPSG:26918+8228", 0.3048, "North American Vertical Datum 1988"),
        ("EPSG:27700+5701", 1.0, "Ordnance Datum Newlyn"),
        ("EPSG:7405", 1.0, "Ordnance Datum Newlyn"),
        ("+proj=utm +zone=18 +datum=NAD83 +vunits=us-ft +type=crs", 1200 / 3937, "ellipsoid"),
        ("+proj=utm +zone=18 +datum=NAD83 +vto_meter=0.9144 +type=crs", 0.9144, "ellipsoid"),
        (
            "+proj=utm +zone=18 +datum=NAD83 +geoidgrids=g2018u0.gtx +vunits=ft +type=crs",
            0.3048,
            "unknown using geoidgrids=g2018u0.gtx",
        ),
    ],
)
def test_heights_have_a_unit_and_a_datum(crs: str, metres: float | None, datum: str | None) -> None:
    known = any_crs(crs, "crs")
    unit = height_unit(known)
    assert (unit and unit.metres) == (metres and pytest.approx(metres, rel=1e-9))
    assert height_datum(known) == datum
    metric_crs(known, "crs")  # in plan they are all in metres


@pytest.mark.parametrize(
    ("bounds", "cell", "expected"),
    [
        ((-74.01, 40.71, -74.0, 40.72), None, True),
        ((-74.01, 40.71, -74.0096, 40.7104), 1e-5, True),
        ((285.99, 40.71, 286.0, 40.72), None, True),  # east of Greenwich all round
        ((5.0, 45.0, 15.0, 55.0), 1 / 1200, True),
        ((5.0, 45.0, 15.0, 55.0), 1 / 24, True),
        ((0.0, 0.0, 30.0, 30.0), 0.1, False),  # a local frame
        ((0.0, 0.0, 30.0, 30.0), 1.0, False),
        ((10.0, 10.0, 40.0, 40.0), 0.5, False),
        ((-15.0, -15.0, 15.0, 15.0), 0.05, False),
        ((0.0, 0.0, 300.0, 80.0), None, False),
        ((583950.0, 4511100.0, 584950.0, 4512100.0), 1.0, False),
        ((583950.0, 4511100.0, 583950.5, 4511100.5), 0.01, False),
    ],
)
def test_what_looks_like_degrees(
    bounds: tuple[float, float, float, float], cell: float | None, expected: bool
) -> None:
    assert looks_like_degrees(bounds, cell) == expected


def test_degrees_are_refused_and_told_in_metres() -> None:
    with pytest.raises(ValueError, match=r"a.tif must be in metres; .* reproject to EPSG:32618"):
        refuse_degrees((-74.01, 40.71, -74.0, 40.72), "a.tif")
    with pytest.raises(ValueError, match="in EPSG:32618 that is 583612, 4507036, 584470, 4508156"):
        refuse_degrees((-74.01, 40.71, -74.0, 40.72), "bounds", crs=pyproj.CRS(32618))
    refuse_degrees((583950.0, 4511100.0, 584950.0, 4512100.0), "bounds")


@pytest.mark.parametrize(
    ("place", "zone"),
    [
        ((-74.0, 40.7), "EPSG:32618"),
        ((286.0, 40.7), "EPSG:32618"),
        ((-0.1, 51.5), "EPSG:32630"),
        ((151.2, -33.9), "EPSG:32756"),
        ((179.9, -17.0), "EPSG:32760"),
        ((10.0, 87.0), "EPSG:32661"),
        ((10.0, -87.0), "EPSG:32761"),
    ],
)
def test_utm_zones(place: tuple[float, float], zone: str) -> None:
    assert utm_zone(*place) == zone


def test_places_go_there_and_back() -> None:
    crs = pyproj.CRS("EPSG:27700")
    x, y = np.array([[530e3, 531e3], [180e3, 181e3]])
    np.testing.assert_allclose(from_lon_lat(crs, *lon_lat(crs, x, y)), [x, y], atol=1e-6)
    with pytest.raises(ValueError, match="nowhere"):
        lon_lat(crs, [np.inf], [0.0])
