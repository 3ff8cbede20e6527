# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The file of a world: one .npz without pickle, byte for byte repeatable, read with distrust."""

import contextlib
import errno
import json
import math
import os
import re
import struct
import zipfile
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from ltp.files import atomic_write

FORMAT = "ltp.world"
VERSION = 1

#: Largest world that is read [cells]: 10 km x 10 km at 1 m, 1.7 GB in memory.
MAX_CELLS = 100_000_000
_MAX_METADATA = 1 << 16  # bytes of JSON
_MAX_HEADER = 4096  # bytes of an .npy header; ours have 128
_MAX_DEFLATE_RATIO = 1032  # what deflate can reach at most; more is a lie in the directory
_CHUNK = 1 << 20

_HEADER = re.compile(
    rb"\{'descr': '(?P<dtype>[<>|=]\w{1,8})', 'fortran_order': False, "
    rb"'shape': \((?P<shape>\d{1,12},(?: \d{1,12})?)\), \} *\n"
)

_ARRAYS: dict[str, np.dtype[Any]] = {
    "ground": np.dtype("<f8"),
    "surface": np.dtype("<f8"),
    "classes": np.dtype("u1"),
}
_METADATA = "metadata"
_DATUM = ("crs", "easting", "northing", "vertical")

# What zipfile, zlib, numpy and json raise on garbage. A real I/O error is an OSError and goes on.
_GARBAGE = (
    zipfile.BadZipFile,
    zlib.error,
    EOFError,
    NotImplementedError,
    RuntimeError,
    ValueError,
    LookupError,
    OverflowError,
    struct.error,
)


def write_fields(fields: Mapping[str, Any], path: str | os.PathLike[str]) -> None:
    """Write a world to `path` atomically; no time stamp or machine name enters the file.

    Args:
        fields: those of a world by name, its datum as such a mapping too.
        path: of the file.

    Raises:
        OSError: if the file cannot be written; whatever stood under `path` is then untouched.
        ValueError: if name, attribution and report are too long.
    """
    metadata = {
        "format": FORMAT,
        "version": VERSION,
        "name": fields["name"],
        "cell": fields["cell"],
        "origin": list(fields["origin"]),
        "datum": {name: fields["datum"][name] for name in _DATUM},
        "attribution": fields["attribution"],
    }
    if fields["report"]:  # without one the file can be read by ltp 0.2.0, too
        metadata["report"] = list(fields["report"])
    text = json.dumps(metadata, indent=1).encode()
    if len(text) > _MAX_METADATA:
        raise ValueError(f"name, attribution and report must fit in {_MAX_METADATA} bytes of JSON")
    arrays: dict[str, NDArray[Any]] = {_METADATA: np.frombuffer(text, dtype=np.uint8)}
    arrays |= {name: fields[name].astype(dtype) for name, dtype in _ARRAYS.items()}
    with atomic_write(path) as file, zipfile.ZipFile(file, "w") as archive:
        for name, array in arrays.items():
            member = zipfile.ZipInfo(f"{name}.npy", date_time=(1980, 1, 1, 0, 0, 0))
            member.compress_type = zipfile.ZIP_DEFLATED
            member.create_system = 3  # the same bytes on every system
            member.external_attr = 0o644 << 16
            with archive.open(member, "w", force_zip64=True) as stream:
                npy.write_array(stream, array, version=(1, 0), allow_pickle=False)


def read_fields(path: str | os.PathLike[str]) -> dict[str, Any]:
    """What `write_fields` wrote; every size is checked before anything is decompressed.

    Shapes, types and names are as they must be; whether the values make a world, `World` decides.

    Raises:
        OSError: if the file cannot be opened or read.
        ValueError: naming the file and the culprit, if it is not a sound world file.
    """
    with Path(path).open("rb") as file, blamed_on(path):
        return _read(file)


@contextlib.contextmanager
def blamed_on(path: str | os.PathLike[str]) -> Iterator[None]:
    """Turn whatever is raised on garbage into a `ValueError` that names the file."""
    try:
        yield
    except _GARBAGE as error:
        raise ValueError(f"{path} is not a sound world file: {error}") from error
    except OSError as error:
        if error.errno != errno.EINVAL:  # EINVAL: a directory that points before the file
            raise
        raise ValueError(f"{path} is not a sound world file: {error}") from error


