# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Digests of all that decides a row, so that a journal never mixes what differs in any of it."""

import functools
import hashlib
import json
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from ltp import _core
from ltp.world import World

_KEY_LENGTH = 20  # hexadecimal digits: no two of a million rows share a key by chance


@functools.cache
def program_digest() -> str:
    """Digest of this program, whatever its version: the compiled core and the package's sources."""
    return build_digest(Path(_core.__file__), Path(__file__).parents[1])


def build_digest(core: Path, package: Path) -> str:
    """Digest of a build.

    Args:
        core: the compiled module.
        package: folder of the Python sources; their names count too.
    """
    digest = hashlib.sha256(core.read_bytes())
    for path in sorted(package.rglob("*.py")):
        source = path.read_bytes()
        digest.update(f"\n{path.relative_to(package).as_posix()} {len(source)}\n".encode())
        digest.update(source)
    return digest.hexdigest()


def world_digest(world: World) -> str:
    """Digest of all that a flight sees of a world."""
    digest = hashlib.sha256(repr((world.name, world.shape, world.cell, world.origin)).encode())
    for array in (world.ground, world.surface, world.classes):
        digest.update(array.data)
    return digest.hexdigest()


def raster_digest(raster: _core.Raster) -> str:
    """Digest of all that a flight sees of a priority map."""
    frame = (raster.shape, tuple(raster.origin), raster.cell, raster.outside)
    digest = hashlib.sha256(repr(frame).encode())
    digest.update(np.ascontiguousarray(raster.values).data)
    return digest.hexdigest()


def row_key(facts: Mapping[str, Any]) -> str:
    """The key of a row: a digest of this program and of the facts that decide it, JSON values."""
    text = json.dumps({"program": program_digest(), **facts}, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()[:_KEY_LENGTH]
