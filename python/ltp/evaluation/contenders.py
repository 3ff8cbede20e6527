# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Contender`: who is compared, by one name: a planner, the same refined, or the shortest path."""

import warnings
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from ltp._core import Plan, Planner, penalty, planner_info
from ltp.registry import INFO, PLANNERS, make_planner, planner_title

from .conditions import Weights

#: After a planner's name: the planner with its paths refined.
REFINE = "+refine"
#: The contender that knows lengths only: LP-Dijkstra with W_P = 0, judged by the weights at hand.
SHORTEST = "shortest"
BASELINE = "lp-dijkstra"
#: Stands for a contender in rows: the reference planner, given the time that it needs.
OPTIMUM = "optimum"

_TITLES = {SHORTEST: "Shortest path", OPTIMUM: "Optimum"}


@dataclass(frozen=True)
class Contender:
    """A planner as tables and the command line name it: a planner's name, the same with `+refine`,
    or `shortest`.

    Raises:
        ValueError: if there is no such planner.
    """

    name: str

    def __post_init__(self) -> None:
        if self.name != SHORTEST and self.planner not in PLANNERS:
            known = ", ".join((SHORTEST, *PLANNERS))
            raise ValueError(f"planner {self.name!r} is none of {known} (or one with {REFINE})")

    @classmethod
    def of(cls, planner: str, refine: bool) -> "Contender":
        """The one that flies a planner, with refined paths or without."""
        return cls(planner + (REFINE if refine else ""))

    @property
    def planner(self) -> str:
        """Its planner, one of `ltp.PLANNERS`."""
        return BASELINE if self.name == SHORTEST else self.name.removesuffix(REFINE)

    @property
    def refine(self) -> bool:
        """Whether paths are shortened between cells, and may so be better than any grid path."""
        return is_refined(self.name)

    @property
    def title(self) -> str:
        """How tables and figures name it."""
        return contender_title(self.name)

    def make(self, ratio: float, **options: Any) -> Planner:
        """The planner for weights of this ratio."""
        weights = Weights.at_ratio(0.0 if self.name == SHORTEST else ratio)
        if self.refine:
            options["refine"] = True
        return make_planner(self.planner, weights=weights.of_core, **options)

    def judge(self, plan: Plan, direct: float, ratio: float) -> tuple[float, float | None]:
        """Eq. 5 of a path found, by the weights of this ratio, and the bound that holds for it."""
        judged = penalty(plan.tally, direct, Weights.at_ratio(ratio).of_core)
        # What is proved for W_P = 0 says nothing about other weights.
        return judged, None if self.name == SHORTEST else plan.bound


def contender_title(name: str) -> str:
    """How tables and figures name a contender, also one of an older version, and the optimum."""
    title = _TITLES.get(name) or planner_title(name.removesuffix(REFINE))
    return title + (", refined" if is_refined(name) else "")


def current_name(name: str) -> str:
    """A contender's name with its planner's old name, if it is one, become the new one.

    Warns of an old name; what is no planner's name stays as it is.
    """
    planner, plus, suffix = name.partition("+")
    try:
        return planner_info(planner).name + plus + suffix
    except ValueError:
        return name


def with_current_name(values: Mapping[str, Any]) -> Mapping[str, Any]:
    """A row of a table, of which nobody need be told that an older version wrote it."""
    name = values.get("planner")
    if not isinstance(name, str):
        return values
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)
        return {**values, "planner": current_name(name)}


def is_refined(name: str) -> bool:
    """Whether a contender's paths are refined."""
    return name.endswith(REFINE)


def on_grid(name: str) -> bool:
    """Whether a contender's paths follow the grid's steps, so that none beats the grid's best."""
    return not is_refined(name) and (name not in INFO or INFO[name].on_grid)
