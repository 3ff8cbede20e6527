# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a flight was worth: pure functions of its record, and of the judge of its drops."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp._core import PathTally, penalty
from ltp.sim.record import FlightRecord, Outcome

from ..off_path import off_path
from .drops import DropJudge
from .rows import FlightRow

if TYPE_CHECKING:
    from ..scenarios import Scenario


@dataclass(frozen=True)
class TimeStatistics:
    """Of the wall times of searches [s]."""

    mean: float
    median: float
    p95: float  # 95th percentile, linearly interpolated

    @staticmethod
    def of(seconds: NDArray[np.float64]) -> "TimeStatistics | None":
        """None where there is nothing to take statistics of."""
        if not len(seconds):
            return None
        return TimeStatistics(
            float(np.mean(seconds)), float(np.median(seconds)), float(np.percentile(seconds, 95))
        )


def flown_penalty(record: FlightRecord) -> float:
    """Eq. (5) on the flown path, L_direct being the global path's length."""
    flown = PathTally(length=record.length, priority=record.mean_priority * record.length)
    return penalty(flown, record.global_length, record.config.planner_options.weights)


def end_distance(record: FlightRecord) -> float:
    """From where the flight ended to the end of the global path [m]."""
    return float(np.linalg.norm(record.positions[-1] - record.global_path[-1]))


def flight_row(
    record: FlightRecord,
    scenario: "Scenario",
    key: str,
    seconds: float,
    judge: DropJudge,
) -> FlightRow:
    """The row of a flight.

    Args:
        record: of the flight.
        scenario: that it flew.
        key: see `flights.flight_key`.
        seconds: wall time that the flight took to simulate [s].
        judge: of the waypoints that it dropped.
    """
    drops = record.dropped
    times, away = TimeStatistics.of(record.plan_seconds), off_path(record)
    config = record.config
    return FlightRow(
        key=key,
        world=record.world_name,
        planner=config.planner,
        length_weight=config.planner_options.weights.length,
        priority_weight=config.planner_options.weights.priority,
        priority_map=config.priority_map,
        refine=config.planner_options.refine,
        scenario=scenario.index,
        seed=scenario.seed,
        crosses_building=scenario.crosses_building,
        outcome=record.outcome.value,
        reason=record.reason,
        waypoints=len(record.global_path) - 1,
        reached=len(record.reached),
        dropped=len(drops),
        too_far=len(record.skipped),
        dropped_goal_blocked=sum(drop.reason == "goal_blocked" for drop in drops),
        dropped_unreachable=sum(drop.reason == "unreachable" for drop in drops),
        wrongly_dropped=len(judge.wrong_by_the_maps_cells(record)),
        wrongly_dropped_fine=len(judge.wrong_by_fine_cells(record)),
        collided=record.outcome is Outcome.COLLIDED,
        mean_priority=record.mean_priority,
        length=record.length,
        length_ratio=record.length_ratio,
        path_distance_mean=away.mean,
        path_distance_max=away.largest,
        penalty=flown_penalty(record),
        min_clearance=record.min_clearance,
        end_distance=end_distance(record),
        duration=record.duration,
        plans=len(record.plans),
        plans_found=sum(plan.status == "found" for plan in record.plans),
        expanded=sum(plan.expanded for plan in record.plans),
        time_plan_mean=1e3 * times.mean if times else None,
        time_plan_median=1e3 * times.median if times else None,
        time_plan_p95=1e3 * times.p95 if times else None,
        time_plans="|".join(f"{1e3 * value:.4g}" for value in record.plan_seconds),
        time_flight=seconds,
    )
