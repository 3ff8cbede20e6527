# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp world`: the built-in city, pictures, imports and what they need."""

import sys
from pathlib import Path

import numpy as np
import pytest

from ltp.installed import pip_install
from ltp.world import World, land_cover

from .runner import SHORT, fail, succeed


def test_the_built_in_city_is_written_and_shown(tmp_path: Path) -> None:
    path = tmp_path / "city.npz"
    said = succeed("world", "city", "--size", "200", "--seed", "3", "--out", path)
    city = World.load(path)
    assert city.extent == (0.0, 0.0, 200.0, 200.0) and city.name in said
    picture = tmp_path / "city.png"
    shown = succeed("world", "show", path, "--out", picture)
    for cover in land_cover(city):
        (line,) = (line for line in shown.splitlines() if line.split()[:1] == [cover.kind.name])
        assert line.split()[1:3] == [f"{cover.cells:,}", f"{100 * cover.share:.2f}"]
        assert line.rstrip().endswith(", ".join(cover.landable) or "-")
    assert "landable, strict: " in shown and "landable, wide: " in shown
    assert "at most 10 degrees steep and 0.2 m rough within 1 m" in shown
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_classes_of_rasters_need_a_meaning(tmp_path: Path) -> None:
    command = ["world", "import", "geotiff", "--dsm", "a", "--dem", "b", "--classes", "c"]
    said = fail(*command, "--class", "building=4", "-o", tmp_path / "w.npz")
    assert "--class: expected CODE=CLASS" in said


def test_classes_of_surveys_may_be_given_a_meaning(tmp_path: Path) -> None:
    survey, out = tmp_path / "survey.las", tmp_path / "w.npz"
    points = pytest.importorskip("laspy").create(point_format=6, file_version="1.4")
    points.x, points.y, points.z = np.arange(4.0), np.zeros(4), np.array([1.0, 1.0, 9.0, 9.0])
    points.classification = np.array([2, 2, 65, 66], dtype=np.uint8)
    points.write(survey)
    command = ["world", "import", "las", survey, "--cell", "1", "-o", out]
    assert "--user-classes ign" in succeed(*command)
    said = succeed(*command, "--class", "65=building", "--class", "66=noise")
    assert "class 65 (building, as you say): 1 returns, taken for BUILDING" in said
    assert World.load(out).surface[:, 0].tolist() == [1.0, 1.0, 9.0, 9.0]
    assert said.splitlines()[1].strip() == World.load(out).report[0]
    assert "--user-classes must be one of" in fail(*command, "--user-classes", "french")
    assert "--class must name classes 0 to 255" in fail(*command, "--class", "300=building")


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


def test_ways_out_of_an_import_are_told_as_options(tmp_path: Path) -> None:
    rasterio = pytest.importorskip("rasterio")

    def write(name: str, crs: str, west: float) -> Path:
        here = rasterio.Affine(1.0, 0.0, west, 0.0, -1.0, 4600030.0)
        options = {"driver": "GTiff", "width": 9, "height": 9, "count": 1, "dtype": "float32"}
        with rasterio.open(tmp_path / name, "w", crs=crs, transform=here, **options) as file:
            file.write(np.full((1, 9, 9), 30.0, dtype=np.float32))
        return tmp_path / name

    feet = write("feet.tif", "EPSG:26918+6360", 5e5)
    off = write("off.tif", "EPSG:26918+6360", 5e5 + 0.5)
    command = ["world", "import", "geotiff", "-o", tmp_path / "w.npz", "--dsm", feet]
    assert "with --convert-heights they are scaled" in fail(*command, "--dem", feet)
    command += ["--convert-heights", "--dem", off]
    assert "with --align it is resampled onto that grid" in fail(*command)
    said = succeed(*command, "--align")
    assert "off.tif: resampled from 9 x 9 cells of 1 m" in said
    assert "heights were scaled from US survey foot (0.30480061 m) to metres" in said
    assert "CRS: EPSG:26918 (NAD83 / UTM zone 18N)" in said
    world = World.load(tmp_path / "w.npz")
    assert world.ground.max() == pytest.approx(30.0 * 1200 / 3937, abs=1e-4)
    assert any("scaled" in line for line in world.report)
