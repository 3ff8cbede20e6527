# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world is checked when it is made, and survives its file; a bad file is refused by name."""

import errno
import io
import json
import os
import pickle
import tracemalloc
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp

import ltp
from ltp.world import Datum, LandClass, World


def small_world(**changes: Any) -> World:
    rng = np.random.default_rng(3)
    ground = rng.normal(20.0, 3.0, (7, 5))
    arguments: dict[str, Any] = {
        "name": "test hill",
        "ground": ground,
        "surface": ground + rng.uniform(0.0, 30.0, (7, 5)),
        "classes": rng.integers(0, 15, (7, 5)),
        "cell": 2.0,
        "origin": (10.0, -4.0),
        "datum": Datum("EPSG:27700", 531999.0, 181359.0, "ODN"),
        "attribution": "nobody, CC0",
        "report": ("3 houses read", "1 height guessed"),
    }
    return World(**{**arguments, **changes})


def assert_same(a: World, b: World) -> None:
    for name in ("ground", "surface", "classes"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name))
        assert getattr(a, name).dtype == getattr(b, name).dtype
    for name in ("name", "cell", "origin", "datum", "attribution", "report"):
        assert getattr(a, name) == getattr(b, name)


# --- what a world is ---


def test_axes_extent_and_heights() -> None:
    world = small_world()
    assert world.shape == (7, 5)
    assert world.extent == (10.0, -4.0, 24.0, 6.0)
    np.testing.assert_array_equal(world.height_above_ground, world.surface - world.ground)


def test_rasters_keep_values_and_frame() -> None:
    world = small_world()
    for raster, values in (
        (world.surface_raster(), world.surface),
        (world.ground_raster(), world.ground),
    ):
        assert isinstance(raster, ltp.Raster)
        np.testing.assert_array_equal(raster.values, values)
        assert tuple(raster.origin) == world.origin
        assert raster.cell == world.cell


def test_arrays_are_copies_and_read_only() -> None:
    ground = np.zeros((3, 4))
    world = small_world(ground=ground, surface=ground + 1.0, classes=ground.astype(int))
    ground[1, 1] = 9.0
    assert world.ground[1, 1] == 0.0
    for array in (world.ground, world.surface, world.classes):
        assert array.flags.c_contiguous
        with pytest.raises(ValueError, match="read-only"):
            array[0, 0] = 1
    assert world.classes.dtype == np.uint8


def test_a_transposed_view_is_stored_in_c_order() -> None:
    ground = np.arange(12.0).reshape(3, 4).T
    world = small_world(ground=ground, surface=ground, classes=np.zeros((4, 3), int))
    assert world.ground.flags.c_contiguous
    np.testing.assert_array_equal(world.ground, ground)


def test_pickling_keeps_the_arrays_read_only() -> None:
    world = small_world()
    copy = pickle.loads(pickle.dumps(world))
    assert_same(copy, world)
    assert not copy.surface.flags.writeable


def test_surface_below_ground_is_refused_beyond_rounding() -> None:
    ground = np.full((3, 3), 5.0)
    classes = np.zeros((3, 3), int)
    world = small_world(ground=ground, surface=ground - 1e-7, classes=classes)
    np.testing.assert_array_equal(world.surface, world.ground)
    surface = ground.copy()
    surface[2, 1] = 4.9
    with pytest.raises(ValueError, match=r"surface.*ground.*surface\[2, 1\] = 4.9"):
        small_world(ground=ground, surface=surface, classes=classes)


def with_value(value: float) -> np.ndarray:
    heights = np.full((7, 5), 100.0)
    heights[4, 2] = value
    return heights


