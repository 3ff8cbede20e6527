# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A LiDAR's cloud as its driver hands it over, and the pose of a tilted sensor."""

import numpy as np

import ltp

# An organised cloud in the sensor's frame, float32: 1024 x 64 rays meet a wall 12 m ahead.
azimuth, elevation = np.meshgrid(
    np.linspace(-np.pi, np.pi, 1024, endpoint=False),
    np.radians(np.linspace(-25, 15, 64)),
    indexing="ij",
)
flat = np.cos(elevation)
rays = np.stack([np.cos(azimuth) * flat, np.sin(azimuth) * flat, np.sin(elevation)], axis=-1)
ahead = rays[..., :1] > 0.1
cloud = np.where(ahead, rays * 12.0 / np.where(ahead, rays[..., :1], 1.0), np.nan)
cloud[200, 10] = 0.0  # "no return", as some drivers write it
cloud[300, :8] = rays[300, :8] * 0.45  # a leg of the aircraft
cloud = cloud.astype(np.float32)  # (1024, 64, 3)

# Where the aircraft is and how it is turned; where on it the sensor sits, tilted down 20 degrees.
body = ltp.Pose((10.0, 20.0, 30.0), yaw=np.radians(90), pitch=np.radians(-2))
mount, tilt = np.array([0.10, 0.0, -0.05]), ltp.Pose((0, 0, 0), pitch=np.radians(20)).rotation
origin, rotation = body.position + body.rotation @ mount, body.rotation @ tilt

options = ltp.ObstacleMapOptions()
options.max_range = 60.0  # of the sensor [m]
options.blind_distance = 0.8  # a return nearer than this is the aircraft itself [m]
planner = ltp.LocalTrajectoryPlanner(
    ltp.Raster(np.zeros((200, 200)), origin=(-200, -200), cell=2.0),
    body.position,
    map_options=options,
)
planner.set_waypoints([(10.0, 60.0, 30.0)])

hits = cloud @ rotation.T + origin  # world frame: ENU, metres
print(planner.sense(origin, hits))
print(planner.update(body.position), len(planner.path), "points")
for warning in planner.map.totals.warnings(options):
    print(warning)
