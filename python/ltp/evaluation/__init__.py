# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""From many flights to the paper's tables and figures: scenarios, campaign, metrics, drawings."""

from .campaign import Campaign, run_campaign
from .rows import FlightRow, read_rows
from .scenarios import Scenario, ScenarioOptions, make_scenarios
from .variants import TABLE_I, TABLE_II, Variant

__all__ = [
    "TABLE_I",
    "TABLE_II",
    "Campaign",
    "FlightRow",
    "Scenario",
    "ScenarioOptions",
    "Variant",
    "make_scenarios",
    "read_rows",
    "run_campaign",
]
