# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The curves of a sweep: over the scenarios that all planners flew."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text

from ltp.evaluation.figures.backdrop import save_figure
from ltp.evaluation.figures.curves import curve_figure, curves
from tests.python.scenes import ATTRIBUTION, flight, row


def swept() -> list:
    return [
        flight(
            planner,
            scenario,
            ratio,
            length_ratio=1.2 + 0.05 * ratio + shift + 0.01 * scenario,
            mean_priority=0.5 + 0.02 * ratio,
        )
        for planner, shift in (("lp-dijkstra", 0.1), ("sweep", 0.0))
        for ratio in (0.0, 2.0, 5.0)
        for scenario in range(3)
    ]


def test_curves_are_over_the_scenarios_that_all_flew(tmp_path: Path) -> None:
    rows = swept()
    rows.remove(next(r for r in rows if r.planner == "sweep" and r.scenario == 2))
    (dijkstra, sweep), count = curves(rows, "binary")
    assert count == 2 and dijkstra.ratios == [0.0, 2.0, 5.0]
    np.testing.assert_allclose(dijkstra.length, [1.305, 1.405, 1.555])
    np.testing.assert_allclose(sweep.priority, [0.5, 0.54, 0.6])
    np.testing.assert_allclose(sweep.length_error, 0.005)
    assert curves(rows, "lpf") == ([], 0)
    figure = curve_figure(rows, ATTRIBUTION)
    written = "\n".join(text.get_text() for text in figure.findobj(Text))
    assert "2 global paths" in written and "Sweep" in written and ATTRIBUTION in written
    drawn = [line.get_xydata() for line in figure.axes[0].lines]
    expected = np.column_stack([sweep.length, sweep.priority])
    assert any(xy.shape == expected.shape and np.allclose(xy, expected) for xy in drawn)
    save_figure(figure, tmp_path / "curve.png")
    assert (tmp_path / "curve.png").stat().st_size > 20_000


def test_no_sweep_no_curve() -> None:
    with pytest.raises(ValueError, match="two ratios"):
        curve_figure([row()], ATTRIBUTION)
    with pytest.raises(ValueError, match="several worlds"):
        curve_figure([*swept(), row(world="elsewhere")], ATTRIBUTION)
