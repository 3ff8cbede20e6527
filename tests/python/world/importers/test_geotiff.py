# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""GeoTIFF rasters become a world the right way up, and damaged ones an error with their name."""

import importlib
import re
import tracemalloc
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.installed import pip_install
from ltp.world import LandClass
from ltp.world.importers import geotiff
from ltp.world.landable import landable_mask

rasterio = pytest.importorskip("rasterio")

NX, NY = 12, 9
Write = Callable[..., Path]


@pytest.fixture
def write(tmp_path: Path) -> Write:
    """Write an array in image order, its first row in the north unless south_up."""

    def write_raster(
        name: str,
        image: NDArray[Any],
        *,
        west: float = 1000.0,
        north: float = 2000.0,
        cell: float = 2.0,
        crs: str | None = "EPSG:32618",
        south_up: bool = False,
        transform: Any = None,
        **options: Any,
    ) -> Path:
        path = tmp_path / name
        rows, columns = image.shape[-2:]
        if transform is None:
            sign, start = (1.0, north - rows * cell) if south_up else (-1.0, north)
            transform = rasterio.Affine(cell, 0.0, west, 0.0, sign * cell, start)
        with rasterio.open(
            path,
            "w",
            driver="GTiff",
            width=columns,
            height=rows,
            count=1,
            dtype=image.dtype,
            crs=crs,
            transform=transform,
            **options,
        ) as dataset:
            dataset.write(image, 1)
        return path

    return write_raster


def _flat(height: float = 0.0) -> NDArray[np.float32]:
    return np.full((NY, NX), height, dtype=np.float32)


@pytest.mark.parametrize("south_up", [False, True])
def test_north_is_up_and_east_is_right(write: Write, south_up: bool) -> None:
    image = _flat()
    image[0, :] = 10.0  # first row
    image[:, -1] = 20.0  # last column
    dsm = write("dsm.tif", image, south_up=south_up)
    world = geotiff.read(dsm=dsm, dem=write("dem.tif", _flat(), south_up=south_up))
    row = 0 if south_up else -1
    assert world.shape == (NX, NY)
    assert (world.surface[:-1, row] == 10.0).all()
    assert (world.surface[-1, :] == 20.0).all()
    assert np.count_nonzero(world.surface) == NX + NY - 1
    assert (world.origin, world.cell) == ((0.0, 0.0), 2.0)
    assert (world.datum.crs, world.datum.easting) == ("EPSG:32618", 1000.0)
    assert world.datum.northing == 2000.0 - NY * 2.0
    assert world.name == "dsm"


def test_a_north_up_and_a_south_up_raster_of_one_place_agree(write: Write) -> None:
    heights = np.random.default_rng(0).random((NY, NX)).astype(np.float32)
    flat = write("dem.tif", _flat())
    north_up = geotiff.read(dsm=write("a.tif", heights), dem=flat)
    south_up = geotiff.read(dsm=write("b.tif", heights[::-1], south_up=True), dem=flat)
    assert np.array_equal(north_up.surface, south_up.surface)


def test_the_surface_is_the_higher_of_buildings_and_ground_plus_canopy(write: Write) -> None:
    dsm, canopy, codes = _flat(12.0), _flat(), np.full((NY, NX), 7, dtype=np.uint8)
    dsm[0, 0], codes[0, 0] = 30.0, 4  # a building
    dsm[0, 1], codes[0, 1], canopy[0, 1] = 30.0, 4, 25.0  # a tree over a building
    canopy[0, 2] = 8.0  # a tree
    canopy[0, 3] = 1.5  # a shrub
    dsm[0, 4] = 9.0  # a slip: the surface below the ground
    world = geotiff.read(
        dsm=write("dsm.tif", dsm),
        dem=write("dem.tif", _flat(12.0)),
        canopy=write("canopy.tif", canopy),
        classes=write("codes.tif", codes, nodata=255),
        class_table={4: "Building", 7: LandClass.GRASS},
    )
    north = world.surface[:5, -1]
    assert np.array_equal(north, [30.0, 37.0, 20.0, 13.5, 12.0])
    kinds = [LandClass(k) for k in world.classes[:5, -1]]
    grass, building = LandClass.GRASS, LandClass.BUILDING
    assert kinds == [building, building, LandClass.TREES, grass, grass]
    assert (world.ground == 12.0).all()


