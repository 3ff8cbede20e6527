# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Values out of a file as arguments of a dataclass: each of the type that its field has."""

import enum
import types
import typing
from collections.abc import Collection, Mapping
from typing import Any


def typed(kind: type, values: Any, without: Collection[str] = ()) -> dict[str, Any]:
    """The values by field, lists as tuples and whole numbers as floats where the field asks so.

    Args:
        kind: a dataclass whose fields are numbers, texts, enums, tuples of these, dictionaries or
            one of these or None.
        values: by field. One that is missing keeps its default; whether it has one, the constructor
            decides.
        without: fields that must not be among the values.

    Raises:
        ValueError: naming the field that does not exist, or whose value is of another type.
    """
    if not isinstance(values, Mapping):
        raise ValueError(f"expected the fields of a {kind.__name__}, not {values!r:.80}")
    hints = typing.get_type_hints(kind)
    for name in values:
        if name not in hints or name in without:
            raise ValueError(f"unknown field {name!r} of a {kind.__name__}")
    return {name: _as(hints[name], name, value) for name, value in values.items()}


def _as(hint: Any, name: str, value: Any) -> Any:
    if isinstance(hint, types.UnionType):
        if value is None:
            return None
        hint = typing.get_args(hint)[0]
    origin = typing.get_origin(hint) or hint
    if origin is tuple and isinstance(value, list):
        kinds = typing.get_args(hint)
        if len(kinds) == len(value):
            return tuple(_as(kind, name, item) for kind, item in zip(kinds, value, strict=True))
    elif isinstance(origin, type) and issubclass(origin, enum.Enum):
        return origin(value)
    elif origin is float and isinstance(value, int | float) and not isinstance(value, bool):
        return float(value)
    elif isinstance(value, origin) and isinstance(value, bool) == (origin is bool):
        return value
    expected = getattr(hint, "__name__", str(hint))
    raise ValueError(f"{name}: expected {expected}, not {value!r:.80}")
