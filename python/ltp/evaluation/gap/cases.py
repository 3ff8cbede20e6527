# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is compared: contenders, under cases of priority map, band and weights."""

import itertools
import math
from collections.abc import Sequence
from dataclasses import dataclass

from ltp.registry import PLANNERS

from ..conditions import PRIORITY_MAPS, Weights, map_title
from ..contenders import SHORTEST, Contender
from .queries import BANDS

_BAND_TITLES = {"planar": "planar flight", "open": "open 3-D band"}


@dataclass(frozen=True)
class Case:
    """What all contenders of one table share."""

    priority_map: str
    band: str
    ratio: float  # W_P / W_L

    @property
    def title(self) -> str:
        """In words."""
        seen = map_title(self.priority_map).capitalize()
        return f"{seen}, {_BAND_TITLES[self.band]}, W_P/W_L = {self.ratio:g}"


@dataclass(frozen=True, kw_only=True)
class GapOptions:
    """What to plan, and with what.

    Raises:
        ValueError: naming the field that is out of range.
    """

    planners: Sequence[str] = (SHORTEST, *PLANNERS)
    ratios: Sequence[float] = (0.5, 1.0, 2.0, 5.0)  # W_P / W_L
    maps: Sequence[str] = PRIORITY_MAPS
    bands: Sequence[str] = tuple(BANDS)
    reference: str = "exact"  # the planner whose answer is the optimum where it proves it
    expansions: int = 0  # the reference gives up after so many; 0: no limit
    memory: float = 2048.0  # the reference, if it is `exact`, gives up beyond it [MB]

    def __post_init__(self) -> None:
        for name, given, known in (
            ("maps", self.maps, PRIORITY_MAPS),
            ("bands", self.bands, tuple(BANDS)),
            ("reference", (self.reference,), PLANNERS),
        ):
            if not given or (strange := [value for value in given if value not in known]):
                wrong = repr(strange[0]) if given else "nothing"
                raise ValueError(f"{name}: {wrong} is none of {', '.join(known)}")
        if not self.planners:
            raise ValueError("planners: nothing to compare")
        for ratio in self.ratios:
            Weights.at_ratio(ratio)
        if self.expansions < 0:
            raise ValueError(f"expansions must be >= 0, not {self.expansions!r}")
        if not (math.isfinite(self.memory) and self.memory > 0.0):
            raise ValueError(f"memory must be above zero [MB], not {self.memory!r}")
        self.contenders()

    def contenders(self) -> list[Contender]:
        """Each once; the reference is there anyway, as `OPTIMUM`."""
        names = dict.fromkeys(name for name in self.planners if name != self.reference)
        return [Contender(name) for name in names]

    def cases(self) -> list[Case]:
        """Every combination of map, band and ratio, each once."""
        axes = (self.maps, self.bands, self.ratios)
        return list(dict.fromkeys(itertools.starmap(Case, itertools.product(*axes))))
