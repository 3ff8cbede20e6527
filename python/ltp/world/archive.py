# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The file of a world: one .npz without pickle, byte for byte repeatable, read with distrust."""

import json
import os
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib import format as npy
from numpy.typing import NDArray

from ltp.files import atomic_write, blamed_on
from ltp.files.npz import NpzReader

FORMAT = "ltp.world"
VERSION = 1

#: Largest world that is read [cells]: 10 km x 10 km at 1 m, 1.7 GB in memory.
MAX_CELLS = 100_000_000
_MAX_METADATA = 1 << 16  # bytes of JSON
_MAX_BYTES = 17 * MAX_CELLS + _MAX_METADATA
_ARRAYS: dict[str, np.dtype[Any]] = {
    "ground": np.dtype("<f8"),
    "surface": np.dtype("<f8"),
    "classes": np.dtype("u1"),
}
_METADATA = "metadata"
_DATUM = ("crs", "easting", "northing", "vertical")

#: What a file of a world is, for messages.
SOUND = "a sound world file"


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
    with Path(path).open("rb") as file, blamed_on(path, SOUND):
        reader = NpzReader(file, _MAX_BYTES)
        reader.expect({_METADATA, *_ARRAYS})
        metadata = _checked(reader.json(_METADATA, _MAX_METADATA))
        shape: tuple[int | None, ...] = (None, None)
        arrays: dict[str, Any] = {}
        for name, dtype in _ARRAYS.items():
            arrays[name] = reader.array(name, dtype.str, shape, MAX_CELLS)
            shape = arrays[name].shape
    return {**metadata, **arrays}


def _checked(metadata: dict[str, Any]) -> dict[str, Any]:
    """The fields among the metadata, datum included; their values are not checked."""
    if metadata.pop("format", None) != FORMAT:
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
