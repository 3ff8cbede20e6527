# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`RegretJudge`: holds flights over one world against the best routes over known ground."""

import dataclasses
import math
import time

import numpy as np
from numpy.typing import NDArray

from ltp._core import OccupancyGrid, Raster, penalty, tally
from ltp.config import MissionConfig
from ltp.sim import MissionSetup
from ltp.sim.record import FlightRecord
from ltp.world import World

from ..campaign.metrics import flown_penalty
from ..campaign.rows import FlightRow
from ..campaign.true_grid import true_grid
from ..served import served_radius
from .gating import asked_gates, radius_text
from .routes import KnownGround
from .rows import RegretRow
from .slopes import Best, Route


def gates_of(setup: MissionSetup) -> NDArray[np.float64]:
    """The same of each waypoint of a mission, (n,) [m]: its gate where that is wider."""
    return np.maximum(setup.gate_radii(setup.waypoints), served_radius(setup.config))


def check_gate(gate: float | None) -> None:
    """Refuse what is no radius.

    Raises:
        ValueError: that names the gate.
    """
    if gate is not None and not (math.isfinite(gate) and gate >= 0.0):
        raise ValueError(f"gate must be a radius >= 0 [m], not {gate!r}")


class RegretJudge:
    """Judges flights that were all flown with one map over one world.

    Args:
        world: that was flown over.
        gate: radius [m] within which the routes serve all waypoints but the last, which keeps that
            of the flights; None: all keep that of the flights.
        priority: the map that was flown with, if it is not that of the world.
    """

    def __init__(self, world: World, gate: float | None, priority: Raster | None = None) -> None:
        self._world = world
        self._gate = gate
        self._priority = priority
        self._grid: OccupancyGrid | None = None  # made when the first flight is judged
        self._heights = (np.inf, -np.inf)

    def row(self, flight: FlightRow, record: FlightRecord, key: str) -> RegretRow:
        """The row of a flight.

        Args:
            flight: its row in its campaign.
            record: of it.
            key: of the row to be made.
        """
        config = record.config
        flown_gates = asked_gates(config)
        served = record.reached
        waypoints = np.array([entry.goal for entry in served])
        last = served_radius(config)
        setup = MissionSetup.of(self._world, config, record.global_path, self._priority)
        radii = gates_of(setup)[[entry.index for entry in served]]
        if self._gate is not None:
            radii[:] = self._gate
            radii[-1:] = last
        weights, direct = config.planner_options.weights, record.global_length
        begin = time.perf_counter()
        legs: Route | None = None
        joint: Best | None = None
        between = end = begin
        if len(waypoints):
            start = float(record.global_path[0, 2])
            ground = KnownGround(
                self._cells(config, record.global_path),
                setup.priority,
                config.navigation.band_from(start, max(start, *waypoints[:, 2])),
                weights,
            )
            legs = ground.leg_by_leg(record.global_path[0], waypoints, radii)
            between = time.perf_counter()
            joint = ground.joint(record.global_path[0], waypoints, radii, direct)
            end = time.perf_counter()
        one, all_ = (
            _Judged.of(route, setup.priority, config, direct)
            for route in (legs, joint.route if joint is not None else None)
        )
        if one.penalty is not None and (all_.penalty is None or one.penalty < all_.penalty):
            all_ = one  # what is best leg by leg is a route through the same gates, too
        return RegretRow(
            key=key,
            world=flight.world,
            planner=flight.planner,
            length_weight=flight.length_weight,
            priority_weight=flight.priority_weight,
            priority_map=flight.priority_map,
            refine=flight.refine,
            scenario=flight.scenario,
            seed=flight.seed,
            outcome=flight.outcome,
            waypoints=flight.waypoints,
            served=len(waypoints),
            gates=flown_gates if self._gate is None else radius_text(self._gate),
            flown_gates=flown_gates,
            horizon=config.navigation.horizon,
            gate=float(radii.max(initial=last)) if self._gate is None else self._gate,
            last_gate=last,
            global_length=direct,
            flown=flown_penalty(record),
            flown_length=record.length,
            flown_priority=record.mean_priority,
            legs=one.penalty,
            legs_length=one.length,
            legs_priority=one.priority,
            joint=all_.penalty,
            joint_length=all_.length,
            joint_priority=all_.priority,
            joint_bound=None if joint is None else joint.bound,
            time_legs=between - begin,
            time_joint=end - between,
        )

    def _cells(self, config: MissionConfig, path: NDArray[np.float64]) -> OccupancyGrid:
        """The true world's cells, up to where the global path leads."""
        low, high = float(path[:, 2].min()), float(path[:, 2].max())
        if self._grid is None or low < self._heights[0] or high > self._heights[1]:
            self._heights = min(low, self._heights[0]), max(high, self._heights[1])
            self._grid = true_grid(self._world, config.mapping, self._heights)
        return self._grid


@dataclasses.dataclass(frozen=True)
class _Judged:
    """A route as flights are judged: over the priority map as it was given."""

    penalty: float | None = None
    length: float | None = None
    priority: float | None = None

    @classmethod
    def of(
        cls, route: Route | None, priority: Raster, config: MissionConfig, direct: float
    ) -> "_Judged":
        if route is None:
            return cls()
        along = tally(route.path, priority)
        judged = penalty(along, direct, config.planner_options.weights)
        return cls(judged, along.length, along.mean_priority)
