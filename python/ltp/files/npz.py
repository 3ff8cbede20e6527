# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays in an .npz file: read with distrust, every size checked before anything is unpacked.

Nothing is unpickled or evaluated; only plain arrays, stored or deflated, are understood.
"""

import json
import math
import re
import zipfile
from collections.abc import Collection, Sequence
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

_MAX_HEADER = 4096  # bytes of an .npy header; numpy's own have 128
_MAX_DEFLATE_RATIO = 1032  # what deflate can reach at most; more is a lie in the directory
_CHUNK = 1 << 20

_HEADER = re.compile(
    rb"\{'descr': '(?P<dtype>[<>|=]\w{1,8})', 'fortran_order': (?P<order>False|True), "
    rb"'shape': \((?P<shape>(?:\d{1,12},(?: \d{1,12}(?:, \d{1,12})?)?)?)\), \} *\n"
)

Shape = Sequence[int | None]


class NpzReader:
    """The members of an open .npz file; each is read when asked for.

    Args:
        file: open for reading in binary.
        base: bytes that the members may hold together, unpacked.
        ratio: they may hold so many more for each byte of the file.

    Raises:
        ValueError: if a member comes twice, is compressed in a way that numpy does not use, or
            promises more than its bytes can hold; or if all of them promise too much together.
            On garbage other errors, too: read within `blamed_on`.
    """

    def __init__(self, file: IO[bytes], base: int, ratio: int = 0) -> None:
        self._archive = zipfile.ZipFile(file)
        self._members: dict[str, zipfile.ZipInfo] = {}
        for member in self._archive.infolist():
            self._members[_sound_name(member, self._members)] = member
        self._most = base + ratio * file.seek(0, 2)
        self._taken = 0

    @property
    def names(self) -> Collection[str]:
        """Names of the members, without `.npy`."""
        return self._members.keys()

    def expect(self, names: Collection[str]) -> None:
        """Raise `ValueError` unless exactly these members are there."""
        for name, member in self._members.items():
            if name not in names:
                raise ValueError(f"unexpected member {member.filename!r}")
        if missing := sorted(set(names) - self._members.keys()):
            raise ValueError(f"missing {', '.join(missing)}")

    def array(
        self, name: str, dtype: str | Sequence[str], shape: Shape, max_size: int
    ) -> NDArray[Any]:
        """The member of a name, C-contiguous, as the first of the types.

        Args:
            name: of the member, without `.npy`.
            dtype: the type that it must have, as numpy writes it ("<f8"), or several.
            shape: that it must have; None where any length will do.
            max_size: most elements.

        Raises:
            ValueError: naming the member, if it is missing or not so.
        """
        if name not in self._members:
            raise ValueError(f"missing {name}")
        member = self._members[name]
        wanted = [np.dtype(text) for text in ([dtype] if isinstance(dtype, str) else dtype)]
        with self._archive.open(member) as stream:
            found, order, lengths = _read_header(name, stream)
            size = _checked_size(name, found, lengths, wanted, shape, max_size)
            itemsize = np.dtype(found).itemsize
            declared = member.file_size - stream.tell()
            if declared != size * itemsize:
                raise ValueError(f"{name}: shape {lengths} does not fit its {declared} bytes")
            self._take(name, declared)
            array = np.empty(lengths if order == "C" else lengths[::-1], found)
            _fill(name, stream, array.reshape(-1).view(np.uint8).data if size else memoryview(b""))
            if stream.read(1):  # also makes zipfile compare the checksum
                raise ValueError(f"{name}: more data than declared")
        return np.ascontiguousarray(array if order == "C" else array.T, dtype=wanted[0])

    def json(self, name: str, max_bytes: int, ratio: int | None = None) -> dict[str, Any]:
        """The JSON object in the member of a name, an array of bytes.

        Args:
            name: of the member.
            max_bytes: of text.
            ratio: with it, a text may be longer, by so many bytes for each that it is packed in.

        Raises:
            ValueError: naming the member, if it is missing or no JSON object.
        """
        packed = self._members[name].compress_size if name in self._members else 0
        longest = max_bytes + (ratio or 0) * packed
        values = json.loads(self.array(name, "|u1", (None,), longest).tobytes())
        if not isinstance(values, dict):
            raise ValueError(f"{name}: expected a JSON object")
        return values

    def _take(self, name: str, size: int) -> None:
        self._taken += size
        if self._taken > self._most:
            raise ValueError(f"{name}: more than {self._most:,} bytes in all, packed too tightly")


def _sound_name(member: zipfile.ZipInfo, others: Collection[str]) -> str:
    name = member.filename.removesuffix(".npy")
    if name in others:
        raise ValueError(f"unexpected member {member.filename!r}")
    if member.compress_type not in (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED):
        raise ValueError(f"{name}: unexpected compression method {member.compress_type}")
    if member.file_size > _MAX_DEFLATE_RATIO * member.compress_size + _MAX_HEADER:
        raise ValueError(f"{name}: {member.compress_size} bytes cannot hold {member.file_size}")
    return name


def _read_header(name: str, stream: IO[bytes]) -> tuple[str, str, tuple[int, ...]]:
    """dtype, order and shape of an .npy header, by pattern: numpy's reader evaluates the text."""
    start = stream.read(10)
    length = int.from_bytes(start[8:], "little")
    if start[:8] != b"\x93NUMPY\x01\x00" or length > _MAX_HEADER:
        raise ValueError(f"{name}: not an .npy array of version 1.0")
    text = stream.read(length)
    match = _HEADER.fullmatch(text)
    if not match:
        raise ValueError(f"{name}: expected a plain array, found header {text[:120]!r}")
    shape = tuple(int(number) for number in match["shape"].replace(b",", b" ").split())
    return match["dtype"].decode(), "F" if match["order"] == b"True" else "C", shape


def _checked_size(
    name: str,
    found: str,
    lengths: tuple[int, ...],
    wanted: Sequence[np.dtype[Any]],
    shape: Shape,
    max_size: int,
) -> int:
    """How many elements an array has whose type and shape are as they must be."""
    if found not in [dtype.str for dtype in wanted]:
        expected = " or ".join(dtype.str for dtype in wanted)
        raise ValueError(f"{name}: expected dtype {expected}, found {found}")
    if len(lengths) != len(shape):
        raise ValueError(f"{name}: unexpected shape {lengths}")
    if any(must not in (None, is_) for must, is_ in zip(shape, lengths, strict=True)):
        expected = "(" + ", ".join("n" if n is None else str(n) for n in shape) + ")"
        raise ValueError(f"{name}: expected shape {expected}, found {lengths}")
    size = math.prod(lengths)
    if size > max_size:
        raise ValueError(f"{name}: shape {lengths} is more than {max_size} elements")
    return size


def _fill(name: str, stream: IO[bytes], into: memoryview) -> None:
    position = 0
    while position < len(into):
        chunk = stream.read(min(_CHUNK, len(into) - position))
        if not chunk:
            raise ValueError(f"{name}: ends {len(into) - position} bytes early")
        into[position : position + len(chunk)] = chunk
        position += len(chunk)
