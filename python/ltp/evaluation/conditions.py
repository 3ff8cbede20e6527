# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What planners are asked for: the weights of Eq. 5, and the priority map that they look at."""

import math
from collections.abc import Mapping
from typing import NamedTuple, Self

from ltp._core import PenaltyWeights

#: The priority maps, and what they are called in words.
MAP_NAMES: Mapping[str, str] = {"binary": "binary", "lpf": "low-pass"}

PRIORITY_MAPS = tuple(MAP_NAMES)


class Weights(NamedTuple):
    """Of Eq. 5."""

    length: float  # W_L
    priority: float  # W_P

    @property
    def ratio(self) -> float:
        """W_P / W_L; inf for W_L = 0."""
        return self.priority / self.length if self.length else math.inf

    @property
    def of_core(self) -> PenaltyWeights:
        """The same as the core's own object."""
        return PenaltyWeights(length=self.length, priority=self.priority)

    @classmethod
    def at_ratio(cls, ratio: float) -> Self:
        """Weights of a given W_P / W_L; for 0 and 2 those of the paper's tables.

        Raises:
            ValueError: unless the ratio is finite and >= 0.
        """
        if not (math.isfinite(ratio) and ratio >= 0.0):
            raise ValueError(f"ratio W_P / W_L must be finite and >= 0, not {ratio!r}")
        return cls(1.0, 0.0) if ratio == 0.0 else cls(0.5, 0.5 * ratio)


def map_title(priority_map: str) -> str:
    """How tables and figures name a priority map."""
    return f"{MAP_NAMES[priority_map]} priority map"