def test_without_classes_what_is_high_is_a_building(write: Write) -> None:
    dsm, canopy = _flat(), _flat()
    dsm[0, 0], dsm[0, 1], canopy[0, 2] = 5.0, 1.0, 6.0
    world = geotiff.read(
        dsm=write("dsm.tif", dsm), dem=write("dem.tif", _flat()), canopy=write("c.tif", canopy)
    )
    expected = [LandClass.BUILDING, LandClass.UNKNOWN, LandClass.TREES]
    assert list(world.classes[:3, -1]) == expected
    # Open ground may be water: nobody lands there, and the report says what to do.
    assert not landable_mask(world, "wide").any()
    assert any(
        "warning" in line and "--classes" in line and "UNKNOWN" in line for line in world.report
    )


@pytest.mark.parametrize("hole", [-9999.0, np.nan, -3.4028234663852886e38, 1e9])
@pytest.mark.parametrize("tagged", [True, False])
def test_holes_are_filled_and_unknown(write: Write, hole: float, tagged: bool) -> None:
    dem, dsm = _flat(), _flat()
    dem += np.arange(NX, dtype=np.float32)
    dsm += dem + 1.0
    dem[4, 5] = dsm[6, 7] = hole
    nodata = {"nodata": np.float32(hole)} if tagged else {}
    world = geotiff.read(
        dsm=write("dsm.tif", dsm, **nodata),
        dem=write("dem.tif", dem, **nodata),
        classes=write("codes.tif", np.ones((NY, NX), dtype=np.uint8)),
        class_table={1: "grass"},
    )
    assert world.ground[5, NY - 1 - 4] == pytest.approx(5.0)
    assert world.surface[7, NY - 1 - 6] == pytest.approx(8.0)
    unknown = np.argwhere(world.classes == LandClass.UNKNOWN)
    assert unknown.tolist() == [[5, NY - 1 - 4], [7, NY - 1 - 6]]


def test_missing_canopy_is_no_tree_and_missing_class_is_unknown(write: Write) -> None:
    canopy = _flat()
    canopy[0, 0] = -9999.0
    codes = np.ones((NY, NX), dtype=np.uint8)
    codes[0, 1] = 255
    world = geotiff.read(
        dsm=write("dsm.tif", _flat(3.0)),
        dem=write("dem.tif", _flat(3.0)),
        canopy=write("canopy.tif", canopy, nodata=-9999.0),
        classes=write("codes.tif", codes, nodata=255),
        class_table={1: 3},
    )
    assert (world.surface == 3.0).all()
    assert list(world.classes[:3, -1]) == [LandClass.PAVED, LandClass.UNKNOWN, LandClass.PAVED]


