# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Classified laser surveys become a world; what their classes mean, and damage to the file."""

import importlib
import re
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.installed import pip_install
from ltp.world import LandClass, World
from ltp.world.importers import las

laspy = pytest.importorskip("laspy")
pyproj = pytest.importorskip("pyproj")

WEST, SOUTH = 292000.0, 6832000.0
Returns = list[tuple[float, float, float, int]]  # x, y, z from the south-west corner, class


def write_cloud(
    path: Path,
    returns: Returns,
    *,
    point_format: int = 6,
    crs: str | None = "EPSG:2154",
    withheld: NDArray[np.bool_] | None = None,
    extra: bool = False,
) -> Path:
    header = laspy.LasHeader(
        point_format=point_format, version="1.4" if point_format >= 6 else "1.2"
    )
    header.scales, header.offsets = [0.001] * 3, [WEST, SOUTH, 0.0]
    if crs is not None:
        header.add_crs(pyproj.CRS(crs))
    if extra:
        header.add_extra_dim(laspy.ExtraBytesParams("confidence", np.float32))
    cloud = laspy.LasData(header)
    x, y, z, kind = (np.array(column) for column in zip(*returns, strict=True))
    cloud.x, cloud.y, cloud.z, cloud.classification = WEST + x, SOUTH + y, z, kind.astype(np.uint8)
    if withheld is not None:
        cloud.withheld = withheld
    cloud.write(path)
    return path


def field(n: int = 12, height: float = 40.0, kind: int = 2) -> Returns:
    """One return in the middle of every 2 m cell of n x n."""
    return [(2.0 * i + 1, 2.0 * j + 1, height, kind) for i in range(n) for j in range(n)]


def random_cloud(n: int = 500) -> Returns:
    rng = np.random.default_rng(7)
    x, y = rng.uniform(0.0, 30.0, (2, n))
    kind = rng.choice([1, 2, 2, 2, 5, 6], n)
    z = 40.0 + np.where(np.isin(kind, (5, 6)), 8.0, 0.0) + rng.random(n)
    return list(zip(x.tolist(), y.tolist(), z.tolist(), kind.tolist(), strict=True))


