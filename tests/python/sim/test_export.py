# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoJSON and KML: the paths are where they were flown."""

import dataclasses
import json
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import pytest

from ltp.sim import Outcome, to_geojson, to_kml
from ltp.sim.export import KML
from ltp.world import Datum
from tests.python.cli.runner import fail, succeed
from tests.python.scenes import box_world, event, record

pyproj = pytest.importorskip("pyproj")

UTM = "EPSG:32618"
PLACE = dataclasses.replace(box_world([]), datum=Datum(UTM, 583000.0, 4507000.0, "NAVD88"))
DROP = event(0, "dropped", "unreachable", goal=(25.0, 20.0, 30.0))
FLIGHT = dataclasses.replace(record([DROP]), outcome=Outcome.COLLIDED, collision=(50.0, 20.0, 30.0))


def in_utm(points: list[list[float]]) -> np.ndarray:
    back = pyproj.Transformer.from_crs("EPSG:4326", UTM, always_xy=True)
    longitude, latitude, z = np.transpose(points)
    return np.column_stack([*back.transform(longitude, latitude), z])


def test_geojson_holds_paths_drops_and_hits_where_they_were() -> None:
    features = json.loads(json.dumps(to_geojson(PLACE, [FLIGHT])))["features"]
    kinds = [feature["properties"]["kind"] for feature in features]
    assert kinds == ["flown path", "global path", "dropped waypoint", "hit"]
    corner = np.array([583000.0, 4507000.0, 0.0])
    for feature, points in zip(
        features,
        (FLIGHT.positions, FLIGHT.global_path, [DROP.goal], [FLIGHT.collision]),
        strict=True,
    ):
        shape = feature["geometry"]
        found = [shape["coordinates"]] if shape["type"] == "Point" else shape["coordinates"]
        np.testing.assert_allclose(in_utm(found) - corner, points, atol=2e-3)
    assert features[0]["properties"]["outcome"] == "collided"
    assert features[2]["properties"]["reason"] == "unreachable"


def test_kml_says_the_same() -> None:
    root = ElementTree.fromstring(to_kml(PLACE, [FLIGHT]))
    marks = root.findall(f".//{{{KML}}}Placemark")
    assert len(marks) == 4
    texts = [mark.find(f".//{{{KML}}}coordinates").text for mark in marks]
    geojson = to_geojson(PLACE, [FLIGHT])["features"]
    for text, feature in zip(texts, geojson, strict=True):
        points = [[float(number) for number in point.split(",")] for point in text.split()]
        # The very numbers, far from Greenwich too: the last digit is a tenth of a millimetre.
        np.testing.assert_array_equal(points, np.atleast_2d(feature["geometry"]["coordinates"]))
    assert "absolute" in to_kml(PLACE, [FLIGHT])


def test_a_world_without_a_place_is_refused() -> None:
    with pytest.raises(ValueError, match="crs"):
        to_geojson(box_world([]), [FLIGHT])
    with pytest.raises(ValueError, match="the flight was over boxes, not over elsewhere"):
        to_kml(dataclasses.replace(PLACE, name="elsewhere"), [FLIGHT])


def test_the_command_writes_both_formats(tmp_path: Path) -> None:
    PLACE.save(tmp_path / "world.npz")
    (tmp_path / "records").mkdir()
    FLIGHT.save(tmp_path / "records" / "flight.npz")
    place, records = tmp_path / "world.npz", tmp_path / "records"
    succeed("export", place, records, "--out", tmp_path / "f.geojson")
    assert len(json.loads((tmp_path / "f.geojson").read_text())["features"]) == 4
    succeed("export", place, records / "flight.npz", "--out", tmp_path / "f.kml")
    assert ElementTree.parse(tmp_path / "f.kml").getroot().tag == f"{{{KML}}}kml"
    assert "must end in .geojson or .kml" in fail("export", place, records, "-o", tmp_path / "f.x")
