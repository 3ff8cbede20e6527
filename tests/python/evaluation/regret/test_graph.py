# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The judge's own graph: against the core's distances, and against one cell at a time."""

import heapq
import itertools

import numpy as np
import pytest

from ltp import _core as core
from ltp.evaluation.regret.graph import LegGraph, Space

FRAME = core.GridFrame((-10.0, 6.0, -8.0), (2.0, 2.0, 4.0), (14, 12, 5))
NO_PRIORITY = core.Raster(np.zeros((1, 1)))


def blocks(seed: int, density: float = 0.25) -> core.OccupancyGrid:
    blocked = np.random.default_rng(seed).random(FRAME.dims) < density
    blocked[:2, :2] = False
    return core.OccupancyGrid.from_array(blocked, FRAME)


def patches(seed: int) -> core.Raster:
    values = np.random.default_rng(seed).random((14, 12))
    return core.Raster(values, origin=FRAME.origin[:2], cell=2.0)


def graph_of(
    grid: core.OccupancyGrid,
    priority: core.Raster,
    ends: tuple[float, float],
    band: tuple[float, float] = (0.0, 0.0),
) -> LegGraph:
    return LegGraph(grid, priority, Space.between(FRAME, ends, band))


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("above", [0.0, np.inf])
def test_lengths_are_the_cores_distances(seed: int, above: float) -> None:
    grid, start = blocks(seed), FRAME.centre((0, 0, 1))
    graph = graph_of(grid, NO_PRIORITY, (start[2], start[2]), (above, above))
    source = np.array([graph.cell_of(start)])
    found = graph.spread(source, np.zeros(1), 1.0, until=np.flatnonzero(graph.free))
    levels = (1, 1) if above == 0.0 else (0, 4)
    expected = core.distance_field(grid, start, levels)[:, :, levels[0] : levels[1] + 1]
    inside = found.reshape(graph.shape)[1:-1, 1:-1, 1:-1]
    np.testing.assert_allclose(inside, expected, rtol=1e-9)
    assert np.isfinite(expected).sum() > 20 and np.isinf(expected).sum() > 20


def one_by_one(graph: LegGraph, priority: core.Raster, source: int, alpha: float) -> np.ndarray:
    """Dijkstra by the book over the free cells; each step tallied exactly."""
    cells = np.argwhere(graph.free.reshape(graph.shape))
    points = graph.vertices(np.ravel_multi_index(tuple(cells.T), graph.shape))
    at = dict(zip(map(tuple, cells), points, strict=True))
    best = np.full(graph.shape, np.inf)
    heap = [(0.0, tuple(int(n) for n in np.unravel_index(source, graph.shape)))]
    while heap:
        cost, cell = heapq.heappop(heap)
        if cost >= best[cell]:
            continue
        best[cell] = cost
        for step in itertools.product((-1, 0, 1), repeat=3):
            box = itertools.product(*[{n, n + d} for n, d in zip(cell, step, strict=True)])
            if not all(corner in at for corner in box):
                continue
            end = tuple(n + d for n, d in zip(cell, step, strict=True))
            along = core.tally(np.array([at[cell], at[end]]), priority)
            heapq.heappush(heap, (cost + alpha * along.length - along.priority, end))
    return best.reshape(-1)


@pytest.mark.parametrize("seed", range(4))
def test_costs_are_those_of_a_search_by_the_book(seed: int) -> None:
    # A leg that climbs from within one level into another: vertices leave the cells' middles.
    grid, priority = blocks(seed), patches(seed)
    graph = graph_of(grid, priority, (-3.5, 1.0), (0.0, 1.5))
    assert graph.shape[2] - 2 == 2
    source, alpha = graph.cell_of(np.array([-9.0, 7.0, -3.5])), 1.2
    cells = np.flatnonzero(graph.free)
    found = graph.spread(np.array([source]), np.zeros(1), alpha, until=cells)
    expected = one_by_one(graph, priority, source, alpha)
    np.testing.assert_allclose(found, expected, atol=1e-9)
    end = cells[np.argmax(np.where(np.isfinite(found[cells]), found[cells], -1.0))]
    path = graph.vertices(graph.trace(found, {source: 0.0}, int(end), alpha))
    assert grid.first_blocked(path) is None
    along = core.tally(path, priority)
    assert alpha * along.length - along.priority == pytest.approx(found[end])
    # Where it may end early, what it was asked for is settled all the same.
    some = cells[::7]
    early = graph.spread(np.array([source]), np.zeros(1), alpha, until=some)
    np.testing.assert_allclose(early[some], expected[some], atol=1e-9)


def test_open_levels_are_those_of_the_band_and_of_both_ends() -> None:
    def levels(ends: tuple[float, float], band: tuple[float, float] = (0.0, 0.0)) -> list[int]:
        return list(Space.between(FRAME, ends, band)[2:])

    assert levels((-2.0, -2.0)) == [1, 1]
    assert levels((-2.0, 1.0)) == [1, 2]
    assert levels((-2.0, -2.0), (2.0, 2.0)) == [1, 1]  # to its faces, and no farther
    assert levels((-2.0, -2.0), (2.5, 2.5)) == [0, 2]
    assert levels((-2.0, 0.0)) == [1, 2]  # an end on a face belongs to the upper cell
    assert levels((-2.0, -2.0), (np.inf, np.inf)) == [0, 4]


def test_a_gate_is_the_free_cells_within_its_radius_and_the_waypoints_own() -> None:
    blocked = np.zeros(FRAME.dims, dtype=bool)
    blocked[5, 4, 1] = True
    grid = core.OccupancyGrid.from_array(blocked, FRAME)
    graph = graph_of(grid, NO_PRIORITY, (-2.0, -2.0))
    waypoint = FRAME.centre((4, 4, 1)) + np.array([0.6, 0.0, 0.0])
    own = [graph.cell_of(waypoint)]
    assert graph.gate(waypoint, 0.0).tolist() == own
    points = graph.vertices(graph.gate(waypoint, 2.5))
    away = np.linalg.norm(points[:, :2] - waypoint[:2], axis=1)
    assert away.max() <= 2.5 and len(points) == 5  # of seven: one is blocked, one of them too far
    assert graph.gate(FRAME.centre((5, 4, 1)), 0.0).size == 0
    with pytest.raises(ValueError, match="outside"):
        graph.cell_of(np.array([500.0, 7.0, -2.0]))
