# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Campaigns: many flights over one world, their rows, the paper's tables, paired comparisons."""

from .campaign import JOURNAL, RECORDS, TABLE, Campaign, run_campaign
from .rows import FlightRow, read_rows, write_rows
from .variants import TABLE_I, TABLE_II, Variant

__all__ = [
    "JOURNAL",
    "RECORDS",
    "TABLE",
    "TABLE_I",
    "TABLE_II",
    "Campaign",
    "FlightRow",
    "Variant",
    "read_rows",
    "run_campaign",
    "write_rows",
]
