# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Flies a UAV through the built-in city, along a global path that leads through its buildings."""

import numpy as np

import ltp
from ltp.world import make_city

HEIGHT = 50.0  # of the flight [m]

world = make_city(seed=4, size=500.0)
# From corner to corner: a point every 35 m east and north, wherever that may be.
along = np.arange(20.0, 481.0, 35.0)
global_path = np.column_stack([along, along, np.full(len(along), HEIGHT)])
inside = world.surface[along.astype(int), along.astype(int)] > HEIGHT
print(f"{world.name}: {len(along)} points in a straight line, {inside.sum()} of them in buildings")

record = ltp.fly(world, ltp.MissionConfig(planner="auto"), global_path)
for event in record.waypoints:
    reason = f" ({event.reason})" if event.reason else ""
    print(f"{event.time:6.1f} s  waypoint {event.index + 1:2d} {event.outcome}{reason}")
print(f"{record.outcome}: {record.length:.0f} m in {record.duration:.0f} s")
print(f"  {record.length_ratio:.2f} times the straight line, {len(record.plans)} plans")
print(f"  mean priority of the ground below: {record.mean_priority:.2f}")
print(f"  never nearer to anything solid than {record.min_clearance:.1f} m")
