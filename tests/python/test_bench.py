# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The benchmarks' work is always the same, and their report says what is missing."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from ltp import Query, flood_fill
from tests.bench import contest, graph, judges, mesh, workload
from tests.bench.goals import GOALS
from tests.bench.report import fill, summary
from tests.bench.results import Figure, Results, figure, load
from tests.bench.scoring import Goal, cpp, python, score

TOWN = "b3b29157783408900ce28c9192195503d35e5df5"
SENSING = "37c7693406f897c12b5ac5aca0d6e039f5912ecd"


def test_the_work_is_the_same_everywhere() -> None:
    assert workload.make_town().digest() == TOWN
    assert workload.make_sensing().digest() == SENSING


def test_the_town_is_what_it_is_said_to_be() -> None:
    town = workload.make_town()
    assert 0.15 < town.solid.mean() < 0.25
    assert len(town.pairs) == len(town.sealed) == 50
    assert not (town.hollow & ~town.solid).any()
    start, goal = workload.centres(town.pairs[0])
    reached = flood_fill(town.solid_grid, Query(start, goal))
    assert reached[tuple(town.pairs.reshape(-1, 3).T)].all()
    outside = flood_fill(town.hollow_grid, Query(start, goal))
    assert outside[tuple(town.sealed[:, 0].T)].all()
    assert not outside[tuple(town.sealed[:, 1].T)].any()
    assert not town.hollow[tuple(town.sealed[:, 1].T)].any()


def test_a_step_past_a_blocked_cell_is_not_on_the_graph() -> None:
    blocked = np.zeros((3, 3, 3), dtype=bool)
    blocked[2, 1, 1] = True
    assert not graph.legal(blocked, (1, 0, 0))[1, 1, 1]
    assert not graph.legal(blocked, (1, 1, 0))[1, 1, 1]
    assert graph.legal(blocked, (0, 1, 0))[1, 1, 1]
    assert not graph.legal(blocked, (-1, 0, 0))[0, 0, 0]


def test_a_raster_and_its_mesh_have_the_same_area() -> None:
    triangles = mesh.raster_mesh(np.array([[1.0, 3.0], [1.0, 1.0]]))
    a, b, c = np.moveaxis(triangles.astype(float), 1, 0)
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2.0
    assert area == pytest.approx(4.0 + 2.0 * 2.0)  # four tops, two walls of 2 m


def _work(answers: dict[str, float], judge: judges.Judge) -> contest.Work:
    work = contest.Work("sum", "a sum", lambda _: 2)
    work.enter("ltp")(lambda _: contest.Solver(lambda i: answers["ltp"]))
    work.enter("numpy", "numpy", judge)(lambda _: contest.Solver(lambda i: answers["numpy"]))
    return work


@pytest.mark.parametrize("theirs", [2.0, 3.0])
def test_who_answers_otherwise_is_not_timed(theirs: float) -> None:
    work = _work({"ltp": 2.0, "numpy": theirs}, judges.lengths(1.0, 1.0))
    limits, shared = contest.Limits(questions=2, seconds=1.0), contest.Shared()
    ours = contest.compete(work, work.contestants[0], shared, limits, None)
    row = contest.compete(work, work.contestants[1], shared, limits, ours.answers).row
    assert ("median" in row) == (theirs == 2.0)
    assert row.get("error", "").startswith("disagrees") == (theirs != 2.0)


def test_who_is_not_there_is_named() -> None:
    work = contest.Work("sum", "a sum", lambda _: 1)
    work.enter("nobody", "no-such-package")(lambda _: contest.Solver(lambda i: i))
    row = contest.compete(work, work.contestants[0], contest.Shared(), contest.Limits(), None).row
    assert row["error"].startswith("not available")


GOAL = Goal(
    "work", cpp("ltp", "work/ltp"), (cpp("slow", "work/slow"), cpp("slower", "work/slower")), 5
)


def _cpp(**milliseconds: float) -> Results:
    rows = {
        f"work/{name}": {"cpu_time": time, "time_unit": "ms"} for name, time in milliseconds.items()
    }
    return Results(cpp=rows)


