# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`GapRow`: one plan for one query as one row of a CSV, held against the query's optimum."""

import dataclasses
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..contenders import OPTIMUM, on_grid, with_current_name
from ..row_table import RowTable
from .cases import Case

PROVED = 1e-6  # of Eq. 5: an answer so close to its own bound is the optimum


@dataclass(frozen=True, kw_only=True)
class GapRow:
    """One plan for one query. None is an empty field."""

    key: str  # of everything that decides the plan
    world: str
    query: int  # its place in the set
    scenario: int
    priority_map: str
    band: str  # see `queries.BANDS`
    ratio: float  # W_P / W_L
    planner: str  # name of a `Contender`, or `OPTIMUM`
    status: str  # of `ltp.PlanStatus`, in lower case
    penalty: float | None  # Eq. 5
    length: float | None  # L [m]
    mean_priority: float | None  # of the path, -Eq. 4
    direct_length: float  # L_direct [m]
    bound: float | None  # the planner's certificate: no grid path has a smaller penalty
    expanded: int  # cells
    time_plan: float  # wall time of the search [ms]
    optimum: float | None = None  # of the query; the best known where it is not proved
    optimum_bound: float | None = None  # within `PROVED` of `optimum` where it is proved
    gap: float | None = None  # penalty - optimum

    @property
    def case(self) -> Case:
        """What it was planned under."""
        return Case(self.priority_map, self.band, self.ratio)

    @property
    def proved(self) -> bool:
        """Whether `optimum` is known to be the optimum."""
        known = self.optimum is not None and self.optimum_bound is not None
        return known and self.optimum - self.optimum_bound <= PROVED  # type: ignore[operator]


class _GapTable(RowTable[GapRow]):
    """Also reads what older versions wrote."""

    def from_mapping(self, values: Mapping[str, Any]) -> GapRow:
        return super().from_mapping(with_current_name(values))


PLANS = _GapTable(GapRow, "a table of gaps")
read_gaps = PLANS.read


def with_optimum(rows: Sequence[GapRow]) -> list[GapRow]:
    """Give each row its query's optimum.

    That is the answer of the reference where it meets its own bound. Elsewhere `optimum` is the
    best penalty that any planner found on the grid, and `optimum_bound` the best bound: the truth
    lies between.
    """
    groups: dict[tuple[Case, int], list[GapRow]] = {}
    for row in rows:
        groups.setdefault((row.case, row.query), []).append(row)
    found = {key: _optimum(group) for key, group in groups.items()}
    return [_against(row, *found[row.case, row.query]) for row in rows]


def _against(row: GapRow, optimum: float | None, bound: float | None) -> GapRow:
    gap = None if row.penalty is None or optimum is None else row.penalty - optimum
    return dataclasses.replace(row, optimum=optimum, optimum_bound=bound, gap=gap)


def _optimum(group: Sequence[GapRow]) -> tuple[float | None, float | None]:
    """The optimum or the best known penalty, and the bound below it."""
    for row in group:
        if row.planner != OPTIMUM or row.penalty is None or row.bound is None:
            continue
        if row.penalty - row.bound <= PROVED:
            return row.penalty, row.bound
    bound_to_it = [row for row in group if on_grid(row.planner)]
    penalties = [row.penalty for row in bound_to_it if row.penalty is not None]
    bounds = [row.bound for row in bound_to_it if row.bound is not None]
    return min(penalties, default=None), max(bounds, default=None)
