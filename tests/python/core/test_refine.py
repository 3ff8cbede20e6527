# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Refined paths from Python: never worse, and what the mission makes of the setting."""

import numpy as np
import pytest

import ltp
from ltp import PlanStatus
from ltp.config import MissionConfig
from ltp.sim.mission import fly

from ..scenes import town

CELL = (2.0, 2.0, 4.0)


def scene(seed: int) -> ltp.Scene:
    """Towers over patches of good ground."""
    rng = np.random.default_rng(seed)
    blocked = np.zeros((40, 40, 8), dtype=bool)
    priority = np.full((40, 40), 0.1)
    for _ in range(15):
        x, y = rng.integers(3, 33, 2)
        w, d = rng.integers(2, 7, 2)
        blocked[x : x + w, y : y + d, : rng.integers(1, 9)] = True
        x, y = rng.integers(0, 34, 2)
        priority[x : x + w, y : y + d] = 1.0
    frame = ltp.GridFrame((0, 0, 0), CELL, blocked.shape)
    return ltp.Scene(ltp.OccupancyGrid.from_array(blocked, frame), ltp.Raster(priority, cell=2.0))


@pytest.mark.parametrize("name", ltp.PLANNERS)
def test_refined_paths_are_better_and_shorter(name: str) -> None:
    limits = {
        "bezier": ltp.BezierOptions(offsets=15, reach=30.0),
        # Circling pays here: they shall give up soon.
        "exact": ltp.ExactOptions(memory=2.0),
    }
    if name == "sweep":
        limits["linearised"] = ltp.LinearisedOptions(closing=2000)
    gains = []
    for seed in range(20):
        query = ltp.Query((3, 3 + 3 * seed, 14), (77, 71 - 3 * seed, 14), (0, 0))
        for w_p in (0.0, 1.0, 5.0):
            options = {"weights": ltp.PenaltyWeights(length=0.5, priority=w_p), **limits}
            plain = ltp.make_planner(name, **options).plan(scene(seed), query)
            refined = ltp.make_planner(name, refine=True, **options).plan(scene(seed), query)
            assert refined.status == plain.status
            if plain.status != PlanStatus.FOUND:
                continue
            assert refined.penalty <= plain.penalty + 1e-12
            assert refined.tally.length <= plain.tally.length * (1 + 1e-12)
            assert len(refined.path) <= len(plain.path)
            assert refined.bound == plain.bound
            gains.append(plain.penalty - refined.penalty)
    assert len(gains) > 20
    assert np.mean(gains) > 0.02


def test_a_mission_flies_refined_paths() -> None:
    world = town()
    path = np.array([(20.0, 20.0, 30.0), (60.0, 90.0, 30.0), (100.0, 110.0, 30.0)])
    shortest = ltp.PenaltyWeights(length=1.0, priority=0.0)
    options = [ltp.PlannerOptions(weights=shortest, refine=refine) for refine in (False, True)]
    plain, refined = (
        fly(world, MissionConfig(planner="ggwp", planner_options=each), path) for each in options
    )
    assert refined.config.planner_options.refine and not plain.config.planner_options.refine
    assert refined.outcome == plain.outcome == ltp.Outcome.REACHED
    assert refined.length < plain.length
