# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The paper's own numbers, to stand beside ours: Tables I and II, and what its text adds.

Source: Magrisso, Rivlin, Rotstein, "Local Trajectory Planning For UAV Autonomous Landing". Times
were measured on an Intel Core i7-7820HQ at 2.90 GHz.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType

from .variants import TABLE_I, TABLE_II, Variant


@dataclass(frozen=True)
class PaperRow:
    """A row of the paper's tables: means over 50 global paths, standard deviations."""

    mean_priority: float
    mean_priority_sd: float
    length_ratio: float  # L_LP / L_GP
    length_ratio_sd: float
    time_plan: float | None  # average run-time [ms]; Table II has none


_TABLE_I = (
    PaperRow(0.61, 0.11, 1.25, 0.23, 20.0),
    PaperRow(0.82, 0.06, 1.34, 0.26, 20.0),
    PaperRow(0.62, 0.11, 1.25, 0.23, 3.6),
    PaperRow(0.76, 0.09, 1.37, 0.28, 3.6),
    PaperRow(0.61, 0.10, 1.26, 0.25, 2.5),
    PaperRow(0.66, 0.12, 1.40, 0.33, 2.5),
    PaperRow(0.59, 0.12, 1.26, 0.21, 8.4),
)

# The last row is digit for digit that of GGWP in Table I: perhaps a slip of the paper.
_TABLE_II = (
    PaperRow(0.68, 0.12, 1.28, 0.24, None),
    PaperRow(0.65, 0.10, 1.27, 0.29, None),
    PaperRow(0.59, 0.12, 1.26, 0.21, None),
)

PAPER: Mapping[Variant, PaperRow] = MappingProxyType(
    dict(zip(TABLE_I + TABLE_II, _TABLE_I + _TABLE_II, strict=True))
)
