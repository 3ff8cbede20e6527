# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp gap`: it records, compares and goes on; the figures drawn from it."""

from pathlib import Path

from .runner import SHORT, fail, succeed


def test_gap_records_compares_and_draws(world: str, tmp_path: Path) -> None:
    out = tmp_path / "gap"
    command = ["gap", world, *SHORT, "--paths", "2", "--queries", "5", "--out", out]
    command += ["--planners", "shortest,lp-dijkstra,additive", "--ratios", "2"]
    command += ["--maps", "binary", "--bands", "planar", "--reference-planner", "sweep"]
    said = succeed(*command)
    assert {path.name for path in out.iterdir()} == {
        "queries.npz",
        "journal.jsonl",
        "gap.csv",
        "gap.md",
        "overview.md",
    }
    assert "Binary priority map, planar flight, W_P/W_L = 2: 5 queries" in said
    assert "| Additive A* | 5/5 |" in (out / "gap.md").read_text()
    again = succeed(*command)
    assert "5 queries were recorded before" in again
    assert "20 of 20 plans were made before" in again
    succeed("figure", "gap", out, "--out", tmp_path / "gap.png")
    drawn = ["--query", "2", "--planners", "shortest,sweep"]
    succeed("figure", "front", out, *drawn, "--out", tmp_path / "front.png")
    for name in ("gap.png", "front.png"):
        assert (tmp_path / name).read_bytes().startswith(b"\x89PNG")
    assert "query 9: there are 5" in fail("figure", "front", out, "--query", "9")
    assert "bands: 'low'" in fail(*command, "--bands", "low")
