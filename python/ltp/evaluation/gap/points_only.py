# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refuses flights whose questions a `RecordedQuery` cannot hold: it goes from point to point."""

from ltp.config import MissionConfig


def refuse_gates(config: MissionConfig) -> None:
    """Refuse settings that have planners asked for regions, or for several waypoints at once.

    A recorded query ends at a point. Recorded from such a flight, it would be another question than
    the one that was answered: to the cell in which that answer happened to end.

    Raises:
        ValueError: naming the setting.
    """
    options = config.navigation
    for name, value, expected in (
        ("gate", config.gate, "point"),
        ("navigation.gate_radius", options.gate_radius, 0.0),
        ("navigation.horizon", options.horizon, 1),
    ):
        if value != expected:
            raise ValueError(
                f"{name} = {value!r}: expected {expected!r}, as recorded queries go from a point "
                "to a point"
            )
