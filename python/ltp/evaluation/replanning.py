# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two planners asked at every scan of one flight: what does it save to remember the last search?"""

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ltp._core import LinearisedOptions, Plan, Planner, PlanStatus, Query, Scene
from ltp.config import MissionConfig
from ltp.sim.mission import Mission, fly
from ltp.world import World

if TYPE_CHECKING:
    from ltp.sim.record import FlightRecord


@dataclass(frozen=True)
class Answer:
    """A planner's answer to one scan."""

    status: PlanStatus
    cost: float  # alpha L - P of the path [m]; 0 unless found
    expanded: int  # cells settled
    seconds: float  # wall time [s]


@dataclass(frozen=True)
class ScanPair:
    """Both planners' answers to one scan."""

    time: float  # in the flight [s]
    ours: Answer
    theirs: Answer


class Rivals:
    """Observer that asks two planners at every scan for the way to the current waypoint.

    Scans whose waypoint lies outside the window are left out.

    Args:
        planner: name of the one that is judged.
        against: name of the one that it is judged by.
        config: of the flight; its weights and options are both planners'.
    """

    def __init__(self, planner: str, against: str, config: MissionConfig) -> None:
        options = config.planner_options()
        self._planners = Planner(planner, options), Planner(against, options)
        self._alpha = config.linearised.alpha
        self.scans: list[ScanPair] = []

    def on_start(self, mission: Mission) -> None:
        """See `Observer`."""

    def on_step(self, mission: Mission) -> None:
        """See `Observer`."""
        planner = mission.planner
        if planner.waypoint_index >= len(planner.waypoints):
            return
        grid = planner.map.blocked
        goal = planner.waypoints[planner.waypoint_index]
        if not grid.frame.contains(goal):
            return
        scene = Scene(grid, mission.priority)
        query = Query(mission.position, goal, mission.config.navigation.band)
        ours, theirs = (self._answer(rival.plan(scene, query)) for rival in self._planners)
        self.scans.append(ScanPair(mission.time, ours, theirs))

    def on_end(self, mission: Mission, record: "FlightRecord") -> None:
        """See `Observer`."""

    def _answer(self, plan: Plan) -> Answer:
        cost = self._alpha * plan.tally.length - plan.tally.priority
        return Answer(plan.status, cost, plan.stats.expanded, plan.stats.seconds)


def compare_replanning(
    world: World,
    config: MissionConfig,
    global_path: ArrayLike,
    planner: str = "incremental",
    against: str = "additive",
    alpha: float = 1.3,
) -> list[ScanPair]:
    """Fly with a planner and ask it and another one at every scan.

    Args:
        world: what is really there.
        config: of the flight, but for its planner.
        global_path: (n, 3), world [m].
        planner: name of the one that flies and is judged.
        against: name of the one that it is judged by.
        alpha: of both planners' cost alpha L - P; the same all the time, so that costs compare.

    Returns:
        A pair of answers a scan, in order.

    Raises:
        ValueError: an unknown planner, or an alpha that is not above 0.
    """
    if not alpha > 0:
        raise ValueError(f"alpha = {alpha!r}: expected a number above 0")
    linearised = LinearisedOptions(
        alpha=alpha, tolerance=config.linearised.tolerance, searches=config.linearised.searches
    )
    config = dataclasses.replace(config, planner=planner, linearised=linearised)
    rivals = Rivals(planner, against, config)
    fly(world, config, global_path, [rivals])
    return rivals.scans


@dataclass(frozen=True)
class Spread:
    """A figure over the scans of a flight."""

    median: float
    mean: float
    p95: float

    @staticmethod
    def of(values: NDArray[np.float64]) -> "Spread":
        """Of (n,) values, n >= 1."""
        return Spread(
            float(np.median(values)), float(np.mean(values)), float(np.percentile(values, 95))
        )


@dataclass(frozen=True)
class ReplanningSummary:
    """Both planners over a flight. A ratio is theirs over ours, a scan with no cell counts as 1."""

    scans: int
    found: int  # scans with a path
    same_status: bool  # whether both always agreed
    same_cost: float  # share of the scans with a path whose costs differ by 1e-9 m at most
    largest_difference: float  # of the costs [m]
    expanded: tuple[Spread, Spread]  # cells settled a scan: ours, theirs
    ratio: Spread  # of the cells settled, scan by scan
    milliseconds: tuple[Spread, Spread]  # wall time a scan [ms]: ours, theirs


def summarise_replanning(scans: Sequence[ScanPair]) -> ReplanningSummary:
    """Boil a flight's scans down.

    Raises:
        ValueError: no scans.
    """
    if not scans:
        raise ValueError("no scan of this flight had its waypoint in the window")
    sides = [scan.ours for scan in scans], [scan.theirs for scan in scans]
    cells = [np.array([answer.expanded for answer in side], dtype=np.float64) for side in sides]
    times = [np.array([1e3 * answer.seconds for answer in side]) for side in sides]
    both = [
        abs(scan.ours.cost - scan.theirs.cost)
        for scan in scans
        if scan.ours.status == scan.theirs.status == PlanStatus.FOUND
    ]
    return ReplanningSummary(
        scans=len(scans),
        found=len(both),
        same_status=all(scan.ours.status == scan.theirs.status for scan in scans),
        same_cost=sum(difference <= 1e-9 for difference in both) / max(1, len(both)),
        largest_difference=max(both, default=0.0),
        expanded=(Spread.of(cells[0]), Spread.of(cells[1])),
        ratio=Spread.of(np.maximum(cells[1], 1.0) / np.maximum(cells[0], 1.0)),
        milliseconds=(Spread.of(times[0]), Spread.of(times[1])),
    )
