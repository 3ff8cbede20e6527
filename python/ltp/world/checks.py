# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks of the arguments of a world: each returns the sound value or raises naming the culprit."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .classes import LandClass


def text(name: str, value: object) -> None:
    """Demand a string."""
    if not isinstance(value, str):
        raise ValueError(f"{name} must be a string, not {value!r}")


def sentences(name: str, values: object) -> tuple[str, ...]:
    """Return `values` as a tuple; demand a sequence of strings."""
    if isinstance(values, str) or not isinstance(values, Sequence):
        raise ValueError(f"{name} must be a sequence of strings, not {values!r}")
    for index, value in enumerate(values):
        text(f"{name}[{index}]", value)
    return tuple(values)


def finite(name: str, value: object) -> float:
    """Return `value` as a float; demand a finite number."""
    try:
        no_number = isinstance(value, str | bytes | bool | np.bool_)
        number = math.nan if no_number else float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError, OverflowError):
        raise ValueError(f"{name} must be a number, not {value!r:.80}") from None
    if not math.isfinite(number):
        raise ValueError(f"{name} must be a finite number, not {value!r}")
    return number


def positive(name: str, value: object) -> float:
    """Return `value` as a float; demand a finite number above zero."""
    number = finite(name, value)
    if number <= 0.0:
        raise ValueError(f"{name} must be above zero, not {value!r}")
    return number


def not_negative(name: str, value: object) -> float:
    """Return `value` as a float; demand a finite number of at least zero."""
    number = finite(name, value)
    if number < 0.0:
        raise ValueError(f"{name} must not be negative, not {value!r}")
    return number


def shares(name: str, values: NDArray[Any]) -> None:
    """Demand shares: finite, from 0 to 1."""
    sound = (values >= 0.0) & (values <= 1.0)  # NaN is neither
    if not sound.all():
        i, j = np.argwhere(~sound)[0]
        raise ValueError(
            f"{name} must hold shares from 0 to 1, but [{i}, {j}] is {values[i, j]:g} "
            f"({np.count_nonzero(~sound)} of {values.size} are none)"
        )


def corner(origin: Any) -> tuple[float, float]:
    """Return `origin` as (x, y); demand two finite numbers."""
    try:
        x, y = origin
    except (TypeError, ValueError):
        raise ValueError(f"origin must be two numbers (x, y) in metres, not {origin!r}") from None
    return finite("origin[0]", x), finite("origin[1]", y)


def resolvable(origin: tuple[float, float], cell: float, shape: tuple[int, ...]) -> None:
    """Demand that neighbouring cells can be told apart, from the first to the last."""
    for start, count in zip(origin, shape, strict=True):
        end = start + count * cell
        if not (math.isfinite(end) and start + cell > start and end - cell < end):
            raise ValueError(
                f"cell must be an edge by which cells differ so far from zero, not {cell!r} "
                f"from {start!r} on"
            )


def triples(name: str, values: ArrayLike) -> NDArray[np.float64]:
    """Return `values` as float64 of shape (N, 3) or (3,); demand finite numbers."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError) as error:
        raise ValueError(f"{name} must be numbers of shape (N, 3): {error}") from error
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        raise ValueError(f"{name} must have shape (N, 3), found {array.shape}")
    if not np.isfinite(array).all():
        raise ValueError(f"{name} must be finite, not {array[~np.isfinite(array)][0]}")
    return array


def heights(
    name: str, values: ArrayLike, shape: tuple[int, ...] | None = None
) -> NDArray[np.float64]:
    """Return `values` as an owned float64 array (nx, ny); demand finite heights."""
    array = _grid(name, values, "iuf", "heights in metres")
    if shape is not None:
        _same_shape(name, array, shape)
    owned: NDArray[np.float64] = _own(array, np.float64)
    if not np.isfinite(owned).all():
        i, j = np.argwhere(~np.isfinite(owned))[0]
        raise ValueError(f"{name} must be finite, but {name}[{i}, {j}] is {owned[i, j]}")
    return owned


def land_classes(values: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.uint8]:
    """Return `values` as an owned uint8 array of `shape`; demand LandClass numbers."""
    array = _grid("classes", values, "iu", "LandClass numbers")
    _same_shape("classes", array, shape)
    known = (array >= min(LandClass)) & (array <= max(LandClass))
    if not known.all():
        i, j = np.argwhere(~known)[0]
        raise ValueError(
            f"classes must lie in 0...{max(LandClass):d} (LandClass), "
            f"but classes[{i}, {j}] is {array[i, j]}"
        )
    return _own(array, np.uint8)


def _grid(name: str, values: ArrayLike, kinds: str, what: str) -> NDArray[Any]:
    hidden = np.count_nonzero(np.ma.getmask(values))
    if hidden:
        raise ValueError(f"{name} must hold {what} in all cells, but {hidden} are masked")
    try:
        array = np.asarray(values)
    except (TypeError, ValueError) as error:  # ragged lists
        raise ValueError(f"{name} must be an array of shape (nx, ny): {error}") from error
    if array.dtype.kind not in kinds:
        raise ValueError(f"{name} must hold {what}, not dtype {array.dtype}")
    if array.ndim != 2 or array.size == 0:
        raise ValueError(f"{name} must have shape (nx, ny), not empty, found {array.shape}")
    return array


def _same_shape(name: str, array: NDArray[Any], shape: tuple[int, ...]) -> None:
    if array.shape != shape:
        raise ValueError(f"{name} must have the shape of ground, {shape}, not {array.shape}")


def _own(array: NDArray[Any], dtype: type) -> NDArray[Any]:
    """A C-contiguous copy, or the array itself where nobody can write to it any more."""
    flags = array.flags
    if array.dtype == dtype and flags.c_contiguous and flags.owndata and not flags.writeable:
        return array
    return np.array(array, dtype=dtype, order="C")
