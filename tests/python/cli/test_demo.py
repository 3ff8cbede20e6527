# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp demo`: everything at once, over the built-in city."""

from pathlib import Path

import ltp
from ltp.evaluation.campaign.rows import read_rows
from ltp.viewer.rerun_module import has_rerun

from .runner import succeed


def test_the_demo_flies_the_papers_planners_and_ours(tmp_path: Path) -> None:
    said = succeed("demo", "--out", tmp_path, "--paths", "1", "--processes", "2")
    rows = read_rows(tmp_path / "flights.csv")
    assert {r.planner for r in rows} == {*ltp.PLANNERS[:5], "sweep", "auto"}
    recording = ["demo.rrd"] if has_rerun() else []
    for name in ("flights.csv", "demo.png", *recording, "tables.md"):
        assert (tmp_path / name).stat().st_size > 500
        assert str(tmp_path / name) in said.replace("\n", "")
