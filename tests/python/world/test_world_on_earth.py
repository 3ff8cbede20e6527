# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`World.to_map` and `World.to_local`: local metres to latitudes and longitudes, and back."""

from typing import Any

import numpy as np
import pytest

from ltp.world import Datum, World

pyproj = pytest.importorskip("pyproj")

# CRS, easting, northing of local (0, 0), and a published place: latitude, longitude [degrees].
PLACES = {
    # EPSG Guidance Note 7-2, transverse Mercator example: 50 30' N 0 30' E, on OSGB 36.
    "EPSG:27700": (577274.99, 69740.50, 50.5, 0.5, 2e-3),
    # Where the central meridian of zone 18 meets the equator.
    "EPSG:32618": (500000.0, 0.0, 0.0, -75.0, 1e-9),
    "EPSG:2154": (700000.0, 6600000.0, 46.5, 3.0, 1e-6),
    "EPSG:2193": (1600000.0, 10000000.0, 0.0, 173.0, 1e-6),  # northing first in its definition
}


def world(crs: str | None, easting: float = 0.0, northing: float = 0.0) -> World:
    flat = np.zeros((3, 2))
    datum = Datum(crs, easting, northing, "somewhere")
    return World("w", flat, flat, np.zeros((3, 2), dtype=np.uint8), 10.0, datum=datum)


@pytest.mark.parametrize("crs", PLACES)
def test_a_corner_lies_where_it_is_known_to(crs: str) -> None:
    easting, northing, lat, lon, slack = PLACES[crs]
    found = world(crs, easting, northing).to_map([0.0, 0.0, 12.5])
    assert found[:2] == pytest.approx([lat, lon], abs=slack)
    assert found[2] == 12.5


@pytest.mark.parametrize("crs", PLACES)
def test_points_go_there_and_back(crs: str) -> None:
    place = world(crs, *PLACES[crs][:2])
    points = np.random.default_rng(5).uniform(-500.0, 1500.0, (50, 3))
    there = place.to_map(points)
    assert there.shape == (50, 3)
    # Shifts between old datums go back to a millimetre.
    np.testing.assert_allclose(place.to_local(there), points, atol=1e-3)
    np.testing.assert_allclose(place.to_local(there[7]), points[7], atol=1e-3)


def test_north_is_north_and_a_metre_a_metre() -> None:
    place = world("EPSG:32618", 583950.0, 4511100.0)
    (lat, lon, _), (north, _, _), (_, east, _) = place.to_map(
        [[0.0, 0.0, 0.0], [0.0, 100.0, 0.0], [100.0, 0.0, 0.0]]
    )
    metres = pyproj.Geod(ellps="WGS84").inv(lon, lat, lon, north)[2]
    assert metres == pytest.approx(100.0, abs=0.1)
    assert north > lat
    assert east > lon


def test_an_empty_list_stays_empty() -> None:
    place = world("EPSG:32618", 5e5, 45e5)
    assert place.to_map(np.empty((0, 3))).shape == (0, 3)
    assert place.to_local(np.empty((0, 3))).shape == (0, 3)


def test_a_made_up_city_lies_nowhere() -> None:
    for method in (world(None).to_map, world(None).to_local):
        with pytest.raises(ValueError, match="w has no CRS"):
            method([[0.0, 0.0, 0.0]])


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ([1.0, 2.0], r"points must have shape \(N, 3\), found \(2,\)"),
        (np.zeros((2, 2)), r"found \(2, 2\)"),
        (np.zeros((2, 2, 3)), r"found \(2, 2, 3\)"),
        ([[0.0, np.nan, 0.0]], "points must be finite, not nan"),
        ("here", "points must be numbers"),
    ],
)
def test_what_is_no_list_of_points_is_refused(points: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        world("EPSG:32618", 5e5, 45e5).to_map(points)


def test_places_must_be_on_the_earth() -> None:
    place = world("EPSG:32618", 5e5, 45e5)
    with pytest.raises(ValueError, match=r"latitudes in -90...90, not 4.5e"):
        place.to_local([[4.5e6, 5e5, 0.0]])  # metres for degrees
    with pytest.raises(ValueError, match=r"datum\.crs must be a known CRS"):
        world("EPSG:1").to_map([0.0, 0.0, 0.0])


@pytest.mark.parametrize("far", [(0.0, 1e9), (1e9, 0.0), (-3e7, 4e7)])
def test_where_the_crs_does_not_reach_there_is_no_place(far: tuple[float, float]) -> None:
    """A transverse Mercator goes on past the pole, to places that it does not mean."""
    with pytest.raises(ValueError, match=r"beyond the area of EPSG:32618|nowhere on the Earth"):
        world("EPSG:32618", 500000.0, 4e6).to_map([*far, 50.0])
