# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The one list of planner names, and making a planner by its name."""

from typing import Any

from ltp._core import Planner, PlannerOptions, planner_names

PLANNERS: tuple[str, ...] = tuple(planner_names())
"""Every planner's name, in the order of the paper's tables."""


def make_planner(name: str = "auto", **options: Any) -> Planner:
    """Make a planner.

    Args:
        name: one of `PLANNERS`; docs/planners.md says which is for what.
        options: fields of `ltp.PlannerOptions`: length_weight (W_L of Eq. 5, default 0.5),
            priority_weight (W_P, default 1.0), max_expansions, scaled_heuristic, refine (free the
            path from the grid's directions), and those of single planners: bezier, linearised,
            pareto, ara, risk, bug, hermite.

    Raises:
        ValueError: an unknown name (those known are listed), or a value out of range.
        TypeError: an option that does not exist.
    """
    return Planner(name, PlannerOptions(**options))
