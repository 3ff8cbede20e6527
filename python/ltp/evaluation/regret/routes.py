# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`KnownGround`: the best routes through the true world, leg by leg or all gates at once."""

import itertools

import numpy as np
from numpy.typing import NDArray

from ltp._core import OccupancyGrid, PenaltyWeights, Raster, onto_columns, tally

from .gates import GatedLegs
from .graph import LegGraph, Space
from .slopes import Best, Route, best_route

_SHORTEST_LEG = 1e-3  # L_direct of a leg that begins where it ends [m]


class KnownGround:
    """The true world's cells and a flight's priority map, and what is best over them.

    Args:
        grid: the cells that a perfect map would block, see `true_grid`.
        priority: the map that the flight was given.
        band: as flown (below, above) [m].
        weights: of Eq. 5.
    """

    def __init__(
        self,
        grid: OccupancyGrid,
        priority: Raster,
        band: tuple[float, float],
        weights: PenaltyWeights,
    ) -> None:
        self._grid = grid
        self._band = band
        self._weights = weights
        # Where the priority counts for nothing, the least cost is the least length.
        counts = weights.priority > 0.0
        ground = priority if counts else Raster(np.zeros((1, 1)), origin=(0.0, 0.0), cell=1.0)
        self._columns = onto_columns(ground, grid.frame)
        self._graphs: dict[Space, LegGraph] = {}

    def leg_by_leg(
        self,
        start: NDArray[np.float64],
        waypoints: NDArray[np.float64],
        radii: NDArray[np.float64],
    ) -> Route | None:
        """Each leg the best by its own Eq. 5, from where the one before it ended.

        This is what a planner does that plans to one waypoint at a time, knows all and finds the
        best. Such legs together need not have the least Eq. 5. None if a leg has no way.

        Args:
            start: (3,) [m].
            waypoints: (n, 3), n >= 1, to serve in this order [m].
            radii: (n,), within which they are served; see `LegGraph.gate` [m].
        """
        here, parts, cost = start, [start[None]], 0.0
        for waypoint, radius in zip(waypoints, radii, strict=True):
            direct = max(float(np.linalg.norm(waypoint - here)), _SHORTEST_LEG)
            best = self.joint(here, waypoint[None], np.array([radius]), direct)
            if best is None:
                return None
            leg = best.route
            here, cost = leg.path[-1], cost + leg.cost
            parts.append(leg.path[1:])
        path = np.concatenate(parts)
        return Route(path, tally(path, self._columns), cost)

    def joint(
        self,
        start: NDArray[np.float64],
        waypoints: NDArray[np.float64],
        radii: NDArray[np.float64],
        direct: float,
    ) -> Best | None:
        """All legs together the best by Eq. 5 of the whole route; None if there is no way.

        Args:
            start: as in `leg_by_leg`.
            waypoints: as in `leg_by_leg`.
            radii: as in `leg_by_leg`.
            direct: L_direct of the whole route [m].
        """
        heights = [float(z) for z in (start[2], *waypoints[:, 2])]
        graphs = [self._graph(ends) for ends in itertools.pairwise(heights)]
        gates = [
            graph.gate(waypoint, float(radius))
            for graph, waypoint, radius in zip(graphs, waypoints, radii, strict=True)
        ]
        legs = GatedLegs(graphs, gates, start)
        return best_route(
            lambda alpha: self._judged(legs.least(alpha)),
            self._weights,
            direct,
            max(graph.best_priority for graph in graphs),
        )

    def _graph(self, ends: tuple[float, float]) -> LegGraph:
        space = Space.between(self._grid.frame, ends, self._band)
        if space not in self._graphs:
            self._graphs[space] = LegGraph(self._grid, self._columns, space)
        return self._graphs[space]

    def _judged(self, found: tuple[NDArray[np.float64], float] | None) -> Route | None:
        """Its tally; the exact walk, which shares nothing with the search, must find it free."""
        if found is None:
            return None
        path, cost = found
        if self._grid.first_blocked(path) is not None:
            raise RuntimeError("a route touches a blocked cell: please report this")
        return Route(path, tally(path, self._columns), cost)
