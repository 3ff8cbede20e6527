# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What paths a query offers: the hull and the exact front hold every planner's path."""

import dataclasses

import numpy as np
import pytest

from ltp.evaluation.contenders import Contender
from ltp.evaluation.gap import Case, QuerySet
from ltp.evaluation.gap.front import plane, supported, survey
from ltp.evaluation.gap.queries import BANDS
from tests.python.scenes import patchwork

CASE = Case("binary", "planar", 2.0)


@pytest.fixture(scope="module")
def queries() -> QuerySet:
    return patchwork(4)


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
