# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The range of every number among the settings: outside of it a flight would hang or overflow.

The core checks what its own algorithms need; these are the limits of what makes sense. They are
generous, and *assumed*: nobody flies with a step of a nanosecond or a radius of a kilometre.
"""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from ltp.config.tables import field_names, plain


@dataclass(frozen=True)
class Range:
    """From `least` to `most`, both among them."""

    least: float
    most: float
    unit: str = ""
    infinite: bool = False  # inf is allowed, too

    def __contains__(self, value: Any) -> bool:
        return _is_number(value) and bool(
            self.least <= value <= self.most or (self.infinite and value == math.inf)
        )

    def __str__(self) -> str:
        unit = f" [{self.unit}]" if self.unit else ""
        return f"a number from {self.least:g} to {self.most:g}{', or inf' * self.infinite}{unit}"


#: Of a setting that has no row below.
ANY = Range(-1e9, 1e9, infinite=True)

_OPTIONS = "planner_options."
#: By key; of a list, every one of its numbers. A new setting is a new row.
RANGES: Mapping[str, Range] = {
    "fov_deg": Range(0.1, 170.0, "deg"),
    "step": Range(0.001, 10.0, "s"),
    "time_limit_factor": Range(0.001, 1000.0),
    "hold_limit": Range(0.001, 86_400.0, "s"),
    f"{_OPTIONS}weights.length": Range(0.0, 1e6),
    f"{_OPTIONS}weights.priority": Range(0.0, 1e6),
    f"{_OPTIONS}bezier.offsets": Range(1, 1001),
    f"{_OPTIONS}bezier.reach": Range(1e-3, 1e4, "m"),
    f"{_OPTIONS}bezier.z_offsets": Range(1, 101),
    f"{_OPTIONS}bezier.z_reach": Range(0.0, 1e4, "m"),
    f"{_OPTIONS}linearised.alpha": Range(0.0, 1e6),
    f"{_OPTIONS}linearised.tolerance": Range(0.0, 1e6),
    f"{_OPTIONS}linearised.searches": Range(1, 1000),
    f"{_OPTIONS}linearised.effort": Range(0, 10**12, "cells"),
    f"{_OPTIONS}linearised.closing": Range(0, 10**12, "cells"),
    f"{_OPTIONS}exact.memory": Range(0.1, 1e6, "MB"),
    f"{_OPTIONS}exact.eps": Range(0.0, 1e6),
    f"{_OPTIONS}ara.step": Range(0.01, 100.0),
    f"{_OPTIONS}risk.length_factor": Range(1e-6, 1e6),
    f"{_OPTIONS}tangent_bug.range": Range(0.0, 1e4, "m"),
    f"{_OPTIONS}hermite.starts": Range(1, 101),
    f"{_OPTIONS}hermite.refined": Range(1, 1000),
    f"{_OPTIONS}hermite.iterations": Range(0, 1000),
    "landing.max_slope": Range(0.0, 89.0, "deg"),
    "landing.max_roughness": Range(0.0, 100.0, "m"),
    "landing.gear_radius": Range(0.01, 100.0, "m"),
    "landing.max_height_above_ground": Range(0.0, 100.0, "m"),
    "landing.clearance": Range(0.0, 1e4, "m"),
    "vehicle.speed": Range(0.01, 200.0, "m/s"),
    "vehicle.max_acceleration": Range(0.01, 1000.0, "m/s^2"),
    "vehicle.max_climb": Range(0.01, 200.0, "m/s"),
    "guidance.look_ahead": Range(0.1, 100.0, "cells"),
    "guidance.tolerance": Range(0.01, 100.0, "cells"),
    "guidance.lateral_share": Range(0.01, 1.0),
    "guidance.braking_share": Range(0.01, 1.0),
    "guidance.stop_margin": Range(0.0, 1000.0, "m"),
    "lidar.min_range": Range(0.0, 1e3, "m"),
    "lidar.max_range": Range(0.1, 1e4, "m"),
    "lidar.range_noise_sd": Range(0.0, 100.0, "m"),
    "lidar.seed": Range(0, 2**64 - 1),
    "mapping.cell": Range(0.01, 100.0, "m"),
    "mapping.dims": Range(1, 10_000, "cells"),
    "mapping.inflation_radius": Range(0.0, 100.0, "m"),
    "mapping.margin": Range(0.0, 100.0, "m"),
    "mapping.max_range": Range(0.1, 1e4, "m"),
    "mapping.blind_distance": Range(0.0, 1e3, "m"),
    "mapping.body_min": Range(-1e3, 1e3, "m"),
    "mapping.body_max": Range(-1e3, 1e3, "m"),
    "mapping.hit_log_odds": Range(0.0, 100.0),
    "mapping.miss_log_odds": Range(-100.0, 0.0),
    "mapping.min_log_odds": Range(-100.0, 0.0),
    "mapping.max_log_odds": Range(0.0, 100.0),
    "navigation.band": Range(0.0, 1e5, "m", infinite=True),
    "navigation.climb": Range(0.0, 1e5, "m", infinite=True),
    "navigation.reach_distance": Range(0.0, 1000.0, "m"),
    "navigation.leave_distance": Range(0.0, 1e4, "m"),
    "navigation.escape_distance": Range(0.01, 1e4, "m"),
    "navigation.gate_radius": Range(0.0, 1000.0, "m"),
    "navigation.gate_height": Range(0.0, 1000.0, "m"),
    "navigation.horizon": Range(1, 20),
    "navigation.max_expansions": Range(0, 10**12, "cells"),
    "navigation.time_limit": Range(0.0, 3600.0, "s"),
    "navigation.max_detour": Range(0.0, 1e6, "m"),
}

GATE = Range(0.0, 1000.0, "m")  # where `gate` is a number

_MOST_CELLS = 10**8  # of the window: 60 times the default's, some GB
_WIDEST = 64  # cells that the radius may span: every one within it is visited


def check_ranges(holder: Any, prefix: str = "") -> None:
    """Raise `ValueError` naming the first number out of its range, its value and the range.

    Args:
        holder: a dataclass of settings, or the core's options.
        prefix: of its keys: "vehicle." or "".
    """
    for key, setting, values in numbers(holder, prefix):
        allowed = RANGES.get(key, ANY)
        for value in values:
            if value not in allowed:
                raise ValueError(f"{key} = {setting!r:.80}: expected {allowed}")


def check_window(mapping: Any) -> None:
    """Raise `ValueError` if the window's cells, or those within the radius, are too many."""
    cells = math.prod(int(length) for length in mapping.dims)
    if cells > _MOST_CELLS:
        raise ValueError(
            f"mapping.dims = {plain(mapping.dims)!r}: expected at most {_MOST_CELLS:,} cells in all"
        )
    smallest = float(min(mapping.cell))
    for name, radius in (
        ("mapping.inflation_radius", mapping.inflation_radius),
        ("mapping.inflation_radius + mapping.margin", mapping.inflation_radius + mapping.margin),
    ):
        if radius > _WIDEST * smallest:
            raise ValueError(
                f"{name} = {radius!r}: expected at most {_WIDEST} cells of {smallest:g} m"
            )


def numbers(holder: Any, prefix: str = "") -> Iterator[tuple[str, Any, list[Any]]]:
    """Key, value and the numbers in it, of every setting that is a number, some, or should be."""
    for name in field_names(holder):
        value = getattr(holder, name)
        if field_names(value):
            yield from numbers(value, f"{prefix}{name}.")
            continue
        value = plain(value)
        default = getattr(type(holder), name, None)  # where a dataclass keeps it
        if _is_number(default) or _is_number(value):
            yield prefix + name, value, [value]
        elif isinstance(value, list) and any(map(_is_number, value)):
            yield prefix + name, value, value


def _is_number(value: Any) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)
