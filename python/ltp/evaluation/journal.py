# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Journals of long computations: finished rows, appended one by one, safe against any kill."""

import fcntl
import json
import logging
import os
from io import FileIO
from pathlib import Path
from types import TracebackType
from typing import Any, Generic, Self

from ltp.brief import brief

from .row_table import Row, RowTable

_log = logging.getLogger(__name__)


class RowJournal(Generic[Row]):
    """One JSON line a row, flushed to the disk before the next; at most one writer at a time.

    A kill in the middle of a line leaves a torn last line: it is cut off when the journal is opened
    again, and that row is made again. Lines that were finished are never lost or repeated.

    Args:
        path: of the file; made if it is not there.
        table: the kind of row.
        owner: what keeps such a journal, in one word: "campaign".
        deed: how a row is made and what it tells of, in two words: "fly flight".

    Raises:
        ValueError: if the file is no journal, or a line other than the last is damaged.
        RuntimeError: if another owner is writing it.
        OSError: from the file system.
    """

    def __init__(
        self, path: str | os.PathLike[str], table: RowTable[Row], owner: str, deed: str
    ) -> None:
        self._path = Path(path)
        self._table = table
        self._owner = owner
        self._verb, self._unit = deed.split()
        self._header = {"format": f"ltp.{owner}.journal", "version": 1}
        self.rows: dict[str, Row] = {}  # by key
        # Unbuffered: after a failed write nothing is left behind that a later one would flush.
        self._file: FileIO = self._path.open("a+b", buffering=0)
        try:
            self._lock()
            self._read()
        except BaseException:
            self._file.close()
            raise

    def append(self, row: Row) -> None:
        """Keep a finished row; it is on the disk when this returns.

        Raises:
            ValueError: if a row of this key is there already.
        """
        if row.key in self.rows:
            raise ValueError(f"the {self._unit} {row.key} is in {self._path} already")
        self._write(self._table.to_mapping(row))
        self.rows[row.key] = row
        if _log.isEnabledFor(logging.INFO):
            _log.info("%s: %s %d: %s", self._path, self._unit, len(self.rows), brief(row))

    def close(self) -> None:
        """Let the next owner write."""
        self._file.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def _lock(self) -> None:
        try:
            fcntl.flock(self._file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise RuntimeError(f"another {self._owner} is writing {self._path}") from None

    def _read(self) -> None:
        self._file.seek(0)
        content = self._file.read()
        whole = content.rfind(b"\n") + 1
        lines = content[:whole].splitlines()
        if lines and self._parse(1, lines[0]) != self._header:
            raise ValueError(f"{self._path} is not the journal of a {self._owner}")
        if not lines and not json.dumps(self._header).encode().startswith(content):
            raise ValueError(f"{self._path} is not the journal of a {self._owner}")
        for number, line in enumerate(lines[1:], start=2):
            try:
                row = self._table.from_mapping(self._parse(number, line))
            except ValueError as error:
                raise ValueError(
                    f"{self._path}, line {number} is damaged ({error}): delete that line to "
                    f"{self._verb} its {self._unit} again"
                ) from error
            self.rows.setdefault(row.key, row)
        self._file.truncate(whole)
        if not lines:
            self._write(self._header)

    def _parse(self, number: int, line: bytes) -> dict[str, Any]:
        try:
            values = json.loads(line)
        except (ValueError, RecursionError) as error:  # not JSON, not UTF-8 or a trap
            raise ValueError(f"{self._path}, line {number} is not JSON: {error}") from error
        if not isinstance(values, dict):
            raise ValueError(f"{self._path}, line {number} is not a JSON object")
        return values

    def _write(self, values: dict[str, Any]) -> None:
        """Append a line whole; after a failure (a full disk) the file ends where it did before."""
        end = self._file.seek(0, os.SEEK_END)
        try:
            line = json.dumps(values).encode() + b"\n"
            while line:
                line = line[self._file.write(line) :]
            os.fsync(self._file.fileno())
        except OSError:
            self._file.truncate(end)
            raise
