# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Presets: the cells and the window of the map, by how high one flies; and whether one climbs."""

from collections.abc import Mapping
from types import MappingProxyType
from typing import Any

#: Settings by name, tables as in TOML; maps with the coarsest cells first.
PRESETS: Mapping[str, Mapping[str, Any]] = MappingProxyType(
    {
        # The paper's map, inflated by whole cells and no more than its window, and planar flight.
        "paper": {
            "mapping": {
                "cell": [2.0, 2.0, 4.0],
                "dims": [200, 200, 40],
                "inflate_whole_cells": True,
                "remember": False,
            },
            "navigation": {"climb": 0.0},
        },
        # What `ltp fly` does: over what is in the way, where that is shorter. See docs/method.md.
        "fly": {"navigation": {"climb": 20.0}},
        # Streets and gardens: 200 m wide, 80 m high.
        "low": {"mapping": {"cell": [1.0, 1.0, 1.0], "dims": [200, 200, 80]}},
        # The last metres: 60 m wide and high.
        "landing": {"mapping": {"cell": [0.5, 0.5, 0.5], "dims": [120, 120, 120]}},
    }
)

#: A flight so many cells above the ground still has a free one above and below it (*assumed*).
_LEAST_CELLS = 3


def preset(name: str) -> Mapping[str, Any]:
    """The settings of a preset, nested as in TOML.

    Raises:
        ValueError: naming the preset that does not exist, and those that do.
    """
    if name not in PRESETS:
        raise ValueError(f"preset = {name!r}: expected one of {', '.join(PRESETS)}")
    return PRESETS[name]


def finer_preset(height: float, cell_height: float) -> str | None:
    """The preset that a flight asks for; None if its cells are fine enough.

    Args:
        height: the least above the ground on the way [m].
        cell_height: of the cells that it has [m].
    """
    if height >= _LEAST_CELLS * cell_height:
        return None
    heights = {
        name: values["mapping"]["cell"][2]
        for name, values in PRESETS.items()
        if "mapping" in values
    }
    finer = [name for name in heights if heights[name] < cell_height]
    enough = [name for name in finer if height >= _LEAST_CELLS * heights[name]]
    return next(iter([*enough, *reversed(finer)]), None)
