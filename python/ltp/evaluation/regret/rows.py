# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`RegretRow`: one flight against the best routes over known ground, as one row of a CSV."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ..campaign.variants import Variant
from ..contenders import with_current_name
from ..row_table import RowTable
from .gating import Gating, radius_text


@dataclass(frozen=True, kw_only=True)
class RegretRow:
    """What was flown, and what one could have flown knowing all obstacles. None is an empty field.

    All penalties are Eq. 5 of whole routes, L_direct being the global path's length.
    """

    key: str  # of the flight's key and of the gates
    world: str
    planner: str
    length_weight: float  # W_L
    priority_weight: float  # W_P
    priority_map: str
    refine: bool
    scenario: int
    seed: int
    outcome: str  # of the flight
    waypoints: int  # of the global path, without its start
    served: int  # of these by the flight; the routes serve the same ones
    gates: str = ""  # that the routes pass, as asked for, see `Gating`; "": not recorded
    flown_gates: str = ""  # the same of the flight
    horizon: int = 1  # how many of them the flight planned jointly
    gate: float  # largest radius within which the routes serve a waypoint but the last [m]
    last_gate: float  # the same of the last one [m]
    global_length: float  # of the global path: L_direct [m]
    flown: float  # Eq. 5
    flown_length: float  # [m]
    flown_priority: float  # mean along it
    legs: float | None  # Eq. 5 of the best legs; None: no way through the true world's cells
    legs_length: float | None  # [m]
    legs_priority: float | None
    joint: float | None  # Eq. 5 of the best route
    joint_length: float | None  # [m]
    joint_priority: float | None
    joint_bound: float | None  # no route of the planners' graph has a lower Eq. 5
    time_legs: float  # wall time of the search [s]
    time_joint: float  # [s]

    @property
    def path(self) -> tuple[int, int]:
        """The global path that was flown along: seed and index of its scenario."""
        return self.seed, self.scenario

    @property
    def variant(self) -> Variant:
        """What was flown: a table's row gathers the flights of one."""
        weights = self.length_weight, self.priority_weight
        return Variant(self.planner, *weights, self.priority_map, self.refine)

    @property
    def gating(self) -> Gating:
        """The gates that were asked for: flights of other gates are other rows of a table."""
        judged = self.gates or radius_text(self.gate)
        return Gating(judged, self.flown_gates or judged, self.horizon)

    @property
    def counts(self) -> bool:
        """Whether it has a regret: the flight came to its end, and there are routes to compare."""
        return self.outcome == "reached" and None not in (self.legs, self.joint)


class _RegretTable(RowTable[RegretRow]):
    """Also reads planners' old names."""

    def from_mapping(self, values: Mapping[str, Any]) -> RegretRow:
        return super().from_mapping(with_current_name(values))


REGRETS = _RegretTable(RegretRow, "a table of regrets")
read_regrets = REGRETS.read
