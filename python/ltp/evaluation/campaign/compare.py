# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two planners, or settings, over the same flown scenarios, pair by pair, and how surely."""

import dataclasses
import itertools
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass

from ..conditions import PRIORITY_MAPS
from ..contenders import BASELINE
from .bootstrap import Interval, mean_interval
from .rows import FlightRow
from .variants import Variant, at_ratio

#: What is compared: column of `FlightRow` -> how it is called.
MEASURES = {
    "penalty": "flown Eq. 5",
    "length_ratio": "length ratio",
    "mean_priority": "mean priority",
    "path_distance_mean": "metres off path",
}


@dataclass(frozen=True)
class FlownVariant:
    """The flights of one variant, by scenario."""

    variant: Variant
    flights: dict[tuple[int, int], FlightRow]  # by seed and index of the scenario
    campaign: str = ""  # its name, where flights of several are compared

    @property
    def name(self) -> str:
        """Of its contender."""
        return self.variant.contender.name

    @property
    def title(self) -> str:
        """Of its contender, for tables; and of its campaign where there are several."""
        title = self.variant.contender.title
        return f"{title} ({self.campaign})" if self.campaign else title

    @property
    def collisions(self) -> int:
        """Flights that ended so."""
        return sum(row.collided for row in self.flights.values())


@dataclass(frozen=True)
class Comparison:
    """A challenger against a baseline over the scenarios that both flew to the end."""

    baseline: FlownVariant
    challenger: FlownVariant
    flown: int  # scenarios that both flew
    pairs: int  # of these: to the end, by both
    differences: dict[str, Interval]  # challenger - baseline, by column
    better: int  # pairs in which the challenger's Eq. 5 is lower
    worse: int


def pick(rows: Iterable[FlightRow], name: str, ratio: float, priority_map: str) -> FlownVariant:
    """The flights of one contender, at one ratio W_P / W_L over one map.

    Raises:
        ValueError: if there are none, or they are of several worlds.
    """
    wanted = at_ratio(ratio, name, priority_map)
    mine = [row for row in rows if row.variant == wanted]
    if not mine:
        raise ValueError(f"no flights of {name} at W_P/W_L = {ratio:g} over the {priority_map} map")
    if len({row.world for row in mine}) > 1:
        raise ValueError(f"flights of {name} over several worlds")
    return FlownVariant(wanted, {row.path: row for row in mine})


def compare(baseline: FlownVariant, challenger: FlownVariant) -> Comparison:
    """Pair the flights by scenario; intervals are of the mean difference, 95 %.

    Raises:
        ValueError: if no scenario was flown to its end by both.
    """
    common = sorted(baseline.flights.keys() & challenger.flights.keys())
    pairs = [(baseline.flights[key], challenger.flights[key]) for key in common]
    ended = [pair for pair in pairs if all(row.completed for row in pair)]
    if not ended:
        raise ValueError(f"{baseline.name} and {challenger.name} flew no scenario both to its end")
    differences = {name: _differences(ended, name) for name in MEASURES}
    gained = differences["penalty"]
    return Comparison(
        baseline=baseline,
        challenger=challenger,
        flown=len(common),
        pairs=len(ended),
        differences={name: mean_interval(values) for name, values in differences.items()},
        better=sum(value < 0.0 for value in gained),
        worse=sum(value > 0.0 for value in gained),
    )


def _differences(pairs: Sequence[tuple[FlightRow, FlightRow]], name: str) -> list[float]:
    """None at all where a row lacks the column: it is older."""
    values = [(getattr(a, name), getattr(b, name)) for a, b in pairs]
    return [] if any(None in pair for pair in values) else [b - a for a, b in values]


def compare_all(
    rows: Sequence[FlightRow], planners: Sequence[str], ratio: float, priority_maps: Sequence[str]
) -> list[Comparison]:
    """The first planner against each of the others, map by map.

    Raises:
        ValueError: if there is no other planner, or flights are missing.
    """
    first, *others = planners or ("",)
    if not others:
        raise ValueError("a comparison takes two planners or more, the baseline first")
    return [
        compare(pick(rows, first, ratio, kind), pick(rows, other, ratio, kind))
        for kind in priority_maps
        for other in others
    ]


