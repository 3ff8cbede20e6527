# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Multipolygons: what lies within an odd number of rings is inside, whatever the rings are like."""

from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from ltp.world import LandClass
from tests.python.world.importers.osm_extract import Corners, Extract, at, box, read

HOUSE = {"building": "yes", "height": "30"}


def odd(rings: Sequence[Corners]) -> NDArray[np.bool_]:
    """The cells of 1 m whose centre lies within an odd number of rings, by a ray from each."""
    x, y = np.meshgrid(np.arange(100) + 0.5, np.arange(100) + 0.5, indexing="ij")
    inside = np.zeros((100, 100), dtype=bool)
    for ring in rings:
        for (x0, y0), (x1, y1) in pairwise(ring):
            if y0 != y1:
                crossed = ((y0 > y) != (y1 > y)) & (x0 + (y - y0) * (x1 - x0) / (y1 - y0) > x)
                inside ^= crossed
    return inside


def star(rng: np.random.Generator, x: float, y: float, inner: float, outer: float) -> Corners:
    """A ring round (x, y) that stays between two distances."""
    spread = rng.uniform(0.05, 2 * np.pi - 0.05, 8)
    quarters = np.arange(4) * np.pi / 2 + 0.01  # so that no chord comes near the centre
    angles = np.sort(np.concatenate([spread, quarters]))
    radii = rng.uniform(inner, outer, len(angles))
    corners = [
        (float(x + r * np.cos(a)), float(y + r * np.sin(a)))
        for a, r in zip(angles, radii, strict=True)
    ]
    return [*corners, corners[0]]


def in_arcs(rng: np.random.Generator, extract: Extract, ring: Corners) -> list[tuple[int, str]]:
    """The ring as member ways: whole or in arcs, in any direction, with any role."""
    cuts = sorted(rng.choice(np.arange(1, len(ring) - 1), int(rng.integers(0, 4)), replace=False))
    members = []
    for start, stop in zip([0, *cuts], [*cuts, len(ring) - 1], strict=True):
        arc = ring[start : stop + 1]
        arc = arc[::-1] if rng.random() < 0.5 else arc
        members.append((extract.way(arc), str(rng.choice(["outer", "inner", ""]))))
    return members


@pytest.mark.parametrize("form", ["xml", "pbf"])
@pytest.mark.parametrize("seed", range(12))
def test_nested_rings_in_any_pieces_and_roles(tmp_path: Path, form: str, seed: int) -> None:
    rng = np.random.default_rng(seed)
    extract, rings, members = Extract(), [], []
    for x, y in ((27.0, 27.0), (73.0, 27.0), (50.0, 74.0)):
        size = 22.0
        for _ in range(int(rng.integers(1, 5))):  # island in hole in island ...
            rings.append(star(rng, x, y, 0.8 * size, size))
            size *= 0.5
    for ring in rings:
        members += in_arcs(rng, extract, ring)
    order = rng.permutation(len(members))
    extract.multipolygon([members[index] for index in order], HOUSE)
    if form == "xml":
        path = extract.write_xml(tmp_path / "a.osm", order="".join(rng.permutation(list("nwr"))))
    else:
        path = extract.write_pbf(tmp_path / "a.osm.pbf")
    world = read(path)
    differ = (world.surface == 30.0) != odd(rings)
    assert differ.sum() <= 4  # a centre within rounding of an edge
    assert set(np.unique(world.surface)) <= {0.0, 30.0}
    assert not any("mended" in line for line in world.report)


@pytest.mark.parametrize("seed", range(12))
def test_rings_that_cross_are_mended_and_reported(tmp_path: Path, seed: int) -> None:
    rng = np.random.default_rng(seed)
    extract = Extract()
    corners = [(float(x), float(y)) for x, y in rng.uniform(5, 95, (6, 2))]
    crossing = [*corners, corners[0]]
    second = star(rng, 50, 50, 20, 30)
    extract.multipolygon([(extract.way(crossing), "outer"), (extract.way(second), "")], HOUSE)
    world = read(extract.write_xml(tmp_path / "a.osm"))
    differ = (world.surface == 30.0) != odd([crossing, second])
    assert differ.sum() <= 4
    assert any("mended" in line and "r1 building=yes" in line for line in world.report)


