# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gaps to the optimum: statistics by hand, runs that go on, plans judged by Eq. 5."""

import dataclasses
import math
import warnings
from pathlib import Path

import numpy as np
import pytest

from ltp.evaluation import digests
from ltp.evaluation.contenders import OPTIMUM
from ltp.evaluation.gap import TABLE, Case, GapOptions, GapRow, QuerySet, read_gaps, run_gap
from ltp.evaluation.gap.overview import markdown_overview
from ltp.evaluation.gap.rows import PLANS, with_optimum
from ltp.evaluation.gap.tables import markdown_gaps, number, share, summarise_gaps, unproved_note
from tests.python.scenes import patchwork

SMALL = GapOptions(
    planners=("shortest", "lp-dijkstra", "additive", "bezier"),
    ratios=(2.0,),
    bands=("planar",),
)


@pytest.fixture(scope="module")
def queries() -> QuerySet:
    return patchwork(4)


@pytest.fixture(scope="module")
def rows(queries: QuerySet, tmp_path_factory: pytest.TempPathFactory) -> list[GapRow]:
    return run_gap(queries, SMALL, tmp_path_factory.mktemp("gap"))


def made_up(planner: str, query: int, penalty: float | None, bound: float | None = None) -> GapRow:
    found = penalty is not None
    return GapRow(
        key=f"{planner}{query}",
        world="boxes",
        query=query,
        scenario=0,
        priority_map="binary",
        band="planar",
        ratio=2.0,
        planner=planner,
        status="found" if found else "none_found",
        penalty=penalty,
        length=60.0 if found else None,
        mean_priority=0.5 if found else None,
        direct_length=50.0,
        bound=bound,
        expanded=100 + query,
        time_plan=1.0 + query,
    )


def by_planner(rows: list[GapRow]) -> dict:
    return {summary.planner: summary for summary in summarise_gaps(with_optimum(rows))}


def test_statistics_by_hand() -> None:
    rows = []
    for query, best in enumerate((0.0, 0.1, 0.2, 0.3)):
        rows += [
            made_up(OPTIMUM, query, best, best),
            made_up("shortest", query, best + 0.5),
            made_up("lp-dijkstra", query, best + 0.1),
            made_up("additive", query, best + 0.01 * query, best - 0.01),
        ]
    rows[-1] = made_up("additive", 3, 0.5, 0.31)  # its bound is above the optimum
    found = by_planner(rows)
    additive = found["additive"]
    assert (additive.queries, additive.proved, additive.found) == (4, 4, 4)
    assert additive.gap_mean == pytest.approx((0.0 + 0.01 + 0.02 + 0.2) / 4)
    assert additive.gap_p95 == pytest.approx(np.percentile([0.0, 0.01, 0.02, 0.2], 95))
    assert additive.gap_worst == pytest.approx(0.2)
    assert additive.close == pytest.approx(0.5)
    assert additive.penalty == pytest.approx((0.0 + 0.11 + 0.22 + 0.5) / 4)
    assert (additive.bounded, additive.valid) == (1.0, 0.75)
    assert additive.width_mean == pytest.approx((0.01 + 0.02 + 0.03 + 0.19) / 4)
    assert additive.certified == pytest.approx(0.25)
    # LP-Dijkstra gains 0.4 on the shortest path; additive gains 0.1 - 0.0575 on LP-Dijkstra.
    assert additive.gain == pytest.approx((0.1 - 0.0575) / 0.4)
    assert found["lp-dijkstra"].gain == 0.0 and found["shortest"].gain == pytest.approx(-1.0)
    assert found[OPTIMUM].gain == pytest.approx(0.25)
    assert found["lp-dijkstra"].bounded == 0.0 and math.isnan(found["lp-dijkstra"].valid)
    assert (additive.time_median, additive.time_p95) == (2.5, pytest.approx(3.85))


def test_tables_of_older_versions_are_read(tmp_path: Path) -> None:
    written = [made_up(name, 0, 0.5) for name in ("pareto", "bug+refine", "sweep", "incremental")]
    PLANS.write(tmp_path / TABLE, written)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        names = [row.planner for row in read_gaps(tmp_path / TABLE)]
    assert names == ["exact", "tangent-bug+refine", "sweep", "incremental"]


def test_numbers_are_told_plainly() -> None:
    assert [number(v) for v in (-0.0004, -0.0126, math.nan)] == ["0.000", "−0.013", "–"]
    assert [share(v) for v in (0.999, 1.0, 0.5, math.nan)] == ["99.9 %", "100 %", "50 %", "–"]


def test_what_is_not_found_has_no_gap_and_what_has_no_path_does_not_count() -> None:
    rows = [
        made_up(OPTIMUM, 0, 0.2, 0.2),
        made_up(OPTIMUM, 1, 0.2, 0.2),
        made_up(OPTIMUM, 2, None),
        made_up("bezier", 0, 0.15),
        made_up("bezier", 1, None),
        made_up("bezier", 2, None),
    ]
    bezier = by_planner(rows)["bezier"]
    assert (bezier.queries, bezier.found) == (2, 1)
    assert bezier.gap_mean == pytest.approx(-0.05)  # off the grid it may beat the grid's best
    text = markdown_gaps(with_optimum(rows))
    assert "did not" not in text and "do not count: 1." in text
    assert "| Bézier | 1/2 | (0.150) | −0.0500 |" in text


