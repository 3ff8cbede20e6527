# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`Gating`: in which gates waypoints were to be served, as was asked for, not as metres came out.

The radius of the camera's gates follows the height above ground and so differs from flight to
flight; what was asked for does not, and so it is what a table's rows are gathered by.
"""

from dataclasses import dataclass

from ltp.config import MissionConfig

EXACT, CAMERA = "point", "camera"


@dataclass(frozen=True)
class Gating:
    """Gates by what was asked for: `point`, `camera`, or a radius as text [m]."""

    judged: str  # the gates that the routes pass
    flown: str  # those of the flights
    horizon: int = 1  # how many of them a flight plans jointly

    @property
    def title(self) -> str:
        """In words."""
        parts = [_in_words(self.judged)]
        if self.flown != self.judged:
            parts.append(f"flown with {_in_words(self.flown)}")
        if self.horizon != 1:
            parts.append(f"horizon {self.horizon}")
        return ", ".join(parts)


def asked_gates(config: MissionConfig) -> str:
    """What a configuration asks for: see `Gating`."""
    options = config.navigation
    if config.gate == CAMERA:
        return CAMERA
    if isinstance(config.gate, str):
        radius = max(options.gate_radius, options.reach_distance)
        return radius_text(radius) if radius > 0.0 else EXACT
    return radius_text(max(config.gate, options.reach_distance))


def radius_text(radius: float) -> str:
    """A radius [m] as `Gating` has it."""
    return f"{radius:.6g}"


def _in_words(asked: str) -> str:
    if asked == EXACT:
        return "exact waypoints"
    return "camera gates" if asked == CAMERA else f"gates of {asked} m"
