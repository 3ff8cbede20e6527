# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The file of a flight's record: its arrays and its header, read with distrust."""

from collections.abc import Mapping
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from ltp.config.moved import with_new_names
from ltp.files.npz import NpzReader

FORMAT = 2

# As they are kept, then as they may have been given.
_FLOATS = ("<f8", "<f4", "<i8", "<i4")
_INTEGERS = ("<i8", "<i4", "<u4")
#: The arrays of a record: their types and shapes, None for as many rows as there are.
ARRAYS: Mapping[str, tuple[tuple[str, ...], tuple[int | None, ...]]] = {
    "global_path": (_FLOATS, (None, 3)),
    "times": (_FLOATS, (None,)),
    "positions": (_FLOATS, (None, 3)),
    "velocities": (_FLOATS, (None, 3)),
    "plan_index": (_INTEGERS, (None,)),
    "waypoint_index": (_INTEGERS, (None,)),
}
_PLANS: Mapping[str, tuple[tuple[str, ...], tuple[int | None, ...]]] = {
    "plan_paths": (_FLOATS, (None, 3)),
    "plan_lengths": (_INTEGERS, (None,)),
}

# A flight of a day has 0.9 million steps. Times and positions hardly repeat themselves: deflate
# packs honest records 5 to 50 times, their headers 10 times (assumed to be twice that at most).
_MAX_ELEMENTS = 100_000_000
_MAX_BYTES, _MAX_PACKING = 64 << 20, 200
_MAX_HEADER, _MAX_HEADER_PACKING = 1 << 20, 20


def read_record(
    file: IO[bytes],
) -> tuple[dict[str, Any], dict[str, Any], list[NDArray[np.float64]]]:
    """What stands in the file of a record, in the names of today's format.

    Args:
        file: open for reading in binary.

    Returns:
        The header, whose values are not checked; the arrays by name; the path of each plan.

    Raises:
        ValueError: naming what is not as it must be. On garbage other errors, too: read within
            `blamed_on`.
    """
    reader = NpzReader(file, _MAX_BYTES, _MAX_PACKING)
    header = reader.json("header", _MAX_HEADER, _MAX_HEADER_PACKING)
    version = header.pop("format", None)
    if version not in (1, FORMAT) or isinstance(version, bool):
        raise ValueError(f"format = {version!r}: expected 1 or {FORMAT}")
    stored = {name: name for name in (*ARRAYS, *_PLANS)}
    if version == 1:
        stored["waypoint_index"] = "way_point_index"
    reader.expect({"header", *stored.values()})
    arrays = {
        name: reader.array(stored[name], dtypes, shape, _MAX_ELEMENTS)
        for name, (dtypes, shape) in (ARRAYS | _PLANS).items()  # type: ignore[operator]
    }
    if version == 1:
        _rename_format_1(header)
    lengths = arrays.pop("plan_lengths")
    paths = _split(arrays.pop("plan_paths"), lengths)
    steps = {name: len(arrays[name]) for name in ARRAYS if name != "global_path"}
    if len(set(steps.values())) != 1:
        raise ValueError(f"expected one number of steps, not {steps}")
    if len(arrays["times"]) < 1 or len(arrays["global_path"]) < 1:
        raise ValueError("expected one step or more, and where the flight started")
    return header, arrays, paths


def _split(points: NDArray[np.float64], lengths: NDArray[np.int64]) -> list[NDArray[np.float64]]:
    """The points of each plan, one after the other."""
    if lengths.size and (lengths.min() < 0 or lengths.max() > len(points)):
        raise ValueError(f"plan_lengths: expected 0 to {len(points)} points each")
    if sum(lengths.tolist()) != len(points):
        raise ValueError(f"plan_lengths: expected {len(points)} points in all")
    return np.split(points, np.cumsum(lengths)[:-1]) if lengths.size else []


def _rename_format_1(header: dict[str, Any]) -> None:
    """Format 1 said `way_point`, and had the planner's options beside the other settings."""
    for holder in (header, *header["plans"]):
        for name in [name for name in holder if name.startswith("way_point")]:
            holder[name.replace("way_point", "waypoint")] = holder.pop(name)
    header["config"] = with_new_names(header["config"])