def _read(file: IO[bytes]) -> dict[str, Any]:
    with zipfile.ZipFile(file) as archive:
        members = _members(archive)
        text = _read_array(archive, members[_METADATA], np.dtype("u1"), None, _MAX_METADATA)
        metadata = _parse(text.tobytes())
        shape: tuple[int, ...] | None = None
        arrays: dict[str, Any] = {}
        for name, dtype in _ARRAYS.items():
            arrays[name] = _read_array(archive, members[name], dtype, shape, MAX_CELLS)
            shape = arrays[name].shape
    return {**metadata, **arrays}


def _members(archive: zipfile.ZipFile) -> dict[str, zipfile.ZipInfo]:
    wanted = {_METADATA, *_ARRAYS}
    found: dict[str, zipfile.ZipInfo] = {}
    for member in archive.infolist():
        name = member.filename.removesuffix(".npy")
        if name not in wanted or name in found:
            raise ValueError(f"unexpected member {member.filename!r}")
        if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
            raise ValueError(f"{name}: unexpected compression method {member.compress_type}")
        if member.file_size > _MAX_DEFLATE_RATIO * member.compress_size + _MAX_HEADER:
            raise ValueError(f"{name}: {member.compress_size} bytes cannot hold {member.file_size}")
        found[name] = member
    if missing := sorted(wanted - found.keys()):
        raise ValueError(f"missing {', '.join(missing)}")
    return found


def _read_array(
    archive: zipfile.ZipFile,
    member: zipfile.ZipInfo,
    dtype: np.dtype[Any],
    shape: tuple[int, ...] | None,
    max_size: int,
) -> NDArray[Any]:
    name = member.filename.removesuffix(".npy")
    with archive.open(member) as stream:
        found_dtype, found_shape = _read_header(name, stream)
        if found_dtype != dtype:
            raise ValueError(f"{name}: expected dtype {dtype.str}, found {found_dtype}")
        if len(found_shape) != (1 if name == _METADATA else 2):
            raise ValueError(f"{name}: unexpected shape {found_shape}")
        if shape is not None and found_shape != shape:
            raise ValueError(f"{name}: expected shape {shape}, found {found_shape}")
        size = math.prod(found_shape)
        if not 0 < size <= max_size:
            raise ValueError(f"{name}: shape {found_shape} is not within 1...{max_size} elements")
        declared = member.file_size - stream.tell()
        if declared != size * dtype.itemsize:
            raise ValueError(f"{name}: shape {found_shape} does not fit its {declared} bytes")
        array = np.empty(found_shape, dtype)
        _fill(name, stream, array.reshape(-1).view(np.uint8).data)
        if stream.read(1):  # also makes zipfile compare the checksum
            raise ValueError(f"{name}: more data than declared")
    return array


def _read_header(name: str, stream: IO[bytes]) -> tuple[str, tuple[int, ...]]:
    """dtype and shape of an .npy header, by pattern: numpy's own reader evaluates the text."""
    start = stream.read(10)
    length = int.from_bytes(start[8:], "little")
    if start[:8] != b"\x93NUMPY\x01\x00" or length > _MAX_HEADER:
        raise ValueError(f"{name}: not an .npy array of version 1.0")
    text = stream.read(length)
    match = _HEADER.fullmatch(text)
    if not match:
        raise ValueError(f"{name}: expected a plain array in C order, found header {text[:120]!r}")
    shape = tuple(int(number) for number in match["shape"].replace(b",", b" ").split())
    return match["dtype"].decode(), shape


def _fill(name: str, stream: IO[bytes], into: memoryview) -> None:
    position = 0
    while position < len(into):
        chunk = stream.read(min(_CHUNK, len(into) - position))
        if not chunk:
            raise ValueError(f"{name}: ends {len(into) - position} bytes early")
        into[position : position + len(chunk)] = chunk
        position += len(chunk)


def _parse(text: bytes) -> dict[str, Any]:
    """The fields in the JSON text, datum included; their values are not checked."""
    metadata = json.loads(text)
    if not isinstance(metadata, dict) or metadata.pop("format", None) != FORMAT:
        raise ValueError(f"metadata: expected format {FORMAT!r}")
    if (version := metadata.pop("version", None)) != VERSION:
        raise ValueError(f"metadata: expected version {VERSION}, found {version!r}")
    expected = {"name", "cell", "origin", "datum", "attribution"}
    if metadata.keys() - {"report"} != expected:
        raise ValueError(f"metadata: expected keys {sorted(expected)}, found {sorted(metadata)}")
    datum = metadata["datum"]
    if not isinstance(datum, dict) or datum.keys() != set(_DATUM):
        raise ValueError(f"metadata: expected a datum, found {datum!r}")
    return metadata
