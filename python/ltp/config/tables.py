# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Settings as nested dictionaries of plain values and as TOML, field by field."""

import dataclasses
import difflib
import tomllib
import typing
from collections.abc import Sequence
from typing import Any

_MAX_TEXT = 100_000  # characters of a document; all settings with comments are some 5,000
_MAX_DOTS = 200  # in a line: of keys and of numbers


def field_names(holder: object) -> tuple[str, ...]:
    """Names of the settings of a dataclass or of one of the core's options; () for a value."""
    if dataclasses.is_dataclass(holder):
        return tuple(item.name for item in dataclasses.fields(holder))
    return tuple(getattr(type(holder), "__fields__", ()))


def meaning(holder: object, name: str) -> str:
    """What a setting is for, with its unit: from its annotation, or the core's own docstring."""
    kind = type(holder)
    if not dataclasses.is_dataclass(holder):
        return " ".join((getattr(kind, name).__doc__ or "").split())  # on one line
    hint = typing.get_type_hints(kind, include_extras=True)[name]
    return next((text for text in getattr(hint, "__metadata__", ()) if isinstance(text, str)), "")


def plain(value: Any) -> Any:
    """A setting as numbers, strings, lists and dictionaries."""
    names = field_names(value)
    if names:
        return {name: plain(getattr(value, name)) for name in names}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, tuple | list):
        return [plain(item) for item in value]
    return value


def assign(holder: Any, values: dict[str, Any], prefix: str = "") -> None:
    """Set the settings of a holder from nested dictionaries.

    Args:
        holder: a dataclass or one of the core's options; it is changed.
        values: setting by name; what is not named keeps its value.
        prefix: of the keys in errors.

    Raises:
        ValueError: for a key that does not exist, or a value of another kind; it is named.
    """
    known = field_names(holder)
    for name, value in values.items():
        key = prefix + name
        if name not in known:
            raise _unknown(key, known)
        current = getattr(holder, name)
        try:
            if field_names(current):
                if not isinstance(value, dict):
                    raise ValueError(f"{key} = {value!r:.80}: expected a table")
                if dataclasses.is_dataclass(current):  # frozen: checked as a whole
                    _refuse_unknown(current, value, key)
                    value = _replaced(current, value, key)
                else:
                    assign(current, value, key + ".")
                    value = current
            elif any(isinstance(current, t) != isinstance(value, t) for t in (bool, str)):
                raise ValueError(f"{key} = {value!r:.80}: expected {_kind(current)}")
            elif isinstance(value, list) and any(isinstance(item, bool) for item in value):
                raise ValueError(f"{key} = {value!r:.80}: expected numbers")
            setattr(holder, name, value)
        except TypeError as error:
            raise ValueError(f"{key} = {value!r:.80}: expected {_kind(current)}") from error


def differences(values: dict[str, Any], others: dict[str, Any], prefix: str = "") -> dict[str, Any]:
    """The plain values by key, tables and keys with dots between, that are not those of others."""
    found: dict[str, Any] = {}
    for name, value in values.items():
        other = others.get(name)
        if isinstance(value, dict) and isinstance(other, dict):
            found |= differences(value, other, f"{prefix}{name}.")
        elif value != other:
            found[prefix + name] = value
    return found


def read_toml(text: str) -> dict[str, Any]:
    """The settings in a TOML document.

    Raises:
        ValueError: if it is none, or is longer or nested more deeply than settings are.
    """
    # The parser's time grows with the square of a key's parts.
    if len(text) > _MAX_TEXT or any(
        line.partition("#")[0].count(".") > _MAX_DOTS for line in text.splitlines()
    ):
        raise ValueError(f"longer than {_MAX_TEXT} characters, or nested too deeply")
    try:
        return tomllib.loads(text)
    except RecursionError:
        raise ValueError("nested too deeply") from None


def toml_lines(holder: Any, prefix: str = "") -> list[str]:
    """The lines of a TOML document of all settings of a holder, each with what it means."""
    lines, tables = [], []
    for name in field_names(holder):
        value = getattr(holder, name)
        text = meaning(holder, name)
        comment = f"  # {text}" if text else ""
        if field_names(value):
            tables += ["", f"[{prefix}{name}]{comment}", *toml_lines(value, f"{prefix}{name}.")]
        else:
            lines.append(f"{name} = {_toml(plain(value))}{comment}")
    return lines + tables


def _kind(current: Any) -> str:
    """What is expected in place of a setting's value, in words."""
    value = plain(current)
    if isinstance(value, list):
        whole = all(isinstance(item, int) for item in value)
        return f"{len(value)} {'whole numbers' if whole else 'numbers'}"
    kinds = {bool: "true or false", str: "a text", int: "a whole number in its range"}
    return kinds.get(type(value), "a number")


def _refuse_unknown(holder: object, values: dict[str, Any], key: str) -> None:
    for name in values:
        if name not in field_names(holder):
            raise _unknown(f"{key}.{name}", field_names(holder))


def _unknown(key: str, known: Sequence[str]) -> ValueError:
    name = key.rpartition(".")[2]
    near = difflib.get_close_matches(name, known, n=1, cutoff=0.6) if len(name) < 100 else []
    meant = f" (did you mean {near[0]!r}?)" if near else ""
    return ValueError(f"unknown key {key[:200]!r}{meant}: expected one of {', '.join(known)}")


def _replaced(holder: Any, values: dict[str, Any], key: str) -> Any:
    try:
        return dataclasses.replace(holder, **values)
    except ValueError as error:
        text = str(error)
        raise ValueError(text if text.startswith(f"{key}.") else f"{key}.{text}") from error


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, list):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    return repr(value)  # numbers; inf and nan are TOML's own words
