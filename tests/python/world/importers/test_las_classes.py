# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Classes of laser returns: who defines them, and what becomes of those that nobody defines."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.world import LandClass, World
from ltp.world.importers import las
from ltp.world.landable import landable_mask

laspy = pytest.importorskip("laspy")
pyproj = pytest.importorskip("pyproj")

USA, FRANCE = "EPSG:26918", "EPSG:2154"
ROOF = np.s_[12:18, 12:18]  # [m], [cells of 1 m]


def corner(crs: str | None) -> tuple[float, float]:
    """Easting and northing, in whole hundreds of metres, amid the area that a CRS is made for."""
    known = pyproj.CRS(crs or USA)
    flat = known.sub_crs_list[0] if known.is_compound else known
    west, south, east, north = flat.area_of_use.bounds
    there = pyproj.Transformer.from_crs("EPSG:4326", flat, always_xy=True)
    x, y = there.transform((west + east) / 2.0, (south + north) / 2.0)
    return round(x, -2), round(y, -2)


def survey(
    path: Path,
    code: int,
    *,
    crs: str | None = USA,
    at: str | None = None,
    top: float = 40.0,
    point_format: int = 6,
    system: str = "",
    software: str = "",
    keep: NDArray[np.bool_] | None = None,
    flags: tuple[str, ...] = (),
) -> Path:
    """Level ground at 10 m with a return in every half metre, and 6 m x 6 m of another class.

    It lies where its CRS, or the one of `at`, is made for.
    """
    west, south = corner(at or crs)
    axis = np.arange(0.25, 30.0, 0.5)
    x, y = (a.ravel() for a in np.meshgrid(axis, axis, indexing="ij"))
    roof = (x >= 12) & (x < 18) & (y >= 12) & (y < 18)
    header = laspy.LasHeader(
        version="1.4" if point_format >= 6 else "1.2" if point_format < 4 else "1.3",
        point_format=point_format,
    )
    header.scales, header.offsets = [0.01] * 3, [west, south, 0.0]
    if system:
        header.system_identifier = system
    if software:
        header.generating_software = software
    if crs is not None:
        header.add_crs(pyproj.CRS(crs), keep_compatibility=False)
    cloud = laspy.LasData(header)
    cloud.x, cloud.y, cloud.z = west + x, south + y, np.where(roof, top, 10.0)
    cloud.classification = np.where(roof, code, 2).astype(np.uint8)
    for flag in flags:
        setattr(cloud, flag, roof)
    if keep is not None:
        cloud.points = cloud.points[keep | ~roof]
    cloud.write(path)
    return path


def read(path: Path, **options: Any) -> World:
    return las.read(path, cell=1.0, **options)


def assert_obstacle(world: World, top: float = 30.0) -> None:
    np.testing.assert_allclose(world.height_above_ground[ROOF], top, atol=1e-6)
    assert not landable_mask(world, "wide")[ROOF].any()
    outside = np.ones(world.shape, dtype=bool)
    outside[ROOF] = False
    assert (world.classes[outside] == LandClass.GROUND).all()
    np.testing.assert_allclose(world.height_above_ground[outside], 0.0)


def assert_dropped(world: World) -> None:
    np.testing.assert_allclose(world.height_above_ground, 0.0)


@pytest.mark.parametrize("crs", [USA, "EPSG:25832", "EPSG:27700", "EPSG:28992", "EPSG:25830", None])
@pytest.mark.parametrize("code", [64, 65, 66, 67, 100, 255])
def test_what_nobody_defines_is_an_obstacle_where_it_stands(
    tmp_path: Path, code: int, crs: str | None
) -> None:
    world = read(survey(tmp_path / "a.las", code, crs=crs))
    assert_obstacle(world)
    assert (world.classes[ROOF] == LandClass.UNKNOWN).all()
    assert any(f"class {code} (the producer's own): 144 returns" in s for s in world.report)
    assert any("--user-classes ign" in s and "--class" in s for s in world.report)


@pytest.mark.parametrize("point_format", [6, 7, 8])
@pytest.mark.parametrize("suffix", ["las", "laz"])
def test_in_every_format_that_holds_such_classes(
    tmp_path: Path, point_format: int, suffix: str
) -> None:
    for code in (65, 200):
        path = survey(tmp_path / f"a.{suffix}", code, point_format=point_format)
        assert_obstacle(read(path))


