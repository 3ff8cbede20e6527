# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""How a goal is stated, where its figures are found, and what came of it."""

from collections.abc import Callable
from dataclasses import dataclass

from .results import Figure, Results

Lookup = Callable[[Results], Figure | None]


@dataclass(frozen=True)
class Source:
    """One figure among the results, and who it belongs to."""

    label: str
    find: Lookup


@dataclass(frozen=True)
class Goal:
    """A row of the summary."""

    work: str
    ours: Source
    peers: tuple[Source, ...] = ()
    factor: float = 0.0  # how many times better than the best of `peers`
    limit: Figure | None = None  # and no worse than this

    @property
    def words(self) -> str:
        """The goal as text."""
        parts = [f"{self.factor:g}x"] if self.factor else []
        if self.limit is not None:
            parts.append(f"{'>=' if self.limit.kind == 'rate' else '<='} {self.limit}")
        return " and ".join(parts)


@dataclass(frozen=True)
class Score:
    """What came of a goal."""

    goal: Goal
    ours: Figure | None
    peer: str = ""
    theirs: Figure | None = None

    @property
    def ratio(self) -> float | None:
        """How many times better than the best peer."""
        if self.ours is None or self.theirs is None:
            return None
        return self.ours.better_than(self.theirs)

    @property
    def verdict(self) -> str:
        """yes, NO, or what is missing for a verdict."""
        if self.ours is None:
            return "missing: ltp"
        if self.goal.factor and self.ratio is None:
            return "missing: peer"
        met = not self.goal.factor or (self.ratio or 0.0) >= self.goal.factor
        if self.goal.limit is not None:
            met = met and self.ours.better_than(self.goal.limit) >= 1.0
        return "yes" if met else "NO"


def score(goal: Goal, results: Results) -> Score:
    """Hold a goal against the results: the best peer that was measured counts."""
    ours = goal.ours.find(results)
    measured = [(peer.label, found) for peer in goal.peers if (found := peer.find(results))]
    if not measured:
        return Score(goal, ours)
    best = measured[0]
    for other in measured[1:]:
        if other[1].better_than(best[1]) > 1.0:
            best = other
    return Score(goal, ours, *best)


def cpp(label: str, name: str, rate: str = "", each: str = "") -> Source:
    """A C++ benchmark: its CPU time, or one of its counters: a rate, or the time of one thing."""
    return Source(label, lambda results: results.of_cpp(name, rate, each))


def python(work: str, name: str) -> Source:
    """A contestant of `peers`."""
    return Source(name, lambda results: results.of_python(work, name))


def scale(name: str) -> Source:
    """A single figure of `scale`."""
    return Source("", lambda results: results.of_scale(name))