BAD = [
    ({"ground": np.zeros(5)}, "ground must have shape"),
    ({"ground": np.zeros((0, 5))}, "ground must have shape"),
    ({"ground": np.zeros((7, 5, 1))}, "ground must have shape"),
    ({"ground": [[1.0], [1.0, 2.0]]}, "ground"),
    ({"ground": np.zeros((7, 5), complex)}, "ground must hold heights"),
    ({"ground": np.full((7, 5), "high")}, "ground must hold heights"),
    ({"ground": np.zeros((7, 5), object)}, "ground must hold heights"),
    ({"ground": None}, "ground must hold heights"),
    ({"ground": np.ma.masked_less(with_value(-9999.0), 0.0)}, "ground must hold .* 1 are masked"),
    ({"ground": with_value(np.nan)}, r"ground must be finite.*ground\[4, 2\] is nan"),
    ({"surface": with_value(np.inf)}, r"surface must be finite.*surface\[4, 2\] is inf"),
    ({"surface": np.full((7, 6), 90.0)}, r"surface must have the shape of ground, \(7, 5\)"),
    ({"classes": np.zeros((5, 7), int)}, "classes must have the shape of ground"),
    ({"classes": np.zeros((7, 5))}, "classes must hold LandClass numbers, not dtype float64"),
    ({"classes": np.zeros((7, 5), bool)}, "classes must hold LandClass numbers"),
    ({"classes": np.full((7, 5), 15)}, "classes must lie in 0...14"),
    ({"classes": np.full((7, 5), -1)}, "classes must lie in 0...14"),
    ({"classes": np.full((7, 5), 257)}, "classes must lie in 0...14"),
    ({"cell": 0.0}, "cell must be above zero, not 0.0"),
    ({"cell": -1.0}, "cell must be above zero"),
    ({"cell": 1e-9, "origin": (1e9, 0.0)}, "cell must be an edge by which cells differ"),
    ({"origin": (0.0, 1e300)}, "cell must be an edge by which cells differ"),
    ({"cell": np.nan}, "cell must be a finite number"),
    ({"cell": "1"}, "cell must be a finite number"),
    ({"cell": None}, "cell must be a number"),
    ({"cell": 10**400}, "cell must be a number"),
    ({"origin": (0.0, np.inf)}, r"origin\[1\] must be a finite number"),
    ({"origin": 3.0}, "origin must be two numbers"),
    ({"origin": (1.0, 2.0, 3.0)}, "origin must be two numbers"),
    ({"name": 7}, "name must be a string"),
    ({"attribution": None}, "attribution must be a string"),
    ({"report": "all well"}, "report must be a sequence of strings"),
    ({"report": ["read", 3]}, r"report\[1\] must be a string"),
    ({"datum": "EPSG:2154"}, "datum must be a Datum"),
]


@pytest.mark.parametrize(("changes", "message"), BAD)
def test_a_bad_argument_is_named(changes: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        small_world(**changes)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"crs": 27700}, "datum.crs must be a string"),
        ({"easting": np.nan}, "datum.easting must be a finite number"),
        ({"northing": "far"}, "datum.northing must be a finite number"),
        ({"vertical": None}, "datum.vertical must be a string"),
    ],
)
def test_a_bad_datum_is_named(arguments: dict[str, Any], message: str) -> None:
    with pytest.raises(ValueError, match=message):
        Datum(**arguments)


# --- its file ---

numbers = st.floats(-1e6, 1e6, allow_nan=False)


@st.composite
def worlds(draw: st.DrawFn) -> World:
    shape = draw(hnp.array_shapes(min_dims=2, max_dims=2, max_side=9))
    ground = draw(hnp.arrays(np.float64, shape, elements=numbers))
    rise = draw(hnp.arrays(np.float64, shape, elements=st.floats(0.0, 500.0)))
    classes = draw(hnp.arrays(np.uint8, shape, elements=st.integers(0, max(LandClass))))
    return World(
        name=draw(st.text()),
        ground=ground,
        surface=ground + rise,
        classes=classes,
        cell=draw(st.floats(0.01, 100.0)),
        origin=(draw(numbers), draw(numbers)),
        datum=Datum(draw(st.none() | st.text()), draw(numbers), draw(numbers), draw(st.text())),
        attribution=draw(st.text()),
    )


