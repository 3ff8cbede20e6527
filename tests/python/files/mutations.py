# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Damage to a file as disks, networks and enemies do it: seeded, so that runs repeat."""

import io
import random
import re
import zipfile
from collections.abc import Iterator

#: Numbers that lengths, counts and offsets are forged to.
_EDGES = (0, 1, 0x7F, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0xFFFFFFFF, 2**63 - 1, 2**64 - 1)
#: What parsers of text stumble over.
_TEXTS = (
    b"9" * 400,
    b"1e999",
    b"-1",
    b"nan",
    b"Infinity",
    b"null",
    b"true",
    b"\0",
    b"\xff\xfe",
    b"[" * 3000,
    b"{" * 50,
    b'{"a":' * 2000,
    b'"',
    b"'",
    b"\r",
    b",,,,",
    b"\n\n",
    b"<a>" * 300,
    b"&x;",
)


def mutations(whole: bytes, count: int, seed: int) -> Iterator[bytes]:
    """`count` damaged copies of a file, each by one to three kinds of damage.

    Of an archive every other copy is damaged inside of a member, and packed again: its checksums
    are right.
    """
    rng = random.Random(seed)
    for number in range(count):
        if whole.startswith(b"PK") and number % 2:
            yield _inside(rng, whole)
        else:
            yield _damaged(rng, whole)


def _damaged(rng: random.Random, whole: bytes) -> bytes:
    data = bytearray(whole)
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        rng.choice(_KINDS)(rng, data)
    return bytes(data)


def _inside(rng: random.Random, whole: bytes) -> bytes:
    with zipfile.ZipFile(io.BytesIO(whole)) as archive:
        members = {member.filename: archive.read(member) for member in archive.infolist()}
    name = rng.choice(sorted(members))
    # numpy's header is 128 bytes: damaged in one of four copies.
    kept = members[name][: rng.choice((0, 128, 128, 128))]
    members[name] = kept + _damaged(rng, members[name][len(kept) :])
    if rng.random() < 0.1:
        members[rng.choice(("other.npy", "../up.npy"))] = members.pop(name)
    if rng.random() < 0.5 and kept:  # a header that tells the new length, where it tells one
        length = len(members.get(name, b"")) - 128
        head = re.sub(rb"\(\d+,\), }", b"(%d,), }" % length, kept[:127].rstrip())
        members[name] = head.ljust(127) + b"\n" + members.get(name, b"")[128:]
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED) as archive:
        for member, data in members.items():
            archive.writestr(member, data)
    return file.getvalue()


def _place(rng: random.Random, data: bytearray) -> int:
    # Heads are where the lengths stand.
    end = len(data) if rng.random() < 0.6 else min(len(data), 256)
    return rng.randrange(end) if end else 0


def _flip(rng: random.Random, data: bytearray) -> None:
    for _ in range(rng.choice((1, 1, 4, 32))):
        if data:
            data[_place(rng, data)] ^= 1 << rng.randrange(8)


def _truncate(rng: random.Random, data: bytearray) -> None:
    del data[_place(rng, data) :]


def _cut(rng: random.Random, data: bytearray) -> None:
    start = _place(rng, data)
    del data[start : start + rng.choice((1, 2, 7, 64, 1000))]


def _splice(rng: random.Random, data: bytearray) -> None:
    """A stretch of the file over another one."""
    source, target, size = _place(rng, data), _place(rng, data), rng.choice((2, 8, 40, 400))
    data[target : target + size] = data[source : source + size]


def _repeat(rng: random.Random, data: bytearray) -> None:
    start, size = _place(rng, data), rng.choice((1, 8, 60, 300))
    data[start:start] = data[start : start + size] * rng.choice((1, 3, 50))


def _forge(rng: random.Random, data: bytearray) -> None:
    """A number of 2, 4 or 8 bytes."""
    size = rng.choice((2, 4, 8))
    value = rng.choice((*_EDGES, rng.getrandbits(8 * size))) % 256**size
    start = _place(rng, data) & ~1
    data[start : start + size] = value.to_bytes(size, rng.choice(("little", "big")))


def _write(rng: random.Random, data: bytearray) -> None:
    """A text that parsers stumble over, in between or instead of what stood there."""
    start, text = _place(rng, data), rng.choice(_TEXTS)
    data[start : start + rng.choice((0, 1, len(text)))] = text


def _noise(rng: random.Random, data: bytearray) -> None:
    start, size = _place(rng, data), rng.choice((4, 16, 100))
    data[start : start + size] = rng.randbytes(size)


_KINDS = (_flip, _truncate, _cut, _splice, _repeat, _forge, _write, _noise)
