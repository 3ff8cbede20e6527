# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The planners by their names: what each is, and making one."""

import warnings
from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

from ltp._core import Planner, PlannerInfo, PlannerOptions, planners

INFO: Mapping[str, PlannerInfo] = MappingProxyType({info.name: info for info in planners()})
"""What each planner is, by its name, in the order of the paper's tables."""

PLANNERS: tuple[str, ...] = tuple(INFO)
"""Every planner's name, in that order."""

_WEIGHTS = {"length_weight": "length", "priority_weight": "priority"}  # until the next release


def make_planner(name: str = "auto", **options: Any) -> Planner:
    """Make a planner.

    Args:
        name: one of `PLANNERS`; docs/planners.md says which is for what.
        options: fields of `ltp.PlannerOptions`, such as weights (`ltp.PenaltyWeights`: W_L and W_P
            of Eq. 5, default 0.5 and 1.0), refine (free the path from the grid's directions), and
            the options of single planners.

    Raises:
        ValueError: an unknown name (those known are listed), or a value out of range.
        TypeError: an option that does not exist.
    """
    old = {option: options.pop(option) for option in _WEIGHTS if option in options}
    made = PlannerOptions(**options)
    for option, value in old.items():
        text = f"make_planner({option}=): use weights=PenaltyWeights({_WEIGHTS[option]}=)"
        warnings.warn(text, DeprecationWarning, stacklevel=2)
        setattr(made.weights, _WEIGHTS[option], value)
    return Planner(name, made)


def planner_title(name: str) -> str:
    """How a planner is written; a name that is unknown (an older version's) as it stands."""
    return INFO[name].title if name in INFO else name
