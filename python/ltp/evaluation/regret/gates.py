# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`GatedLegs`: one search through several gates; where one leg may end, the next may begin."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .graph import Cells, Costs, LegGraph


class _Layer(NamedTuple):
    """One leg's search: where it began at what costs, and the least costs of what it reached."""

    sources: Cells  # sorted
    source_costs: Costs
    origins: Cells  # of each source: the cell of the gate before, in the graph before
    reached: Cells
    costs: Costs


class GatedLegs:
    """A start and the gates that follow it.

    Args:
        graphs: of each leg.
        gates: the cells of each leg's graph that end it, see `LegGraph.gate`.
        start: (3,) [m].
    """

    def __init__(
        self, graphs: Sequence[LegGraph], gates: Sequence[Cells], start: NDArray[np.float64]
    ) -> None:
        self._graphs = graphs
        self._gates = list(gates)
        self._start = start

    def least(self, alpha: float) -> tuple[NDArray[np.float64], float] | None:
        """The path (n, 3) [m] of the least sum of (alpha - p) dl, and that sum; None without one.

        Dynamic programming, a layer a leg: the least costs at a gate's cells are what the next leg
        begins with. A route takes as many searches as it has legs, whatever the gates' sizes.

        Args:
            alpha: above the largest priority.
        """
        layers: list[_Layer] = []
        for number, graph in enumerate(self._graphs):
            gate = self._gates[number]
            sources, costs, origins = self._sources(number, layers, alpha)
            best = graph.spread(sources, costs, alpha, until=gate)
            gate = gate[np.isfinite(best[gate])]
            if not len(gate):
                return None
            self._gates[number] = gate  # what no way leads to need not be waited for again
            reached = np.flatnonzero(np.isfinite(best))
            layers.append(_Layer(sources, costs, origins, reached, best[reached]))
        end = int(gate[np.argmin(best[gate])])
        return self._path(layers, end, alpha), float(best[end])

    def _sources(
        self, number: int, layers: Sequence[_Layer], alpha: float
    ) -> tuple[Cells, Costs, Cells]:
        """Where a leg's search begins, at what costs, and the gate's cells that these come from."""
        graph = self._graphs[number]
        if number == 0:
            cells, costs = graph.from_point(self._start, alpha)
            order = np.argsort(cells)
            return cells[order], costs[order], cells[order]
        before, gate = self._graphs[number - 1], self._gates[number - 1]
        last = layers[-1]
        so_far = last.costs[np.searchsorted(last.reached, gate)]
        cells, costs, places = graph.from_gate(
            graph.same_cells(gate, before), before.vertices(gate), so_far, alpha
        )
        return cells, costs, gate[places]

    def _path(self, layers: Sequence[_Layer], end: int, alpha: float) -> NDArray[np.float64]:
        parts = []
        for graph, layer in zip(reversed(self._graphs), reversed(layers), strict=True):
            best = np.full(graph.free.shape, np.inf)
            best[layer.reached] = layer.costs
            sources = dict(zip(layer.sources.tolist(), layer.source_costs.tolist(), strict=True))
            way = graph.trace(best, sources, end, alpha)
            parts.append(graph.vertices(way))
            end = int(layer.origins[np.searchsorted(layer.sources, way[0])])
        path = np.concatenate([self._start[None], *reversed(parts)])
        moved = np.any(np.diff(path, axis=0) != 0.0, axis=1)
        return np.asarray(path[np.append(True, moved)])
