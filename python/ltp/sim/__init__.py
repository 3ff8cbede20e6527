# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The simulator: LiDAR over a true world, the local trajectory planner, guidance, a vehicle."""

import warnings
from typing import TYPE_CHECKING

from ltp.sim.export import to_geojson, to_kml
from ltp.sim.flight import Flight
from ltp.sim.guidance import PathFollower
from ltp.sim.mission import Mission, fly
from ltp.sim.observer import Observer
from ltp.sim.parts import FlightPlanner, Guidance, Vehicle
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEntry
from ltp.sim.sensors import MountedLidar, Sensor, look_down
from ltp.sim.setup import MissionSetup
from ltp.sim.step import Step
from ltp.sim.vehicle import PointMass

__all__ = [
    "Flight",
    "FlightPlanner",
    "FlightRecord",
    "Guidance",
    "Mission",
    "MissionSetup",
    "MountedLidar",
    "Observer",
    "Outcome",
    "PathFollower",
    "PlanEntry",
    "PointMass",
    "Sensor",
    "Step",
    "Vehicle",
    "WaypointEntry",
    "fly",
    "look_down",
    "to_geojson",
    "to_kml",
]

if not TYPE_CHECKING:  # which would take any name for one of the module's

    def __getattr__(name: str) -> object:
        """The names of version 0.1, for one release."""
        if name not in ("WayPointEvent", "WaypointEvent"):
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        warnings.warn(f"`{name}` is now `WaypointEntry`", DeprecationWarning, stacklevel=2)
        return WaypointEntry
