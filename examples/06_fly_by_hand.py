# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drives the simulation from a loop of one's own: two LiDARs, changes of mind, a descent."""

import numpy as np

import ltp
from ltp.sim import look_down
from ltp.world import make_city

world = make_city(seed=4, size=500.0)
config = ltp.MissionConfig()
sensors = [
    ltp.MountedLidar(config.lidar),  # level, one scan a step
    ltp.MountedLidar(look_down(), ltp.Pose((0.1, 0.0, -0.2)), rate=5.0),  # beneath, 5 Hz
]
flight = ltp.Flight(world, config, start=(20.0, 20.0, 50.0), sensors=sensors)

# Run until something happens; what has been decided may be changed then.
flight.set_waypoints([(90.0, 90.0, 50.0), (480.0, 480.0, 50.0)])
step = flight.run(until=lambda step: bool(step.events))
print(f"{step.time:5.1f} s  first waypoint done, on to another place, as straight as can be")
flight.set_waypoints([(160.0, 60.0, 50.0), (230.0, 110.0, 50.0)])
flight.set_weights(ltp.PenaltyWeights(length=1.0, priority=0.0))

# Or step by step.
nearest = np.inf
while step.status != ltp.NavigationStatus.FINISHED:
    step = flight.step()
    for scan in filter(None, step.scans):
        if len(scan.hits):
            nearest = min(nearest, np.linalg.norm(scan.hits - scan.origin, axis=1).min())
print(f"{step.time:5.1f} s  there; nothing was measured nearer than {nearest:.1f} m")

# All waypoints are used up, and the UAV hovers. Down now, by commands of one's own [m/s].
flight.run(until=lambda step: not step.velocity.any())
while step.collision is None:
    step = flight.step(command=(0.0, 0.0, -1.0))
print(f"{step.time:5.1f} s  touched down at a height of {step.collision[2]:.1f} m")

record = flight.end()
print(f"{record.outcome}: {record.length:.0f} m, {len(record.plans)} plans")
flight.reset()  # and it may fly again