def cell_at(world: World, x: float, y: float) -> tuple[float, float, LandClass]:
    at = int(x // world.cell), int(y // world.cell)
    ground, surface = world.ground[at].round(6), world.surface[at].round(6)
    return ground, surface, LandClass(world.classes[at])


@pytest.mark.parametrize(("name", "point_format"), [("a.las", 6), ("a.laz", 6), ("b.laz", 1)])
def test_east_is_the_first_axis_and_north_the_second(
    tmp_path: Path, name: str, point_format: int
) -> None:
    returns = [*field(), (21.0, 3.0, 52.0, 6)]
    world = las.read(write_cloud(tmp_path / name, returns, point_format=point_format))
    assert world.shape == (12, 12)
    assert np.argwhere(world.surface > 45.0).tolist() == [[10, 1]]
    assert cell_at(world, 21.0, 3.0) == (40.0, 52.0, LandClass.BUILDING)
    assert (world.origin, world.cell) == ((0.0, 0.0), 2.0)
    assert (world.datum.easting, world.datum.northing) == (WEST, SOUTH)
    assert world.datum.crs == "EPSG:2154"


def test_what_the_classes_mean(tmp_path: Path) -> None:
    tops = {
        1: (46.0, LandClass.UNKNOWN),  # a wire, a lorry
        3: (40.3, LandClass.GROUND),  # a low plant
        5: (55.0, LandClass.TREES),
        6: (60.0, LandClass.BUILDING),
        17: (47.0, LandClass.BUILDING),  # a bridge
        64: (51.0, LandClass.BUILDING),  # permanent, above ground
        19: (44.0, LandClass.UNKNOWN),  # overhead structure
        200: (44.0, LandClass.UNKNOWN),  # nobody knows: an obstacle
    }
    dropped = (7, 18, 65, 66, 67, 12)
    returns = field()
    for index, (kind, (top, _)) in enumerate(tops.items()):
        returns.append((2.0 * index + 1, 5.0, top, kind))
    for index, kind in enumerate(dropped):
        returns.append((2.0 * index + 1, 9.0, 90.0, kind))
    returns.append((1.0, 13.0, 40.3, 1))  # too low to be an obstacle
    returns.append((3.0, 13.0, 41.2, 1))  # a car
    world = las.read(write_cloud(tmp_path / "a.laz", returns))
    for index, (kind, (top, land)) in enumerate(tops.items()):
        assert cell_at(world, 2.0 * index + 1, 5.0) == (40.0, top, land), f"class {kind}"
    for index, kind in enumerate(dropped):
        expected = (40.0, 40.0, LandClass.GROUND)
        assert cell_at(world, 2.0 * index + 1, 9.0) == expected, f"class {kind}"
    assert cell_at(world, 1.0, 13.0) == (40.0, 40.0, LandClass.GROUND)
    assert cell_at(world, 3.0, 13.0) == (40.0, 41.2, LandClass.UNKNOWN)


@pytest.mark.parametrize(
    ("kind", "land"), [(9, LandClass.WATER), (10, LandClass.RAIL), (11, LandClass.ROAD)]
)
def test_kinds_of_ground_that_the_survey_knows(tmp_path: Path, kind: int, land: LandClass) -> None:
    returns = [*field(), (5.0, 5.0, 40.0, kind)]
    world = las.read(write_cloud(tmp_path / "a.las", returns))
    assert np.argwhere(world.classes == land).tolist() == [[2, 2]]


def test_a_withheld_return_is_not_there_and_an_absurd_height_is_noise(tmp_path: Path) -> None:
    returns = [*field(), (5.0, 5.0, 80.0, 6), (7.0, 7.0, 50_000.0, 6)]
    withheld = np.arange(len(returns)) == len(returns) - 2
    world = las.read(write_cloud(tmp_path / "a.las", returns, withheld=withheld))
    np.testing.assert_allclose(world.surface, 40.0)


def test_the_ground_is_the_mean_of_its_returns_and_goes_on_under_a_building(
    tmp_path: Path,
) -> None:
    def slope(x: float) -> float:
        return 40.0 + 0.1 * x

    returns = []
    for x, y, _, _ in field(20):
        roof = 10.0 < x < 30.0 and 10.0 < y < 30.0
        if roof:
            returns.append((x, y, 60.0, 6))
        else:
            returns += [(x - 0.5, y, slope(x) - 0.2, 2), (x + 0.5, y, slope(x) + 0.2, 2)]
    world = las.read(write_cloud(tmp_path / "a.laz", returns))
    middle_of_cell = 1.0 + 2.0 * np.arange(20)[:, None]
    np.testing.assert_allclose(world.ground, slope(np.tile(middle_of_cell, 20)), atol=2e-3)
    assert np.count_nonzero(world.classes == LandClass.BUILDING) == 100


def test_a_thinned_roof_has_no_holes(tmp_path: Path) -> None:
    rng = np.random.default_rng(11)
    returns = [
        (x, y, 52.0, 6) if 8.0 < x < 32.0 and 8.0 < y < 32.0 else (x, y, z, kind)
        for x, y, z, kind in field(20)
        if rng.random() > 0.36
    ]
    world = las.read(write_cloud(tmp_path / "a.laz", returns))
    inside = np.s_[5:15, 5:15]  # but for the outermost ring, where a wall may shift by a cell
    assert (world.classes[inside] == LandClass.BUILDING).all()
    np.testing.assert_allclose(world.surface[inside], 52.0)
    outside = np.ones((20, 20), dtype=bool)
    outside[3:17, 3:17] = False
    assert (world.classes[outside] == LandClass.GROUND).all()


def test_a_wide_gap_is_unknown_and_nothing_stands_on_it(tmp_path: Path) -> None:
    gap = [r for r in field(20) if not (10.0 < r[0] < 24.0 and 10.0 < r[1] < 24.0)]
    path = write_cloud(tmp_path / "a.laz", gap)
    world = las.read(path)
    unknown = world.classes == LandClass.UNKNOWN
    assert unknown[6:11, 6:11].all()
    assert not unknown[:5].any()
    assert not unknown[:, 12:].any()
    np.testing.assert_allclose(world.surface, 40.0)
    assert (las.read(path, max_gap=16.0).classes == LandClass.GROUND).all()


def test_bounds_cut_a_piece_out(tmp_path: Path) -> None:
    returns = [*field(), (9.0, 7.0, 55.0, 6)]
    path = write_cloud(tmp_path / "a.laz", returns)
    piece = las.read(path, bounds=(WEST + 4, SOUTH + 6, WEST + 14, SOUTH + 12))
    whole = las.read(path)
    assert piece.shape == (5, 3)
    assert np.array_equal(piece.surface, whole.surface[2:7, 3:6])
    assert (piece.datum.easting, piece.datum.northing) == (WEST + 4, SOUTH + 6)
    with pytest.raises(ValueError, match=r"lie outside of .*, which covers"):
        las.read(path, bounds=(0.0, 0.0, 10.0, 10.0))
    for bounds in ((5.0, 5.0, 5.0, 9.0), (9.0, 9.0, 1.0, 1.0), (np.nan, 0.0, 1.0, 1.0)):
        with pytest.raises(ValueError, match="bounds must"):
            las.read(path, bounds=bounds)
    with pytest.raises(ValueError, match="bounds needs"):
        las.read(path, bounds=(0.0, 0.0, 1e6, 1e6))


def test_the_cell_size_is_a_choice(tmp_path: Path) -> None:
    path = write_cloud(tmp_path / "a.laz", random_cloud())
    world = las.read(path, cell=5.0)
    assert (world.cell, world.shape) == (5.0, (6, 6))
    for cell in (0.0, -1.0, np.nan, np.inf):
        with pytest.raises(ValueError, match="cell must be above zero"):
            las.read(path, cell=cell)
    with pytest.raises(ValueError, match=r"needs .* cells"):
        las.read(path, cell=1e-4)


def test_the_crs_must_be_metric_and_may_be_given(tmp_path: Path) -> None:
    without = write_cloud(tmp_path / "a.las", field(), crs=None)
    assert las.read(without).datum.crs is None
    assert las.read(without, crs="EPSG:32630").datum.crs == "EPSG:32630"
    with pytest.raises(ValueError, match="projected CRS in metres"):
        las.read(without, crs="EPSG:4326")
    with pytest.raises(ValueError, match="known CRS"):
        las.read(without, crs="EPSG:0")
    feet = write_cloud(tmp_path / "feet.las", field(), crs="EPSG:2263")
    with pytest.raises(ValueError, match=r"CRS of .*feet\.las must be"):
        las.read(feet)


def test_a_survey_without_ground_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"a\.las has no ground return"):
        las.read(write_cloud(tmp_path / "a.las", field(kind=6)))


