# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Can a LAS/LAZ file hold what its header declares? Asked before anybody allocates by it."""

import struct
from pathlib import Path
from typing import IO

from .chunks import LaszipRecord, check_chunks
from .records import walk

# LAS 1.4 R15, table 3.
_HEADER_BYTES = {(1, 0): 227, (1, 1): 227, (1, 2): 227, (1, 3): 235, (1, 4): 375}
_POINT_BYTES = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)  # by point format, without extras
_VLR_BYTES = 54
_COARSEST = 100.0  # nobody stores coordinates in larger steps [m]
_FARTHEST = 1e9  # nor puts their origin farther off [m]
_LASZIP_USER, _LASZIP_RECORD = b"laszip encoded", 22204


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
    steps, origin = struct.unpack_from("<3d", head, 131), struct.unpack_from("<3d", head, 155)
    if not all(0.0 < step <= _COARSEST for step in steps):
        raise ValueError(f"coordinates in steps of {steps} are out of the question")
    if not all(abs(offset) <= _FARTHEST for offset in origin):
        raise ValueError(f"coordinates from {origin} on are out of the question")
    laszip = None
    for found in walk(file, header_bytes, n_records, data_start):
        if (found.user, found.number) == (_LASZIP_USER, _LASZIP_RECORD):
            laszip = found.read(file)
    if n_points == 0:
        raise ValueError("holds no points")
    room = size - data_start
    if not packed and n_points * point_bytes > room:
        raise EOFError(f"{n_points} points of {point_bytes} B do not fit the {room} B left")
    if packed:
        if laszip is None:
            raise ValueError("compressed points without a LASzip record")
        record = LaszipRecord.parse(laszip, point_bytes)
        check_chunks(file, record, data_start, n_points, point_bytes, size)
