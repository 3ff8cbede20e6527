# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp evaluate`, and what is made of its flights: `table`, `compare`, two figures."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest

from ltp.evaluation.campaign.rows import read_rows

from .runner import SHORT, fail, succeed


def test_evaluate_table_and_sweep(world: str, tmp_path: Path) -> None:
    out = tmp_path / "campaign"
    command = ["evaluate", world, *SHORT, "--paths", "2", "--out", out, "--processes", "1"]
    command += ["--rows", "1", "--planners", "lp-dijkstra,bezier", "--ratios", "0,2"]
    said = succeed(*command)
    rows = read_rows(out / "flights.csv")
    variants = {dataclasses.astuple(r.variant) for r in rows}
    assert variants == {
        ("lp-dijkstra", 1.0, 0.0, "binary", False),
        ("lp-dijkstra", 0.5, 1.0, "binary", False),
        ("lp-dijkstra", 1.0, 0.0, "lpf", False),
        ("lp-dijkstra", 0.5, 1.0, "lpf", False),
        ("bezier", 1.0, 0.0, "binary", False),
        ("bezier", 0.5, 1.0, "binary", False),
        ("bezier", 1.0, 0.0, "lpf", False),
        ("bezier", 0.5, 1.0, "lpf", False),
    }
    assert len(rows) == 16
    assert "2 through buildings; 8 variants" in said and "Table I" in said
    assert "0.82 (0.06)" in said  # the paper's
    assert "16 of 16 flights were flown before" in succeed(*command)

    table = succeed("table", out)
    assert table == (out / "tables.md").read_text()
    assert "| LP-Dijkstra | 0.5 | 1 |" in table
    assert "paper_mean_priority" in succeed("table", out / "flights.csv", "--format", "csv")
    succeed("table", out, "--out", tmp_path / "table.md")
    assert (tmp_path / "table.md").read_text() == table

    succeed("figure", "sweep", out, world, "--out", tmp_path / "sweep.png")
    assert (tmp_path / "sweep.png").stat().st_size > 20_000
    assert "was flown over town, not over built-in city" in fail(
        "figure", "sweep", out, "city", "--out", tmp_path / "no.png"
    )


def test_a_priority_map_of_ones_own_is_flown_with(world: str, tmp_path: Path) -> None:
    np.savez(tmp_path / "own.npz", values=np.full((130, 110), 0.25), origin=(0, 0), cell=2)
    command = ["evaluate", world, *SHORT, "--paths", "1", "--planners", "ggwp", "--processes", "1"]
    out = tmp_path / "campaign"
    succeed(*command, "--out", out, "--priority", tmp_path / "own.npz")
    rows = read_rows(out / "flights.csv")
    assert len(rows) == 1 and rows[0].mean_priority == pytest.approx(0.25)


def test_a_sweep_of_chosen_planners_is_compared_and_drawn(world: str, tmp_path: Path) -> None:
    out = tmp_path / "campaign"
    command = ["evaluate", world, *SHORT, "--paths", "3", "--out", out, "--processes", "1"]
    command += ["--rows", "none", "--planners", "lp-a-star,ggwp", "--ratios", "0,2"]
    succeed(*command, "--maps", "lpf")
    rows = read_rows(out / "flights.csv")
    assert {dataclasses.astuple(r.variant) for r in rows} == {
        (planner, *weights, "lpf", False)
        for planner in ("lp-a-star", "ggwp")
        for weights in ((1.0, 0.0), (0.5, 1.0))
    }
    said = succeed("compare", out, "--planners", "lp-a-star,ggwp", "--out", tmp_path / "compare.md")
    assert "GGWP less LP-A*, lpf map, W_P/W_L = 2: 3 pairs of 3" in said
    assert "| GGWP – LP-A* | lpf | 3/3 |" in (tmp_path / "compare.md").read_text()
    succeed("figure", "curve", out, world, "--out", tmp_path / "curve.png")
    assert (tmp_path / "curve.png").stat().st_size > 20_000
    assert "GGWP less LP-A*, lpf map" in succeed("compare", out)  # by default all that were flown
    assert "To fly two: ltp evaluate WORLD" in fail("compare", out, "--ratio", "5")
    assert "no map flown by all" in fail("compare", out, "--planners", "lp-a-star,bezier")
    # Each planner against itself with other settings.
    said = "".join(succeed("compare", out, "--against", out, "--maps", "lpf").split())  # wrapped
    same = f"GGWP ({out}) less GGWP ({out}), lpf map, W_P/W_L = 2: 3 pairs of 3"
    assert same.replace(" ", "") in said and "flownEq.5+0.000" in said
    assert "hold no planner that both" in fail("compare", out, "--against", out, "--ratio", "5")
    # Another command adds its rows; one with other settings is refused.
    succeed(*command[:-4], "--planners", "bezier", "--ratios", "2", "--maps", "lpf")
    assert read_rows(out / "flights.csv")[: len(rows)] == rows
    faster = tmp_path / "faster.toml"
    faster.write_text("[vehicle]\nspeed = 4.0\n")
    assert "other settings (vehicle.speed): give another folder" in fail(
        *command, "--config", faster
    )
    assert "was flown over town" in fail("figure", "curve", out, "city", "-o", tmp_path / "n.png")


def test_evaluate_flies_with_and_without_refinement(world: str, tmp_path: Path) -> None:
    out = tmp_path / "campaign"
    command = ["evaluate", world, *SHORT, "--paths", "2", "--out", out, "--processes", "1"]
    said = succeed(*command, "--rows", "1", "--planners", "ggwp", "--refine")
    rows = read_rows(out / "flights.csv")
    assert [row.refine for row in rows] == [False, False, True, True]
    assert sum(row.length for row in rows[2:]) < sum(row.length for row in rows[:2])
    assert "GGWP, refined" in said
    assert "| GGWP, refined | 1 | 0 |" in (out / "tables.md").read_text()
