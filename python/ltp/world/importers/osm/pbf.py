# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A look at the frames of a .osm.pbf file before osmium reads it: sizes, and zeros within texts.

libosmium ends its texts with a zero byte, and reads on beyond its memory where a file has put one
inside of a text (https://wiki.openstreetmap.org/wiki/PBF_Format describes the frames).
"""

import zlib
from collections.abc import Iterator
from pathlib import Path
from typing import BinaryIO

_LARGEST_HEADER, _LARGEST_BLOB = 64 * 1024, 32 * 1024 * 1024  # the format's own limits [bytes]
_VARINT, _LONG, _BYTES, _SHORT = 0, 1, 2, 5  # protocol buffers' kinds of fields


def check_frames(path: Path) -> None:
    """Refuse a file that is cut within a frame, or holds a text with a zero byte in it.

    Raises:
        ValueError: saying what is wrong, without the name of the file.
    """
    with path.open("rb") as file:
        while head := file.read(4):
            kind, size = _header(_exactly(file, int.from_bytes(head, "big"), _LARGEST_HEADER))
            blob = _exactly(file, size, _LARGEST_BLOB)
            if kind == b"OSMData":
                _check_texts(_content(blob))


def _exactly(file: BinaryIO, size: int, most: int) -> bytes:
    if size > most:
        raise ValueError(f"a frame claims {size} bytes, more than {most}")
    data = file.read(size)
    if len(data) < size:
        raise ValueError("it is cut within a frame")
    return data


def _header(data: bytes) -> tuple[bytes, int]:
    kind, size = b"", 0
    for number, value in _fields(data):
        if number == 1 and isinstance(value, bytes):
            kind = value
        elif number == 3 and isinstance(value, int):
            size = value
    return kind, size


def _content(blob: bytes) -> bytes:
    for number, value in _fields(blob):
        if number == 1 and isinstance(value, bytes):
            return value
        if number == 3 and isinstance(value, bytes):
            inflater = zlib.decompressobj()
            data = inflater.decompress(value, _LARGEST_BLOB)
            if inflater.unconsumed_tail:
                raise ValueError(f"a blob inflates to more than {_LARGEST_BLOB} bytes")
            return data
        if isinstance(value, bytes):
            raise ValueError("its blobs are compressed by something other than zlib")
    raise ValueError("a blob holds no data")


def _check_texts(block: bytes) -> None:
    for number, table in _fields(block):
        if number == 1 and isinstance(table, bytes) and table.count(0) > 1:  # one: the empty text
            for _, text in _fields(table):
                if isinstance(text, bytes) and 0 in text:
                    raise ValueError("a text holds a zero byte")


def _fields(data: bytes) -> Iterator[tuple[int, int | bytes]]:
    """Number and value of each field of a message."""
    at = 0
    while at < len(data):
        key, at = _varint(data, at)
        kind = key & 7
        if kind == _VARINT:
            value, at = _varint(data, at)
            yield key >> 3, value
            continue
        if kind == _BYTES:
            size, at = _varint(data, at)
        elif kind in (_LONG, _SHORT):
            size = 8 if kind == _LONG else 4
        else:
            raise ValueError(f"a field of unknown kind {kind}")
        if at + size > len(data):
            raise ValueError("a field is longer than its message")
        yield key >> 3, data[at : at + size]
        at += size


def _varint(data: bytes, at: int) -> tuple[int, int]:
    value = 0
    for shift in range(0, 70, 7):
        if at >= len(data):
            raise ValueError("a number is cut")
        value |= (data[at] & 0x7F) << shift
        at += 1
        if data[at - 1] < 0x80:
            return value, at
    raise ValueError("a number is too long")
