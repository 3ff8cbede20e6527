# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""OpenStreetMap files as they come: unordered, cut at a border, with deleted objects, hostile."""

import itertools
import zlib
from pathlib import Path

import numpy as np
import pytest

from ltp.world import LandClass, World
from tests.python.world.importers.osm_extract import (
    Corners,
    Extract,
    Tags,
    at,
    box,
    mutable,
    osmium,
    read,
)

HOUSE = {"building": "yes", "height": "30"}


def town() -> Extract:
    """A house of two rings, a lake, a road, a mast."""
    extract = Extract()
    outer, inner = extract.way(box(10, 10, 50, 50)), extract.way(box(20, 20, 40, 40))
    extract.multipolygon([(outer, "outer"), (inner, "inner")], HOUSE)
    extract.way(box(60, 10, 90, 40), {"natural": "water"})
    extract.way([(-20, 70), (120, 70)], {"highway": "residential"})
    extract.node(75, 85, {"man_made": "mast", "height": "25"})
    return extract


def same(one: World, other: World) -> bool:
    surfaces = np.array_equal(one.surface, other.surface)
    return surfaces and np.array_equal(one.classes, other.classes)


@pytest.mark.parametrize("order", ["".join(p) for p in itertools.permutations("nwr")])
@pytest.mark.parametrize("sign", [1, -1])
def test_neither_order_nor_sign_of_the_ids_matters(tmp_path: Path, order: str, sign: int) -> None:
    plain = read(town().write_xml(tmp_path / "a.osm"))
    assert at(plain, 15, 15) == (30.0, LandClass.BUILDING)
    other = read(town().write_xml(tmp_path / "b.osm", order=order, sign=sign))
    assert same(plain, other)
    assert plain.report == tuple(line.replace("-", "") for line in other.report)


def test_lines_of_a_file_in_any_order(tmp_path: Path) -> None:
    plain = read(town().write_xml(tmp_path / "a.osm"))
    lines = (tmp_path / "a.osm").read_text().splitlines()
    for seed in range(5):
        shuffled = np.random.default_rng(seed).permutation(lines[2:-1]).tolist()
        (tmp_path / "b.osm").write_text("\n".join([*lines[:2], *shuffled, lines[-1]]))
        assert same(plain, read(tmp_path / "b.osm"))


def test_new_objects_of_an_editor_stand_beside_old_ones(tmp_path: Path) -> None:
    path = tmp_path / "a.osm.pbf"
    writer = osmium.SimpleWriter(str(path), overwrite=True)
    extract = Extract()
    extract.way(box(10, 10, 30, 30), HOUSE)
    extract.way(box(50, 10, 70, 30), {"building": "yes", "height": "50"})
    for sign, way in ((1, extract.ways[0]), (-1, extract.ways[1])):
        for number, place, _ in extract._placed():
            if number in way[1]:
                writer.add_node(mutable.Node(id=sign * number, location=place))
        refs = [sign * ref for ref in way[1]]
        writer.add_way(mutable.Way(id=sign * way[0], nodes=refs, tags=way[2]))
    writer.close()
    world = read(path)
    assert [at(world, x, 20)[0] for x in (20, 60)] == [30.0, 50.0]


@pytest.mark.parametrize(
    "mark", ['action="delete"', "action='delete'", 'visible="false"', 'action = "delete"']
)
def test_deleted_objects_are_left_out_and_counted(tmp_path: Path, mark: str) -> None:
    extract = town()
    extract.way(box(60, 75, 70, 85), HOUSE)
    path = tmp_path / "a.osm"
    world = read(extract.write_xml(path, attributes={("w", 5): mark}))
    assert same(world, read(town().write_xml(tmp_path / "b.osm")))
    assert "Left out of the file: 1 deleted objects." in world.report
    for deleted, place in ((("r", 1), (15, 15)), (("n", 15), (75, 85)), (("w", 3), (75, 25))):
        world = read(extract.write_xml(path, attributes={deleted: mark}))
        assert at(world, *place) == (0.0, LandClass.UNKNOWN)
        assert "Left out of the file: 1 deleted objects." in world.report
    world = read(extract.write_xml(path, attributes={("w", 3): 'action="modify"'}))
    assert at(world, 75, 25)[1] == LandClass.WATER


