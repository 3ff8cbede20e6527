# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The simulator: LiDAR over a true world, the local trajectory planner, guidance, a vehicle."""

from ltp.sim.mission import Mission, Observer, fly
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEvent

__all__ = [
    "FlightRecord",
    "Mission",
    "Observer",
    "Outcome",
    "PlanEntry",
    "WaypointEvent",
    "fly",
]
