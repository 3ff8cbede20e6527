# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hostile `.bt` and `.ot` files: one clear error that names the file, soon, and little memory."""

import resource
import struct
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from ltp._core import OctreeSurface

BT = b"# Octomap OcTree binary file"
OT = b"# Octomap OcTree file"


def octree(
    magic: bytes, nodes: int | str, data: bytes, res: str = "0.5", kind: str = "OcTree"
) -> bytes:
    return magic + f"\nid {kind}\nsize {nodes}\nres {res}\ndata\n".encode() + data


def voxel(x: int, y: int, z: int) -> bytes:
    """`.bt` data of one occupied voxel, counted from the world's lowest corner."""
    data = b""
    for level in range(15, -1, -1):
        child = (x >> level & 1) | (y >> level & 1) << 1 | (z >> level & 1) << 2
        data += ((3 if level > 0 else 2) << 2 * child).to_bytes(2, "little")
    return data


def full_voxel(x: int, y: int, z: int, log_odds: float) -> bytes:
    """`.ot` data of one voxel."""
    data = b""
    for level in range(15, -1, -1):
        child = (x >> level & 1) | (y >> level & 1) << 1 | (z >> level & 1) << 2
        data += struct.pack("<fB", log_odds, 1 << child)
    return data + struct.pack("<fB", log_odds, 0)


ONE_VOXEL = octree(BT, 17, voxel(32768, 32770, 32767))
ONE_FULL_VOXEL = octree(OT, 17, full_voxel(32768, 32770, 32767, 0.7))


def read(folder: Path, content: bytes) -> OctreeSurface:
    path = folder / "map.bt"
    path.write_bytes(content)
    return OctreeSurface(path)


def refusal(folder: Path, content: bytes) -> str:
    with pytest.raises(ValueError, match=r"map\.bt") as caught:
        read(folder, content)
    return str(caught.value)


@pytest.mark.parametrize("content", [ONE_VOXEL, ONE_FULL_VOXEL])
def test_a_voxel_lies_where_the_format_says(tmp_path: Path, content: bytes) -> None:
    surface = read(tmp_path, content)
    assert surface.size == 1
    assert surface.resolution == 0.5
    assert surface.cast((0.25, 1.25, 3.0), (0, 0, -1), 10.0).range == 3.0
    assert surface.voxels.frame.origin == pytest.approx([0, 1, -0.5])


def test_a_free_voxel_is_no_obstacle(tmp_path: Path) -> None:
    assert read(tmp_path, octree(OT, 17, full_voxel(1, 2, 3, -0.7))).size == 0


@pytest.mark.parametrize("content", [ONE_VOXEL, ONE_FULL_VOXEL])
def test_a_file_cut_anywhere_is_refused(tmp_path: Path, content: bytes) -> None:
    for size in range(len(content)):
        refusal(tmp_path, content[:size])


@settings(
    deadline=None,
    max_examples=300,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(data=st.binary(max_size=200), nodes=st.integers(0, 60), magic=st.sampled_from([BT, OT]))
def test_random_data_are_read_or_refused(
    tmp_path: Path, data: bytes, nodes: int, magic: bytes
) -> None:
    try:
        assert read(tmp_path, octree(magic, nodes, data)).size >= 0
    except ValueError as error:
        assert "map.bt" in str(error)


@settings(
    deadline=None,
    max_examples=300,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(position=st.integers(0, len(ONE_FULL_VOXEL) - 1), byte=st.integers(0, 255))
def test_a_spoiled_byte_is_read_or_refused(tmp_path: Path, position: int, byte: int) -> None:
    content = bytearray(ONE_FULL_VOXEL)
    content[position] = byte
    try:
        assert read(tmp_path, bytes(content)).size in (0, *(8**level for level in range(17)))
    except ValueError as error:
        assert "map.bt" in str(error)


@pytest.mark.parametrize(
    ("content", "reason"),
    [
        (b"", "first line"),
        (b"\x03\x00\x00\x00" + bytes(100), "first line"),  # the legacy format
        (BT + b"\n" + b"#" * 10_000_000, "data"),
        (octree(BT, 17, voxel(1, 2, 3) + b"\0"), "bytes after the tree"),
        (octree(BT, 16, voxel(1, 2, 3)), "size = 16"),
        (octree(BT, 2**64 - 1, voxel(1, 2, 3)), "size = 18446744073709551615"),
        (octree(BT, 2**64, voxel(1, 2, 3)), "size"),
        (octree(BT, "-1", voxel(1, 2, 3)), "size"),
        (octree(BT, 10**6, b"\x03\x00" * 10**6), "16 levels"),
        (octree(OT, 10**6, struct.pack("<fB", 1.0, 1) * 10**6), "16 levels"),
        (octree(OT, 1, struct.pack("<fB", float("nan"), 0)), "log-odds"),
        (octree(OT, 1, struct.pack("<fB", float("inf"), 0)), "log-odds"),
        (octree(BT, 17, voxel(1, 2, 3), res="0"), "res = 0"),
        (octree(BT, 17, voxel(1, 2, 3), res="-0.5"), "res = -0.5"),
        (octree(BT, 17, voxel(1, 2, 3), res="nan"), "res = nan"),
        (octree(BT, 17, voxel(1, 2, 3), res="inf"), "res = inf"),
        (octree(BT, 17, voxel(1, 2, 3), res="ten"), "res"),
        (octree(BT, 17, voxel(1, 2, 3), kind="CountingOcTree"), "CountingOcTree"),
    ],
)
def test_a_hostile_file_is_refused(tmp_path: Path, content: bytes, reason: str) -> None:
    assert reason in refusal(tmp_path, content)


def test_all_of_octomaps_world_is_one_leaf(tmp_path: Path) -> None:
    whole = read(tmp_path, octree(OT, 1, struct.pack("<fB", 1.0, 0)))
    assert whole.size == 2**48
    assert whole.memory < 20_000_000
    with pytest.raises(ValueError, match="bounding box"):
        _ = whole.voxels


def test_a_small_file_cannot_ask_for_much_memory(tmp_path: Path) -> None:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for nodes in (2**32 - 1, 2**40, 2**63):
        refusal(tmp_path, octree(BT, nodes, voxel(1, 2, 3)))
        refusal(tmp_path, octree(OT, nodes, full_voxel(1, 2, 3, 1.0)))
    grown = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before
    assert grown < 20_000  # kB


def test_what_is_no_file_is_named(tmp_path: Path) -> None:
    for path in (tmp_path / "absent.bt", tmp_path, Path("/dev/zero")):
        with pytest.raises(ValueError, match=str(path)):
            OctreeSurface(path)