@pytest.mark.parametrize("suffix", [".osm", ".osm.pbf"])
@pytest.mark.parametrize("turned", [False, True])
def test_of_many_versions_the_newest_counts(tmp_path: Path, suffix: str, turned: bool) -> None:
    extract = Extract()
    ring = box(10, 10, 30, 30)
    extract.way(ring, HOUSE)
    extract.way(box(40, 10, 60, 30), HOUSE)
    extract.node(80.5, 20.5)
    nodes = {number: place for number, place, _ in extract._placed()}
    (first, refs, _), (second, others, _), mast = *extract.ways, len(nodes)
    versions = [
        *[mutable.Node(id=n, version=1, location=place) for n, place in nodes.items() if n < mast],
        mutable.Node(id=mast, version=1, location=nodes[mast], tags={"man_made": "mast"}),
        mutable.Node(id=mast, version=2, location=nodes[mast]),
        mutable.Way(id=first, version=1, nodes=refs, tags={"building": "yes", "height": "9"}),
        mutable.Way(id=first, version=3, nodes=refs, tags=HOUSE),
        mutable.Way(id=second, version=1, nodes=others, tags=HOUSE),
        mutable.Way(id=second, version=2, nodes=[], visible=False),
    ]
    path = tmp_path / f"a{suffix}"
    writer = osmium.SimpleWriter(osmium.io.File(str(path), suffix[1:] + ",history=true"))
    for item in versions[::-1] if turned else versions:
        writer.add(item)
    writer.close()
    world = read(path)
    assert [at(world, x, 20)[0] for x in (20, 50, 80)] == [30.0, 0.0, 0.0]
    assert any("3 older versions" in line for line in world.report)
    assert any("1 deleted objects" in line for line in world.report)


# --- cut at a border -----------------------------------------------------------------------------

L_SHAPE = [(10, 10), (50, 10), (50, 30), (30, 30), (30, 60), (10, 60), (10, 10)]
NEEDED: list[Tags] = [
    HOUSE,
    {"building:part": "yes"},
    {"man_made": "storage_tank"},
    {"natural": "water"},
    {"natural": "wood"},
    {"landuse": "railway"},
    {"tourism": "attraction", "height": "20"},
]


@pytest.mark.parametrize("tags", NEEDED, ids=str)
@pytest.mark.parametrize("relation", [False, True])
def test_what_must_not_be_missed_is_refused_without_a_corner(
    tmp_path: Path, tags: Tags, relation: bool
) -> None:
    extract = Extract()
    ring = extract.way([(float(x), float(y)) for x, y in L_SHAPE], {} if relation else tags)
    if relation:
        extract.multipolygon([(ring, "outer")], tags)
    for corners in ((1,), (2,), (4,), (6,), (2, 3), (1, 3, 5), (1, 2, 3, 4, 5)):
        path = extract.write_xml(tmp_path / "a.osm", without=corners)
        name = "r1" if relation else "w1"
        with pytest.raises(ValueError, match=rf"a\.osm lacks nodes .*\({name}.*\).*osmium extract"):
            read(path)


@pytest.mark.parametrize("corner", [1, 2, 3, 4])
def test_a_lawn_without_a_corner_is_no_lawn(tmp_path: Path, corner: int) -> None:
    extract = Extract()
    extract.way(box(10, 10, 50, 50), {"leisure": "park"})
    extract.way(box(60, 60, 70, 70), HOUSE)
    world = read(extract.write_xml(tmp_path / "a.osm", without=(corner,)))
    assert not (world.classes == LandClass.GRASS).any()
    assert any("some nodes are not in the file, such as w1" in line for line in world.report)


def test_a_road_without_a_node_has_a_gap(tmp_path: Path) -> None:
    extract = Extract()
    corners: Corners = [(-20, 50), (20, 50), (40, 90), (60, 50), (120, 50)]
    extract.way(corners, {"highway": "residential"})
    world = read(extract.write_xml(tmp_path / "a.osm", without=(3,)))
    assert [at(world, x, 50)[1] for x in (10, 40, 90)] == [
        LandClass.ROAD,
        LandClass.UNKNOWN,
        LandClass.ROAD,
    ]
    assert any("some nodes are not in the file, such as w1" in line for line in world.report)


