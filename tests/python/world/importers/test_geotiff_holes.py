# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a raster does not know is a hole: tagged, masked, or a fill value whose tag was lost.

And what only looks like one - lakes, the sea, flat roofs, terraces - stays as it is.
"""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.world import LandClass, World
from ltp.world.importers import geotiff
from ltp.world.landable import landable_mask

rasterio = pytest.importorskip("rasterio")

N = 40
Mask = NDArray[np.bool_]


def write(path: Path, image: NDArray[Any], **options: Any) -> Path:
    """Write an image whose first row lies in the north; axis 0 are bands if it has three."""
    bands = image if image.ndim == 3 else image[None]
    with rasterio.open(
        path,
        "w",
        driver="GTiff",
        count=len(bands),
        height=bands.shape[1],
        width=bands.shape[2],
        dtype=image.dtype,
        crs="EPSG:32618",
        transform=rasterio.Affine(1.0, 0, 5e5, 0, -1.0, 4_600_040),
        **options,
    ) as dataset:
        dataset.write(bands)
    return path


def read(
    folder: Path, dsm: NDArray[Any], dem: NDArray[Any], lawn: bool = True, **more: Any
) -> World:
    """The world of two arrays in image order, all of it a lawn if the ground should be landable."""
    if lawn:
        lawns = np.ones(dsm.shape, dtype=np.uint8)
        more |= {"classes": write(folder / "c.tif", lawns), "class_table": {1: "grass"}}
    return geotiff.read(
        dsm=write(folder / "dsm.tif", dsm), dem=write(folder / "dem.tif", dem), **more
    )


def turned(image: NDArray[Any]) -> NDArray[Any]:
    """From image order to [x, y]."""
    return image[::-1].T


def rolling(height: float = 10.0, relief: float = 3.0) -> NDArray[np.float32]:
    """Land in waves around a height."""
    y, x = np.mgrid[:N, :N]
    waves = np.sin(x / 6.0) * np.cos(y / 9.0)
    return (height + relief * waves).astype(np.float32)


def _block(where: tuple[slice, slice]) -> Mask:
    mask = np.zeros((N, N), dtype=bool)
    mask[where] = True
    return mask


def _disc() -> Mask:
    y, x = np.mgrid[:N, :N]
    return np.asarray((x - 18) ** 2 + (y - 21) ** 2 < 60)


def _speckle() -> Mask:
    return np.asarray(np.random.default_rng(3).random((N, N)) < 0.08)


SHAPES: dict[str, Mask] = {
    "square": _block(np.s_[22:34, 2:14]),
    "small": _block(np.s_[20:22, 20:22]),
    "line": _block(np.s_[5, 4:30]),
    "corner": _block(np.s_[:9, :7]),
    "strip on the rim": _block(np.s_[:, 34:]),
    "disc": _disc(),
    "ring": _block(np.s_[8:30, 8:30]) & ~_block(np.s_[12:26, 12:26]),
    "two": _block(np.s_[2:8, 2:8]) | _block(np.s_[30:36, 20:33]),
    "speckle": _speckle(),
    "most of it": ~_block(np.s_[10:30, 14:30]),
}
FILLS = (-9999.0, -32768.0, -32767.0, -999.0, -99.0, 9999.0, 999.0, 8888.0, 99999.0, 3.4e38, -1e20)


def assert_hole(world: World, hole: Mask, land: NDArray[Any], slack: float = 4.0) -> None:
    """The hole is unknown and at the height of the land; what is around it is as it was."""
    there = turned(hole)
    assert (world.classes[there] == LandClass.UNKNOWN).all()
    assert not landable_mask(world, "wide")[there].any()
    assert (world.classes[~there] == LandClass.GRASS).all()
    for heights in (world.ground, world.surface):
        np.testing.assert_allclose(heights[~there], turned(land)[~there], rtol=1e-6)
        np.testing.assert_allclose(heights[there], turned(land)[there], atol=slack)
    assert any("taken for holes" in line for line in world.report)
    n = f"{np.count_nonzero(hole):,} of {hole.size:,} cells"
    assert any(n in line for line in world.report), world.report


@pytest.mark.parametrize("in_files", ["both", "dsm", "dem"])
@pytest.mark.parametrize("fill", FILLS)
def test_a_fill_value_without_its_tag_is_a_hole(tmp_path: Path, fill: float, in_files: str) -> None:
    land, hole = rolling(), SHAPES["square"]
    holed = np.where(hole, np.float32(fill), land).astype(np.float32)
    dsm, dem = (holed if in_files in (name, "both") else land for name in ("dsm", "dem"))
    assert_hole(read(tmp_path, dsm, dem), hole, land)


@pytest.mark.parametrize("fill", [-999.0, 999.0, -9999.0])
@pytest.mark.parametrize("shape", SHAPES)
def test_whatever_the_shape_of_the_hole(tmp_path: Path, shape: str, fill: float) -> None:
    land, hole = rolling(), SHAPES[shape]
    holed = np.where(hole, np.float32(fill), land).astype(np.float32)
    assert_hole(read(tmp_path, holed, holed), hole, land, slack=6.5)


@pytest.mark.parametrize(
    ("height", "fill"), [(600, -99), (2500, 999), (300, 0), (150, -1), (0, -50)]
)
def test_the_jump_counts_not_the_number(tmp_path: Path, height: float, fill: float) -> None:
    land, hole = rolling(height), SHAPES["square"]
    holed = np.where(hole, np.float32(fill), land).astype(np.float32)
    assert_hole(read(tmp_path, holed, holed), hole, land)


@pytest.mark.parametrize("height", [10.0, 40.0])
def test_a_fill_value_that_nobody_has_heard_of(tmp_path: Path, height: float) -> None:
    land, hole = rolling(height), SHAPES["disc"]
    for fill in (-123.0, -321.5, 1234.5, 5000.0, 7777.0):
        holed = np.where(hole, np.float32(fill), land).astype(np.float32)
        assert_hole(read(tmp_path, holed, holed), hole, land)


@pytest.mark.parametrize(
    ("dtype", "fill"),
    [
        ("int16", -9999),
        ("int16", -32768),
        ("int16", -999),
        ("int16", 32767),
        ("int16", 9999),
        ("uint16", 65535),
        ("uint16", 9999),
        ("uint16", 999),
        ("uint8", 255),
        ("int32", -99999),
        ("int32", 2**31 - 1),
        ("float64", -9999.9),
    ],
)
def test_whole_metres_have_holes_as_well(tmp_path: Path, dtype: str, fill: float) -> None:
    land = np.round(rolling(30.0, 8.0)).astype(dtype)
    hole = SHAPES["two"]
    holed = np.where(hole, np.array(fill, dtype=dtype), land)
    assert_hole(read(tmp_path, holed, holed), hole, land, slack=8.0)


def test_a_stored_code_is_one_whatever_its_scale(tmp_path: Path) -> None:
    land, hole = np.round(rolling(10.0) * 100.0).astype(np.int16), SHAPES["square"]
    holed = np.where(hole, np.int16(32767), land).astype(np.int16)  # 327.67 m
    paths = []
    for name in ("dsm", "dem"):
        paths.append(write(tmp_path / f"{name}.tif", holed))
        with rasterio.open(paths[-1], "r+") as dataset:
            dataset.scales = (0.01,)
    lawn = write(tmp_path / "c.tif", np.ones((N, N), dtype=np.uint8))
    world = geotiff.read(dsm=paths[0], dem=paths[1], classes=lawn, class_table={1: "grass"})
    assert_hole(world, hole, land * 0.01)


@pytest.mark.parametrize("scale", [0.0, float("nan"), float("inf")])
def test_a_scale_that_flattens_everything_is_refused(tmp_path: Path, scale: float) -> None:
    paths = [write(tmp_path / f"{name}.tif", rolling()) for name in ("dsm", "dem")]
    with rasterio.open(paths[0], "r+") as dataset:
        dataset.scales = (scale,)
    with pytest.raises(ValueError, match=r"dsm\.tif must have a scale other than"):
        geotiff.read(dsm=paths[0], dem=paths[1])


def test_several_fills_side_by_side(tmp_path: Path) -> None:
    land = rolling()
    holed, hole = land.copy(), np.zeros((N, N), dtype=bool)
    for k, fill in enumerate((-999.0, 9999.0, -99.0, 999.0, -32768.0, -200.0)):
        where = np.s_[10:20, 2 + 5 * k : 7 + 5 * k]  # each touches the next
        holed[where], hole[where] = fill, True
    assert_hole(read(tmp_path, holed, holed), hole, land)
    other = np.where(SHAPES["corner"], np.float32(999.0), land).astype(np.float32)
    world = read(tmp_path, other, holed)
    assert_hole(world, hole | SHAPES["corner"], land)


def test_cells_mixed_with_the_fill_by_resampling_go_with_it(tmp_path: Path) -> None:
    land, hole = rolling(), SHAPES["square"]
    holed = np.where(hole, np.float32(-999.0), land)
    rows = holed.copy()
    rows[1:] = 0.5 * (holed[1:] + holed[:-1])
    columns = rows.copy()
    columns[:, 1:] = 0.5 * (rows[:, 1:] + rows[:, :-1])
    mixed = columns.astype(np.float32)
    world = read(tmp_path, mixed, mixed)
    assert world.ground.min() > 6.5
    around = turned(np.abs(mixed - land) > 8.0)
    assert (world.classes[around] == LandClass.UNKNOWN).all()
    assert not landable_mask(world, "wide")[around].any()


def _lake() -> NDArray[np.float32]:
    land = rolling(300.0, 40.0)
    return np.maximum(land, np.float32(280.0))  # a shore where the land meets the water


def _harbour() -> NDArray[np.float32]:
    land = rolling(8.0, 2.0)
    land[15:30, 10:35] = 0.0  # quays of 6 to 10 m all around
    return land


def _sea() -> NDArray[np.float32]:
    y, x = np.mgrid[:N, :N]
    return np.maximum(0.0, 4.0 * (x - 25.0) + np.sin(y / 4.0)).astype(np.float32)


def _cliff() -> NDArray[np.float32]:
    land = rolling(90.0, 5.0)
    land[:, :25] = 0.0
    land[:, 25:27] = np.float32(1.5)  # the beach below
    return land


def _terraces(step: float = 25.0) -> NDArray[np.float32]:
    y, _ = np.mgrid[:N, :N]
    return (step * (y // 8)).astype(np.float32)


def _polder() -> NDArray[np.float32]:
    land = np.full((N, N), -4.0, dtype=np.float32)
    land[:, 18:22] = 3.0  # a dyke
    return land


def _dead_sea() -> NDArray[np.float32]:
    y, _ = np.mgrid[:N, :N]
    return np.maximum(-429.0, -435.0 + 2.0 * y).astype(np.float32)


def _quarry() -> NDArray[np.float32]:
    land = rolling(120.0, 4.0)
    land[10:25, 10:25] = 92.0  # a flat floor between walls of some 25 m
    return land


KEPT: dict[str, Callable[[], NDArray[np.float32]]] = {
    "a lake": _lake,
    "a harbour": _harbour,
    "the sea": _sea,
    "the sea below a cliff": _cliff,
    "terraces": _terraces,
    "a polder": _polder,
    "the shore of the Dead Sea": _dead_sea,
    "a quarry": _quarry,
    "a plain": lambda: np.full((N, N), 999.0, dtype=np.float32),
    "a plain at zero": lambda: np.zeros((N, N), dtype=np.float32),
    "whole metres": lambda: np.round(rolling(50.0, 30.0)),
    "mountains": lambda: np.round(rolling(3000.0, 900.0)),
}


@pytest.mark.parametrize("name", KEPT)
@pytest.mark.parametrize("dtype", ["float32", "int16"])
def test_flat_land_and_water_are_no_holes(tmp_path: Path, name: str, dtype: str) -> None:
    land = KEPT[name]().astype(dtype)
    world = read(tmp_path, land, land)
    np.testing.assert_array_equal(world.ground, turned(land))
    np.testing.assert_array_equal(world.surface, turned(land))
    assert (world.classes == LandClass.GRASS).all()
    assert not any("hole" in line for line in world.report), world.report


@pytest.mark.parametrize("roof", [16.0, 55.0, 128.0, 256.0, 333.0, 400.0, 820.0])
def test_flat_roofs_are_no_holes_and_courtyards_neither(tmp_path: Path, roof: float) -> None:
    for ground in (rolling(), np.full((N, N), 10.0, dtype=np.float32)):
        dsm = ground.copy()
        dsm[8:30, 8:30] = roof
        dsm[14:22, 14:22] = ground[14:22, 14:22]
        world = read(tmp_path, dsm, ground)
        np.testing.assert_array_equal(world.surface, turned(dsm))
        np.testing.assert_array_equal(world.ground, turned(ground))
        assert (world.classes == LandClass.GRASS).all()


def test_a_roof_at_a_fill_value_stays_an_obstacle(tmp_path: Path) -> None:
    land = rolling(600.0)
    dsm = np.where(SHAPES["square"], np.float32(999.0), land).astype(np.float32)
    world = read(tmp_path, dsm, land)
    there = turned(SHAPES["square"])
    assert (world.surface[there] == 999.0).all()
    assert (world.classes[there] == LandClass.UNKNOWN).all()
    assert any("holes or towers" in line for line in world.report)


def test_a_tower_in_the_model_of_the_ground_stays_an_obstacle(tmp_path: Path) -> None:
    dsm = np.where(SHAPES["square"], np.float32(312.0), rolling()).astype(np.float32)
    world = read(tmp_path, dsm, dsm)  # somebody who has no other model
    there = turned(SHAPES["square"])
    assert (world.surface[there] == 312.0).all()
    assert (world.classes[there] == LandClass.UNKNOWN).all()
    assert any("nobody knows" in line for line in world.report)


def test_a_surface_far_below_the_ground_is_a_hole(tmp_path: Path) -> None:
    land = rolling(30.0)
    for value in (0.0, 12.0):
        dsm = np.where(SHAPES["disc"], np.float32(value), land).astype(np.float32)
        assert_hole(read(tmp_path, dsm, land), SHAPES["disc"], land)


@pytest.mark.parametrize("n", [1, 2, 5, 10])
def test_a_coarse_cell_with_a_hole_in_it_is_unknown(tmp_path: Path, n: int) -> None:
    hole = _block(np.s_[20, 20]) | _block(np.s_[3:5, 7:9])
    land = rolling()
    holed = np.where(hole, np.float32(-9999.0), land).astype(np.float32)
    world = read(tmp_path, holed, holed, cell=float(n))
    blocks = turned(hole).reshape(N // n, n, N // n, n).any(axis=(1, 3))
    assert ((world.classes == LandClass.UNKNOWN) == blocks).all()


@pytest.mark.parametrize("value", [-9999.0, 9999.0, -999.0, 255.0, 3.4e38])
def test_a_lost_hole_in_the_canopy_is_no_lawn(tmp_path: Path, value: float) -> None:
    crowns = np.where(SHAPES["square"], np.float32(value), np.float32(0.0)).astype(np.float32)
    world = read(tmp_path, rolling(), rolling(), canopy=write(tmp_path / "trees.tif", crowns))
    there = turned(SHAPES["square"])
    assert (world.classes[there] == LandClass.UNKNOWN).all()
    assert (world.classes[~there] == LandClass.GRASS).all()
    np.testing.assert_allclose(world.surface, turned(rolling()))
    assert any("trees.tif" in line and "144 cells" in line for line in world.report)


def test_a_class_of_many_codes_is_one_sentence(tmp_path: Path) -> None:
    codes = np.arange(N * N, dtype=np.uint16).reshape(N, N)
    classes = write(tmp_path / "codes.tif", codes)
    table = {code: "water" if code < 2 else "grass" for code in range(N * N)}
    world = read(tmp_path, rolling(), rolling(), lawn=False, classes=classes, class_table=table)
    assert "codes.tif: codes 0, 1 are WATER: 2 cells" in world.report
    assert "codes.tif: codes 2, 3, 4, 5, 6, 7, 8, 9, ... are GRASS: 1,598 cells" in world.report
    world.save(tmp_path / "w.npz")
    assert World.load(tmp_path / "w.npz").report == world.report


def test_tagged_holes_are_counted(tmp_path: Path) -> None:
    image = rolling()
    image[3, 4:9] = -9999.0
    image[20, 20] = np.nan
    paths = [write(tmp_path / f"{name}.tif", image, nodata=-9999.0) for name in ("a", "b", "c")]
    world = geotiff.read(dsm=paths[0], dem=paths[1], canopy=paths[2])
    why = "6 cells hold no value (no-data tag, mask or NaN)"
    for line in (f"a.tif: {why}: holes", f"b.tif: {why}: holes", f"c.tif: {why}: no tree there"):
        assert line in world.report
    assert any("6 of 1,600 cells" in line for line in world.report)


def test_cells_without_a_code_are_counted(tmp_path: Path) -> None:
    codes = np.where(SHAPES["square"], 255, 1).astype(np.uint8)
    classes = write(tmp_path / "codes.tif", codes, nodata=255)
    flat = rolling()
    world = read(tmp_path, flat, flat, lawn=False, classes=classes, class_table={1: "grass"})
    assert "codes.tif: 144 cells without a code are UNKNOWN" in world.report
    assert "codes.tif: code 1 is GRASS: 1,456 cells" in world.report


def _internal(path: Path, image: NDArray[Any], valid: NDArray[np.uint8]) -> None:
    with rasterio.Env(GDAL_TIFF_INTERNAL_MASK="YES"):
        write(path, image)
        with rasterio.open(path, "r+") as dataset:
            dataset.write_mask(valid)


def _external(path: Path, image: NDArray[Any], valid: NDArray[np.uint8]) -> None:
    write(path, image)
    with rasterio.Env(GDAL_TIFF_INTERNAL_MASK="NO"), rasterio.open(path, "r+") as dataset:
        dataset.write_mask(valid)
    assert path.with_name(path.name + ".msk").is_file()


def _alpha(path: Path, image: NDArray[Any], valid: NDArray[np.uint8]) -> None:
    write(path, np.stack([image, valid.astype(image.dtype)]), alpha="YES")


def _both(path: Path, image: NDArray[Any], valid: NDArray[np.uint8]) -> None:
    """Half of the hole in a mask, half of it under the no-data tag, which the mask hides."""
    half = valid.copy()
    half[:26] = 255
    tagged = image.copy()
    tagged[:26][valid[:26] == 0] = 77
    with rasterio.Env(GDAL_TIFF_INTERNAL_MASK="YES"):
        write(path, tagged, nodata=77)
        with rasterio.open(path, "r+") as dataset:
            dataset.write_mask(half)


@pytest.mark.parametrize("in_files", ["dsm", "dem", "both"])
@pytest.mark.parametrize("dtype", ["float32", "int16", "uint8"])
@pytest.mark.parametrize("way", [_internal, _external, _alpha, _both])
def test_masks_are_read(tmp_path: Path, way: Any, dtype: str, in_files: str) -> None:
    land, hole = np.round(rolling()).astype(dtype), SHAPES["square"]
    lie = np.where(hole, np.array(14, dtype=dtype), land)  # below a mask stands anything
    valid = np.where(hole, 0, 255).astype(np.uint8)
    paths = {}
    for name in ("dsm", "dem"):
        paths[name] = tmp_path / f"{name}.tif"
        if in_files in (name, "both"):
            way(paths[name], lie, valid)
        else:
            write(paths[name], land)
    lawn = write(tmp_path / "c.tif", np.ones((N, N), dtype=np.uint8))
    world = geotiff.read(**paths, classes=lawn, class_table={1: "grass"})
    there = turned(hole)
    assert (world.classes[there] == LandClass.UNKNOWN).all()
    assert (world.classes[~there] == LandClass.GRASS).all()
    np.testing.assert_allclose(world.surface[there], turned(land)[there], atol=4.0)
    assert any("144 of 1,600 cells" in line for line in world.report)
    if way is not _both:
        assert any(word in line for line in world.report for word in ("mask", "alpha"))


def test_a_mask_of_another_raster_is_refused(tmp_path: Path) -> None:
    flat = rolling()
    dsm = write(tmp_path / "dsm.tif", flat)
    beside = tmp_path / "dsm.tif.msk"
    write(beside, np.zeros((N // 2, N), dtype=np.uint8))
    with pytest.raises(ValueError, match=r"dsm\.tif\.msk masks 40 x 20 cells, expected 40 x 40"):
        geotiff.read(dsm=dsm, dem=dsm)
    for damage in (b"no TIFF at all", b"", beside.read_bytes()[:200]):
        beside.write_bytes(damage)
        with pytest.raises(ValueError, match=r"dsm\.tif\.msk"):
            geotiff.read(dsm=dsm, dem=dsm)


def test_a_no_data_value_in_a_side_file_is_mentioned(tmp_path: Path) -> None:
    flat = rolling()
    dsm = write(tmp_path / "dsm.tif", flat)
    (tmp_path / "dsm.tif.aux.xml").write_text(
        '<PAMDataset><PAMRasterBand band="1"><NoDataValue>12</NoDataValue></PAMRasterBand>'
        "</PAMDataset>"
    )
    world = geotiff.read(dsm=dsm, dem=dsm)
    assert any("dsm.tif.aux.xml" in line for line in world.report)


def test_two_bands_that_are_no_alpha_are_refused(tmp_path: Path) -> None:
    dsm = write(tmp_path / "dsm.tif", np.stack([rolling(), rolling()]))
    with pytest.raises(ValueError, match=r"dsm\.tif must have one band, it has 2"):
        geotiff.read(dsm=dsm, dem=dsm)


def test_without_a_lost_tag_nothing_is_said_of_holes(tmp_path: Path) -> None:
    world = read(tmp_path, rolling(), rolling())
    assert not any("hole" in line for line in world.report)
