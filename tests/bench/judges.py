# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What "the same answer" means: each judge compares answers with ours, question by question."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Verdict:
    """How answers compare with ours."""

    ok: bool
    text: str


Judge = Callable[[list[Any], list[Any]], Verdict]  # (ours, theirs), question by question


def lengths(lowest: float, highest: float) -> Judge:
    """Path lengths: ours / theirs within [lowest, highest] on every query.

    Who may find no path at all has `lowest` 0.
    """

    def judge(ours: list[Any], theirs: list[Any]) -> Verdict:
        ratios = np.array(ours) / np.array(theirs)
        ok = bool(((ratios >= lowest) & (ratios <= highest)).all())
        found = ratios[ratios > 0.0]
        if found.size == 0:
            return Verdict(ok, "no path found")
        low, middle, high = found.min(), float(np.median(found)), found.max()
        none = f", none in {len(ratios) - len(found)}" if len(found) < len(ratios) else ""
        return Verdict(ok, f"ours/theirs {middle:.4f} ({low:.4f} ... {high:.4f}){none}")

    return judge


def near(tolerance: float, share: float) -> Judge:
    """Arrays: at most `share` of the values differ by more than `tolerance` (inf equals inf)."""

    def judge(ours: list[Any], theirs: list[Any]) -> Verdict:
        apart, count = 0, 0
        for mine, other in zip(ours, theirs, strict=True):
            a, b = np.asarray(mine, dtype=float), np.asarray(other, dtype=float)
            if a.shape != b.shape:
                return Verdict(False, f"{a.shape} values, not {b.shape}")
            with np.errstate(invalid="ignore"):
                apart += int((~((np.abs(a - b) <= tolerance) | (a == b))).sum())
            count += a.size
        return Verdict(apart <= share * count, f"{apart} of {count} differ")

    return judge


def fields(lowest: float, highest: float) -> Judge:
    """Distance fields: ours / theirs within [lowest, highest], from 20 m on, where both reach."""

    def judge(ours: list[Any], theirs: list[Any]) -> Verdict:
        ratios = []
        for mine, other in zip(ours, theirs, strict=True):
            compared = np.isfinite(mine) & np.isfinite(other) & (np.asarray(other) > 20.0)
            ratios.append(mine[compared] / other[compared])
        return lengths(lowest, highest)([np.concatenate(ratios)], [1.0])

    return judge


def finite(values: NDArray[np.floating[Any]], limit: float) -> NDArray[np.float64]:
    """Values with those at or beyond `limit` (or not finite) as inf."""
    values = np.asarray(values, dtype=np.float64)
    return np.where(np.isfinite(values) & (values < limit), values, np.inf)
