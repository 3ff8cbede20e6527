# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp regret`: it flies, judges and goes on; the figure drawn from it."""

from pathlib import Path

from ltp.evaluation.campaign.rows import read_rows
from ltp.evaluation.regret import read_regrets

from .runner import SHORT, fail, succeed


def test_regret_flies_judges_and_draws(world: str, tmp_path: Path) -> None:
    out = tmp_path / "regret"
    command = ["regret", world, *SHORT, "--paths", "2", "--processes", "1", "--out", out]
    command += ["--planners", "auto,lp-dijkstra+refine"]
    said = succeed(*command)
    rows = read_regrets(out / "regret.csv")
    assert [(row.planner, row.refine) for row in rows] == [
        ("auto", False),
        ("auto", False),
        ("lp-dijkstra", True),
        ("lp-dijkstra", True),
    ]
    assert all(row.joint <= row.legs for row in rows if row.joint is not None)
    flown = {(row.planner, row.scenario): row.penalty for row in read_rows(out / "flights.csv")}
    assert all(row.flown == flown[row.planner, row.scenario] for row in rows)
    assert "W_P/W_L = 2, exact waypoints" in said and "jointly" in said
    assert "| Auto | 2/2 |" in (out / "regret.md").read_text()
    assert max(map(len, said.splitlines())) <= 80 + len(str(out))
    again = succeed(*command)
    assert "4 of 4 flights were flown before" in again
    assert "4 of 4 regrets were judged before" in again
    # Other gates are judged anew, over the same flights.
    wider = succeed(*command, "--gate", "10")
    assert "4 of 4 flights were flown before" in wider and "gates of 10 m" in wider
    assert "judged before" not in wider

    drawn = "--out", tmp_path / "regret.png"
    succeed("figure", "regret", out, world, "--beside", out, *drawn)
    assert (tmp_path / "regret.png").read_bytes().startswith(b"\x89PNG")
    assert "was flown over town, not over built-in city" in fail("figure", "regret", out, "city")


def test_mistakes_name_the_option(world: str, tmp_path: Path) -> None:
    command = ["regret", world, *SHORT, "--paths", "1", "--processes", "1"]
    command += ["--out", tmp_path / "regret"]
    assert "--gate must be a radius >= 0 [m], not -1" in fail(*command, "--gate", "-1")
    assert "--planners" in fail(*command, "--planners", "nobody")
    assert "--ratios" in fail(*command, "--ratios", "-2")
    assert "--maps" in fail(*command, "--maps", "ours")
    assert "--planners must name a planner" in fail(*command, "--planners", ",")
