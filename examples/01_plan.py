# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plans one path round a wall, over ground of random priority. README.md shows the same lines."""

import numpy as np

import ltp

frame = ltp.GridFrame(origin=(0, 0, 0), cell=(2, 2, 4), dims=(100, 100, 10))  # metres
blocked = np.zeros((100, 100, 10), dtype=bool)
blocked[50, :80, :] = True  # a wall with a way round its end
grid = ltp.OccupancyGrid.from_array(blocked, frame)
priority = ltp.Raster(np.random.default_rng(1).random((100, 100)), origin=(0, 0), cell=2.0)
planner = ltp.make_planner("auto", weights=ltp.PenaltyWeights(length=0.5, priority=1.0))
plan = planner.plan(ltp.Scene(grid, priority), ltp.Query((20, 20, 20), (180, 20, 20), band=(0, 0)))
print(plan.status, plan.tally.length, plan.tally.mean_priority, plan.penalty, plan.bound)
