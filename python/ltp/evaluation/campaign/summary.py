# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What the flights of a campaign's variants were worth: one `Summary` a row of a table."""

import dataclasses
import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from .paper import PAPER, PaperRow
from .rows import FlightRow
from .variants import Variant


@dataclass(frozen=True)
class Spread:
    """Mean and sample standard deviation (n - 1); nan where there are too few values."""

    mean: float
    sd: float

    @staticmethod
    def of(values: Sequence[float]) -> "Spread":
        """Of plain numbers."""
        array = np.array(values, dtype=np.float64)
        mean = float(array.mean()) if len(array) else math.nan
        return Spread(mean, float(array.std(ddof=1)) if len(array) > 1 else math.nan)


@dataclass(frozen=True)
class Summary:
    """The flights of one variant, or (`timed_out_only`) those of them that timed out.

    The means of a variant are paired: over the global paths (`common`) that every variant of
    its table flew to the end. Else a planner that strands on the hard paths would look shorter.
    """

    world: str
    variant: Variant
    timed_out_only: bool
    flights: int
    completed: int  # the end of the global path was reached, or proved unreachable
    common: int  # global paths that the two means are over
    timed_out: int
    collisions: int
    dropped: int  # waypoints, of all flights together
    wrongly_dropped: int  # see `FlightRow`
    wrongly_dropped_fine: int | None  # the same; None if it was not judged
    too_far: int  # waypoints skipped as too far: no proof, so they are not among those dropped
    mean_priority: Spread
    length_ratio: Spread
    path_distance: Spread | None  # mean distance from the global path [m]; None: not in the rows
    path_distance_max: float | None  # the largest of these flights [m]
    min_clearance: float  # the smallest of all flights [m]
    plans: int
    time_mean: float  # of a search, over all searches of all flights [ms]
    time_median: float
    time_p95: float
    paper: PaperRow | None


def summarise(variants: Sequence[Variant], rows: Iterable[FlightRow]) -> list[Summary]:
    """A table: a summary a variant, and below it one of its flights that timed out, if any did.

    Args:
        variants: the rows of the table.
        rows: of a campaign; those of other variants are left out.

    Raises:
        ValueError: if the rows are of several worlds.
    """
    rows = list(rows)
    flown = {variant: [row for row in rows if row.variant == variant] for variant in variants}
    worlds = {row.world for mine in flown.values() for row in mine}
    if len(worlds) > 1:
        raise ValueError(f"rows of several worlds in one table: {', '.join(sorted(worlds))}")
    ended = [{row.path for row in mine if row.completed} for mine in flown.values() if mine]
    common = set.intersection(*ended) if ended else set()
    summaries = []
    for variant, mine in flown.items():
        summaries.append(_summary(variant, mine, [row for row in mine if row.path in common]))
        if lost := [row for row in mine if row.outcome == "timed_out"]:
            theirs = _summary(variant, lost, lost)
            summaries.append(dataclasses.replace(theirs, timed_out_only=True, paper=None))
    return summaries


def _summary(variant: Variant, mine: Sequence[FlightRow], averaged: Sequence[FlightRow]) -> Summary:
    times = np.array([time for row in mine for time in row.plan_times])
    fine = [row.wrongly_dropped_fine for row in mine]
    away = [row.path_distance_mean for row in averaged if row.path_distance_mean is not None]
    most = [row.path_distance_max for row in averaged if row.path_distance_max is not None]
    measured = len(away) == len(most) == len(averaged)
    return Summary(
        world=mine[0].world if mine else "",
        variant=variant,
        timed_out_only=False,
        flights=len(mine),
        completed=sum(row.completed for row in mine),
        common=len(averaged),
        timed_out=sum(row.outcome == "timed_out" for row in mine),
        collisions=sum(row.collided for row in mine),
        dropped=sum(row.dropped for row in mine),
        wrongly_dropped=sum(row.wrongly_dropped for row in mine),
        wrongly_dropped_fine=None if None in fine else sum(count or 0 for count in fine),
        too_far=sum(row.too_far for row in mine),
        mean_priority=Spread.of([row.mean_priority for row in averaged]),
        length_ratio=Spread.of([row.length_ratio for row in averaged]),
        path_distance=Spread.of(away) if measured else None,
        path_distance_max=max(most, default=math.nan) if measured else None,
        min_clearance=min((row.min_clearance for row in mine), default=math.nan),
        plans=sum(row.plans for row in mine),
        time_mean=float(times.mean()) if len(times) else math.nan,
        time_median=float(np.median(times)) if len(times) else math.nan,
        time_p95=float(np.percentile(times, 95)) if len(times) else math.nan,
        paper=PAPER.get(variant),
    )
