# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Recorded queries: what was asked in flight, asked again, gives what was answered in flight."""

import math
from pathlib import Path

import numpy as np
import pytest

from ltp._core import PenaltyWeights
from ltp.config import MissionConfig
from ltp.evaluation.gap.queries import BANDS, QueryRecorder, QuerySet, evenly, record_queries
from ltp.evaluation.scenarios import ScenarioOptions, make_scenarios
from ltp.registry import make_planner
from ltp.sim import fly
from tests.python.scenes import ATTRIBUTION, patchwork, town

OPTIONS = ScenarioOptions(count=2, length=120.0, spacing=40.0, altitude=30.0, margin=10.0)
CONFIG = MissionConfig(planner="lp-dijkstra", priority_map="lpf")  # it remembers no plans


@pytest.fixture(scope="module")
def recorded() -> QuerySet:
    world = town()
    return record_queries(world, make_scenarios(world, OPTIONS), CONFIG, 8, "made in a test")


def test_a_replayed_query_gives_the_flown_plan(recorded: QuerySet) -> None:
    planner = make_planner("lp-dijkstra")
    assert len(recorded.queries) >= 5
    for query in recorded.queries:
        plan = planner.plan(recorded.scene(query, "lpf"), query.query())
        assert plan.penalty == query.flown
        if math.isfinite(plan.penalty):
            np.testing.assert_array_equal(plan.path[[0, -1]], [query.start, query.goal])
    assert any(query.grid.count() for query in recorded.queries)


def test_every_plan_of_a_flight_with_free_ends_is_kept() -> None:
    world = town()
    path = make_scenarios(world, OPTIONS)[1].global_path
    recorder = QueryRecorder(1)
    record = fly(world, CONFIG, path, [recorder])
    flown = {(plan.time, plan.penalty) for plan in record.plans}
    kept = {(query.time, query.flown) for query in recorder.queries}
    assert kept <= flown
    assert {entry for entry in flown if math.isfinite(entry[1])} <= kept
    for query in recorder.queries:
        ends = np.stack([query.start, query.goal])
        assert not query.grid.blocked_at(ends).any()
        assert all(query.grid.frame.contains(end) for end in ends)


def test_a_set_comes_back_from_its_file(recorded: QuerySet, tmp_path: Path) -> None:
    path = tmp_path / "queries.npz"
    recorded.save(path)
    loaded = QuerySet.load(path)
    assert (loaded.world, loaded.attribution) == ("town", ATTRIBUTION)
    assert loaded.source == "made in a test"
    assert len(loaded.queries) == len(recorded.queries)
    for a, b in zip(recorded.queries, loaded.queries, strict=True):
        assert a.digest() == b.digest() and a.grid == b.grid
        assert (a.scenario, a.time, a.waypoint, a.band, a.flown) == (
            b.scenario,
            b.time,
            b.waypoint,
            b.band,
            b.flown,
        )
    for scenario, maps in recorded.priorities.items():
        for name, raster in maps.items():
            other = loaded.priorities[scenario][name]
            np.testing.assert_array_equal(raster.values, other.values)
            assert raster.cell == other.cell and tuple(raster.origin) == tuple(other.origin)
    # Both flights were at one height over flat ground: their two maps are kept once.
    assert sum(name.startswith("raster") for name in np.load(path).files) == 2
    assert path.stat().st_size < 200_000


def test_a_set_from_before_a_field_was_renamed_is_read(tmp_path: Path) -> None:
    path, found = tmp_path / "queries.npz", patchwork(5, count=2)
    found.save(path)
    arrays = dict(np.load(path))
    header = arrays["header"].tobytes().replace(b'"waypoint"', b'"way_point"')
    np.savez(path, **(arrays | {"header": np.frombuffer(header, np.uint8)}))
    assert [query.digest() for query in QuerySet.load(path).queries] == [
        query.digest() for query in found.queries
    ]


def test_the_open_band_lets_paths_climb() -> None:
    found = patchwork(5)
    planner = make_planner("lp-a-star", weights=PenaltyWeights(length=1.0, priority=0.0))
    shorter = 0
    for query in found.queries:
        scene = found.scene(query, "binary")
        flat, free = (planner.plan(scene, query.query(BANDS[b])) for b in ("planar", "open"))
        assert np.ptp(flat.path[:, 2]) == 0.0
        assert free.tally.length <= flat.tally.length + 1e-9
        shorter += bool(np.ptp(free.path[:, 2]))
    assert shorter > 0


def test_thinning_keeps_both_ends() -> None:
    items = list(range(11))
    assert evenly(items, 3) == [0, 5, 10]  # type: ignore[comparison-overlap,arg-type]
    assert evenly(items, 20) == items  # type: ignore[comparison-overlap,arg-type]
    with pytest.raises(ValueError, match="number of queries"):
        record_queries(town(), [], CONFIG, 0)


def test_flights_through_gates_are_refused_by_name() -> None:
    # Their plans end anywhere in a region: kept as points, they would be other questions.
    gated, looking = MissionConfig(), MissionConfig()
    gated.navigation.gate_radius = 5.0
    looking.navigation.horizon = 3
    for config, said in (
        (MissionConfig(gate="camera"), "gate = 'camera': expected 'point'"),
        (MissionConfig(gate=25.0), "gate = 25.0: expected 'point'"),
        (gated, "navigation.gate_radius = 5.0: expected 0.0"),
        (looking, "navigation.horizon = 3: expected 1"),
    ):
        with pytest.raises(ValueError, match=said):
            record_queries(town(), [], config, 8)
        path = make_scenarios(town(), OPTIONS)[0].global_path
        with pytest.raises(ValueError, match=said):
            fly(town(), config, path, [QueryRecorder(0)])


def test_other_files_are_no_queries(tmp_path: Path) -> None:
    path = tmp_path / "queries.npz"
    np.savez(path, values=np.zeros(3))
    with pytest.raises(ValueError, match="not a set of recorded queries"):
        QuerySet.load(path)
    path.write_text("speed = 3\n")
    with pytest.raises(ValueError, match="not a set of recorded queries"):
        QuerySet.load(path)