def test_a_coarser_world_keeps_the_tops(write: Write) -> None:
    dsm = np.random.default_rng(2).random((NY, NX)).astype(np.float32)
    files = {"dsm": write("dsm.tif", dsm), "dem": write("dem.tif", _flat())}
    fine, coarse = geotiff.read(**files), geotiff.read(**files, cell=6.0)
    assert (coarse.cell, coarse.shape) == (6.0, (NX // 3, NY // 3))
    tops = fine.surface.reshape(NX // 3, 3, NY // 3, 3).max(axis=(1, 3))
    assert np.array_equal(coarse.surface, tops)
    for cell in (3.0, 1.0, 0.0, -2.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="cell must be a multiple"):
            geotiff.read(**files, cell=cell)


@pytest.mark.parametrize(
    "change",
    [{"west": 1002.0}, {"north": 2000.5}, {"cell": 2.1}, {"crs": "EPSG:32617"}, {"crs": None}],
    ids=str,
)
def test_another_grid_is_named(write: Write, change: dict[str, Any]) -> None:
    dsm = write("dsm.tif", _flat())
    with pytest.raises(ValueError, match=r"odd\.tif lies on another grid than .*dsm\.tif"):
        geotiff.read(dsm=dsm, dem=write("odd.tif", _flat(), **change))


def test_another_size_is_named(write: Write) -> None:
    dsm = write("dsm.tif", _flat())
    with pytest.raises(ValueError, match=r"odd\.tif lies on another grid"):
        geotiff.read(dsm=dsm, dem=write("odd.tif", _flat()[:-1]))


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"crs": "EPSG:4326"}, "in degrees"),
        ({"crs": "EPSG:2263"}, "in metres, not .* foot"),
        ({"transform": rasterio.Affine(2, 0.5, 0, 0, -2, 0)}, "columns that go east"),
        ({"transform": rasterio.Affine(-2, 0, 0, 0, -2, 0)}, "columns that go east"),
        ({"transform": rasterio.Affine(2, 0, 0, 0, -3, 0)}, "square cells"),
    ],
    ids=lambda value: str(value)[:20],
)
def test_grids_that_are_not_metric_squares_are_refused(
    write: Write, change: dict[str, Any], message: str
) -> None:
    with pytest.raises(ValueError, match=rf"dsm\.tif.*{message}"):
        geotiff.read(dsm=write("dsm.tif", _flat(), **change), dem=write("dem.tif", _flat()))


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_a_raster_without_a_place_is_refused(write: Write) -> None:
    here = rasterio.Affine.identity()
    dsm = write("dsm.tif", _flat(), crs=None, transform=here)
    with pytest.raises(ValueError, match="no georeference"):
        geotiff.read(dsm=dsm, dem=dsm)


def test_a_code_without_a_meaning_is_refused(write: Write) -> None:
    codes = np.ones((NY, NX), dtype=np.uint8)
    codes[3, 3:5] = 6
    files = {"dsm": write("dsm.tif", _flat()), "dem": write("dem.tif", _flat())}
    with pytest.raises(ValueError, match=r"codes\.tif holds code 6 in 2 cells"):
        geotiff.read(**files, classes=write("codes.tif", codes), class_table={1: "paved"})
    with pytest.raises(ValueError, match="not 'lawn'"):
        geotiff.read(**files, classes=write("codes.tif", codes), class_table={1: "lawn"})
    with pytest.raises(ValueError, match="go together"):
        geotiff.read(**files, classes=write("codes.tif", codes))
    with pytest.raises(ValueError, match="go together"):
        geotiff.read(**files, class_table={1: "paved"})


def test_a_raster_without_any_height_is_refused(write: Write) -> None:
    dsm = write("dsm.tif", _flat())
    with pytest.raises(ValueError, match=r"dem\.tif holds no height"):
        geotiff.read(dsm=dsm, dem=write("dem.tif", _flat(-9999.0)))


@pytest.mark.filterwarnings("ignore::rasterio.errors.NotGeoreferencedWarning")
def test_a_vrt_in_disguise_is_refused(write: Write, tmp_path: Path) -> None:
    inner = write("inner.tif", _flat())
    disguised = tmp_path / "dsm.tif"
    disguised.write_text(
        f'<VRTDataset rasterXSize="{NX}" rasterYSize="{NY}"><VRTRasterBand dataType="Float32" '
        f'band="1"><SimpleSource><SourceFilename>{inner}</SourceFilename></SimpleSource>'
        "</VRTRasterBand></VRTDataset>"
    )
    with rasterio.open(disguised) as dataset:  # GDAL itself would follow it
        assert dataset.driver == "VRT"
    with pytest.raises(ValueError, match=r"dsm\.tif: not a TIFF file"):
        geotiff.read(dsm=disguised, dem=inner)


