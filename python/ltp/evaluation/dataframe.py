# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows and flights as pandas data frames, where pandas is installed."""

import dataclasses
from collections.abc import Iterable
from typing import Any

import numpy as np

from ltp.sim.record import FlightRecord

from .off_path import distances_to_path
from .row_table import Keyed


def to_dataframe(rows: Iterable[Keyed] | FlightRecord) -> Any:
    """A table as a `pandas.DataFrame`: a line a row of a campaign or of gaps, or, of one flight, a
    line a step.

    Of a flight the columns are `time` [s], `x`, `y`, `z` [m], `vx`, `vy`, `vz` [m/s] (world frame),
    `plan` and `waypoint` (indices), `path_distance` (horizontal, from the global path [m]). Of rows
    they are their fields.

    Raises:
        ImportError: if pandas is not installed.
    """
    try:
        import pandas
    except ImportError as error:
        raise ImportError(f"to_dataframe needs pandas: pip install pandas ({error})") from error
    if not isinstance(rows, FlightRecord):
        values: list[Any] = list(rows)
        return pandas.DataFrame([dataclasses.asdict(row) for row in values])
    names = ("time", "x", "y", "z", "vx", "vy", "vz")
    steps = np.column_stack([rows.times, rows.positions, rows.velocities])
    away = distances_to_path(rows.positions, rows.global_path)
    frame = pandas.DataFrame(steps, columns=names)
    return frame.assign(plan=rows.plan_index, waypoint=rows.waypoint_index, path_distance=away)