@pytest.mark.parametrize("tags", [{"waterway": "stream"}, {"barrier": "wall", "height": "3"}])
def test_a_stream_and_a_wall_go_on_where_a_node_is_missing(tmp_path: Path, tags: Tags) -> None:
    extract = Extract()
    extract.way([(-20, 50.5), (20, 50.5), (40, 50.5), (60, 50.5), (120, 50.5)], tags)
    world = read(extract.write_xml(tmp_path / "a.osm", without=(3,)))
    assert (world.classes[:, 50] != LandClass.UNKNOWN).all()


def test_a_coast_that_lacks_its_bays_floods_no_land(tmp_path: Path) -> None:
    # From (20, -30) the coast runs round outside of the box, without its nodes, to (120, 50).
    extract = Extract()
    coast: Corners = [(20, 130), (20, -30), (20, -200), (300, -200), (300, 50), (120, 50)]
    extract.way(coast[::-1], {"natural": "coastline"})
    extract.way(box(60, 60, 80, 80), {"leisure": "park"})
    whole = read(extract.write_xml(tmp_path / "a.osm"))
    cut = read(extract.write_xml(tmp_path / "b.osm", without=(2, 3, 4)))
    assert same(whole, cut)


def test_a_house_outside_of_the_bounds_may_lack_what_it_likes(tmp_path: Path) -> None:
    extract = town()
    extract.way(box(130, 10, 150, 30), HOUSE)
    last = len(extract.nodes)
    world = read(extract.write_xml(tmp_path / "a.osm", without=(last,)))
    assert same(world, read(town().write_xml(tmp_path / "b.osm")))
    assert any("some nodes are not in the file, such as w5" in line for line in world.report)


def test_a_lake_that_lacks_members_is_reported_by_its_name(tmp_path: Path) -> None:
    extract = town()
    half = extract.way([(10, 80), (50, 80), (50, 90)])
    extract.multipolygon([(half, "outer"), (999, "outer")], {"natural": "water", "name": "Loch"})
    report = read(extract.write_xml(tmp_path / "a.osm")).report
    assert any(
        "cut open (the file lacks members), such as r2 natural=water 'Loch'" in s for s in report
    )


def test_a_house_that_lacks_members_is_refused(tmp_path: Path) -> None:
    extract = town()
    half = extract.way([(10, 80), (50, 80), (50, 90)])
    extract.multipolygon([(half, "outer"), (999, "outer")], HOUSE)
    with pytest.raises(ValueError, match=r"a\.osm lacks nodes .*\(r2\)"):
        read(extract.write_xml(tmp_path / "a.osm"))


def test_an_outline_that_is_not_closed_is_closed_and_reported(tmp_path: Path) -> None:
    extract = town()
    extract.way(box(60, 75, 70, 85)[:-1], HOUSE)
    world = read(extract.write_xml(tmp_path / "a.osm"))
    assert at(world, 65, 80)[0] == 30.0
    assert any("an outline that is not closed: closed, such as w5" in line for line in world.report)


def test_an_answer_that_a_server_broke_off_is_refused(tmp_path: Path) -> None:
    path = town().write_xml(tmp_path / "a.osm")
    text = path.read_text(encoding="utf-8")
    remark = "<remark> runtime error: Query timed out in 'query' at line 3 </remark>"
    path.write_text(text.replace("</osm>", f"{remark}</osm>"), encoding="utf-8")
    with pytest.raises(ValueError, match=r"a\.osm .*broke off its answer: runtime error: Query"):
        read(path)


# --- hostile files -------------------------------------------------------------------------------


def plain_pbf(path: Path) -> bytes:
    """A file whose blocks are not compressed, so that damage reaches what is inside."""
    town().write_xml(path.with_suffix(".xml.osm"))
    target = osmium.io.File(str(path), "pbf,pbf_compression=none")
    writer = osmium.SimpleWriter(target, overwrite=True)
    for item in osmium.FileProcessor(str(path.with_suffix(".xml.osm"))):
        writer.add(item)
    writer.close()
    return path.read_bytes()


