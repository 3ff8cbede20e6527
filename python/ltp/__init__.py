# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Local trajectory planning for autonomous UAV landing. The public names, listed by hand."""

from ltp._core import (
    GridFrame,
    OccupancyGrid,
    PathTally,
    Pose,
    Raster,
    __version__,
)

__all__ = [
    "GridFrame",
    "OccupancyGrid",
    "PathTally",
    "Pose",
    "Raster",
    "__version__",
]
