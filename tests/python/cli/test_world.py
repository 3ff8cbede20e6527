# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp world`: the built-in city, pictures, imports and what they need."""

import sys
from pathlib import Path

import pytest

from ltp.installed import pip_install
from ltp.world import World

from .runner import SHORT, fail, succeed


def test_the_built_in_city_is_written_and_shown(tmp_path: Path) -> None:
    path = tmp_path / "city.npz"
    said = succeed("world", "city", "--size", "200", "--seed", "3", "--out", path)
    city = World.load(path)
    assert city.extent == (0.0, 0.0, 200.0, 200.0) and city.name in said
    picture = tmp_path / "city.png"
    said = succeed("world", "show", path, "--out", picture)
    assert "landable, strict: " in said and "landable, wide: " in said
    assert "at most 10 degrees steep and 0.2 m rough within 1 m" in said
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_classes_of_rasters_need_a_meaning(tmp_path: Path) -> None:
    command = ["world", "import", "geotiff", "--dsm", "a", "--dem", "b", "--classes", "c"]
    said = fail(*command, "--class", "building=4", "-o", tmp_path / "w.npz")
    assert "--class: expected CODE=CLASS" in said


@pytest.mark.parametrize(
    ("option", "value", "complaint"),
    [
        ("--crs", "EPSG:1", "--crs must be a known CRS"),
        ("--default-height", "0", "--default-height must be above zero"),
        ("--cell", "-1", "--cell must be above zero"),
    ],
)
def test_a_mistake_in_an_import_names_the_option(option: str, value: str, complaint: str) -> None:
    for module in ("osmium", "pyproj", "shapely"):
        pytest.importorskip(module)
    command = ["world", "import", "osm", "map.osm", "--crs", "EPSG:32618", "-o", "w.npz"]
    command += ["--bounds", "0", "0", "9", "9"]
    assert complaint in fail(*command, option, value)


def test_a_missing_extra_is_told_with_its_command(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, world: str
) -> None:
    survey = tmp_path / "survey.las"
    points = pytest.importorskip("laspy").create(point_format=6, file_version="1.4")
    points.x, points.y, points.z = [0.0, 9.0], [0.0, 9.0], [1.0, 2.0]
    points.write(survey)
    monkeypatch.setitem(sys.modules, "laspy", None)
    assert pip_install("geo") in fail("world", "import", "las", survey, "-o", "w.npz")
    monkeypatch.setitem(sys.modules, "rerun", None)
    said = fail("fly", world, *SHORT, "--recording", "--out", tmp_path)
    assert pip_install("viewer") in said
