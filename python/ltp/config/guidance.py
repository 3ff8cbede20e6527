# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`GuidanceOptions`: how closely and how fast a path is followed."""

from dataclasses import dataclass
from typing import Annotated

from ltp.config.ranges import check_ranges


@dataclass(frozen=True)
class GuidanceOptions:
    """Settings of the path follower: docs/method.md, "Guidance", says what they do.

    Raises:
        ValueError: for a value out of range; it is named.
    """

    look_ahead: Annotated[float, "how far ahead to aim, at least [cells]; assumed"] = 1.0
    tolerance: Annotated[float, "how far a bend may be cut [cells]"] = 0.5
    lateral_share: Annotated[float, "of max_acceleration, used in bends; assumed"] = 0.65
    braking_share: Annotated[float, "of max_acceleration, used to slow down; assumed"] = 0.8
    stop_margin: Annotated[float, "left between a stop and what was hit [m]; assumed"] = 0.5

    def __post_init__(self) -> None:
        check_ranges(self, "guidance.")
