# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Journals: whole after any kill, each row once, damage told by line."""

from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ltp.evaluation.campaign.campaign import JOURNAL, FlightJournal
from tests.python.scenes import row


@settings(deadline=None)
@given(st.data())
def test_a_journal_cut_anywhere_keeps_its_whole_lines(data: st.DataObject) -> None:
    import tempfile

    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / JOURNAL
        rows = [row(key=f"k{i}", world="Zürich | « »") for i in range(4)]
        with FlightJournal(path) as journal:
            for line in rows:
                journal.append(line)
        whole = path.read_bytes()
        cut = data.draw(st.integers(0, len(whole)))
        path.write_bytes(whole[:cut])
        lines = whole[:cut].count(b"\n")
        with FlightJournal(path) as journal:
            assert list(journal.rows.values()) == rows[: max(0, lines - 1)]
            journal.append(row(key="new"))
        with FlightJournal(path) as journal:
            assert list(journal.rows) == [f"k{i}" for i in range(max(0, lines - 1))] + ["new"]


def test_a_journal_takes_each_flight_once(tmp_path: Path) -> None:
    with FlightJournal(tmp_path / JOURNAL) as journal:
        journal.append(row())
        with pytest.raises(ValueError, match="k0"):
            journal.append(row())


def test_a_damaged_journal_is_told_by_line(tmp_path: Path) -> None:
    path = tmp_path / JOURNAL
    with FlightJournal(path) as journal:
        for i in range(3):
            journal.append(row(key=f"k{i}"))
    lines = path.read_bytes().splitlines(keepends=True)
    lines[2] = lines[2].replace(b'"length": 550.0', b'"length": "far"')
    path.write_bytes(b"".join(lines))
    with pytest.raises(ValueError, match=r"journal.jsonl, line 3 is damaged .*length: 'far'"):
        FlightJournal(path)
    for content in (b"world,planner\n1,2\n", b"world", b"[]\n", b"\xff\xfe\n"):
        path.write_bytes(content)
        with pytest.raises(ValueError, match=r"journal\.jsonl"):
            FlightJournal(path)
        assert path.read_bytes() == content  # a stranger's file is left alone
