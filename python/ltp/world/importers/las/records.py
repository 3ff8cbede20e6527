# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The variable-length records of a LAS file, before its points or, extended, behind them."""

import struct
from collections.abc import Iterator
from typing import IO, NamedTuple

_HEAD_BYTES = {False: 54, True: 60}  # LAS 1.4 R15, tables 6 and 7
_LARGEST = 1 << 24  # bytes of a record that is read


class Record(NamedTuple):
    """Where one record lies."""

    user: bytes
    number: int
    offset: int  # of what it holds
    length: int

    def read(self, file: IO[bytes]) -> bytes:
        """What it holds.

        Raises:
            ValueError: if that is too much.
        """
        if self.length > _LARGEST:
            raise ValueError(f"a record of {self.length} B, more than {_LARGEST}")
        file.seek(self.offset)
        return file.read(self.length)


def walk(
    file: IO[bytes], start: int, count: int, end: int, *, extended: bool = False
) -> Iterator[Record]:
    """The `count` records between the bytes `start` and `end`.

    Raises:
        EOFError: if one of them runs beyond `end`.
    """
    n_head = _HEAD_BYTES[extended]
    for _ in range(count):
        file.seek(start)
        head = file.read(n_head)
        if len(head) < n_head:
            raise EOFError(f"a record at {start} is cut")
        user, number = head[2:18].rstrip(b"\0"), struct.unpack_from("<H", head, 18)[0]
        (length,) = struct.unpack_from("<Q" if extended else "<H", head, 20)
        if start + n_head + length > end:
            raise EOFError(f"a record of {length} B at {start} runs beyond {end}")
        yield Record(user, number, start + n_head, length)
        start += n_head + length