@pytest.mark.parametrize("point_format", [0, 1, 2, 3, 4, 5, 6, 7, 8])
@pytest.mark.parametrize("code", [0, 1, 6, 13, 14, 15, 16, 17, 19, 20, 21, 22, 23, 26, 31])
def test_reserved_classes_hide_nothing(tmp_path: Path, code: int, point_format: int) -> None:
    path = survey(tmp_path / "a.las", code, point_format=point_format)
    assert_obstacle(read(path))


@pytest.mark.parametrize("code", [23, 40, 63, 64, 65, 66, 67, 128, 255])
@pytest.mark.parametrize("top", [10.0, 10.3, 9.0])
def test_low_returns_of_an_unknown_class_are_unknown_ground(
    tmp_path: Path, code: int, top: float
) -> None:
    world = read(survey(tmp_path / "a.las", code, top=top))
    assert (world.classes[ROOF] == LandClass.UNKNOWN).all()
    assert not landable_mask(world, "wide")[ROOF].any()
    np.testing.assert_allclose(world.ground, 10.0)


@pytest.mark.parametrize(
    "crs",
    [
        *(FRANCE, "EPSG:9794", "EPSG:3945", "EPSG:27572"),  # France, by RGF93 and by NTF
        *("EPSG:5490", "EPSG:2972", "EPSG:2975", "EPSG:4471", "EPSG:4467"),  # overseas
        "EPSG:5698",  # with heights
    ],
)
def test_french_classes_in_french_data(tmp_path: Path, crs: str) -> None:
    world = read(survey(tmp_path / "a.las", 64, crs=crs))
    assert_obstacle(world)
    assert (world.classes[ROOF] == LandClass.BUILDING).all()
    assert any("as its CRS is" in s for s in world.report)
    for code in (65, 66, 67):
        assert_dropped(read(survey(tmp_path / "a.las", code, crs=crs)))
    assert_obstacle(read(survey(tmp_path / "a.las", 68, crs=crs)))


@pytest.mark.parametrize("crs", ["EPSG:32631", None])
@pytest.mark.parametrize(
    "said",
    [
        {"system": "IGN"},
        {"system": "IGN LiDAR HD"},
        {"software": "IGNF pdal-tools 1.9"},
        {"software": "LIDARHD v2"},
        {"system": "lidar_hd"},
    ],
    ids=str,
)
def test_french_classes_by_the_header(
    tmp_path: Path, said: dict[str, str], crs: str | None
) -> None:
    world = read(survey(tmp_path / "a.las", 66, crs=crs, **said))
    assert_dropped(world)
    assert any("its header says" in s for s in world.report)


@pytest.mark.parametrize(
    "said",
    [{"system": "DESIGN"}, {"software": "Alignment 2.0"}, {"software": "Lidar HDF"}],
    ids=str,
)
def test_other_words_are_not_french(tmp_path: Path, said: dict[str, str]) -> None:
    assert_obstacle(read(survey(tmp_path / "a.las", 66, **said)))


def test_the_user_has_the_last_word(tmp_path: Path) -> None:
    abroad = survey(tmp_path / "a.las", 65)
    home = survey(tmp_path / "b.las", 65, crs=FRANCE)
    assert_dropped(read(abroad, user_classes="ign"))
    assert_obstacle(read(home, user_classes="none"))
    given = survey(tmp_path / "c.las", 65, crs=None, at=FRANCE)
    assert_dropped(read(given, crs=FRANCE))
    with pytest.raises(ValueError, match="user_classes must be one of auto, ign, none, not 'IGN'"):
        read(home, user_classes="IGN")


@pytest.mark.parametrize(
    ("meaning", "kind", "height"),
    [
        ("building", LandClass.BUILDING, 30.0),
        (LandClass.TREES, LandClass.TREES, 30.0),
        ("Unknown", LandClass.UNKNOWN, 30.0),
        ("noise", LandClass.UNKNOWN, 0.0),
    ],
)
@pytest.mark.parametrize("crs", [USA, FRANCE])
def test_a_table_gives_classes_a_meaning(
    tmp_path: Path, meaning: Any, kind: LandClass, height: float, crs: str
) -> None:
    path = survey(tmp_path / "a.las", 65, crs=crs)
    world = read(path, class_table={65: meaning}, max_gap=3.0)
    np.testing.assert_allclose(world.height_above_ground[ROOF], height, atol=1e-6)
    assert (world.classes[15, 15]) == kind
    assert any("as you say" in s for s in world.report)


