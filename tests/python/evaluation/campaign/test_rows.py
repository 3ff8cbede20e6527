# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows of flights as a CSV: out and in to the last bit, older files too, damage told by line."""

import csv
from pathlib import Path

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from ltp.evaluation.campaign.campaign import JOURNAL, FlightJournal
from ltp.evaluation.campaign.rows import read_rows, write_rows
from tests.python.scenes import row

texts = st.text(st.characters(codec="utf-8", exclude_characters="\x00"), max_size=20)
reals = st.floats(allow_nan=False)


@example(
    world='a\rb\nc,"d"',
    length=0.1,
    priority=0.0,
    clearance=1e300,
    time=None,
    collided=False,
    scenario=0,
)
@given(
    world=texts,
    length=reals,
    priority=st.floats(0, 1),
    clearance=reals,
    time=st.none() | reals,
    collided=st.booleans(),
    scenario=st.integers(0, 10**9),
)
def test_rows_survive_the_csv_exactly(
    world: str,
    length: float,
    priority: float,
    clearance: float,
    time: float | None,
    collided: bool,
    scenario: int,
) -> None:
    import tempfile

    line = row(
        world=world,
        length=length,
        mean_priority=priority,
        min_clearance=clearance,
        time_plan_mean=time,
        collided=collided,
        scenario=scenario,
    )
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "flights.csv"
        write_rows(path, [line, row()])
        assert read_rows(path) == [line, row()]


def test_a_csv_from_before_refinement_was_flown_without(tmp_path: Path) -> None:
    path = tmp_path / "flights.csv"
    write_rows(path, [row(), row(refine=True)])
    table = [line.split(",") for line in path.read_text().splitlines()]
    column = table[0].index("refine")
    assert [line[column] for line in table[1:]] == ["no", "yes"]
    path.write_text("".join(",".join(x[:column] + x[column + 1 :]) + "\n" for x in table[:2]))
    assert read_rows(path) == [row()]


def test_a_csv_from_before_the_distance_and_the_reason_is_read(tmp_path: Path) -> None:
    path = tmp_path / "flights.csv"
    write_rows(path, [row(reason="", path_distance_mean=1.5, path_distance_max=4.0)])
    assert read_rows(path)[0].path_distance_max == 4.0
    newer = ("reason", "path_distance_mean", "path_distance_max")
    lines = list(csv.DictReader(path.read_text().splitlines()))
    with path.open("w", newline="") as file:
        table = csv.DictWriter(file, [name for name in lines[0] if name not in newer])
        table.writeheader()
        table.writerow({name: lines[0][name] for name in table.fieldnames})
    assert read_rows(path) == [row()]
    assert (row().reason, row().path_distance_mean) == ("", None)


@pytest.mark.parametrize(
    ("old", "new", "complaint"),
    [
        ("550.0", "far", "line 2: length: 'far'"),
        ("550.0", "nan", "line 2: length"),
        ("yes", "maybe", "line 2: crosses_building: 'maybe'"),
        ("length_ratio", "ratio", "missing columns: length_ratio"),
        ("0.5\n", "0.5,7\n", "line 2: unknown columns"),
    ],
)
def test_a_damaged_csv_is_told_by_line(tmp_path: Path, old: str, new: str, complaint: str) -> None:
    path = tmp_path / "flights.csv"
    write_rows(path, [row()])
    path.write_text(path.read_text().replace(old, new, 1))
    with pytest.raises(ValueError, match=complaint) as error:
        read_rows(path)
    assert "flights.csv" in str(error.value)


@pytest.mark.parametrize("count", [0, 2])
def test_a_csv_from_before_a_column_was_renamed_is_read(tmp_path: Path, count: int) -> None:
    path = tmp_path / "flights.csv"
    rows = [row(key=f"k{i}", waypoints=10 + i) for i in range(count)]
    write_rows(path, rows)
    path.write_text(path.read_text().replace(",waypoints,", ",way_points,", 1))
    assert ",way_points," in path.read_text() and ",waypoints," not in path.read_text()
    assert read_rows(path) == rows
    path.write_text(path.read_text().replace(",length_ratio,", ",ratio,", 1) + "1\n")
    with pytest.raises(ValueError, match=r"flights\.csv, line .*missing columns: .*length_ratio"):
        read_rows(path)


def test_a_journal_from_before_a_column_was_renamed_is_read(tmp_path: Path) -> None:
    path = tmp_path / JOURNAL
    with FlightJournal(path) as journal:
        journal.append(row())
    path.write_text(path.read_text().replace('"waypoints"', '"way_points"'))
    with FlightJournal(path) as journal:
        assert journal.rows == {"k0": row()}
