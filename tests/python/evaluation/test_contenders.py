# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contenders, weights, and what is known of the planners behind them."""

import heapq
import itertools

import numpy as np
import pytest

import ltp
from ltp.evaluation.conditions import PRIORITY_MAPS, Weights, map_title
from ltp.evaluation.contenders import OPTIMUM, Contender, contender_title, on_grid
from tests.python.scenes import patchwork

INFO = {info.name: info for info in ltp.planners()}


def test_every_planner_is_known_in_the_order_of_the_registry() -> None:
    assert list(INFO) == list(ltp.PLANNERS)
    assert len({row.title for row in INFO.values()}) == len(INFO)
    assert {row.family for row in INFO.values()} == {"paper", "ours", "baseline"}
    assert list(INFO)[:5] == [name for name, row in INFO.items() if row.family == "paper"]


def test_what_is_known_is_what_the_planners_say() -> None:
    for name, row in INFO.items():
        assert ltp.make_planner(name).info.title == row.title
        assert row.on_grid or not row.bounds  # bounds are of the grid's paths


def test_bounds_and_the_use_of_priority_show_in_the_plans() -> None:
    recorded = patchwork(3, count=5, density=0.03)
    for name, row in INFO.items():
        planner = ltp.make_planner(name)
        found, other_paths = 0, 0
        for query in recorded.queries:
            plans = [
                planner.plan(recorded.scene(query, kind), query.query()) for kind in PRIORITY_MAPS
            ]
            if any(plan.status != ltp.PlanStatus.FOUND for plan in plans):
                continue
            found += 1
            assert all((plan.bound is not None) == row.bounds for plan in plans), name
            other_paths += not np.array_equal(plans[0].path, plans[1].path)
        assert found > 0, name
        assert bool(other_paths) == row.uses_priority, name


@pytest.mark.parametrize(
    ("name", "planner", "refine", "title", "follows"),
    [
        ("lp-dijkstra", "lp-dijkstra", False, "LP-Dijkstra", True),
        ("bezier", "bezier", False, "Bézier", False),
        ("sweep+refine", "sweep", True, "Sweep, refined", False),
        ("shortest", "lp-dijkstra", False, "Shortest path", True),
    ],
)
def test_a_contender_is_told_by_its_name(
    name: str, planner: str, refine: bool, title: str, follows: bool
) -> None:
    contender = Contender(name)
    assert (contender.planner, contender.refine, contender.title) == (planner, refine, title)
    assert on_grid(name) == follows
    if name != "shortest":
        assert Contender.of(planner, refine) == contender


def test_names_of_rows_need_be_no_planners() -> None:
    assert contender_title(OPTIMUM) == "Optimum" and on_grid(OPTIMUM)
    assert contender_title("of-an-older-version+refine") == "of-an-older-version, refined"
    for name in ("of-an-older-version", OPTIMUM, "shortest+refine", ""):
        with pytest.raises(ValueError, match="is none of shortest, lp-dijkstra"):
            Contender(name)


def test_the_weights_of_the_paper() -> None:
    assert Weights.at_ratio(0.0) == (1.0, 0.0) and Weights.at_ratio(2.0) == (0.5, 1.0)
    assert Weights.at_ratio(5.0).ratio == 5.0 and Weights(0.0, 1.0).ratio == float("inf")
    for ratio in (-1.0, float("nan"), float("inf")):
        with pytest.raises(ValueError, match="ratio W_P / W_L must be finite and >= 0"):
            Weights.at_ratio(ratio)


def test_every_map_has_a_name() -> None:
    assert [map_title(kind) for kind in PRIORITY_MAPS] == [
        "binary priority map",
        "low-pass priority map",
    ]


def test_the_shortest_path_is_the_shortest_ends_included() -> None:
    """Against Dijkstra over all steps between the points that a path can pass."""
    rng = np.random.default_rng(8)
    frame = ltp.GridFrame((0, 0, 0), (2, 2, 4), (12, 11, 3))
    offsets = [o for o in itertools.product((-1, 0, 1), repeat=3) if any(o)]
    judged = 0
    for number in range(24):
        blocked = rng.random((12, 11, 3)) < 0.25
        ends = rng.uniform((0, 0, 0), (24, 22, 12), (2, 3))
        cells = [tuple(int(c) for c in p // (2, 2, 4)) for p in ends]
        if cells[0] == cells[1] or any(blocked[cell] for cell in cells):
            continue
        band = (0.0, 0.0) if number % 2 else (np.inf, np.inf)
        low, high = sorted(ends[:, 2]) + np.array((-band[0], band[1]))

        points = (np.stack(np.indices((12, 11, 3)), -1) + 0.5) * (2, 2, 4)
        points[..., 2] = np.clip(points[..., 2], low, high)
        points[cells[0]], points[cells[1]] = ends
        levels = range(3)
        if not np.isinf(high):
            levels = range(min(c[2] for c in cells), max(c[2] for c in cells) + 1)
        far = {cells[0]: 0.0}
        heap = [(0.0, cells[0])]
        while heap:
            length, cell = heapq.heappop(heap)
            if length > far[cell]:
                continue
            for offset in offsets:
                box = itertools.product(*[{0, o} for o in offset])
                around = [tuple(np.add(cell, b)) for b in box if any(b)]
                inside = all(
                    0 <= x < 12 and 0 <= y < 11 and z in levels and not blocked[x, y, z]
                    for x, y, z in around
                )
                if not inside:
                    continue
                to = tuple(np.add(cell, offset))
                total = length + float(np.linalg.norm(points[to] - points[cell]))
                if total < far.get(to, np.inf):
                    far[to] = total
                    heapq.heappush(heap, (total, to))
        scene = ltp.Scene(
            ltp.OccupancyGrid.from_array(blocked, frame), ltp.Raster(rng.random((12, 11)), cell=2.0)
        )
        plan = Contender("shortest").make(2.0).plan(scene, ltp.Query(*ends, band))
        assert (plan.status == ltp.PlanStatus.FOUND) == (cells[1] in far)
        if cells[1] in far:
            assert plan.tally.length == pytest.approx(far[cells[1]], abs=1e-9)
            judged += 1
    assert judged > 4