def test_what_touches_or_turns_back_is_assembled(tmp_path: Path) -> None:
    def area(*rings: Corners) -> NDArray[np.bool_]:
        extract = Extract()
        extract.multipolygon([(extract.way(ring), "outer") for ring in rings], HOUSE)
        world = read(extract.write_xml(tmp_path / "a.osm"))
        assert not any("mended" in line for line in world.report)
        return np.asarray(world.surface == 30.0)

    spike: Corners = [(10, 10), (50, 10), (50, 50), (70, 50), (50, 50), (10, 50), (10, 10)]
    assert np.array_equal(area(spike), odd([box(10, 10, 50, 50)]))
    eight: Corners = [(10, 10), (30, 28.3), (50, 10), (50, 50), (30, 28.3), (10, 50), (10, 10)]
    assert np.array_equal(area(eight), odd([eight]))
    side_by_side = area(box(10, 10, 30, 40), box(30, 10, 60, 40))  # one wall between them
    assert np.array_equal(side_by_side, odd([box(10, 10, 60, 40)]))
    corner_to_corner = [box(10, 10, 30, 30), box(30, 30, 50, 50)]
    assert np.array_equal(area(*corner_to_corner), odd(corner_to_corner))
    hole_at_the_wall: list[Corners] = [
        [(10, 10), (60, 10), (60, 60), (10, 60), (10, 30), (10, 10)],
        [(10, 30), (30, 20), (30, 40), (10, 30)],
    ]
    assert np.array_equal(area(*hole_at_the_wall), odd(hole_at_the_wall))


def test_a_member_listed_twice_counts_once(tmp_path: Path) -> None:
    extract = Extract()
    way = extract.way(box(10, 10, 50, 50))
    extract.multipolygon([(way, "outer"), (way, "outer"), (way, "inner")], HOUSE)
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert np.array_equal(world.surface == 30.0, odd([box(10, 10, 50, 50)]))


@pytest.mark.parametrize("pieces", [1, 2, 5])
def test_a_lake_larger_than_the_box_keeps_its_far_shore(tmp_path: Path, pieces: int) -> None:
    shore = [(-900.0, -900.0), (950.0, -900.0), (990.0, 40.0), (950.0, 900.0), (-900.0, 900.0)]
    ring = [*shore, shore[0]]
    cuts = np.linspace(0, len(ring) - 1, pieces + 1).round().astype(int)
    extract = Extract()
    members = [(extract.way(ring[a : b + 1]), "outer") for a, b in pairwise(cuts)]
    members.append((extract.way(box(40, 40, 60, 60)), "inner"))
    extract.multipolygon(members, {"natural": "water"})
    for path in (
        extract.write_xml(tmp_path / "a.osm"),
        extract.write_pbf(tmp_path / "a.osm.pbf"),
    ):
        water = read(path).classes == LandClass.WATER
        assert np.array_equal(~water, odd([box(40, 40, 60, 60)]))


