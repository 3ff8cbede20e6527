# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The figure of regret: every flight a dot, means and their names."""

from pathlib import Path

import numpy as np
import pytest
from matplotlib.text import Text

from ltp.evaluation.figures.backdrop import save_figure
from ltp.evaluation.figures.regrets import regret_figure
from tests.python.scenes import ATTRIBUTION, regret_row


def test_every_flight_is_a_dot(tmp_path: Path) -> None:
    rows = [regret_row(scenario=i, flown=0.05 * i) for i in range(6)]
    rows += [regret_row(planner="sweep", scenario=i, flown=0.04 * i) for i in range(6)]
    rows += [regret_row(planner="sweep", scenario=6, outcome="timed_out", flown=9.0)]
    figure = regret_figure(rows, ATTRIBUTION)
    written = "\n".join(text.get_text() for text in figure.findobj(Text))
    assert "exact waypoints" in written
    assert "Auto" in written and "Sweep" in written and ATTRIBUTION in written
    dots = [line.get_xdata() for line in figure.axes[1].lines if len(line.get_xdata()) == 6]
    np.testing.assert_allclose(dots[0], 0.1 + 0.05 * np.arange(6))
    save_figure(figure, tmp_path / "regret.png")
    assert (tmp_path / "regret.png").stat().st_size > 20_000
    with pytest.raises(ValueError, match="no flight"):
        regret_figure([regret_row(outcome="timed_out")], ATTRIBUTION)