@pytest.mark.parametrize("name", ["/vsicurl/http://localhost:9/a.tif", "zip://a.zip!b.tif"])
def test_names_that_gdal_would_take_for_addresses_are_files(write: Write, name: str) -> None:
    with pytest.raises(FileNotFoundError):
        geotiff.read(dsm=name, dem=write("dem.tif", _flat()))


@pytest.mark.parametrize("layout", ["strips", "tiles", "big"])
def test_a_file_cut_anywhere_is_an_error_with_its_name(write: Write, layout: str) -> None:
    options: dict[str, Any] = {
        "strips": {},
        "tiles": {"tiled": True, "blockxsize": 16, "blockysize": 16, "compress": "deflate"},
        "big": {"BIGTIFF": "YES", "compress": "lzw"},
    }[layout]
    heights = np.random.default_rng(4).random((40, 50)).astype(np.float32)
    sound = write("dsm.tif", heights, nodata=-9999.0, **options)
    dem = write("dem.tif", np.zeros_like(heights))
    data = sound.read_bytes()
    geotiff.read(dsm=sound, dem=dem)
    cut = sound.with_name("cut.tif")
    lengths = np.random.default_rng(5).integers(0, len(data), 60)
    for length in (*lengths.tolist(), 0, 7, len(data) - 1):
        cut.write_bytes(data[:length])
        with pytest.raises(ValueError, match=r"cut\.tif"):
            geotiff.read(dsm=cut, dem=dem)


def test_damage_never_does_worse_than_an_error(write: Write) -> None:
    sound = write("dsm.tif", _flat(5.0), nodata=-9999.0, compress="deflate")
    dem = write("dem.tif", _flat())
    data = sound.read_bytes()
    damaged = sound.with_name("damaged.tif")
    rng = np.random.default_rng(6)
    refused = 0
    for _ in range(150):
        broken = bytearray(data)
        at = int(rng.integers(len(broken)))
        broken[at : at + 4] = rng.choice([b"\xff" * 4, b"\x7f\xff\xff\xff", b"\0" * 4])
        damaged.write_bytes(broken)
        try:
            geotiff.read(dsm=damaged, dem=dem)
        except ValueError as error:
            refused += 1
            assert "tif" in str(error)
    assert refused > 50


@pytest.mark.parametrize(("side", "message"), [(60_000, "more than"), (9_000, "do not hold")])
def test_a_header_that_promises_too_much_is_refused_before_reading(
    tmp_path: Path, side: int, message: str
) -> None:
    path = tmp_path / "huge.tif"
    with rasterio.open(
        path,
        "w",
        driver="GTiff",
        width=side,
        height=side,
        count=1,
        dtype="float32",
        crs="EPSG:32618",
        transform=rasterio.Affine(1, 0, 0, 0, -1, side),
        SPARSE_OK="TRUE",
        tiled=True,
        compress="deflate",
    ):
        pass
    assert path.stat().st_size < side * side / 1000
    tracemalloc.start()
    with pytest.raises(ValueError, match=rf"huge\.tif declares {side} x {side} cells.* {message}"):
        geotiff.read(dsm=path, dem=path)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 20_000_000


def test_a_missing_library_is_named_with_its_cure(
    write: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    dsm = write("dsm.tif", _flat())
    found = importlib.import_module

    def without_rasterio(name: str, package: str | None = None) -> Any:
        if name.startswith("rasterio"):
            raise ModuleNotFoundError(f"No module named {name!r}")
        return found(name, package)

    monkeypatch.setattr(importlib, "import_module", without_rasterio)
    with pytest.raises(
        ImportError, match=re.escape(f"reading GeoTIFF needs rasterio: {pip_install('geo')}")
    ):
        geotiff.read(dsm=dsm, dem=dsm)
