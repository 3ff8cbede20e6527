# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`RowTable`: dataclasses of plain values as the rows of a CSV, out and in, checked by type."""

import csv
import dataclasses
import io
import math
import os
import types
import typing
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Generic, Protocol, TypeVar

from ltp.files import atomic_write


class Keyed(Protocol):
    """A row; its key tells it from all others."""

    @property
    def key(self) -> str:
        """Digest of everything that decides the row."""
        ...


Row = TypeVar("Row", bound=Keyed)


class RowTable(Generic[Row]):
    """How rows of one kind become text and are read back.

    Args:
        kind: a dataclass whose fields are str, int, float, bool, or one of these or None (an empty
            cell). A field with a default may be missing: files older than the field lack it.
        what: what a file of such rows is, for messages: "a table of flights".
    """

    def __init__(self, kind: type[Row], what: str) -> None:
        self._kind = kind
        self._what = what
        fields = dataclasses.fields(kind)  # type: ignore[arg-type]
        self._types = typing.get_type_hints(kind)
        self._needed = {f.name for f in fields if f.default is dataclasses.MISSING}
        self.columns = tuple(field.name for field in fields)

    def to_mapping(self, row: Row) -> dict[str, Any]:
        """The row as plain values by column."""
        return {name: getattr(row, name) for name in self.columns}

    def from_mapping(self, values: Mapping[str, Any]) -> Row:
        """The row of plain values or CSV texts by column.

        Raises:
            ValueError: naming the columns that are missing, unknown or hold no value of their type.
        """
        if missing := [name for name in self.columns if self._lacks(name, values)]:
            raise ValueError(f"missing columns: {', '.join(missing)}")
        if unknown := [str(name) for name in values if name not in self.columns]:
            raise ValueError(f"unknown columns: {', '.join(unknown)}")
        given = [name for name in self.columns if name in values or name in self._needed]
        return self._kind(**{name: self._parse(name, values.get(name)) for name in given})

    def write(self, path: str | os.PathLike[str], rows: Iterable[Row]) -> None:
        """Write the CSV, all or nothing; numbers as their shortest exact text."""
        lines = [_line(self.columns)]
        lines += [_line([_text(value) for value in self.to_mapping(row).values()]) for row in rows]
        with atomic_write(path) as file:
            file.write("".join(lines).encode())

    def read(self, path: str | os.PathLike[str]) -> list[Row]:
        """Read what `write` wrote.

        Raises:
            OSError: if the file cannot be read.
            ValueError: naming the file, the line and what is wrong with it.
        """
        try:
            with Path(path).open(newline="", encoding="utf-8") as file:
                reader = csv.DictReader(file, restkey="beyond the last column")
                rows = [self._read_line(path, reader.line_num, line) for line in reader]
                header = set(reader.fieldnames or ())
                if not self._needed <= header <= set(self.columns):  # none but the header
                    raise ValueError(f"{path}: missing columns, it is not {self._what}")
                return rows
        except (UnicodeDecodeError, csv.Error) as error:
            raise ValueError(f"{path} is not {self._what}: {error}") from error

    def _lacks(self, name: str, values: Mapping[str, Any]) -> bool:
        if name not in values:
            return name in self._needed and not self._optional(name)
        return values[name] is None and not self._optional(name)

    def _read_line(self, path: str | os.PathLike[str], number: int, line: Mapping[str, Any]) -> Row:
        try:
            return self.from_mapping(line)
        except ValueError as error:
            raise ValueError(f"{path}, line {number}: {error}") from error

    def _optional(self, name: str) -> bool:
        return isinstance(self._types[name], types.UnionType)

    def _parse(self, name: str, value: Any) -> Any:
        kind = self._types[name]
        if self._optional(name):
            if value in (None, ""):
                return None
            kind = typing.get_args(kind)[0]
        try:
            if kind is bool:
                return {"yes": True, "no": False, True: True, False: False}[value]
            number = kind(value)
        except (KeyError, TypeError, ValueError, OverflowError):
            raise ValueError(f"{name}: {value!r:.80} is not a {kind.__name__}") from None
        if kind is float and math.isnan(number):
            raise ValueError(f"{name}: not a number")
        return number


def _line(cells: Sequence[str]) -> str:
    # With its own line ending the writer also quotes a lone carriage return.
    text = io.StringIO()
    csv.writer(text, lineterminator="\r\n").writerow(cells)
    return text.getvalue().removesuffix("\r\n") + "\n"


def _text(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return repr(value) if isinstance(value, float) else str(value)