@pytest.mark.parametrize(
    ("name", "point_format", "extra"),
    [("a.las", 6, False), ("a.laz", 6, False), ("a.laz", 7, True), ("a.laz", 3, False)],
)
def test_a_file_cut_anywhere_is_an_error_with_its_name(
    tmp_path: Path, name: str, point_format: int, extra: bool
) -> None:
    sound = write_cloud(tmp_path / name, random_cloud(), point_format=point_format, extra=extra)
    data = sound.read_bytes()
    las.read(sound)
    cut = tmp_path / f"cut{sound.suffix}"
    lengths = np.random.default_rng(8).integers(0, len(data), 60)
    for length in (*lengths.tolist(), 0, 3, len(data) - 1):
        cut.write_bytes(data[:length])
        with pytest.raises(ValueError, match=r"cut\.la"):
            las.read(cut)


@pytest.mark.parametrize(("name", "point_format"), [("a.las", 6), ("a.laz", 6), ("a.laz", 3)])
def test_damage_never_does_worse_than_an_error(
    tmp_path: Path, name: str, point_format: int
) -> None:
    data = write_cloud(tmp_path / name, random_cloud(), point_format=point_format).read_bytes()
    damaged = tmp_path / f"damaged{Path(name).suffix}"
    rng = np.random.default_rng(9)
    refused = 0
    for _ in range(100):
        broken = bytearray(data)
        at = int(rng.integers(min(len(broken) - 8, 2000)))
        broken[at : at + 4] = rng.choice([b"\xff" * 4, b"\xff\xff\xff\x7f", b"\0" * 4])
        damaged.write_bytes(broken)
        try:
            las.read(damaged)
        except ValueError as error:
            refused += 1
            assert "damaged.la" in str(error)
    assert refused > 20