@given(world=worlds())
@settings(
    max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
def test_a_world_survives_its_file(tmp_path: Path, world: World) -> None:
    path = tmp_path / "world.npz"
    world.save(path)
    assert_same(World.load(path), world)


def test_the_same_world_gives_the_same_bytes(tmp_path: Path) -> None:
    small_world().save(tmp_path / "a.npz")
    small_world().save(str(tmp_path / "b.npz"))
    assert (tmp_path / "a.npz").read_bytes() == (tmp_path / "b.npz").read_bytes()
    with zipfile.ZipFile(tmp_path / "a.npz") as archive:
        assert {member.date_time for member in archive.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_numpy_reads_the_file_without_pickle(tmp_path: Path) -> None:
    world = small_world()
    world.save(tmp_path / "world.npz")
    with np.load(tmp_path / "world.npz", allow_pickle=False) as arrays:
        np.testing.assert_array_equal(arrays["surface"], world.surface)
        assert json.loads(arrays["metadata"].tobytes())["version"] == 1


def test_a_full_disk_keeps_the_old_world(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_: int) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    path = tmp_path / "world.npz"
    small_world().save(path)
    with monkeypatch.context() as patch:
        patch.setattr(os, "fsync", fail)
        with pytest.raises(OSError, match=r"No space left on device: .*world\.npz"):
            small_world(name="new").save(path)
    assert_same(World.load(path), small_world())
    assert list(tmp_path.iterdir()) == [path]


def test_a_missing_file_is_an_os_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError, match=r"nothing\.npz"):
        World.load(tmp_path / "nothing.npz")


# --- files that lie ---


def header(array: np.ndarray) -> bytes:
    stream = io.BytesIO()
    np.lib.format.write_array(stream, array, version=(1, 0))
    return stream.getvalue()


def good_members() -> dict[str, bytes]:
    stream = io.BytesIO()
    world = small_world()
    metadata = {
        "format": "ltp.world",
        "version": 1,
        "name": world.name,
        "cell": world.cell,
        "origin": world.origin,
        "datum": {"crs": None, "easting": 0.0, "northing": 0.0, "vertical": "local"},
        "attribution": "",
    }
    stream.write(json.dumps(metadata).encode())
    return {
        "metadata.npy": header(np.frombuffer(stream.getvalue(), np.uint8)),
        "ground.npy": header(world.ground),
        "surface.npy": header(world.surface),
        "classes.npy": header(world.classes),
    }


def write_members(
    path: Path, members: dict[str, bytes], method: int = zipfile.ZIP_DEFLATED
) -> None:
    with zipfile.ZipFile(path, "w", method) as archive:
        for name, data in members.items():
            archive.writestr(name, data)


def edit_metadata(**changes: Any) -> bytes:
    data = good_members()["metadata.npy"]
    metadata = json.loads(data[data.index(b"{", 80) :])
    metadata.update(changes)
    metadata = {key: value for key, value in metadata.items() if value is not ...}
    return header(np.frombuffer(json.dumps(metadata).encode(), np.uint8))


def claim_shape(shape: str, data: bytes) -> bytes:
    text = f"{{'descr': '<f8', 'fortran_order': False, 'shape': {shape}, }}".ljust(117) + "\n"
    return b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text.encode() + data


def test_the_good_members_are_good(tmp_path: Path) -> None:
    path = tmp_path / "good.npz"
    for method in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        write_members(path, good_members(), method)
        np.testing.assert_array_equal(World.load(path).surface, small_world().surface)


GROUND = small_world().ground
LIES: list[tuple[dict[str, bytes | None], str]] = [
    ({"surface.npy": None}, "missing surface"),
    ({"metadata.npy": None}, "missing metadata"),
    ({"extra.npy": b""}, "unexpected member 'extra.npy'"),
    ({"../ground.npy": b""}, "unexpected member"),
    ({"ground.npy": header(GROUND.astype(np.float32))}, "ground: expected dtype <f8, found <f4"),
    ({"ground.npy": header(GROUND.astype(">f8"))}, "ground: expected dtype <f8, found >f8"),
    ({"ground.npy": header(GROUND.T)}, r"surface: expected shape \(5, 7\)"),
    ({"ground.npy": header(GROUND.astype([("a", "<f8")]))}, "ground: expected a plain array"),
    ({"ground.npy": header(GROUND[None])}, r"ground: unexpected shape \(1, 7, 5\)"),
    ({"ground.npy": header(GROUND[0])}, r"ground: unexpected shape \(5,\)"),
    ({"ground.npy": header(GROUND[:0])}, r"surface: expected shape \(0, 5\)"),
    ({"ground.npy": header(np.where(GROUND > 21, np.nan, GROUND))}, "ground must be finite"),
    ({"ground.npy": header(GROUND)[:60]}, "ground"),
    ({"ground.npy": header(GROUND)[:-8]}, "ground: shape .* does not fit"),
    ({"ground.npy": header(GROUND) + b"more"}, "ground: shape .* does not fit"),
    ({"ground.npy": b""}, "ground: not an .npy array"),
    ({"ground.npy": b"\x93NUMPY\x02\x00" + bytes(20)}, "ground: not an .npy array"),
    ({"ground.npy": claim_shape("(999999999999, 99999)", GROUND.tobytes())}, "ground: shape"),
    ({"ground.npy": claim_shape("(10000, 10000)", GROUND.tobytes())}, "ground: .*does not fit"),
    ({"ground.npy": claim_shape("(-7, -5)", GROUND.tobytes())}, "ground: expected a plain array"),
    ({"ground.npy": claim_shape("(7, __import__('os'))", b"")}, "ground: expected a plain array"),
    ({"surface.npy": header(GROUND[:6])}, r"surface: expected shape \(7, 5\), found \(6, 5\)"),
    ({"surface.npy": header(GROUND - 1.0)}, "surface must not lie below ground"),
    ({"classes.npy": header(np.full((7, 5), 77, np.uint8))}, "classes must lie in 0...14"),
    ({"metadata.npy": header(np.frombuffer(b"{", np.uint8))}, "Expecting property name"),
    ({"metadata.npy": header(np.frombuffer(b"[" * 50_000, np.uint8))}, "recursion"),
    ({"metadata.npy": header(np.frombuffer(b"\xff\xfe\xfd", np.uint8))}, "codec"),
    ({"metadata.npy": header(np.zeros(70_000, np.uint8))}, "metadata: shape"),
    ({"metadata.npy": edit_metadata(format="other")}, "metadata: expected format 'ltp.world'"),
    ({"metadata.npy": edit_metadata(version=2)}, "metadata: expected version 1, found 2"),
    ({"metadata.npy": edit_metadata(cell=...)}, "metadata: expected keys"),
    ({"metadata.npy": edit_metadata(cell=-1)}, "cell must be above zero"),
    ({"metadata.npy": edit_metadata(cell=float("nan"))}, "cell must be a finite number"),
    ({"metadata.npy": edit_metadata(surprise=1)}, "metadata: expected keys"),
    ({"metadata.npy": edit_metadata(datum=None)}, "metadata: expected a datum"),
    ({"metadata.npy": edit_metadata(origin=[0])}, "origin must be two numbers"),
]


@pytest.mark.parametrize(("changes", "message"), LIES)
def test_a_lying_file_is_refused_by_name(
    tmp_path: Path, changes: dict[str, bytes | None], message: str
) -> None:
    members = {**good_members(), **changes}
    path = tmp_path / "liar.npz"
    write_members(path, {name: data for name, data in members.items() if data is not None})
    with pytest.raises(ValueError, match=rf"liar\.npz is not a sound world file: .*{message}"):
        World.load(path)


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_compressions_are_refused(tmp_path: Path, method: int) -> None:
    path = tmp_path / "liar.npz"
    write_members(path, good_members(), method)
    with pytest.raises(ValueError, match="unexpected compression method"):
        World.load(path)


def test_a_member_that_comes_twice_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "liar.npz"
    write_members(path, good_members())
    with (
        pytest.warns(UserWarning, match="Duplicate"),
        zipfile.ZipFile(path, "a") as archive,
    ):
        archive.writestr("ground.npy", good_members()["ground.npy"])
    with pytest.raises(ValueError, match=r"unexpected member 'ground\.npy'"):
        World.load(path)


class Trap:
    """Creates a file when it is unpickled."""

    def __init__(self, path: Path) -> None:
        self.path = path

    def __reduce__(self) -> tuple[Any, ...]:
        return os.mkdir, (str(self.path),)


def test_nothing_is_unpickled(tmp_path: Path) -> None:
    path, sprung = tmp_path / "trap.npz", tmp_path / "sprung"
    trap = np.array([[Trap(sprung)]], dtype=object)
    arrays = {"metadata": trap, "ground": trap, "surface": trap, "classes": trap}
    np.savez(path, **arrays)
    with pytest.raises(ValueError, match=r"trap\.npz"):
        World.load(path)
    path.write_bytes(pickle.dumps(Trap(sprung)))
    with pytest.raises(ValueError, match=r"trap\.npz"):
        World.load(path)
    assert not sprung.exists()


def test_sizes_are_checked_before_anything_is_unpacked(tmp_path: Path) -> None:
    path = tmp_path / "bomb.npz"
    bombs = (
        {"metadata.npy": header(np.zeros(60_000_000, np.uint8))},
        {"ground.npy": claim_shape("(99999, 99999)", bytes(60_000_000))},
        {"surface.npy": claim_shape("(2739, 2739)", bytes(2739 * 2739 * 8))},
    )
    for bomb in bombs:
        write_members(path, {**good_members(), **bomb})
        tracemalloc.start()
        try:
            with pytest.raises(ValueError, match="shape"):
                World.load(path)
            _, peak = tracemalloc.get_traced_memory()
        finally:
            tracemalloc.stop()
        assert peak < 4_000_000


def test_a_directory_that_promises_too_much_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "bomb.npz"
    members = {**good_members(), "ground.npy": claim_shape("(10000, 10000)", bytes(8))}
    write_members(path, members)
    data = bytearray(path.read_bytes())
    size = len(members["ground.npy"]).to_bytes(4, "little")
    forged = (len(members["ground.npy"]) - 8 + 800_000_000).to_bytes(4, "little")
    data = data.replace(size, forged)
    path.write_bytes(data)
    with pytest.raises(ValueError, match=r"ground: .* bytes cannot hold"):
        World.load(path)


def test_a_truncated_file_is_refused_wherever_it_ends(tmp_path: Path) -> None:
    path = tmp_path / "cut.npz"
    small_world().save(path)
    data = path.read_bytes()
    for length in range(0, len(data), 7):
        path.write_bytes(data[:length])
        with pytest.raises(ValueError, match=r"cut\.npz is not a sound world file"):
            World.load(path)


def test_a_flipped_byte_is_found_or_harmless(tmp_path: Path) -> None:
    path = tmp_path / "flipped.npz"
    world = small_world()
    world.save(path)
    data = path.read_bytes()
    rng = np.random.default_rng(5)
    refused = 0
    positions = range(0, len(data), 3)
    for position in positions:
        flipped = bytearray(data)
        flipped[position] ^= int(rng.integers(1, 256))
        path.write_bytes(flipped)
        try:
            loaded = World.load(path)
        except ValueError as error:
            assert "flipped.npz" in str(error)
            refused += 1
        else:
            assert_same(loaded, world)  # a time stamp, say
    assert refused > 0.8 * len(positions)


@given(data=st.binary(max_size=300))
@settings(
    max_examples=100, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture]
)
def test_noise_is_refused(tmp_path: Path, data: bytes) -> None:
    path = tmp_path / "noise.npz"
    path.write_bytes(data)
    with pytest.raises(ValueError, match=r"noise\.npz"):
        World.load(path)
