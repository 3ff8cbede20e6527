# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Confidence intervals of a mean by the bootstrap: no assumption on how the values are spread."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from statistics import NormalDist

import numpy as np
from numpy.typing import NDArray

RESAMPLES = 10_000
_CHUNK = 1_000  # resamples at once: bounds the memory


@dataclass(frozen=True)
class Interval:
    """A mean and its confidence interval; the ends are nan below two values."""

    mean: float
    low: float
    high: float

    @property
    def excludes_zero(self) -> bool:
        """Whether the mean differs from zero at this confidence."""
        return self.low > 0.0 or self.high < 0.0


def mean_interval(values: Sequence[float], confidence: float = 0.95, seed: int = 1) -> Interval:
    """The mean and its BCa interval (Efron 1987, bias-corrected and accelerated), 10,000 resamples.

    Args:
        values: independent of each other.
        confidence: of the interval, 0...1.
        seed: of the resampling; the same gives the same interval.

    Raises:
        ValueError: if the confidence is not between 0 and 1.
    """
    if not 0.0 < confidence < 1.0:
        raise ValueError(f"confidence must be between 0 and 1, not {confidence!r}")
    array = np.array(values, dtype=np.float64)
    if len(array) < 2:
        return Interval(float(array.mean()) if len(array) else math.nan, math.nan, math.nan)
    mean = float(array.mean())
    if np.ptp(array) == 0.0:
        return Interval(mean, mean, mean)
    means = _resampled_means(array, np.random.default_rng(seed))
    normal = NormalDist()
    below = float(np.mean(means < mean) + 0.5 * np.mean(means == mean))
    bias = normal.inv_cdf(min(max(below, 0.5 / RESAMPLES), 1.0 - 0.5 / RESAMPLES))
    off = array - mean  # the jackknife of a mean in closed form
    acceleration = float(np.sum(off**3) / (6.0 * np.sum(off**2) ** 1.5))
    ends = []
    for share in (0.5 - confidence / 2.0, 0.5 + confidence / 2.0):
        z = bias + normal.inv_cdf(share)
        ends.append(100.0 * normal.cdf(bias + z / (1.0 - acceleration * z)))
    low, high = np.percentile(means, ends)
    return Interval(mean, float(low), float(high))


def _resampled_means(values: NDArray[np.float64], rng: np.random.Generator) -> NDArray[np.float64]:
    draws = [
        values[rng.integers(0, len(values), (_CHUNK, len(values)))].mean(axis=1)
        for _ in range(RESAMPLES // _CHUNK)
    ]
    return np.concatenate(draws)
