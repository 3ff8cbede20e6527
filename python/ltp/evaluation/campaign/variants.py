# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a campaign varies: planner, weights, priority map; the rows of the paper's tables."""

import dataclasses
import math
from collections.abc import Iterable
from dataclasses import dataclass

from ltp.registry import PLANNERS

from ..conditions import PRIORITY_MAPS, Weights
from ..contenders import Contender


@dataclass(frozen=True)
class Variant:
    """One row of a table: whose flights, under which weights, over which priority map.

    Raises:
        ValueError: naming the field that is wrong.
    """

    planner: str
    length_weight: float  # W_L
    priority_weight: float  # W_P
    priority_map: str = "binary"  # "binary" | "lpf"
    refine: bool = False  # whether the planner's paths are refined

    def __post_init__(self) -> None:
        if self.planner not in PLANNERS:
            raise ValueError(f"planner must be one of {', '.join(PLANNERS)}, not {self.planner!r}")
        if self.priority_map not in PRIORITY_MAPS:
            raise ValueError(f"priority_map must be one of {PRIORITY_MAPS}: {self.priority_map!r}")
        weights = (self.length_weight, self.priority_weight)
        if not all(math.isfinite(w) and w >= 0.0 for w in weights) or sum(weights) <= 0.0:
            raise ValueError(f"weights must be finite, >= 0 and not both zero, not {weights}")

    @property
    def weights(self) -> Weights:
        """W_L and W_P."""
        return Weights(self.length_weight, self.priority_weight)

    @property
    def ratio(self) -> float:
        """W_P / W_L; inf for W_L = 0."""
        return self.weights.ratio

    @property
    def contender(self) -> Contender:
        """Its planner, refined or not, by one name."""
        return Contender.of(self.planner, self.refine)

    @property
    def refined(self) -> "Variant":
        """The same with refinement."""
        return dataclasses.replace(self, refine=True)


#: The rows of the paper's Table I, in its order.
TABLE_I = (
    Variant("lp-dijkstra", 1.0, 0.0),
    Variant("lp-dijkstra", 0.5, 1.0),
    Variant("lp-a-star", 1.0, 0.0),
    Variant("lp-a-star", 0.5, 1.0),
    Variant("wlp-a-star", 1.0, 0.0),
    Variant("wlp-a-star", 0.5, 1.0),
    Variant("ggwp", 1.0, 0.0),
)

#: The rows of the paper's Table II.
TABLE_II = (
    Variant("lp-dijkstra", 0.5, 1.0, "lpf"),
    Variant("lp-a-star", 0.5, 1.0, "lpf"),
    Variant("wlp-a-star", 0.5, 1.0, "lpf"),
)

TABLES = TABLE_I + TABLE_II

#: W_P / W_L of the sweep figure; the paper names 0, 2 and 5.
SWEEP_RATIOS = (0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 7.5, 10.0, 15.0, 20.0)


def rows_of(planner: str, rows: Iterable[Variant] = TABLES) -> list[Variant]:
    """Those of the rows that fly this planner; for one that the paper's tables lack, the like."""
    if any(variant.planner == planner for variant in TABLES):
        return [variant for variant in rows if variant.planner == planner]
    kinds = {(v.length_weight, v.priority_weight, v.priority_map): None for v in rows}
    return [Variant(planner, *kind) for kind in kinds]


def at_ratio(ratio: float, name: str = "lp-dijkstra", priority_map: str = "binary") -> Variant:
    """The variant of a given W_P / W_L; 0 and 2 are those of the tables.

    Only the ratio matters to LP-Dijkstra: a common factor of both weights changes no comparison.

    Args:
        ratio: W_P / W_L.
        name: of a `Contender`.
        priority_map: "binary" or "lpf".
    """
    contender = Contender(name)
    weights = Weights.at_ratio(ratio)
    return Variant(contender.planner, *weights, priority_map, contender.refine)


def sweep(ratios: Iterable[float] = SWEEP_RATIOS, planner: str = "lp-dijkstra") -> list[Variant]:
    """The variants of the sweep of W_P / W_L, over both maps."""
    return [at_ratio(ratio, planner, kind) for kind in PRIORITY_MAPS for ratio in ratios]


def with_refined(variants: Iterable[Variant]) -> list[Variant]:
    """Each variant, and after it the same with refinement."""
    return [twin for variant in variants for twin in (variant, variant.refined)]


def unique(variants: Iterable[Variant]) -> list[Variant]:
    """The variants in their order, each once."""
    return list(dict.fromkeys(variants))
