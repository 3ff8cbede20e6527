# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRow`: one flight of a campaign as one row of a CSV, out and in."""

import csv
import dataclasses
import io
import math
import os
import types
import typing
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ltp.files import atomic_write

#: Columns that hold measured times and so differ from run to run begin with this.
TIME_PREFIX = "time_"


@dataclass(frozen=True, kw_only=True)
class FlightRow:
    """What a table or a plot wants to know of a flight. None is an empty field."""

    key: str  # of everything that decides the flight; see `campaign.flight_key`
    world: str
    planner: str
    length_weight: float  # W_L
    priority_weight: float  # W_P
    priority_map: str
    refine: bool = False  # whether paths were refined; campaigns before it was an option had none
    scenario: int
    seed: int
    crosses_building: bool  # the straight global path does
    outcome: str  # reached, timed_out, collided
    way_points: int  # to reach: the start is none
    reached: int  # way-points reached
    dropped: int  # way-points dropped as proved unreachable
    dropped_goal_blocked: int  # of these: the way-point lay in a blocked cell
    dropped_unreachable: int  # of these: no free path led there
    wrongly_dropped: int  # of these: the true world's own cells have a way there
    collided: bool
    mean_priority: float
    length: float  # flown [m]
    length_ratio: float  # flown over the global path's length, L_LP / L_GP
    penalty: float  # Eq. (5) on the flown path
    min_clearance: float  # to the true world's solid [m]
    end_distance: float  # from where the flight ended to the end of the global path [m]
    duration: float  # simulated [s]
    plans: int
    plans_found: int
    expanded: int  # cells expanded by all searches together
    time_plan_mean: float | None  # wall time of a search [ms]
    time_plan_median: float | None  # [ms]
    time_plan_p95: float | None  # [ms]
    time_plans: str  # all of them, "|" between [ms]
    time_flight: float  # wall time of the whole simulated flight [s]

    @property
    def plan_times(self) -> list[float]:
        """The wall times of the searches [ms]."""
        return [float(text) for text in self.time_plans.split("|") if text]

    @property
    def variant(self) -> tuple[str, float, float, str, bool]:
        """Planner, W_L, W_P, priority map, refined: what a table's row gathers."""
        weights = self.length_weight, self.priority_weight
        return self.planner, *weights, self.priority_map, self.refine


COLUMNS = tuple(field.name for field in dataclasses.fields(FlightRow))
_TYPES = typing.get_type_hints(FlightRow)
_DEFAULTS = {
    field.name: field.default
    for field in dataclasses.fields(FlightRow)
    if field.default is not dataclasses.MISSING
}


def to_mapping(row: FlightRow) -> dict[str, Any]:
    """The row as plain values by column."""
    return {name: getattr(row, name) for name in COLUMNS}


def from_mapping(values: Mapping[str, Any]) -> FlightRow:
    """The row of plain values or CSV texts by column; columns with a default may be missing.

    Raises:
        ValueError: naming the columns that are missing, unknown or hold no value of their type.
    """
    values = {**_DEFAULTS, **values}
    if missing := [name for name in COLUMNS if values.get(name) is None and not _optional(name)]:
        raise ValueError(f"missing columns: {', '.join(missing)}")
    if unknown := [str(name) for name in values if name not in COLUMNS]:
        raise ValueError(f"unknown columns: {', '.join(unknown)}")
    return FlightRow(**{name: _parse(name, values.get(name)) for name in COLUMNS})


def write_rows(path: str | os.PathLike[str], rows: Iterable[FlightRow]) -> None:
    """Write the CSV, all or nothing; numbers as their shortest exact text."""
    lines = [_line(COLUMNS)]
    lines += [_line([_text(value) for value in to_mapping(row).values()]) for row in rows]
    with atomic_write(path) as file:
        file.write("".join(lines).encode())


def read_rows(path: str | os.PathLike[str]) -> list[FlightRow]:
    """Read what `write_rows` wrote.

    Raises:
        OSError: if the file cannot be read.
        ValueError: naming the file, the line and what is wrong with it.
    """
    try:
        with Path(path).open(newline="", encoding="utf-8") as file:
            reader = csv.DictReader(file, restkey="beyond the last column")
            rows = [_read_line(path, reader.line_num, line) for line in reader]
            if not set(COLUMNS) - set(_DEFAULTS) <= set(reader.fieldnames or ()):  # no line told
                raise ValueError(f"{path}: missing columns, it is not a table of flights")
            return rows
    except (UnicodeDecodeError, csv.Error) as error:
        raise ValueError(f"{path} is not a table of flights: {error}") from error


def _line(cells: Sequence[str]) -> str:
    # With its own line ending the writer also quotes a lone carriage return.
    text = io.StringIO()
    csv.writer(text, lineterminator="\r\n").writerow(cells)
    return text.getvalue().removesuffix("\r\n") + "\n"


def _read_line(path: str | os.PathLike[str], number: int, line: Mapping[str, Any]) -> FlightRow:
    try:
        return from_mapping(line)
    except ValueError as error:
        raise ValueError(f"{path}, line {number}: {error}") from error


def _optional(name: str) -> bool:
    return isinstance(_TYPES[name], types.UnionType)


def _text(value: object) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return "yes" if value else "no"
    return repr(value) if isinstance(value, float) else str(value)


def _parse(name: str, value: Any) -> Any:
    kind = _TYPES[name]
    if _optional(name):
        if value in (None, ""):
            return None
        kind = float
    try:
        if kind is bool:
            return {"yes": True, "no": False, True: True, False: False}[value]
        number = kind(value)
    except (KeyError, TypeError, ValueError):
        raise ValueError(f"{name}: {value!r} is not a {kind.__name__}") from None
    if kind is float and math.isnan(number):
        raise ValueError(f"{name}: not a number")
    return number