def test_the_overview_has_a_row_a_case_and_one_a_certificate() -> None:
    rows = [
        made_up(OPTIMUM, 0, 0.2, 0.2),
        made_up("sweep", 0, 0.205, 0.198),
        made_up("sweep+refine", 0, 0.15, 0.198),  # a bound that is not about its own path
        made_up("bezier", 0, None),
    ]
    gaps, certificates = markdown_overview(summarise_gaps(with_optimum(rows))).split("\n\n")
    assert gaps.splitlines()[2:] == ["| binary | planar | 2 | 1/1 | 0.005 | −0.050 | – |"]
    (row,) = certificates.splitlines()[2:]
    assert row.startswith("| binary | planar | 2 | Sweep | 100 % | – |")
    assert row.endswith("| 100 % | 100 % | 0.007 |")


def test_without_a_proof_the_best_known_stands_in() -> None:
    rows = [
        made_up(OPTIMUM, 0, 0.3, 0.1),
        made_up("additive", 0, 0.25, 0.15),
        made_up("additive+refine", 0, 0.2),
        made_up("bezier", 0, 0.1),
        made_up(OPTIMUM, 1, None),  # out of budget
        made_up("additive", 1, 0.4),
    ]
    against = {row.key: row for row in with_optimum(rows)}
    first = against["additive0"]
    assert (first.optimum, first.optimum_bound, first.proved) == (0.25, 0.15, False)
    assert against[f"{OPTIMUM}0"].gap == pytest.approx(0.05)
    assert against["additive+refine0"].gap == pytest.approx(-0.05)
    second = against["additive1"]
    assert (second.optimum, second.optimum_bound, second.gap) == (0.4, None, 0.0)
    note = unproved_note(list(against.values()))
    assert note.startswith("In 2 of 2 queries the optimum is not proved")
    only = unproved_note([row for row in against.values() if row.query == 0])
    assert "by at most 0.1000" in only


def test_a_run_goes_on_where_it_stopped(queries: QuerySet, tmp_path: Path) -> None:
    class Stop:
        """Presses Ctrl-C after some plans."""

        def __init__(self, after: int) -> None:
            self.left = after
            self.start: tuple[int, int] | None = None

        def on_start(self, total: int, done: int) -> None:
            self.start = (total, done)

        def on_plan(self, row: GapRow) -> None:
            self.left -= 1
            if not self.left:
                raise KeyboardInterrupt

        def on_end(self) -> None:
            pass

    total = 2 * 5 * len(queries.queries)
    with pytest.raises(KeyboardInterrupt):
        run_gap(queries, SMALL, tmp_path, [Stop(17)])
    assert len(read_gaps(tmp_path / TABLE)) == 17
    second = Stop(10**6)
    rows = run_gap(queries, SMALL, tmp_path, [second])
    assert second.start == (total, 17) and len(rows) == total
    third = Stop(1)
    assert run_gap(queries, SMALL, tmp_path, [third]) == rows
    assert third.start == (total, total)
    assert read_gaps(tmp_path / TABLE) == rows
    # Fewer planners: the journal keeps the others, the table does not show them.
    fewer = run_gap(queries, dataclasses.replace(SMALL, planners=("bezier",)), tmp_path)
    assert {row.planner for row in fewer} == {OPTIMUM, "bezier"}


def test_another_build_plans_anew(
    queries: QuerySet, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    options = dataclasses.replace(SMALL, planners=("lp-dijkstra",), maps=("binary",))
    first = run_gap(queries, options, tmp_path)
    monkeypatch.setattr(digests, "program_digest", lambda: "another build")
    second = run_gap(queries, options, tmp_path)
    assert [row.penalty for row in first] == [row.penalty for row in second]
    assert not {row.key for row in first} & {row.key for row in second}


def test_plans_are_judged_by_the_weights_at_hand(rows: list[GapRow], queries: QuerySet) -> None:
    assert {row.planner for row in rows} == {OPTIMUM, *SMALL.planners}
    for row in rows:
        if row.penalty is None:
            continue
        assert row.length is not None and row.mean_priority is not None
        judged = 0.5 * row.length / row.direct_length - 1.0 * row.mean_priority
        assert row.penalty == pytest.approx(judged)
        assert row.optimum is not None and row.gap == row.penalty - row.optimum
        assert row.proved
        if row.planner in ("lp-dijkstra", "additive", "shortest"):
            assert row.gap >= -1e-9
        if row.bound is not None:
            assert row.bound <= row.optimum + 1e-9
    found = {summary.planner: summary for summary in summarise_gaps(rows) if summary.case == CASE}
    assert found["additive"].penalty <= found["lp-dijkstra"].penalty + 1e-9
    assert found["lp-dijkstra"].penalty < found["shortest"].penalty
    assert found["shortest"].bounded == 0.0


CASE = Case("binary", "planar", 2.0)


def test_refined_planners_are_named_and_no_worse(queries: QuerySet, tmp_path: Path) -> None:
    options = dataclasses.replace(SMALL, planners=("ggwp", "ggwp+refine"), maps=("binary",))
    found = {s.planner: s for s in summarise_gaps(run_gap(queries, options, tmp_path))}
    assert found["ggwp+refine"].penalty < found["ggwp"].penalty
    assert "GGWP, refined" in (markdown_gaps(read_gaps(tmp_path / TABLE)))


@pytest.mark.parametrize(
    ("wrong", "complaint"),
    [
        ({"maps": ["blurred"]}, "maps: 'blurred'"),
        ({"bands": []}, "bands: nothing"),
        ({"reference": "a-star"}, "reference: 'a-star'"),
        ({"planners": ["ggwp", "a-star"]}, "planner 'a-star'"),
        ({"planners": []}, "nothing to compare"),
        ({"ratios": [-1.0]}, "ratio"),
        ({"expansions": -1}, "expansions"),
        ({"memory": 0.0}, "memory"),
    ],
)
def test_wrong_options_are_named(wrong: dict, complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        GapOptions(**wrong)


def test_no_queries_no_gaps(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match="no queries"):
        run_gap(QuerySet("boxes", "", "", [], {}), SMALL, tmp_path)
