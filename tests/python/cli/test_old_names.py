# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""What version 0.1 called otherwise is understood on the command line, and told on stderr."""

from pathlib import Path

import pytest

from ltp.evaluation.campaign.rows import read_rows
from ltp.evaluation.gap.rows import PLANS
from ltp.sim.record import FlightRecord

from .runner import SHORT, run, succeed


def told(option: str, old: str, new: str) -> str:
    return f"ltp: {option}: the planner '{old}' is now '{new}'; the old name goes with the next"


def test_fly_understands_the_old_name_of_a_planner(world: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    result = run("fly", world, *SHORT, "--planner", "bug", "--no-recording", "--out", out)
    assert result.exit_code == 0, result.output
    assert told("--planner", "bug", "tangent-bug") in result.stderr
    assert "is now" not in result.stdout
    assert FlightRecord.load(out / "flight.npz").config.planner == "tangent-bug"


def test_evaluate_and_compare_understand_the_old_names(world: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = ["evaluate", world, *SHORT, "--paths", 1, "--rows", "none", "--processes", 1]
    command += ["--planners", "lp-dijkstra,bug", "--ratios", "2", "--maps", "binary", "--out", out]
    result = run(*command)
    assert result.exit_code == 0, result.output
    assert result.stderr.count(told("--planners", "bug", "tangent-bug")) == 1
    rows = read_rows(out / "flights.csv")
    assert {row.planner for row in rows} == {"lp-dijkstra", "tangent-bug"}
    compared = run("compare", out, "--planners", "bug,lp-dijkstra", "--ratio", 2)
    assert compared.exit_code == 0, compared.output
    assert told("--planners", "bug", "tangent-bug") in compared.stderr


def test_gap_understands_the_old_names(world: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    command = ["gap", world, *SHORT, "--paths", 1, "--queries", 2, "--ratios", 2, "--maps", "lpf"]
    command += ["--planners", "pareto+refine,shortest", "--reference-planner", "pareto"]
    result = run(*command, "--bands", "planar", "--out", out)
    assert result.exit_code == 0, result.output
    for option in ("--planners", "--reference-planner"):
        assert told(option, "pareto", "exact") in result.stderr
    planners = {row.planner for row in PLANS.read(out / "gap.csv")}
    assert planners == {"exact+refine", "shortest", "optimum"}


def test_a_figure_understands_the_old_names(world: str, tmp_path: Path) -> None:
    command = ["figure", "summary", world, *SHORT, "--out", tmp_path / "a.png"]
    result = run(*command, "--planners", "bug")
    assert result.exit_code == 0, result.output
    assert told("--planners", "bug", "tangent-bug") in result.stderr


def test_way_points_are_waypoints_and_no_help_tells_of_them(world: str, tmp_path: Path) -> None:
    points, out = tmp_path / "points.csv", tmp_path / "out"
    points.write_text("20,20,30\n20,60,30\n")
    result = run("fly", world, "--way-points", points, "--no-recording", "--out", out)
    assert result.exit_code == 0, result.output
    assert "ltp: --way-points is now --waypoints;" in result.stderr
    path = FlightRecord.load(out / "flight.npz").global_path
    assert path.tolist() == [[20, 20, 30], [20, 60, 30]]
    assert "--way-points" not in succeed("fly", "--help")


@pytest.mark.parametrize("name", ["bugs", "pareto+", "bug+smooth"])
def test_what_is_no_old_name_is_refused(name: str, world: str, tmp_path: Path) -> None:
    result = run("gap", world, *SHORT, "--planners", name, "--out", tmp_path / "out")
    assert result.exit_code == 2, result.output
    assert "ltp: error: --planners " in result.stderr
