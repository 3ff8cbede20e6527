# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A priority map of one's own: read right, or refused by name."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp import Raster
from ltp.world import Datum, World, boxes, read_priority, save_priority

VALUES = np.random.default_rng(1).uniform(0.0, 1.0, (13, 11))


def field(datum: Datum | None = None) -> World:
    flat = np.zeros((26, 22))
    classes = np.ones(flat.shape, np.uint8)
    return World("field", flat, flat, classes, 1.0, (0.0, 0.0), datum or Datum())


def save(path: Path, **members: Any) -> Path:
    np.savez(path, **({"values": VALUES, "origin": [0.0, 0.0], "cell": 2.0} | members))
    return path


@pytest.mark.parametrize("compressed", [False, True])
@pytest.mark.parametrize("dtype", [np.float64, np.float32, np.uint8, np.int64, np.bool_])
@pytest.mark.parametrize("order", ["C", "F"])
def test_what_numpy_saves_is_read(compressed: bool, dtype: Any, order: Any, tmp_path: Path) -> None:
    values = (VALUES if np.dtype(dtype).kind == "f" else VALUES > 0.5).astype(dtype, order=order)
    write = np.savez_compressed if compressed else np.savez
    write(tmp_path / "p.npz", values=values, origin=(0, 0), cell=2)
    raster, report = read_priority(tmp_path / "p.npz", field())
    np.testing.assert_array_equal(raster.values, values.astype(np.float64))
    assert (tuple(raster.origin), raster.cell, raster.outside) == ((0.0, 0.0), 2.0, 0.0)
    assert report == ()


def test_what_is_saved_is_read_back(tmp_path: Path) -> None:
    own = Raster(VALUES, origin=(-3.0, 1.5), cell=2.5)
    save_priority(own, tmp_path / "p.npz")
    raster, report = read_priority(str(tmp_path / "p.npz"), field())
    np.testing.assert_array_equal(raster.values, own.values)
    assert (tuple(raster.origin), raster.cell) == ((-3.0, 1.5), 2.5)
    assert len(report) == 1 and "p.npz covers 93.2 % of field; elsewhere" in report[0]
    with pytest.raises(ValueError, match=r"path must end in \.npz"):
        save_priority(own, tmp_path / "p.tif")
    with pytest.raises(ValueError, match="raster must hold shares"):
        save_priority(Raster(3.0 * VALUES), tmp_path / "q.npz")


@pytest.mark.parametrize(
    ("members", "message"),
    [
        ({"values": VALUES * 255}, r"values must hold shares from 0 to 1, but \[0, 0\] is 130"),
        ({"values": VALUES - 0.5}, "values must hold shares from 0 to 1"),
        ({"values": np.where(VALUES > 0.9, np.nan, VALUES)}, "values must hold shares .* is nan"),
        ({"values": np.where(VALUES > 0.9, np.inf, VALUES)}, "values must hold shares .* is inf"),
        ({"values": VALUES[0]}, "values: unexpected shape"),
        ({"values": VALUES[None]}, "values: unexpected shape"),
        ({"values": VALUES[:0]}, "expected values of cells"),
        ({"values": VALUES.astype(complex)}, "values: expected dtype"),
        ({"values": np.array([[{}]])}, "values: expected dtype"),
        ({"values": VALUES.astype("U")}, "values: "),
        ({"cell": 0.0}, "cell 0.0"),
        ({"cell": -2.0}, "cell -2.0"),
        ({"cell": np.nan}, "cell nan"),
        ({"cell": [2.0, 3.0]}, "cell: unexpected shape"),
        ({"origin": [0.0, np.inf]}, "origin"),
        ({"origin": [0.0]}, r"origin: expected shape \(2\)"),
        (
            {"origin": [900.0, 0.0]},
            r"x = 900 ... 926 m.*nothing of field, which covers x = 0 ... 26",
        ),
        ({"origin": [26.0, 0.0]}, "nothing of field"),
        ({"more": VALUES}, "unexpected member 'more.npy'"),
    ],
)
def test_what_is_wrong_is_named(members: dict[str, Any], message: str, tmp_path: Path) -> None:
    path = save(tmp_path / "p.npz", **members)
    with pytest.raises(ValueError, match=rf"p\.npz.*{message}"):
        read_priority(path, field())


def test_other_files_are_refused_by_name(tmp_path: Path) -> None:
    for name in ("p.npy", "p.csv", "p", "p.png"):
        (tmp_path / name).write_bytes(b"\x93NUMPY")
        with pytest.raises(ValueError, match=rf"{name}: a priority map is a .tif, .tiff or .npz"):
            read_priority(tmp_path / name, field())
    with pytest.raises(OSError, match=r"missing\.npz"):
        read_priority(tmp_path / "missing.npz", field())
    boxes([], size=(26, 22)).save(tmp_path / "world.npz")
    with pytest.raises(ValueError, match=r"world\.npz is not a sound priority map: unexpected"):
        read_priority(tmp_path / "world.npz", field())


