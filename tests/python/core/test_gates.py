# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regions and horizons as Python sees them."""

import math

import numpy as np
import pytest

import ltp


def scene(priority: float = 0.0) -> ltp.Scene:
    frame = ltp.GridFrame((0, 0, 0), (2, 2, 4), (40, 40, 1))
    return ltp.Scene(ltp.OccupancyGrid(frame), ltp.Raster(np.full((40, 40), priority), (0, 0), 2.0))


def test_a_query_says_what_it_asks() -> None:
    gate = ltp.Gate((60, 60, 2), radius=8, height=1)
    query = ltp.Query((5, 5, 2), (60, 5, 2), (0, 0), gate_radius=6, gate_height=1, then=[gate])
    assert (query.gate_radius, query.gate_height) == (6.0, 1.0)
    assert query.direct_length == pytest.approx(55 + 55 - 8), "as far as the last region"
    np.testing.assert_array_equal(query.then[0].point, gate.point)
    assert repr(gate).startswith("Gate(point=")
    assert ltp.Query((0, 0, 0), (3, 4, 0)).direct_length == 5.0


@pytest.mark.parametrize("name", ltp.PLANNERS)
def test_every_planner_says_where_it_passes_the_gates(name: str) -> None:
    gates = [ltp.Gate((60, 60, 2), radius=8, height=1), ltp.Gate((20, 61, 2))]
    query = ltp.Query((5, 5, 2), (60, 5, 2), (0, 0), gate_radius=6, gate_height=1, then=gates)
    plan = ltp.make_planner(name).plan(scene(), query)
    assert plan.status == ltp.PlanStatus.FOUND
    assert len(plan.passed) == 3
    assert plan.passed == sorted(plan.passed)
    assert plan.passed[-1] == plan.tally.length
    np.testing.assert_array_equal(plan.path[-1], gates[-1].point)


def test_traits_say_who_plans_them_natively() -> None:
    native = {info.name for info in ltp.planners() if info.horizon}
    assert native == {"additive", "sweep", "exact", "auto", "risk-a-star"}
    regions = {info.name for info in ltp.planners() if info.regions}
    assert regions == native | {"lp-dijkstra", "lp-a-star", "wlp-a-star"}


def test_wrong_gates_are_named() -> None:
    planner = ltp.make_planner()
    with pytest.raises(ValueError, match="gate_radius = -1"):
        planner.plan(scene(), ltp.Query((5, 5, 2), (60, 5, 2), gate_radius=-1))
    with pytest.raises(ValueError, match=r"then\[0\].height = inf"):
        bad = ltp.Gate((5, 5, 2), height=math.inf)
        planner.plan(scene(), ltp.Query((5, 5, 2), (60, 5, 2), then=[bad]))


def test_a_joint_plan_is_no_worse_than_leg_by_leg() -> None:
    """Over level ground: the joint path is the shortest one through all regions."""
    gates = [ltp.Gate((60, 60, 2), radius=12, height=1)]
    query = ltp.Query((5, 5, 2), (60, 5, 2), (0, 0), gate_radius=12, gate_height=1, then=gates)
    weights = ltp.PenaltyWeights(length=1.0, priority=0.0)
    joint = ltp.make_planner("auto", weights=weights).plan(scene(), query)
    legs = ltp.make_planner("lp-dijkstra", weights=weights).plan(scene(), query)
    assert joint.tally.length < legs.tally.length
    assert joint.bound == joint.penalty
