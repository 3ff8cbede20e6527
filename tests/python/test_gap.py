# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Gaps to the optimum: statistics by hand, runs that go on, figures that show what they say."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text

from ltp.evaluation.backdrop import save_figure
from ltp.evaluation.front import plane, supported, survey
from ltp.evaluation.gap import (
    OPTIMUM,
    TABLE,
    Case,
    Contender,
    GapOptions,
    GapRow,
    read_gaps,
    run_gap,
    with_optimum,
)
from ltp.evaluation.gap_figures import front_figure, gap_figure
from ltp.evaluation.gap_overview import markdown_overview
from ltp.evaluation.gap_tables import markdown_gaps, number, share, summarise_gaps, unproved_note
from ltp.evaluation.queries import BANDS, QuerySet

from .scenes import ATTRIBUTION, patchwork

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


def test_the_hull_holds_every_path(queries: QuerySet) -> None:
    contenders = [Contender(name) for name in ("shortest", "lp-dijkstra", "additive", "ggwp")]
    corners = 0
    for index, query in enumerate(queries.queries):
        view = survey(queries, index, CASE, contenders)
        hull, most = view.hull, view.most
        assert (np.diff(hull[:, 0]) > 0).all() and (np.diff(hull[:, 1]) > 0).all()
        slopes = np.diff(hull[:, 1]) / np.diff(hull[:, 0])
        assert (np.diff(slopes) < 1e-9).all() and (slopes > most).all()
        for landing in view.landings:
            assert landing.length >= hull[0, 0] - 1e-6
            for alpha in [*slopes, 1.001 * most]:
                best = np.min(alpha * hull[:, 0] - hull[:, 1])
                assert alpha * landing.length - landing.priority >= best - 1e-6
        corners += len(hull)
        front = view.front
        assert front is not None and (np.diff(front[:, 0]) > 0).all()
        assert (np.diff(most * front[:, 0] - front[:, 1]) < 0).all()
        for corner in hull:  # supported paths are on the front
            assert np.abs(front - corner).sum(axis=1).min() < 1e-6
        for alpha in slopes:
            best = np.min(alpha * hull[:, 0] - hull[:, 1])
            assert np.min(alpha * front[:, 0] - front[:, 1]) >= best - 1e-6
        edge = view.envelope(3.0)
        assert (np.diff(edge[:, 0]) > 0).all() and edge[-1, 0] == pytest.approx(3.0)
        np.testing.assert_allclose(edge[0], plane(hull[:1], query.direct_length)[0])
    assert corners > 3 * len(queries.queries)
    with pytest.raises(ValueError, match="there are"):
        survey(queries, len(queries.queries), CASE, contenders)


def test_a_front_that_needs_too_much_memory_is_left_out(queries: QuerySet) -> None:
    view = survey(queries, 0, CASE, [Contender("lp-dijkstra")], memory=1e-6)
    assert view.front is None and len(view.hull)


def test_a_hull_needs_a_path(queries: QuerySet) -> None:
    query = queries.queries[0]
    outside = dataclasses.replace(query, goal=np.array([5e3, 0.0, 0.0]))
    with pytest.raises(ValueError, match="no path: outside_map"):
        supported(queries.scene(query, "binary"), outside.query(BANDS["planar"]), 1.0)


def texts(figure) -> str:
    return "\n".join(text.get_text() for text in figure.findobj(Text))


def test_the_front_figure_names_every_path(queries: QuerySet, tmp_path: Path) -> None:
    names = ("lp-dijkstra", "sweep", "shortest")
    view = survey(queries, 1, CASE, [Contender(name) for name in names])
    figure = front_figure(view, queries.world, queries.attribution)
    written = texts(figure)
    for landing, title in zip(
        view.landings, ("LP-Dijkstra", "Sweep", "Shortest path"), strict=True
    ):
        assert f"{title}:  {landing.penalty:.3f}" in written.replace("−", "-")
    assert (
        "no grid path lies above it" in written
        and "exact front:" in written
        and "certificate of Sweep" in written
    )
    assert ATTRIBUTION in written
    drawn = [line.get_xydata() for line in figure.axes[0].lines]
    for landing in view.landings:
        (at,) = plane(np.array([(landing.length, landing.priority)]), view.direct_length)
        assert any(len(xy) == 1 and np.allclose(xy[0], at) for xy in drawn)
    save_figure(figure, tmp_path / "front.png")
    assert (tmp_path / "front.png").stat().st_size > 20_000


def test_the_gap_figure_counts_queries(rows: list[GapRow], tmp_path: Path) -> None:
    figure = gap_figure(rows, ATTRIBUTION)
    assert len(figure.axes) == 2 and ATTRIBUTION in texts(figure)
    mine = [row for row in rows if row.case == CASE and row.planner == "lp-dijkstra"]
    gaps = [row.gap for row in mine if row.gap is not None]
    (line,) = [line for line in figure.axes[0].lines if line.get_label() == "LP-Dijkstra"]
    x, y = line.get_data()
    for limit in (0.0, 0.01, 0.1, 1.0):
        expected = sum(gap <= limit for gap in gaps) / len(mine)
        assert y[np.searchsorted(x, limit, side="right") - 1] == pytest.approx(expected)
    save_figure(figure, tmp_path / "gap.png")
    with pytest.raises(ValueError, match="no planner"):
        gap_figure([row for row in rows if row.planner == OPTIMUM], ATTRIBUTION)


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
