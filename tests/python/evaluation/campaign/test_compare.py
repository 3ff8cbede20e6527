# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Paired comparisons: intervals against scipy's and against their promise; pairs by hand."""

import dataclasses
import inspect
import math

import numpy as np
import pytest

from ltp.evaluation.campaign.bootstrap import mean_interval
from ltp.evaluation.campaign.compare import (
    compare,
    compare_all,
    compare_campaigns,
    flown_maps,
    flown_planners,
    markdown_comparisons,
    pick,
)
from tests.python.scenes import flight


def test_the_interval_is_scipys() -> None:
    stats = pytest.importorskip("scipy.stats")
    rng = np.random.default_rng(3)
    # As scipy called it before 1.15.
    new = "rng" in inspect.signature(stats.bootstrap).parameters
    for values in (rng.normal(0.1, 1.0, 40), rng.exponential(1.0, 25), rng.integers(0, 5, 60)):
        ours = mean_interval(list(values))
        theirs = stats.bootstrap(
            (values,),
            np.mean,
            n_resamples=10_000,
            method="BCa",
            **{"rng" if new else "random_state": np.random.default_rng(5)},
        ).confidence_interval
        spread = theirs.high - theirs.low
        assert ours.low == pytest.approx(theirs.low, abs=0.03 * spread)
        assert ours.high == pytest.approx(theirs.high, abs=0.03 * spread)


def test_the_interval_holds_the_truth_as_often_as_it_says() -> None:
    rng = np.random.default_rng(8)
    held = 0
    for seed in range(60):
        interval = mean_interval(list(rng.normal(3.0, 1.0, 50)), seed=seed)
        held += interval.low <= 3.0 <= interval.high
    assert 51 <= held <= 60  # 57 are expected; outside with probability 0.2 %


def test_the_interval_of_few_or_equal_values() -> None:
    assert mean_interval([0.5, 0.5, 0.5]).high == 0.5
    one = mean_interval([2.0])
    assert one.mean == 2.0 and math.isnan(one.low) and not one.excludes_zero
    assert math.isnan(mean_interval([]).mean)
    assert mean_interval([1.0, 2.0, 4.0], seed=4) == mean_interval([1.0, 2.0, 4.0], seed=4)
    assert mean_interval([1.0, 2.0, 4.0]).excludes_zero
    assert not mean_interval([-1.0, 2.0, -4.0]).excludes_zero
    with pytest.raises(ValueError, match="confidence"):
        mean_interval([1.0, 2.0], confidence=95.0)


def test_flights_are_paired_by_scenario() -> None:
    rows = [flight("lp-dijkstra", i, penalty=0.1 * i, length_ratio=1.2) for i in range(5)]
    rows += [
        flight("sweep", i, penalty=0.1 * i - 0.02 * i, length_ratio=1.1)
        for i in reversed(range(1, 6))
    ]
    rows[9 - 1] = flight("sweep", 2, penalty=9.0, outcome="collided", collided=True)
    rows += [flight("sweep", 3, ratio=5.0, penalty=99.0)]
    rows += [flight("sweep", 3, kind="lpf", penalty=99.0)]
    found = compare(pick(rows, "lp-dijkstra", 2.0, "binary"), pick(rows, "sweep", 2.0, "binary"))
    assert (found.flown, found.pairs) == (4, 3)  # 1...4, less the one that collided
    assert found.differences["penalty"].mean == pytest.approx(-0.02 * (1 + 3 + 4) / 3)
    assert found.differences["length_ratio"].mean == pytest.approx(-0.1)
    assert (found.better, found.worse) == (3, 0)
    assert (found.baseline.collisions, found.challenger.collisions) == (0, 1)
    assert flown_maps(rows, ["lp-dijkstra", "sweep"], 2.0) == ["binary"]
    rows += [flight("sweep+refine", i, penalty=0.1 * i - 0.5) for i in range(5)]
    (refined,) = compare_all(rows, ["lp-dijkstra", "sweep+refine"], 2.0, ["binary"])
    assert refined.pairs == 5 and refined.differences["penalty"].mean == pytest.approx(-0.5)
    assert "| Sweep, refined – LP-Dijkstra | binary |" in markdown_comparisons([refined])
    text = markdown_comparisons([found])
    assert "| Sweep – LP-Dijkstra | binary | 3/4 | −0.053 [" in text
    assert "| 3 : 0 | 1, 0 |" in text


def test_distances_from_the_global_path_are_compared_where_all_have_them() -> None:
    rows = [flight("lp-dijkstra", i, path_distance_mean=5.0 + i) for i in range(3)]
    rows += [flight("sweep", i, path_distance_mean=3.0) for i in range(3)]
    (found,) = compare_all(rows, ["lp-dijkstra", "sweep"], 2.0, ["binary"])
    assert found.differences["path_distance_mean"].mean == pytest.approx(-3.0)
    rows[-1] = flight("sweep", 2)  # of an older file
    (found,) = compare_all(rows, ["lp-dijkstra", "sweep"], 2.0, ["binary"])
    assert math.isnan(found.differences["path_distance_mean"].mean)
    assert found.pairs == 3 and "| – | 0 : 0 |" in markdown_comparisons([found])


def test_what_cannot_be_paired_is_said() -> None:
    rows = [flight("lp-dijkstra", 0), flight("sweep", 1), flight("ggwp", 0, outcome="timed_out")]
    with pytest.raises(ValueError, match="no flights of bezier"):
        compare_all(rows, ["lp-dijkstra", "bezier"], 2.0, ["binary"])
    for other in ("sweep", "ggwp"):
        with pytest.raises(ValueError, match="no scenario both"):
            compare_all(rows, ["lp-dijkstra", other], 2.0, ["binary"])
    with pytest.raises(ValueError, match="two planners"):
        compare_all(rows, ["lp-dijkstra"], 2.0, ["binary"])


def test_by_default_what_was_flown_is_compared_with_lp_dijkstra() -> None:
    rows = [flight("ggwp", 0, kind="lpf"), flight("bezier", 0), flight("lp-dijkstra", 0)]
    rows += [flight("sweep", 0, ratio=5.0), flight("bezier+refine", 0)]
    assert flown_planners(rows, 2.0) == ["lp-dijkstra", "bezier", "bezier+refine"]
    assert flown_planners(rows, 2.0, ["lpf"]) == []
    assert flown_planners(rows, 5.0) == []
    assert flown_planners(rows[:2], 2.0) == []


def test_settings_are_compared_planner_by_planner_over_the_same_paths() -> None:
    points = [flight("auto", i, penalty=0.1 * i, length=550.0) for i in range(4)]
    camera = [flight("auto", i, penalty=0.1 * i - 0.05, length=500.0) for i in range(4)]
    for rows, ratio in ((points, 1.1), (camera, 1.0)):
        rows[:] = [dataclasses.replace(row, length_ratio=ratio) for row in rows]
    (found,) = compare_campaigns({"points": points}, {"camera": camera}, ["auto"], 2.0, ["binary"])
    assert (found.baseline.title, found.challenger.title) == ("Auto (points)", "Auto (camera)")
    assert found.differences["penalty"].mean == pytest.approx(-0.05)
    assert (found.pairs, found.better, found.worse) == (4, 4, 0)
    assert "| Auto (camera) – Auto (points) | binary | 4/4 |" in markdown_comparisons([found])
    # The same numbers of scenarios, but of another length.
    longer = [dataclasses.replace(row, length=row.length * 2) for row in camera]
    with pytest.raises(ValueError, match="not flown over the same global paths"):
        compare_campaigns({"a": points}, {"b": longer}, ["auto"], 2.0, ["binary"])
