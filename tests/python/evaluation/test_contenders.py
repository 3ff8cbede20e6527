# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Contenders, weights, and what is known of the planners behind them."""

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
