# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""An extract, and bounds that miss it: degrees, another zone, another city."""

from pathlib import Path

import pytest

from ltp.world.importers import osm

for library in ("osmium", "pyproj", "rasterio", "shapely"):
    pytest.importorskip(library)
pyproj = pytest.importorskip("pyproj")

LON, LAT = -74.0, 40.75


@pytest.fixture
def extract(tmp_path: Path) -> Path:
    """A house of some 40 m in Manhattan."""
    corners = [(0.0, 0.0), (0.0005, 0.0), (0.0005, 0.0004), (0.0, 0.0004)]
    nodes = "".join(
        f'<node id="{i}" version="1" lat="{LAT + dy}" lon="{LON + dx}"/>'
        for i, (dx, dy) in enumerate(corners, 1)
    )
    way = "".join(f'<nd ref="{i}"/>' for i in (1, 2, 3, 4, 1))
    path = tmp_path / "manhattan.osm"
    path.write_text(
        f'<osm version="0.6">{nodes}<way id="9" version="1">{way}'
        '<tag k="building" v="yes"/><tag k="height" v="30"/></way></osm>'
    )
    return path


def box(crs: str, lon: float = LON, lat: float = LAT) -> tuple[float, float, float, float]:
    to_map = pyproj.Transformer.from_crs(4326, crs, always_xy=True)
    x, y = (round(value) for value in to_map.transform(lon, lat))
    return x - 100.0, y - 100.0, x + 100.0, y + 100.0


@pytest.mark.parametrize("crs", ["EPSG:32618", "EPSG:26918", "EPSG:32118"])
def test_the_right_zone_is_read(extract: Path, crs: str) -> None:
    world = osm.read(extract, bounds=box(crs), crs=crs)
    assert world.surface.max() == 30.0
    assert world.report[0].startswith(f"CRS: {crs} (")


@pytest.mark.parametrize("crs", ["EPSG:32617", "EPSG:32619"])
def test_the_neighbouring_zone_is_refused_and_the_right_one_named(extract: Path, crs: str) -> None:
    message = r"manhattan\.osm holds nothing in the bounds .* EPSG:32618, in which these bounds lie"
    with pytest.raises(ValueError, match=message):
        osm.read(extract, bounds=box("EPSG:32618"), crs=crs)


def test_another_city_is_told_where_the_file_lies(extract: Path) -> None:
    with pytest.raises(ValueError, match=r"it lies at longitude -73\.99\d+, latitude 40\.75"):
        osm.read(extract, bounds=box("EPSG:32618", -74.2, 40.9), crs="EPSG:32618")


@pytest.mark.parametrize("crs", ["EPSG:32618", "EPSG:26918"])
def test_bounds_in_degrees_are_refused_and_told_in_metres(extract: Path, crs: str) -> None:
    with pytest.raises(ValueError, match=rf"bounds must be in metres; .* in {crs} that is 5844"):
        osm.read(extract, bounds=(LON, LAT, LON + 0.01, LAT + 0.01), crs=crs)


@pytest.mark.parametrize("crs", ["EPSG:3857", "EPSG:3395", "EPSG:32630", "EPSG:4087"])
def test_a_crs_whose_metre_is_none_here_is_refused(extract: Path, crs: str) -> None:
    with pytest.raises(ValueError, match=r"crs: a metre on the ground is .*; use EPSG:32618"):
        osm.read(extract, bounds=box(crs), crs=crs)


@pytest.mark.parametrize("crs", ["EPSG:2263", "EPSG:4326", "EPSG:4979", "EPSG:5773", "nonsense"])
def test_a_crs_that_is_no_metric_map_is_refused(extract: Path, crs: str) -> None:
    with pytest.raises(ValueError, match="crs must be"):
        osm.read(extract, bounds=(0.0, 0.0, 100.0, 100.0), crs=crs)