@pytest.mark.parametrize("kind", ["grass", "water", "road", "paved", "rail", "ground", 4])
def test_a_table_names_ground(tmp_path: Path, kind: str | int) -> None:
    world = read(survey(tmp_path / "a.las", 70, top=11.0), class_table={70: kind})
    expected = LandClass[kind.upper()] if isinstance(kind, str) else LandClass(kind)
    assert (world.classes[ROOF] == expected).all()
    np.testing.assert_allclose(world.ground[ROOF], 11.0)
    np.testing.assert_allclose(world.height_above_ground, 0.0)


@pytest.mark.parametrize(
    ("table", "message"),
    [
        ({65: "lawn"}, "class must be one of .*, not 'lawn'"),
        ({256: "grass"}, "class_table must name classes 0 to 255, not 256"),
        ({-1: "grass"}, "class_table must name classes"),
        ({True: "grass"}, "class_table must name classes"),
        ({"65": "grass"}, "class_table must name classes"),
        ({65: 99}, "class must be one of"),
    ],
)
def test_a_wrong_table_is_refused(tmp_path: Path, table: Any, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        read(survey(tmp_path / "a.las", 65), class_table=table)


def test_a_survey_that_calls_its_ground_otherwise_is_read_by_a_table(tmp_path: Path) -> None:
    path = survey(tmp_path / "a.las", 6)
    with pytest.raises(ValueError, match="no ground return"):
        read(path, class_table={2: "noise"})
    assert_obstacle(read(path, class_table={2: "ground", 6: "building"}))


@pytest.mark.parametrize("code", [7, 18])
@pytest.mark.parametrize("crs", [USA, FRANCE])
def test_noise_is_dropped_everywhere(tmp_path: Path, code: int, crs: str) -> None:
    world = read(survey(tmp_path / "a.las", code, crs=crs))
    assert_dropped(world)
    assert any("dropped" in s and f"class {code}" in s for s in world.report)


@pytest.mark.parametrize("point_format", [0, 1, 3, 6, 7, 8])
@pytest.mark.parametrize("code", [6, 1])
def test_what_the_flags_do(tmp_path: Path, code: int, point_format: int) -> None:
    def flagged(flag: str) -> World:
        path = tmp_path / "a.las"
        return read(survey(path, code, point_format=point_format, flags=(flag,)))

    withheld = flagged("withheld")
    assert_dropped(withheld)
    assert "144 returns marked as withheld: dropped" in withheld.report
    for flag in ("synthetic", "key_point", *(["overlap"] if point_format >= 6 else [])):
        assert_obstacle(flagged(flag))


@pytest.mark.parametrize(
    ("code", "kind"),
    [(2, LandClass.UNKNOWN), (11, LandClass.UNKNOWN), (9, LandClass.WATER)],
)
def test_ground_that_nobody_saw_is_unknown(tmp_path: Path, code: int, kind: LandClass) -> None:
    world = read(survey(tmp_path / "a.las", code, top=9.0, flags=("synthetic",)))
    assert (world.classes[ROOF] == kind).all()
    np.testing.assert_allclose(world.ground[ROOF], 9.0)
    assert any("144 ground returns are synthetic" in s for s in world.report)


def test_a_model_that_is_synthetic_as_a_whole_is_read(tmp_path: Path) -> None:
    path = survey(tmp_path / "a.las", 6)
    cloud = laspy.read(path)
    cloud.synthetic = np.ones(len(cloud.points), dtype=bool)
    cloud.write(path)
    assert_obstacle(read(path))


def test_the_report_counts_every_class(tmp_path: Path) -> None:
    world = read(survey(tmp_path / "a.las", 6))
    assert [line for line in world.report if line.startswith("class")] == [
        "class 2 (ground): 3,456 returns, taken for ground",
        "class 6 (building): 144 returns, taken for BUILDING",
    ]
    low = read(survey(tmp_path / "a.las", 6, top=-999.0))
    assert "144 returns outside of -430 ... 8849 m: dropped as noise" in low.report
    x, y = corner(USA)
    cut = read(tmp_path / "a.las", bounds=(x, y, x + 10, y + 30))
    assert any("outside of the bounds" in line for line in cut.report)


def test_a_thinned_roof_of_an_unknown_class_has_no_holes(tmp_path: Path) -> None:
    keep = np.random.default_rng(1).random(3600) < 0.3
    world = read(survey(tmp_path / "a.las", 99, keep=keep))
    np.testing.assert_allclose(world.height_above_ground[13:17, 13:17], 30.0)
    assert not landable_mask(world, "wide")[ROOF].any()
