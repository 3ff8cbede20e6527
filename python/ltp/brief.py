# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One line about a dataclass that holds arrays or many things: shapes and counts of what is in."""

import dataclasses
from collections.abc import Mapping
from typing import Any

_LONGEST = 80  # characters of a value


def brief(holder: Any) -> str:
    """The fields of a dataclass by name: its `__repr__`, written `__repr__ = brief`."""
    fields = (field.name for field in dataclasses.fields(holder) if field.repr)
    parts = (f"{name}={_short(getattr(holder, name))}" for name in fields)
    return f"{type(holder).__name__}({', '.join(parts)})"


def _short(value: Any) -> str:
    shape = getattr(value, "shape", None)
    if isinstance(shape, tuple) and hasattr(value, "dtype"):
        small = value.ndim == 1 and value.size <= 3
        return _cut(str(value.tolist())) if small else f"<{' x '.join(map(str, shape))} array>"
    text = _cut(repr(value))
    if len(text) > _LONGEST and isinstance(value, list | tuple | Mapping):
        return f"<{len(value)} of {type(next(iter(value))).__name__}>"
    return text


def _cut(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= _LONGEST else line[:_LONGEST] + "...)"