@pytest.mark.parametrize("name", ["a.osm", "a.osm.pbf", "plain.osm.pbf"])
def test_damaged_files_are_read_or_refused_by_name(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    if name == "plain.osm.pbf":
        data = plain_pbf(path)
    else:
        data = (town().write_pbf if name.endswith("pbf") else town().write_xml)(path).read_bytes()
    rng = np.random.default_rng(3)
    refused = 0
    for turn in range(120):
        broken = bytearray(data)
        at_byte = int(rng.integers(len(broken)))
        if turn % 3 == 0:
            broken[at_byte] ^= 1 << int(rng.integers(8))
        elif turn % 3 == 1:
            broken[at_byte : at_byte + 3] = rng.bytes(3)
        else:
            digits = [i for i in range(at_byte, len(broken)) if chr(broken[i]).isdigit()]
            for index in digits[:2]:
                broken[index] = 48 + int(rng.integers(10))
        path.write_bytes(broken)
        try:
            read(path)
        except ValueError as error:
            refused += 1
            assert name in str(error)
    assert refused > 12


def test_a_zero_byte_in_a_text_is_refused(tmp_path: Path) -> None:
    # libosmium reads past its memory there.
    path = tmp_path / "a.osm.pbf"
    data = plain_pbf(path)
    assert b"man_made" in data
    path.write_bytes(data.replace(b"man_made", b"man\0made"))
    with pytest.raises(ValueError, match=r"a\.osm\.pbf .* zero byte"):
        read(path)


@pytest.mark.parametrize(
    ("blob", "message"),
    [
        (b"\x1a" + b"\xff\xff\xff\x7f", "longer than its message"),
        (b"\x1a\x04" + zlib.compress(b"x" * 10)[:4], "cannot be read"),
        (b"\x22\x01x", "other than zlib"),
        (b"", "no data"),
    ],
)
def test_a_blob_that_lies_is_refused(tmp_path: Path, blob: bytes, message: str) -> None:
    path = tmp_path / "a.osm.pbf"
    header = b"\x0a\x07OSMData\x18" + bytes([len(blob)])
    sound = town().write_pbf(path).read_bytes()
    path.write_bytes(sound + len(header).to_bytes(4, "big") + header + blob)
    with pytest.raises(ValueError, match=rf"a\.osm\.pbf .*{message}"):
        read(path)


def test_a_blob_that_inflates_without_end_is_refused(tmp_path: Path) -> None:
    packed = zlib.compress(bytes(40 * 1024 * 1024))
    size = bytearray()
    for value in (len(packed),):
        while value > 0x7F:
            size.append(value & 0x7F | 0x80)
            value >>= 7
        size.append(value)
    blob = b"\x1a" + bytes(size) + packed
    path = tmp_path / "a.osm.pbf"
    sound = town().write_pbf(path).read_bytes()
    length = len(blob)
    header = b"\x0a\x07OSMData\x18" + bytes([length & 0x7F | 0x80, length >> 7 & 0x7F | 0x80])
    header += bytes([length >> 14])
    path.write_bytes(sound + len(header).to_bytes(4, "big") + header + blob)
    with pytest.raises(ValueError, match=r"a\.osm\.pbf .* inflates to more than"):
        read(path)


def test_an_ocean_that_leaves_the_projection_harms_nothing_else(tmp_path: Path) -> None:
    extract = town()
    ring = extract.way(box(10, 60, 20, 70))
    extract.multipolygon([(ring, "outer")], {"natural": "bay"})
    path = extract.write_xml(tmp_path / "a.osm")
    text = path.read_text()
    first = min(extract.ways[-1][1])
    start = text.index(f'<node id="{first}"')
    line = text[start : text.index("</node>", start)]
    path.write_text(text.replace(line, f'<node id="{first}" version="1" lat="0.0" lon="99.0">'))
    world = read(path)
    assert at(world, 15, 15)[0] == 30.0
    assert any("cannot be projected" in line for line in world.report)
