# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRow`: one flight of a campaign as one row of a CSV, out and in."""

from dataclasses import dataclass

from .row_table import RowTable

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
    waypoints: int  # to reach: the start is none
    reached: int  # waypoints reached
    dropped: int  # waypoints dropped as proved unreachable
    dropped_goal_blocked: int  # of these: the waypoint lay in a blocked cell
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


FLIGHTS = RowTable(FlightRow, "a table of flights")

COLUMNS = FLIGHTS.columns
write_rows = FLIGHTS.write
read_rows = FLIGHTS.read
