# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rows and flights as data frames."""

import sys

import numpy as np
import pytest

from ltp.evaluation import to_dataframe
from tests.python.scenes import record, row


def test_rows_keep_their_fields_and_values() -> None:
    rows = [row(), row(key="k1", scenario=1, time_plan_mean=None)]
    frame = to_dataframe(rows)
    assert list(frame.columns)[:3] == ["key", "world", "planner"]
    assert frame.mean_priority.tolist() == [0.5, 0.5] and frame.scenario.tolist() == [0, 1]
    assert frame.time_plan_mean.isna().tolist() == [False, True]


def test_a_flight_is_a_line_a_step() -> None:
    flight = record()
    frame = to_dataframe(flight)
    np.testing.assert_array_equal(frame[["x", "y", "z"]], flight.positions)
    np.testing.assert_array_equal(frame.time, flight.times)
    assert frame.path_distance.tolist() == [0.0] * 6  # along the global path itself
    assert frame.waypoint.dtype.kind == "i"


def test_without_pandas_it_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pandas", None)
    with pytest.raises(ImportError, match="pip install pandas"):
        to_dataframe([])
