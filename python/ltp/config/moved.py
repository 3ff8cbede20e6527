# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings that have moved, and where to: their old names are understood for one release."""

import sys
import warnings
from typing import Any

#: Old key of a `MissionConfig` -> new one, tables and keys with dots between.
MOVED = {
    "length_weight": "planner_options.weights.length",
    "priority_weight": "planner_options.weights.priority",
    "scaled_heuristic": "planner_options.scaled_heuristic",
    "max_expansions": "navigation.max_expansions",
    "refine": "planner_options.refine",
    "bezier": "planner_options.bezier",
    "linearised": "planner_options.linearised",
    "pareto": "planner_options.exact",
    "ara": "planner_options.ara",
    "risk": "planner_options.risk",
    "bug": "planner_options.tangent_bug",
    "hermite": "planner_options.hermite",
}

#: Table -> keys that older files hold and that have no effect any more: they are passed over.
GONE = {"navigation": ("memory_widths",)}


def warn_of(name: str) -> None:
    """Issue the `DeprecationWarning` of one of `MOVED`, at the line that called this package."""
    level = 2
    while _is_ours(sys._getframe(level).f_globals):
        level += 1
    text = f"the setting {name!r} is now {MOVED[name]!r}; the old name goes with the next release"
    warnings.warn(text, DeprecationWarning, stacklevel=level + 1)


def with_new_names(values: dict[str, Any]) -> dict[str, Any]:
    """Nested settings with every old key where it belongs now, or gone; `values` stays as it is.

    Raises:
        ValueError: if a setting is given under both of its names, or a table is none.
    """
    moved = {name: value for name, value in values.items() if name not in MOVED}
    for table, keys in GONE.items():
        if isinstance(moved.get(table), dict):
            moved[table] = {key: value for key, value in moved[table].items() if key not in keys}
    for name in MOVED.keys() & values.keys():
        *tables, key = MOVED[name].split(".")
        holder = moved
        for table in tables:
            inner = holder.get(table, {})
            if not isinstance(inner, dict):
                raise ValueError(f"{table} = {inner!r}: expected a table")
            holder[table] = dict(inner)
            holder = holder[table]
        if key in holder:
            raise ValueError(f"{name!r} is the old name of {MOVED[name]!r}: give only one of them")
        holder[key] = values[name]
    return moved


def _is_ours(variables: dict[str, Any]) -> bool:
    return str(variables.get("__name__", "")).startswith("ltp.config.")
