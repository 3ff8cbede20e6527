# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two planners at every scan of a flight: the one that remembers answers the same for less."""

import dataclasses
import math

import numpy as np
import pytest

from ltp import MissionConfig, NavigationOptions, PlanStatus
from ltp.evaluation.replanning import Answer, ScanPair, compare_replanning, summarise_replanning
from ltp.evaluation.scenarios import ScenarioOptions, make_scenario
from ltp.world.city import make_city


@pytest.mark.parametrize("band", [(0.0, 0.0), (20.0, 20.0)])
def test_a_flight_costs_the_same_at_every_scan_for_a_tenth_of_the_cells(
    band: tuple[float, float],
) -> None:
    world = make_city(seed=1)
    path = make_scenario(world, ScenarioOptions(length=150.0), 0).global_path
    config = MissionConfig(navigation=NavigationOptions(band=band), time_limit_factor=2.0)
    scans = compare_replanning(world, config, path)
    summary = summarise_replanning(scans)
    assert summary.scans == len(scans) > 300
    assert summary.found > 300
    assert summary.same_status
    assert summary.same_cost == 1.0
    assert summary.largest_difference <= 1e-9
    assert summary.ratio.median >= 10
    assert summary.expanded[0].mean * 5 < summary.expanded[1].mean


def test_a_planner_is_its_own_equal() -> None:
    world = make_city(seed=1)
    path = make_scenario(world, ScenarioOptions(length=60.0), 0).global_path
    scans = compare_replanning(world, MissionConfig(), path, "additive", "additive")
    summary = summarise_replanning(scans)
    assert (summary.ratio.median, summary.ratio.mean, summary.ratio.p95) == (1, 1, 1)
    assert summary.largest_difference == 0


def test_a_summary_counts_what_differs() -> None:
    good = Answer(PlanStatus.FOUND, 50.0, 0, 1e-3)
    dear = dataclasses.replace(good, cost=50.5, expanded=30, seconds=3e-3)
    none = Answer(PlanStatus.UNREACHABLE, 0.0, 12, 2e-3)
    summary = summarise_replanning(
        [ScanPair(0.0, good, good), ScanPair(0.1, good, dear), ScanPair(0.2, none, none)]
    )
    assert (summary.scans, summary.found, summary.same_status) == (3, 2, True)
    assert summary.same_cost == 0.5
    assert summary.largest_difference == 0.5
    assert summary.ratio.median == 1
    assert summary.ratio.mean == pytest.approx(32 / 3)
    assert summary.expanded[1].mean == 14
    assert summary.milliseconds[0].mean == pytest.approx(4 / 3)
    assert not summarise_replanning([ScanPair(0.0, good, none)]).same_status
    with pytest.raises(ValueError, match="no scan"):
        summarise_replanning([])


def test_alpha_must_be_above_zero() -> None:
    path = np.array([[0.0, 0.0, 50.0], [50.0, 0.0, 50.0]])
    for alpha in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match=r"^alpha = "):
            compare_replanning(make_city(seed=1), MissionConfig(), path, alpha=alpha)
