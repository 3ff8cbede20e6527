# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figures of gaps: they name every planner and count what they say."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text

from ltp.evaluation.contenders import OPTIMUM, Contender
from ltp.evaluation.figures.backdrop import save_figure
from ltp.evaluation.figures.gaps import front_figure, gap_figure
from ltp.evaluation.gap import Case, GapOptions, GapRow, QuerySet, run_gap
from ltp.evaluation.gap.front import plane, survey
from tests.python.scenes import ATTRIBUTION, patchwork

CASE = Case("binary", "planar", 2.0)
SMALL = GapOptions(
    planners=("shortest", "lp-dijkstra", "additive", "bezier"), ratios=(2.0,), bands=("planar",)
)


@pytest.fixture(scope="module")
def queries() -> QuerySet:
    return patchwork(4)


@pytest.fixture(scope="module")
def rows(queries: QuerySet, tmp_path_factory: pytest.TempPathFactory) -> list[GapRow]:
    return run_gap(queries, SMALL, tmp_path_factory.mktemp("gap"))


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
