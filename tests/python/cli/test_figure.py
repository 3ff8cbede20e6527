# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp figure`: a picture each, in a folder that it makes."""

from pathlib import Path

import pytest

from .runner import SHORT, succeed


@pytest.mark.parametrize("kind", ["paths", "sensing", "scenarios", "summary"])
def test_figures(kind: str, world: str, tmp_path: Path) -> None:
    out = tmp_path / "new folder" / f"{kind}.png"
    extra = {
        "paths": ["--ratios", "0,2", "--planner", "lp-a-star"],
        "sensing": ["--planner", "ggwp"],
        "scenarios": ["--paths", "4"],
        "summary": ["--planners", "lp-a-star,ggwp"],
    }[kind]
    said = succeed("figure", kind, world, *SHORT, *extra, "--out", out)
    assert str(out) in said
    assert out.read_bytes().startswith(b"\x89PNG") and out.stat().st_size > 50_000
