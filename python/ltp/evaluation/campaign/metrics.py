# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a flight was worth: pure functions of its record, and of the world that judges it."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ltp._core import PathTally, penalty
from ltp.sim.record import FlightRecord, Outcome, WaypointEntry
from ltp.world import World

from .reachability import TrueCells
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


def wrongly_dropped(
    record: FlightRecord, world: World, cells: TrueCells | None = None
) -> list[WaypointEntry]:
    """The dropped waypoints to which the true world's own cells have a way.

    For each drop, a flood over the cells that the solid world itself blocks (the same lattice,
    inflation and altitude band as the mission's map, but the whole world instead of the window, and
    all of its surface instead of what was sensed) from where the UAV was. If it reaches the
    waypoint's cell, the drop was wrong.

    Args:
        record: of the flight.
        world: that it was flown over.
        cells: of this world and these map options, if at hand; else they are made.

    Raises:
        ValueError: if the map's window was not on the lattice of the cells.
    """
    drops = [event for event in record.waypoints if event.outcome == "dropped"]
    if not drops:
        return []
    cells = cells or TrueCells(world, record.config.mapping)
    if strange := [drop for drop in drops if not cells.on_lattice(drop.window_origin)]:
        raise ValueError(f"window_origin {strange[0].window_origin} is not on the world's lattice")
    band = record.config.navigation.band
    return [
        drop
        for drop in drops
        if cells.reachable(drop.position, drop.goal, below=band[0], above=band[1])
    ]


def flight_row(
    record: FlightRecord,
    scenario: "Scenario",
    key: str,
    seconds: float,
    world: World,
    cells: TrueCells | None = None,
) -> FlightRow:
    """The row of a flight.

    Args:
        record: of the flight.
        scenario: that it flew.
        key: see `flights.flight_key`.
        seconds: wall time that the flight took to simulate [s].
        world: that it was flown over.
        cells: see `wrongly_dropped`.
    """
    drops = [event for event in record.waypoints if event.outcome == "dropped"]
    times = TimeStatistics.of(record.plan_seconds)
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
        waypoints=len(record.global_path) - 1,
        reached=len(record.waypoints) - len(drops),
        dropped=len(drops),
        dropped_goal_blocked=sum(drop.reason == "goal_blocked" for drop in drops),
        dropped_unreachable=sum(drop.reason == "unreachable" for drop in drops),
        wrongly_dropped=len(wrongly_dropped(record, world, cells)),
        collided=record.outcome is Outcome.COLLIDED,
        mean_priority=record.mean_priority,
        length=record.length,
        length_ratio=record.length_ratio,
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