# --- GeoTIFF ---

UTM = Datum("EPSG:32618", 583950.0, 4511100.0)


def tiff(path: Path, image: NDArray[Any], crs: str | None = "EPSG:32618", **changes: Any) -> Path:
    """An image in rows from north to south, its south-west corner at that of UTM's world."""
    rasterio = pytest.importorskip("rasterio")
    west, south, cell = 583950.0, 4511100.0, changes.pop("cell", 2.0)
    west += changes.pop("east", 0.0)
    corner = rasterio.Affine(cell, 0.0, west, 0.0, -cell, south + image.shape[0] * cell)
    shape = {"height": image.shape[0], "width": image.shape[1], "count": 1}
    with rasterio.open(
        path, "w", driver="GTiff", dtype=image.dtype, crs=crs, transform=corner, **shape, **changes
    ) as dataset:
        dataset.write(image, 1)
    return path


@pytest.mark.parametrize("name", ["p.tif", "p.TIFF"])
def test_a_geotiff_lies_where_it_says_north_up(name: str, tmp_path: Path) -> None:
    image = np.zeros((11, 13), np.float32)
    image[0, :] = 1.0  # the northernmost row
    image[:, 0] = 0.5
    raster, report = read_priority(tiff(tmp_path / name, image), field(UTM))
    assert (
        raster.at(25.0, 21.0) == 1.0 and raster.at(1.0, 1.0) == 0.5 and raster.at(9.0, 9.0) == 0.0
    )
    assert (tuple(raster.origin), raster.cell, report) == ((0.0, 0.0), 2.0, ())
    moved, report = read_priority(tiff(tmp_path / name, image, east=4.0, cell=1.0), field(UTM))
    assert (tuple(moved.origin), moved.cell) == ((4.0, 0.0), 1.0)
    assert report == (f"{tmp_path / name} covers 25.0 % of field; elsewhere the priority is 0",)


def test_cells_without_data_count_nothing_and_are_told(tmp_path: Path) -> None:
    image = np.full((11, 13), 0.75, np.float32)
    image[3:5, 6] = -9999.0
    raster, report = read_priority(tiff(tmp_path / "p.tif", image, nodata=-9999.0), field(UTM))
    assert sorted(np.unique(raster.values)) == [0.0, 0.75]
    assert report == (f"{tmp_path / 'p.tif'}: 2 cells without data count 0",)
    with pytest.raises(ValueError, match=r"p\.tif: values must hold shares .* is -9999"):
        read_priority(tiff(tmp_path / "p.tif", image), field(UTM))


def test_one_crs_in_other_words_is_the_same(tmp_path: Path) -> None:
    pyproj = pytest.importorskip("pyproj")
    image = np.full((11, 13), 0.5, np.float32)
    for words in (pyproj.CRS("EPSG:32618").to_wkt(), "+proj=utm +zone=18 +datum=WGS84"):
        raster, _ = read_priority(tiff(tmp_path / "p.tif", image, words), field(UTM))
        assert raster.at(9.0, 9.0) == 0.5
    strange = Datum("LOCAL:1", UTM.easting, UTM.northing)
    with pytest.raises(ValueError, match=r"p\.tif is in EPSG:32618, field in LOCAL:1"):
        read_priority(tiff(tmp_path / "p.tif", image), field(strange))


def test_a_geotiff_elsewhere_is_refused_by_name(tmp_path: Path) -> None:
    image = np.ones((11, 13), np.uint8)
    with pytest.raises(ValueError, match=r"p\.tif is in EPSG:32617, field in EPSG:32618"):
        read_priority(tiff(tmp_path / "p.tif", image, "EPSG:32617"), field(UTM))
    with pytest.raises(ValueError, match=r"p\.tif is in EPSG:32618, field in no CRS"):
        read_priority(tiff(tmp_path / "p.tif", image), field())
    with pytest.raises(ValueError, match=r"p\.tif covers .* and so nothing of field"):
        read_priority(tiff(tmp_path / "p.tif", image, east=900.0), field(UTM))
    with pytest.raises(ValueError, match=r"p\.tif: values must hold shares"):
        read_priority(tiff(tmp_path / "p.tif", 255 * image), field(UTM))
    (tmp_path / "q.tif").write_bytes(b"II*\0" + bytes(40))
    with pytest.raises(ValueError, match=r"q\.tif"):
        read_priority(tmp_path / "q.tif", field(UTM))
