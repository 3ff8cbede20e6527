# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Is a TIFF file all there? GDAL drops tags that lie beyond the end of a cut file without a word,
and a raster that has lost its no-data tag still reads, wrongly."""

import os
import struct
from pathlib import Path
from typing import IO

import numpy as np

from ..geokeys import GeoKeys

# TIFF 6.0 section 2 and BigTIFF: bytes per value of each field type.
_TYPE_BYTES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8} | {
    13: 4,
    16: 8,
    17: 8,
    18: 8,
}
_UNSIGNED = {1: "u1", 3: "u2", 4: "u4", 13: "u4", 16: "u8", 18: "u8"}
_KEY_TAGS = {34735: (3, "u2"), 34736: (12, "f8"), 34737: (2, "u1")}  # GeoKeys and their values
_MAX_KEY_BYTES = 1 << 20
_BLOCK_TAGS = {273: "strips", 279: "strips", 324: "tiles", 325: "tiles"}  # offsets, byte counts
_MAX_TAGS = 4096


def check_complete(path: Path) -> None:
    """Check that every tag and every block of the first image in `path` lies inside the file.

    Raises:
        ValueError: naming the file, if it is not a TIFF file or has been cut.
    """
    size = path.stat().st_size
    blocks = _tags(path)
    for offset_tag, count_tag in ((273, 279), (324, 325)):
        if offset_tag not in blocks:
            continue
        offsets, counts = blocks[offset_tag], blocks.get(count_tag)
        if counts is None or counts.size != offsets.size:
            raise ValueError(f"{path}: {_BLOCK_TAGS[offset_tag]} without a length each")
        # In floating point, where a hostile offset plus its length cannot wrap round.
        beyond = offsets.astype(np.float64) + counts.astype(np.float64) > size
        if beyond.any():
            raise ValueError(
                f"{path} ends early: {np.count_nonzero(beyond)} of its {offsets.size} "
                f"{_BLOCK_TAGS[offset_tag]} lie beyond its {size} bytes"
            )


def read_geokeys(path: Path) -> GeoKeys | None:
    """The GeoKeys of the first image in `path`; None if it has none.

    Raises:
        ValueError: naming the file, if it is damaged.
    """
    tags = _tags(path)
    if 34735 not in tags:
        return None
    try:
        parts = {
            tag: tags[tag].astype("<" + kind).tobytes()
            for tag, (_, kind) in _KEY_TAGS.items()
            if tag in tags
        }
        return GeoKeys.parse(parts[34735], parts.get(34736, b""), parts.get(34737, b""))
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error


def _tags(path: Path) -> dict[int, np.ndarray]:
    """The tags of the first image that are read here, or a ValueError that names the file."""
    with path.open("rb") as file:
        try:
            return _read_directory(file, path.stat().st_size)
        except (struct.error, EOFError) as error:
            raise ValueError(f"{path} ends early: {error}") from error
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error


def _read_directory(file: IO[bytes], size: int) -> dict[int, np.ndarray]:
    """The numbers of the tags that say where the pixels are, and in which CRS."""
    head = file.read(16)
    order = {b"II": "<", b"MM": ">"}.get(head[:2])
    version = struct.unpack_from(order + "H", head, 2)[0] if order else None
    if order is None or version not in (42, 43):
        raise ValueError(f"not a TIFF file, it starts with {head[:8]!r}")
    big = version == 43
    (start,) = struct.unpack_from(order + ("Q" if big else "I"), head, 8 if big else 4)
    count_format, entry_bytes, inline = ("Q", 20, 8) if big else ("H", 12, 4)
    (n_tags,) = struct.unpack(order + count_format, _read_at(file, start, 8 if big else 2, size))
    if n_tags > _MAX_TAGS:
        raise ValueError(f"expected at most {_MAX_TAGS} tags, its directory says {n_tags}")
    entries = _read_at(file, start + (8 if big else 2), n_tags * entry_bytes, size)
    found = {}
    for position in range(0, len(entries), entry_bytes):
        tag, kind = struct.unpack_from(order + "HH", entries, position)
        (number,) = struct.unpack_from(order + ("Q" if big else "I"), entries, position + 4)
        n_bytes = number * _TYPE_BYTES.get(kind, 0)
        value = position + entry_bytes - inline
        if n_bytes <= inline:
            data = entries[value : value + n_bytes]
        else:
            (offset,) = struct.unpack_from(order + ("Q" if big else "I"), entries, value)
            if offset + n_bytes > size:
                raise EOFError(f"tag {tag} lies beyond its {size} bytes")
            wanted = tag in _BLOCK_TAGS or (tag in _KEY_TAGS and n_bytes <= _MAX_KEY_BYTES)
            data = _read_at(file, offset, n_bytes, size) if wanted else b""
        if tag in _BLOCK_TAGS:
            if kind not in _UNSIGNED:
                raise ValueError(f"tag {tag} has field type {kind}, expected an unsigned integer")
            found[tag] = np.frombuffer(data, dtype=order + _UNSIGNED[kind])
        elif tag in _KEY_TAGS and kind == _KEY_TAGS[tag][0]:
            found[tag] = np.frombuffer(data, dtype=order + _KEY_TAGS[tag][1])
    return found


def _read_at(file: IO[bytes], offset: int, n_bytes: int, size: int) -> bytes:
    if offset + n_bytes > size:
        raise EOFError(f"expected {n_bytes} bytes at {offset}, it has {size} in all")
    file.seek(offset, os.SEEK_SET)
    return file.read(n_bytes)
