# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Within what distance a flight serves a waypoint that is a point."""

import numpy as np

from ltp.config import MissionConfig


def served_radius(config: MissionConfig) -> float:
    """Within which horizontal distance a flight of these settings serves its waypoints [m]."""
    return config.navigation.reach_distance or float(np.hypot(*config.mapping.cell[:2]))