def _declare(path: Path, at: int, form: str, *values: float) -> Path:
    data = bytearray(path.read_bytes())
    struct.pack_into(form, data, at, *values)
    path.write_bytes(data)
    return path


def test_promises_that_the_file_cannot_keep_are_refused(tmp_path: Path) -> None:
    def cloud(name: str) -> Path:
        return write_cloud(tmp_path / name, random_cloud())

    many = _declare(cloud("a.las"), 247, "<Q", 10**12)
    with pytest.raises(ValueError, match=r"a\.las ends early: 1000000000000 points"):
        las.read(many)
    many = _declare(cloud("b.laz"), 247, "<Q", 10**12)
    with pytest.raises(ValueError, match=r"b\.laz ends early: 1000000000000 points"):
        las.read(many)
    records = _declare(cloud("c.laz"), 100, "<I", 2**32 - 1)
    with pytest.raises(ValueError, match=r"c\.laz ends early: 4294967295 records"):
        las.read(records)
    # x_max, x_min in the header, 1000 km apart
    wide = _declare(cloud("d.laz"), 179, "<4d", WEST + 1e6, WEST, SOUTH + 1e6, SOUTH)
    with pytest.raises(ValueError, match=r"d\.laz: the extent in the header needs"):
        las.read(wide)
    small = _declare(cloud("e.laz"), 179, "<4d", WEST + 9, WEST, SOUTH + 9, SOUTH)
    with pytest.raises(ValueError, match=r"e\.laz has a return at .* outside of the extent"):
        las.read(small)
    steps = _declare(cloud("f.las"), 131, "<d", float("nan"))
    with pytest.raises(ValueError, match=r"f\.las: coordinates in steps"):
        las.read(steps)


def test_layers_of_a_chunk_that_do_not_fit_are_refused(tmp_path: Path) -> None:
    path = write_cloud(tmp_path / "a.laz", random_cloud())
    data = path.read_bytes()
    (start,) = struct.unpack_from("<I", data, 96)
    # One plain point of format 6 and the count stand before the sizes of the layers.
    _declare(path, start + 8 + 30 + 4, "<I", 2**32 - 1)
    with pytest.raises(ValueError, match=r"a\.laz ends early: a chunk of 4\d{9} B"):
        las.read(path)


def test_other_files_are_refused(tmp_path: Path) -> None:
    text = tmp_path / "a.laz"
    text.write_text("x y z\n" * 100)
    with pytest.raises(ValueError, match=r"a\.laz: not a LAS or LAZ file"):
        las.read(text)
    with pytest.raises(FileNotFoundError):
        las.read(tmp_path / "missing.laz")


@pytest.mark.parametrize("missing", ["laspy", "lazrs"])
def test_a_missing_library_is_named_with_its_cure(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, missing: str
) -> None:
    path = write_cloud(tmp_path / "a.laz", field())
    found = importlib.import_module

    def without(name: str, package: str | None = None) -> Any:
        if name == missing:
            raise ModuleNotFoundError(f"No module named {name!r}")
        return found(name, package)

    monkeypatch.setattr(importlib, "import_module", without)
    message = re.escape(f"reading LAS and LAZ needs {missing}: {pip_install('geo')}")
    with pytest.raises(ImportError, match=message):
        las.read(path)


@pytest.mark.parametrize(("spacing", "cell"), [(40.0, 1.0), (40.0, 2.0), (300.0, 2.0), (25.0, 0.5)])
def test_a_survey_too_sparse_for_its_cells_names_a_cell_that_is_not(
    spacing: float, cell: float, tmp_path: Path
) -> None:
    returns = [(spacing * i, spacing * j, 40.0, 2) for i in range(6) for j in range(6)]
    path = write_cloud(tmp_path / "sparse.las", returns)
    with pytest.raises(ValueError, match=r"sparse\.las.* a larger cell would help, of ") as caught:
        las.read(path, cell=cell)
    found = re.search(r"would help, of ([\d.e+]+) m", str(caught.value))
    assert found is not None
    larger = float(found[1])
    assert cell < larger < 0.5 * spacing
    assert las.read(path, cell=larger).cell == larger
