# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Are the chunks of a LAZ file all there? The decoder makes room by what they declare, gigabytes
if need be, and stops the thread where the record about them contradicts the points."""

import struct
from dataclasses import dataclass
from typing import IO

_SMALLEST_RECORD = 34  # bytes of a LASzip record without items
_ITEM_BYTES = 6
_CHUNKED, _LAYERED = 2, 3  # compressors; all others are not in use
_VARIABLE = 0xFFFFFFFF  # points per chunk, where every chunk says its own
_BYTES, _BYTES_LAYERED = 0, 14  # item types of any size
# Item type: bytes of the item in a point, and layers of it in a chunk.
_CHUNKED_ITEMS = {6: (20, 0), 7: (8, 0), 8: (6, 0), 9: (29, 0)}
_LAYERED_ITEMS = {10: (30, 9), 11: (6, 1), 12: (8, 2), 13: (29, 1)}
# LASzip packs a point of a survey into some ten bytes; a thousand points into one byte is a lie.
_MAX_POINTS_PER_BYTE = 1000


@dataclass(frozen=True)
class LaszipRecord:
    """How the points of a LAZ file are packed."""

    layered: bool
    chunk_points: int  # points per chunk; 2**32 - 1 if they differ
    n_layers: int

    @staticmethod
    def parse(data: bytes, point_bytes: int) -> "LaszipRecord":
        """Read the record of LASzip; raise ValueError if it does not fit the points."""
        if len(data) < _SMALLEST_RECORD:
            raise ValueError(f"a LASzip record of {len(data)} B is too small")
        compressor, coder = struct.unpack_from("<HH", data)
        (chunk_points,) = struct.unpack_from("<I", data, 12)
        (n_items,) = struct.unpack_from("<H", data, 32)
        if compressor not in (_CHUNKED, _LAYERED) or coder != 0 or chunk_points == 0:
            raise ValueError(f"unknown LASzip packing {(compressor, coder, chunk_points)}")
        if len(data) < _SMALLEST_RECORD + n_items * _ITEM_BYTES:
            raise ValueError(f"a LASzip record of {len(data)} B cannot name {n_items} items")
        layered = compressor == _LAYERED
        known = _LAYERED_ITEMS if layered else _CHUNKED_ITEMS
        any_size = _BYTES_LAYERED if layered else _BYTES
        n_bytes = n_layers = 0
        for i in range(n_items):
            at = _SMALLEST_RECORD + i * _ITEM_BYTES
            kind, size, version = struct.unpack_from("<HHH", data, at)
            if kind == any_size:
                n_layers += size if layered else 0
            elif known.get(kind, (0, 0))[0] == size:
                n_layers += known[kind][1]
            else:
                raise ValueError(f"unknown LASzip item of type {kind}, {size} B")
            if version not in ((3, 4) if layered else (1, 2)):
                raise ValueError(f"unknown version {version} of LASzip item {kind}")
            n_bytes += size
        if n_bytes != point_bytes or n_items == 0:
            raise ValueError(f"LASzip items of {n_bytes} B do not make points of {point_bytes} B")
        return LaszipRecord(layered, chunk_points, n_layers)


def check_chunks(
    file: IO[bytes], record: LaszipRecord, start: int, n_points: int, point_bytes: int, size: int
) -> None:
    """Check the table of chunks and the chunks themselves, from byte `start` of a file on.

    Raises:
        ValueError, EOFError: saying what does not fit.
    """
    if n_points > (size - start) * _MAX_POINTS_PER_BYTE:
        raise EOFError(f"{n_points} points cannot fit the {size - start} B left")
    file.seek(start)
    (table,) = struct.unpack("<q", file.read(8))
    if table == -1:  # written by a stream; the place then stands at the end of the file
        file.seek(-8, 2)
        (table,) = struct.unpack("<q", file.read(8))
    if not start + 8 <= table <= size - 8:
        raise EOFError(f"the table of chunks at {table} lies outside the file of {size} B")
    file.seek(table + 4)
    (n_chunks,) = struct.unpack("<I", file.read(4))
    variable = record.chunk_points == _VARIABLE
    most = n_points if variable else -(-n_points // record.chunk_points) + 1
    if n_chunks > most or n_chunks > size:
        raise ValueError(f"a table of {n_chunks} chunks does not go with {n_points} points")
    if record.layered:
        _walk(file, record, start + 8, table, point_bytes)


def _walk(file: IO[bytes], record: LaszipRecord, start: int, end: int, point_bytes: int) -> None:
    """Walk chunks in layers: one plain point, the number of points, the bytes of each layer."""
    position = start
    while position < end:
        file.seek(position + point_bytes)
        head = file.read(4 + 4 * record.n_layers)
        sizes = struct.unpack_from(f"<{record.n_layers}I", head, 4)
        position += point_bytes + len(head) + sum(sizes)
        if position > end:
            raise EOFError(f"a chunk of {sum(sizes)} B runs beyond the chunks' end at {end}")
