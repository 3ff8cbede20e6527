# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Can a LAS/LAZ file hold what its header declares? Asked before anybody allocates by it."""

import struct
from pathlib import Path
from typing import IO

# LAS 1.4 R15, tables 3 and 27; the compression record and the chunk table are LASzip's.
_HEADER_BYTES = {(1, 0): 227, (1, 1): 227, (1, 2): 227, (1, 3): 235, (1, 4): 375}
_POINT_BYTES = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)  # by point format, without extras
_VLR_BYTES = 54
_LASZIP_USER, _LASZIP_RECORD = b"laszip encoded", 22204
_LASZIP_SMALLEST = 34  # bytes of a LASzip record without items
_VARIABLE_CHUNKS = 0xFFFFFFFF
#: LASzip packs some ten bytes into a point of a survey; a thousand points into one byte is a lie.
_MAX_POINTS_PER_BYTE = 1000


def check_complete(path: Path) -> None:
    """Check the sizes and offsets in the header of `path` against the size of the file.

    Raises:
        ValueError: naming the file, if it is not LAS/LAZ or cannot hold what it declares.
    """
    size = path.stat().st_size
    with path.open("rb") as file:
        try:
            _check(file, size)
        except (struct.error, EOFError) as error:
            raise ValueError(f"{path} ends early: {error}") from error
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error


def _check(file: IO[bytes], size: int) -> None:
    head = file.read(375)
    if head[:4] != b"LASF":
        raise ValueError(f"not a LAS or LAZ file, it starts with {head[:4]!r}")
    version = struct.unpack_from("<BB", head, 24)
    if version not in _HEADER_BYTES:
        raise ValueError(f"LAS version {version[0]}.{version[1]} is unknown, expected 1.0 to 1.4")
    header_bytes, data_start, n_records = struct.unpack_from("<HII", head, 94)
    if header_bytes < _HEADER_BYTES[version] or len(head) < _HEADER_BYTES[version]:
        raise ValueError(f"a header of {header_bytes} bytes is too small for LAS {version}")
    coded_format, point_bytes, n_points = struct.unpack_from("<BHI", head, 104)
    n_extended = 0
    if version == (1, 4):
        extended_start, n_extended, n_points_14 = struct.unpack_from("<QIQ", head, 235)
        n_points = n_points_14 or n_points
        if n_extended and extended_start + n_extended * 60 > size:
            raise EOFError(f"{n_extended} extended records from {extended_start} do not fit")
    if header_bytes + n_records * _VLR_BYTES > data_start or data_start > size:
        raise EOFError(f"{n_records} records and points from {data_start} on do not fit {size} B")
    point_format, packed = coded_format & 0x3F, bool(coded_format & 0xC0)
    if point_format >= len(_POINT_BYTES) or point_bytes < _POINT_BYTES[point_format]:
        raise ValueError(f"points of format {point_format} and {point_bytes} bytes are unknown")
    chunk_points = _check_records(file, header_bytes, n_records, data_start)
    if n_points == 0:
        raise ValueError("holds no points")
    room = size - data_start
    if not packed and n_points * point_bytes > room:
        raise EOFError(f"{n_points} points of {point_bytes} B do not fit the {room} B left")
    if packed:
        if chunk_points is None:
            raise ValueError("compressed points without a LASzip record")
        if n_points > room * _MAX_POINTS_PER_BYTE:
            raise EOFError(f"{n_points} points cannot fit the {room} B left")
        _check_chunks(file, data_start, n_points, chunk_points, size)


def _check_records(file: IO[bytes], start: int, n_records: int, end: int) -> int | None:
    """Walk the variable-length records; return the points per chunk of the LASzip one, if any."""
    chunk_points = None
    position = start
    for _ in range(n_records):
        file.seek(position)
        head = file.read(_VLR_BYTES)
        user, record, length = head[2:18].rstrip(b"\0"), *struct.unpack_from("<HH", head, 18)
        if position + _VLR_BYTES + length > end:
            raise EOFError(f"a record of {length} B at {position} runs into the points at {end}")
        if (user, record) == (_LASZIP_USER, _LASZIP_RECORD):
            if length < _LASZIP_SMALLEST:
                raise ValueError(f"a LASzip record of {length} B is too small")
            (chunk_points,) = struct.unpack_from("<I", file.read(16), 12)
        position += _VLR_BYTES + length
    return chunk_points


def _check_chunks(file: IO[bytes], start: int, n_points: int, chunk_points: int, size: int) -> None:
    """Check the table of chunks, which the decoder makes room for before it reads it."""
    file.seek(start)
    (table,) = struct.unpack("<q", file.read(8))
    if table == -1:  # written by a stream; the place then stands at the end of the file
        file.seek(-8, 2)
        (table,) = struct.unpack("<q", file.read(8))
    if not start + 8 <= table <= size - 8:
        raise EOFError(f"the table of chunks at {table} lies outside the file of {size} B")
    file.seek(table + 4)
    (n_chunks,) = struct.unpack("<I", file.read(4))
    fixed = 0 < chunk_points < _VARIABLE_CHUNKS
    most = -(-n_points // chunk_points) + 1 if fixed else n_points
    if n_chunks > most or n_chunks > size:
        raise ValueError(f"a table of {n_chunks} chunks does not go with {n_points} points")
    if chunk_points == 0:
        raise ValueError("chunks of 0 points")