def test_a_wood_round_the_box_without_any_way_in_it_is_read(tmp_path: Path) -> None:
    extract = Extract()
    ring = box(-2000, -2000, 2000, 2000)
    halves = [extract.way(ring[:3]), extract.way(ring[2:])]
    extract.multipolygon([(half, "outer") for half in halves], {"natural": "wood", "height": "9"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert (world.surface == 9.0).all()


# --- tags on the ways, and buildings in pieces ---------------------------------------------------


@pytest.mark.parametrize("own", [{}, {"source": "survey", "note": "old"}, {"name": "Hall"}])
def test_tags_may_lie_on_the_outer_ways(tmp_path: Path, own: dict[str, str]) -> None:
    outer, inner = box(10, 10, 50, 50), box(20, 20, 40, 40)
    whole, arcs = Extract(), Extract()
    members = [(whole.way(outer, HOUSE), "outer"), (whole.way(inner), "inner")]
    whole.multipolygon(members, own)
    members = [(arcs.way(outer[:3], HOUSE), "outer"), (arcs.way(outer[2:], HOUSE), "outer")]
    arcs.multipolygon([*members, (arcs.way(inner), "inner")], own)
    for extract in (whole, arcs):
        world = read(extract.write_xml(tmp_path / "a.osm"))
        assert np.array_equal(world.surface == 30.0, odd([outer, inner]))


def test_a_lake_tagged_on_its_shore_keeps_its_island(tmp_path: Path) -> None:
    extract = Extract()
    extract.way(box(0, 0, 100, 100), {"leisure": "park"})
    shore = extract.way(box(10, 10, 50, 50), {"natural": "water"})
    extract.multipolygon([(shore, "outer"), (extract.way(box(20, 20, 40, 40)), "inner")], {})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert [at(world, *xy)[1] for xy in ((15, 15), (30, 30))] == [LandClass.WATER, LandClass.GRASS]


def test_a_house_told_twice_has_its_courtyard(tmp_path: Path) -> None:
    extract = Extract()
    outer = extract.way(box(10, 10, 50, 50), {"building": "yes", "height": "30"})
    inner = extract.way(box(20, 20, 40, 40))
    extract.multipolygon([(outer, "outer"), (inner, "inner")], {"building": "yes"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert np.array_equal(world.surface == 30.0, odd([box(10, 10, 50, 50), box(20, 20, 40, 40)]))


def test_a_tagged_ring_of_a_relation_that_cannot_be_closed_stands_by_itself(tmp_path: Path) -> None:
    extract = Extract()
    ring = extract.way(box(10, 10, 50, 50), HOUSE)
    extract.way(box(60, 60, 70, 70), {"leisure": "park"})
    extract.multipolygon([(ring, "outer"), (999, "outer")], {})
    assert at(read(extract.write_xml(tmp_path / "a.osm")), 30, 30)[0] == 30.0


@pytest.mark.parametrize(
    ("relation", "way", "height"),
    [
        ({"building": "yes", "height": "60"}, {}, 60.0),
        ({"height": "60"}, {}, 60.0),
        ({"height": "60"}, {"building": "yes"}, 60.0),
        ({"building:levels": "5"}, {"building": "house"}, 15.0),
        ({}, {"building": "yes", "height": "40"}, 40.0),
        ({"name": "Tower"}, {"building": "yes", "height": "40"}, 40.0),
        ({"height": "60"}, {"building": "yes", "height": "40"}, 40.0),
    ],
)
@pytest.mark.parametrize("arcs", [False, True])
def test_a_building_relation_gives_its_outline_what_it_lacks(
    tmp_path: Path, relation: dict[str, str], way: dict[str, str], height: float, arcs: bool
) -> None:
    extract, ring = Extract(), box(10, 10, 50, 50)
    rings = [ring[:3], ring[2:]] if arcs else [ring]
    outline = [(extract.way(part, way), "outline") for part in rings]
    extract.relation(outline, {"type": "building", **relation})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert np.array_equal(world.surface == height, odd([ring]))


def test_parts_of_a_building_relation_come_before_its_outline(tmp_path: Path) -> None:
    extract = Extract()
    outline = extract.way(box(10, 10, 50, 50))
    tower = extract.way(box(10, 10, 30, 50), {"building:part": "yes", "height": "80"})
    low = extract.way(box(30, 10, 50, 50), {"height": "8"})  # a part only by its role
    roles = [(outline, "outline"), (tower, "part"), (low, "part")]
    extract.relation(roles, {"type": "building", "height": "80"})
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert [at(world, *xy)[0] for xy in ((20, 30), (40, 30))] == [80.0, 8.0]


@pytest.mark.parametrize("tags", [HOUSE, {"natural": "water"}], ids=str)
def test_a_ring_with_a_gap_is_closed_and_reported(tmp_path: Path, tags: dict[str, str]) -> None:
    extract = Extract()
    ring: Corners = [(10, 10), (50, 10), (50, 50), (10, 50), (10, 11)]
    arcs = [extract.way(ring[:3]), extract.way(ring[2:])]
    extract.multipolygon([(arc, "outer") for arc in arcs], tags)
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert np.array_equal(world.classes != LandClass.UNKNOWN, odd([box(10, 10, 50, 50)]))
    assert any("mended, such as r1" in line for line in world.report)
