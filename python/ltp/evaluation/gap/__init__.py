# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gaps: every planner on queries recorded in flight, held against the exact optimum of Eq. 5."""

from .cases import Case, GapOptions
from .comparison import JOURNAL, TABLE, run_gap
from .queries import QuerySet, record_queries
from .rows import GapRow, read_gaps

__all__ = [
    "JOURNAL",
    "TABLE",
    "Case",
    "GapOptions",
    "GapRow",
    "QuerySet",
    "read_gaps",
    "record_queries",
    "run_gap",
]