@pytest.mark.parametrize(
    ("results", "row"),
    [
        (_cpp(ltp=0.5, slow=3, slower=9), "work | 500 µs | slow | 3 ms | 6x | 5x | yes"),
        (_cpp(ltp=1, slower=2), "work | 1 ms | slower | 2 ms | 2x | 5x | NO"),
        (_cpp(slow=3), "work | missing | slow | 3 ms | - | 5x | missing: ltp"),
        (_cpp(ltp=1), "work | 1 ms | missing | - | - | 5x | missing: peer"),
    ],
)
def test_a_goal_is_met_missed_or_missing(results: Results, row: str) -> None:
    assert summary([score(GOAL, results)])[-1] == f"| {row} |"


def test_a_rate_is_better_when_it_is_higher() -> None:
    assert figure(3.0, "M rays/s").better_than(figure(1.5, "M rays/s")) == 2.0
    assert figure(3.0, "ms").better_than(figure(1500.0, "us")) == 0.5
    with pytest.raises(ValueError, match="rate cannot be compared with a time"):
        figure(3.0, "M rays/s").better_than(Figure(1.0))


def test_the_page_is_filled_between_its_markers_only() -> None:
    page = "Before.\n<!-- bench:summary -->\nold\n<!-- bench:end -->\nAfter.\n"
    filled = fill(page, Results())
    assert filled.startswith("Before.\n<!-- bench:summary -->\n| work |")
    assert filled.endswith("<!-- bench:end -->\nAfter.\n")
    assert "old" not in filled
    assert filled.count("missing: ltp") == len(GOALS)
    assert fill(filled, Results()) == filled
    with pytest.raises(ValueError, match="marker 'nothing'"):
        fill(page.replace("summary", "nothing"), Results())


def test_every_section_of_the_real_page_is_known_and_small_results_fill_it() -> None:
    page = (Path(__file__).parents[2] / "docs" / "performance.md").read_text(encoding="utf-8")
    row: dict[str, Any] = {"work": "shortest", "unit": "ms", "version": "1", "questions": 50}
    rows = [
        row | {"name": "ltp auto", "package": "ltp", "median": 0.05, "p95": 0.4},
        row | {"name": "dijkstra3d A*", "package": "dijkstra3d", "median": 6.0, "p95": 9.0},
        row | {"name": "tcod A*", "package": "tcod", "error": "not available: tcod"},
    ]
    results = Results(
        cpp={"ggwp/ltp": {"cpu_time": 1.5, "time_unit": "ms", "rays_per_second": 2e8}},
        python={"rows": rows},
        scale={"tables": [{"title": "Rays", "columns": ["rays"], "rows": [[65536]]}]},
        latency={"rows": [{"name": "a flight", "median_ms": 1.0, "worst_ms": 9.0}]},
    )
    filled = fill(page, results)
    assert (
        "| shortest path, one query | 50 µs | dijkstra3d A* | 6 ms | 120x | 100x | yes |" in filled
    )
    assert "not available: tcod" in filled
    assert "| `ggwp/ltp` | 1.5 ms | rays_per_second 200 M/s |" in filled
    assert "| 65,536 |" in filled
    assert "| a flight | 1 ms | - | - | 9 ms |" in filled


def test_google_benchmark_s_medians_are_read_by_name(tmp_path: Path) -> None:
    (tmp_path / "cpp.json").write_text(
        '{"benchmarks": [{"name": "a/ltp/min_time:0.1_mean", "run_name": "a/ltp/min_time:0.1",'
        ' "run_type": "aggregate", "aggregate_name": "mean", "cpu_time": 9, "time_unit": "us"},'
        ' {"name": "a/ltp/min_time:0.1_median", "run_name": "a/ltp/min_time:0.1",'
        ' "run_type": "aggregate", "aggregate_name": "median", "cpu_time": 2, "time_unit": "us"},'
        ' {"name": "b", "run_name": "b", "run_type": "iteration", "cpu_time": 3, "time_unit": "ns",'
        ' "items_per_second": 1e8, "a_point": 1e-8},'
        ' {"name": "c", "run_name": "c", "run_type": "iteration",'
        ' "error_occurred": true, "error_message": "differs", "cpu_time": 0, "time_unit": "ns"}]}',
        encoding="utf-8",
    )
    results = load(tmp_path)
    assert results.of_cpp("a/ltp") == figure(2.0, "us")
    assert results.of_cpp("b", "items_per_second") == Figure(1e8, "rate")
    assert results.of_cpp("b", each="a_point") == Figure(1e-8)
    assert results.of_cpp("c") is results.of_cpp("d") is None
    assert results.cpp["c"] == {"error": "differs"}
    assert python("shortest", "ltp auto").find(results) is None