def compare_campaigns(
    first: Mapping[str, Sequence[FlightRow]],
    second: Mapping[str, Sequence[FlightRow]],
    planners: Sequence[str],
    ratio: float,
    priority_maps: Sequence[str],
) -> list[Comparison]:
    """Each planner of the second campaign against itself in the first, map by map.

    Args:
        first: the baseline: its name -> its rows.
        second: flown with other settings over the same global paths, likewise.
        planners: names of contenders that both flew.
        ratio: W_P / W_L.
        priority_maps: that both were flown over.

    Raises:
        ValueError: if flights are missing, of another world, or not over the same global paths.
    """
    comparisons = []
    for kind, planner in itertools.product(priority_maps, planners):
        one, other = (
            dataclasses.replace(pick(rows, planner, ratio, kind), campaign=name)
            for campaign in (first, second)
            for name, rows in campaign.items()
        )
        _check_same_paths(one, other)
        comparisons.append(compare(one, other))
    return comparisons


def _check_same_paths(one: FlownVariant, other: FlownVariant) -> None:
    """As far as the rows tell: the world, the waypoints and the length of the global path."""
    for path in one.flights.keys() & other.flights.keys():
        facts = [
            (row.world, row.waypoints, f"{row.length / row.length_ratio:.4g}")
            for row in (one.flights[path], other.flights[path])
            if row.length_ratio > 0.0
        ]
        if len(set(facts)) > 1:
            raise ValueError(
                f"{one.campaign} and {other.campaign} were not flown over the same global paths: "
                f"of path {path[1]} world, waypoints and length [m] are {facts[0]} and {facts[1]}"
            )


def flown_maps(rows: Iterable[FlightRow], planners: Sequence[str], ratio: float) -> list[str]:
    """The maps over which all of the planners were flown at this ratio."""
    flown = {row.variant for row in rows}
    return [
        kind
        for kind in PRIORITY_MAPS
        if all(at_ratio(ratio, planner, kind) in flown for planner in planners)
    ]


def flown_planners(
    rows: Iterable[FlightRow], ratio: float, priority_maps: Sequence[str] = ()
) -> list[str]:
    """The contenders flown at this ratio over the first map that has two of them: LP-Dijkstra
    first, if it is one of them.

    Args:
        rows: of a campaign.
        ratio: W_P / W_L.
        priority_maps: to look at; none named: all.
    """
    flown = list(dict.fromkeys(row.variant for row in rows))
    for kind in priority_maps or PRIORITY_MAPS:
        names = [variant.contender.name for variant in flown if variant.priority_map == kind]
        found = [name for name in dict.fromkeys(names) if at_ratio(ratio, name, kind) in flown]
        if len(found) > 1:
            return sorted(found, key=lambda name: name != BASELINE)
    return []


def cells(comparison: Comparison) -> list[str]:
    """A line of a table."""
    return [
        f"{comparison.challenger.title} – {comparison.baseline.title}",
        comparison.challenger.variant.priority_map,
        f"{comparison.pairs}/{comparison.flown}",
        *(interval_text(comparison.differences[name]) for name in MEASURES),
        f"{comparison.better} : {comparison.worse}",
        f"{comparison.challenger.collisions}, {comparison.baseline.collisions}",
    ]


TITLES = (
    "difference",
    "map",
    "pairs",
    *MEASURES.values(),
    "better : worse",
    "collisions",
)


def interval_text(interval: Interval) -> str:
    """Mean and ends, signed; a dash where there is no mean, no ends of a single value."""
    if math.isnan(interval.mean):
        return "–"
    mean, low, high = (
        f"{value:+.3f}".replace("-", "−") for value in (interval.mean, interval.low, interval.high)
    )
    return mean if math.isnan(interval.low) else f"{mean} [{low}, {high}]"


def markdown_comparisons(comparisons: Sequence[Comparison]) -> str:
    """The table in Markdown, with what it shows."""
    first = comparisons[0].baseline
    world = next(iter(first.flights.values())).world
    lines = [
        f"# Paired comparison: {world}, W_P/W_L = {first.variant.ratio:g}\n",
        "Mean difference over the global paths that both planners flew to the end, with its 95 % "
        "confidence interval (BCa bootstrap, 10,000 resamples). Lower is better for Eq. 5 and for "
        "the length. Collisions are of all flights: the first planner's, the second's.\n",
        "| " + " | ".join(TITLES) + " |",
        "|" + "|".join([" --- "] * 2 + [" ---: "] * (len(TITLES) - 2)) + "|",
    ]
    lines += ["| " + " | ".join(cells(comparison)) + " |" for comparison in comparisons]
    return "\n".join(lines) + "\n"
