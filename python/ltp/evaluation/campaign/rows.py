# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRow`: one flight of a campaign as one row of a CSV, out and in."""

import csv
import os
import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ltp.files import blamed_on

from ..contenders import with_current_name
from ..row_table import RowTable
from .variants import Variant

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
    outcome: str  # reached, nothing_reached, timed_out, collided
    reason: str = ""  # why it ended so, a sentence without its full stop; "": not recorded
    waypoints: int  # to reach: the start is none
    reached: int  # waypoints reached
    dropped: int  # waypoints dropped as proved unreachable
    too_far: int = 0  # waypoints skipped as too far; there were none before `max_detour`
    dropped_goal_blocked: int  # of these: the waypoint lay in a blocked cell
    dropped_unreachable: int  # of these: no free path led there
    wrongly_dropped: int  # of these: the true world's own cells have a way there
    wrongly_dropped_fine: int | None = None  # of these: by cells of 0.5 m
    collided: bool
    mean_priority: float
    length: float  # flown [m]
    length_ratio: float  # flown over the global path's length, L_LP / L_GP
    path_distance_mean: float | None = None  # from the global path, see `off_path` [m]
    path_distance_max: float | None = None  # the largest [m]
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
    def way_points(self) -> int:
        """The old name of `waypoints`, for one release."""
        warnings.warn("`way_points` is now `waypoints`", DeprecationWarning, stacklevel=2)
        return self.waypoints

    @property
    def completed(self) -> bool:
        """Whether it came to its end and reached a waypoint; `dropped`, `too_far`: the others."""
        return self.outcome == "reached"

    @property
    def path(self) -> tuple[int, int]:
        """The global path that was flown along: seed and index of its scenario."""
        return self.seed, self.scenario

    @property
    def plan_times(self) -> list[float]:
        """The wall times of the searches [ms]."""
        return [float(text) for text in self.time_plans.split("|") if text]

    @property
    def variant(self) -> Variant:
        """What was flown: a table's row gathers the flights of one."""
        weights = self.length_weight, self.priority_weight
        return Variant(self.planner, *weights, self.priority_map, self.refine)


#: Columns by the names that older versions wrote.
_RENAMED = {"way_points": "waypoints"}


class _FlightTable(RowTable[FlightRow]):
    """Also reads what older versions wrote."""

    def from_mapping(self, values: Mapping[str, Any]) -> FlightRow:
        named = {_RENAMED.get(name, name): value for name, value in values.items()}
        return super().from_mapping(with_current_name(named))

    def read(self, path: str | os.PathLike[str]) -> list[FlightRow]:
        with Path(path).open("rb") as file:
            header = file.readline().decode(errors="replace").strip().split(",")
        if not set(_RENAMED) & set(header):
            return super().read(path)
        with (
            blamed_on(path, "a table of flights"),
            Path(path).open(newline="", encoding="utf-8") as file,
        ):
            reader = csv.DictReader(file, restkey="beyond the last column")
            return [self._read_line(path, reader.line_num, line) for line in reader]


FLIGHTS = _FlightTable(FlightRow, "a table of flights")

COLUMNS = FLIGHTS.columns
write_rows = FLIGHTS.write
read_rows = FLIGHTS.read
