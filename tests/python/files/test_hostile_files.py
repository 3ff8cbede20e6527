# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever the bytes of a file: it is read, or refused by a `ValueError` that names it."""

import io
import json
import tracemalloc
import warnings
import zipfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ltp.config import MissionConfig
from ltp.evaluation.gap import queries
from ltp.evaluation.gap.queries import QuerySet
from ltp.sim import FlightRecord, record_file
from ltp.world import World
from tests.python.files.hostile import READERS, Reader
from tests.python.files.mutations import mutations

MUTATIONS = 2000


@pytest.mark.parametrize("reader", READERS, ids=lambda reader: reader.name)
def test_a_damaged_file_is_read_or_refused_by_name(reader: Reader, tmp_path: Path) -> None:
    for library in reader.needs:
        pytest.importorskip(library)
    path = tmp_path / reader.name
    reader.write(path)
    reader.read(path)
    refused = 0
    for number, data in enumerate(mutations(path.read_bytes(), MUTATIONS, seed=10)):
        path.write_bytes(data)
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                reader.read(path)
        except ValueError as error:
            assert str(path) in str(error), f"mutation {number}: {error}"
            refused += 1
    assert refused > MUTATIONS // 4


@pytest.mark.parametrize("reader", READERS, ids=lambda reader: reader.name)
def test_an_empty_file_and_a_strangers_are_refused_by_name(reader: Reader, tmp_path: Path) -> None:
    for library in reader.needs:
        pytest.importorskip(library)
    path = tmp_path / reader.name
    may_be_empty = (".toml", ".jsonl")
    strangers = [b"PK\x03\x04", b"\x1f\x8b\x08\x00", b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n", bytes(1000)]
    for data in [*strangers, *([] if path.suffix in may_be_empty else [b""])]:
        path.write_bytes(data)
        with pytest.raises(ValueError, match=reader.name):
            reader.read(path)
    path.unlink()
    if path.suffix != ".jsonl":  # a journal is made where there is none
        with pytest.raises((OSError, ValueError), match=reader.name):
            reader.read(path)


# ---- archives -----------------------------------------------------------------------------------

ARCHIVES: dict[str, Callable[[Path], object]] = {
    "world.npz": World.load,
    "flight.npz": FlightRecord.load,
    "queries.npz": QuerySet.load,
}


def sound(name: str, folder: Path) -> dict[str, bytes]:
    """The members of a sound archive."""
    path = folder / name
    next(reader for reader in READERS if reader.name == name).write(path)
    with zipfile.ZipFile(path) as archive:
        return {member.filename: archive.read(member) for member in archive.infolist()}


def pack(path: Path, members: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED) -> None:
    with zipfile.ZipFile(path, "w", method, compresslevel=9) as archive:
        for name, data in members.items():
            archive.writestr(name, data)


def npy(shape: str, data: bytes, dtype: str = "<f8") -> bytes:
    text = f"{{'descr': '{dtype}', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text.encode() + data


def numbers(array: Any) -> bytes:
    file = io.BytesIO()
    np.save(file, array)
    return file.getvalue()


def refused_with_little_memory(path: Path, limit: int) -> str:
    """What a reader says to a file, having held at most `limit` bytes."""
    tracemalloc.start()
    try:
        with pytest.raises(ValueError, match=path.name) as caught:
            ARCHIVES[path.name](path)
        _, peak = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert peak < limit
    return str(caught.value)


@pytest.mark.parametrize("name", ARCHIVES)
def test_a_header_that_lies_allocates_nothing(name: str, tmp_path: Path) -> None:
    members = sound(name, tmp_path)
    for member in members:
        for shape in ("(999999999999, 999999)", "(999999999999,)", "(99999999, 3)"):
            dtype = "|u1" if member in ("header.npy", "metadata.npy") else "<f8"
            pack(tmp_path / name, {**members, member: npy(shape, bytes(64), dtype)})
            refused_with_little_memory(tmp_path / name, 4_000_000)


@pytest.mark.parametrize("name", ARCHIVES)
@pytest.mark.parametrize("brackets", [b"[", b'{"a":', b"[[],"])
def test_a_header_nested_deeply_or_endlessly_is_refused(
    name: str, brackets: bytes, tmp_path: Path
) -> None:
    members = sound(name, tmp_path)
    for count in (3000, 5_000_000):
        data = brackets * count
        bomb = npy(f"({len(data)},)", data, "|u1")
        member = "metadata.npy" if name == "world.npz" else "header.npy"
        pack(tmp_path / name, {**members, member: bomb})
        refused_with_little_memory(tmp_path / name, 30_000_000)


def test_a_bomb_is_refused_before_it_is_unpacked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    # A million bytes of a file may become so many in memory at most.
    assert record_file._MAX_BYTES + 1_000_000 * record_file._MAX_PACKING < 400e6
    assert queries._MAX_BYTES + 1_000_000 * queries._MAX_PACKING < 800e6
    monkeypatch.setattr(record_file, "_MAX_BYTES", 1_000_000)
    monkeypatch.setattr(queries, "_MAX_BYTES", 1_000_000)
    points = numbers(np.zeros((1_000_000, 3)))
    for member in ("positions.npy", "plan_paths.npy", "global_path.npy"):
        pack(tmp_path / "flight.npz", {**sound("flight.npz", tmp_path), member: points})
        assert "packed too tightly" in refused_with_little_memory(
            tmp_path / "flight.npz", 5_000_000
        )
    raster = numbers(np.zeros((2000, 2000)))
    pack(tmp_path / "queries.npz", {**sound("queries.npz", tmp_path), "raster_0.npy": raster})
    assert "packed too tightly" in refused_with_little_memory(tmp_path / "queries.npz", 5_000_000)


@pytest.mark.parametrize("name", ARCHIVES)
def test_objects_strange_members_and_compressions_are_refused(name: str, tmp_path: Path) -> None:
    members, path = sound(name, tmp_path), tmp_path / name
    first = sorted(members)[0]
    file = io.BytesIO()
    np.save(file, np.array([print], dtype=object), allow_pickle=True)
    for changed in (
        {**members, first: file.getvalue()},
        {**members, "more.npy": members[first]},
        {key: data for key, data in members.items() if key != first},
        {**members, first: npy("(1, __import__('os').getpid())", b"")},
        {**members, first: members[first][:6] + b"\x02\x00" + members[first][8:]},
    ):
        pack(path, changed)
        with pytest.raises(ValueError, match=name):
            ARCHIVES[name](path)
    for method in (zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA):
        pack(path, members, method)
        with pytest.raises(ValueError, match="unexpected compression method"):
            ARCHIVES[name](path)
    pack(path, members)
    ARCHIVES[name](path)


HEADERS: list[tuple[str, dict[str, Any], str]] = [
    ("flight.npz", {"length": "far"}, "length: expected float"),
    ("flight.npz", {"length": True}, "length: expected float"),
    ("flight.npz", {"collision": [1.0, 2.0]}, "collision: expected tuple"),
    ("flight.npz", {"outcome": "landed"}, "landed"),
    ("flight.npz", {"waypoints": [{"index": 0}]}, "outcome"),
    ("flight.npz", {"waypoints": [7]}, "expected the fields of a WaypointEntry"),
    ("flight.npz", {"plans": []}, "zip"),
    ("flight.npz", {"metadata": [1]}, "metadata: expected dict"),
    ("flight.npz", {"world_name": None}, "world_name: expected str"),
    ("flight.npz", {"config": {"wind": 3.0}}, "unknown key 'wind'"),
    ("flight.npz", {"surprise": 1}, "unknown field 'surprise'"),
    ("flight.npz", {"times": [1.0]}, "unknown field 'times'"),
    ("queries.npz", {"world": 3}, "world: expected a text"),
    ("queries.npz", {"priorities": {"0": {"binary": 5}}}, "range"),
    ("queries.npz", {"rasters": [{"origin": [0, 0], "cell": -1.0, "outside": 0.0}]}, "cell"),
    ("queries.npz", {"rasters": [{"origin": "far", "cell": 1.0, "outside": 0.0}]}, "origin"),
    ("queries.npz", {"queries": [{}]}, "queries"),
    ("queries.npz", {"priorities": {}}, "no priority map of scenario"),
]


@pytest.mark.parametrize(("name", "changes", "message"), HEADERS)
def test_a_header_with_values_of_other_types_is_refused(
    name: str, changes: dict[str, Any], message: str, tmp_path: Path
) -> None:
    members = sound(name, tmp_path)
    header = json.loads(np.load(io.BytesIO(members["header.npy"])).tobytes()) | changes
    text = np.frombuffer(json.dumps(header).encode(), np.uint8)
    pack(tmp_path / name, {**members, "header.npy": numbers(text)})
    with pytest.raises(ValueError, match=rf"{name}.*{message}") as caught:
        ARCHIVES[name](tmp_path / name)
    assert "\n" not in str(caught.value)


def test_a_record_of_no_flight_is_refused(tmp_path: Path) -> None:
    """Nothing could be told of it: no duration, no place."""
    members = sound("flight.npz", tmp_path)
    steps = ("times", "positions", "velocities", "plan_index", "waypoint_index")
    for cut in (steps, ("global_path",)):
        changed = dict(members)
        for name in cut:
            array = np.load(io.BytesIO(members[f"{name}.npy"]))
            changed[f"{name}.npy"] = numbers(array[:0])
        pack(tmp_path / "flight.npz", changed)
        with pytest.raises(ValueError, match=r"flight\.npz.*one step or more"):
            FlightRecord.load(tmp_path / "flight.npz")


def test_paths_of_plans_are_as_long_as_the_record_says(tmp_path: Path) -> None:
    members = sound("flight.npz", tmp_path)
    for lengths in ([2, 3], [-2, 6], [4], [2**62, 2]):
        changed = {**members, "plan_lengths.npy": numbers(np.array(lengths, np.int64))}
        pack(tmp_path / "flight.npz", changed)
        with pytest.raises(ValueError, match=r"flight\.npz is not a flight record"):
            FlightRecord.load(tmp_path / "flight.npz")


# ---- texts --------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "text", ["a = " + "[" * 5000, "a" + ".b" * 20000 + " = 1", "a = " + "{b = " * 3000]
)
def test_deep_nesting_in_a_mission_is_refused_by_name(text: str, tmp_path: Path) -> None:
    path = tmp_path / "mission.toml"
    path.write_text(text)
    with pytest.raises(ValueError, match=r"mission\.toml"):
        MissionConfig.load(path)


def test_the_readers_are_all_there() -> None:
    assert len({reader.name for reader in READERS}) == len(READERS) >= 14
