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

    sources: dict[int, float]
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
        cells, costs = self._graphs[0].from_point(self._start, alpha)
        layers: list[_Layer] = []
        for number, graph in enumerate(self._graphs):
            best = graph.spread(cells, costs, alpha, until=self._gates[number])
            sources = dict(zip(cells.tolist(), costs.tolist(), strict=True))
            reached = np.flatnonzero(np.isfinite(best))
            layers.append(_Layer(sources, reached, best[reached]))
            gate = self._gates[number]
            gate = gate[np.isfinite(best[gate])]
            if not len(gate):
                return None
            self._gates[number] = gate  # what no way leads to need not be waited for again
            if number + 1 < len(self._graphs):
                cells, costs = self._graphs[number + 1].same_cells(gate, graph), best[gate]
        end = int(gate[np.argmin(best[gate])])
        return self._path(layers, end, alpha), float(best[end])

    def _path(self, layers: Sequence[_Layer], end: int, alpha: float) -> NDArray[np.float64]:
        parts = []
        for number in reversed(range(len(layers))):
            graph = self._graphs[number]
            best = np.full(graph.free.shape, np.inf)
            best[layers[number].reached] = layers[number].costs
            way = graph.trace(best, layers[number].sources, end, alpha)
            # A gate's vertex of one leg may lie above or below that of the next: the step from the
            # former stays in the same cells, which is all that makes it legal.
            parts.append(graph.vertices(way[1:] if number else way))
            if number:
                end = int(self._graphs[number - 1].same_cells(way[:1], graph)[0])
        return np.concatenate([self._start[None], *reversed(parts)])
