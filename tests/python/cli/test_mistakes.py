# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""A mistake takes one line, and names the option that it was made in."""

from pathlib import Path

import pytest

from ltp.cli.naming import naming
from ltp.evaluation.campaign.rows import write_rows
from ltp.evaluation.gap.queries import QuerySet
from ltp.world import World

from ..scenes import row
from .runner import SHORT, fail, run


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["fly", "nowhere.npz"], "nowhere.npz: no such world file"),
        (["fly", "city:one"], "the seed of the city must be a whole number"),
        (["fly", "city:²"], "the seed of the city must be a whole number"),
        (["fly", "WORLD", "--planner", "a-star"], "--planner"),
        (["fly", "WORLD", "--priority-map", "blurred"], "--priority-map"),
        (["fly", "WORLD", "--priority-weight", "-1"], "--priority-weight"),
        (["fly", "WORLD", "--scenario", "-1"], "--scenario must be >= 0"),
        (["fly", "WORLD", "--config", "missing.toml"], "missing.toml: No such file"),
        (["fly", "WORLD", "--config", "BAD"], "unknown key 'speed'"),
        (["fly", "WORLD", "--waypoints", "BAD"], "not a list of numbers x,y,z"),
        (["fly", "BAD"], "not a sound world file"),
        (["fly", "WORLD"], "--length = 500 m with --margin = 20 m does not fit into town"),
        (["evaluate", "WORLD", *SHORT, "--rows", "3"], "--rows"),
        (["evaluate", "WORLD", *SHORT, "--planners", "a-star"], "--planners: 'a-star'"),
        (["evaluate", "WORLD", *SHORT, "--ratios", "0;2"], "--ratios"),
        (["evaluate", "WORLD", *SHORT, "--ratios", "-1"], "--ratios W_P / W_L must be"),
        (["evaluate", "WORLD", *SHORT, "--rows", "none"], "nothing to fly"),
        (["evaluate", "WORLD", *SHORT, "--maps", "blurred"], "--maps: 'blurred'"),
        (["evaluate", "WORLD", *SHORT, "--processes", "-1"], "--processes must be >= 0"),
        (["gap", "WORLD", "--planners", "a-star"], "--planners 'a-star'"),
        (["gap", "WORLD", "--reference-planner", "a-star"], "--reference-planner: 'a-star'"),
        (["gap", "WORLD", "--maps", "blurred"], "--maps: 'blurred'"),
        (["gap", "WORLD", "--bands", "low"], "--bands: 'low'"),
        (["gap", "WORLD", "--ratios", "-1"], "--ratios W_P / W_L must be"),
        (["gap", "WORLD", "--memory", "0"], "--memory must be above zero"),
        (["gap", "WORLD", "--expansions", "-1"], "--expansions must be >= 0"),
        (["gap", "WORLD", *SHORT, "--paths", "0"], "--paths must be"),
        (["gap", "WORLD", *SHORT, "--queries", "0", "--out", "OUT/gap"], "--queries must be >= 1"),
        (["compare", "ROWS", "--planners", "lp-dijkstra"], "--planners must name two"),
        (["compare", "ROWS", "--maps", "blurred"], "--maps: 'blurred' is none of binary, lpf"),
        (["compare", "ROWS", "--planners", "a-star,ggwp"], "--planners 'a-star' is none of"),
        (["compare", "ROWS", "--ratio", "-1"], "--ratio W_P / W_L must be"),
        (["demo", "--paths", "0"], "--paths must be"),
        (["demo", "--seed", "-1"], "--seed must be"),
        (
            ["figure", "paths", "WORLD", *SHORT, "--planner", "a-star"],
            "--planner 'a-star' is none",
        ),
        (["figure", "paths", "WORLD", *SHORT, "--map", "blurred"], "--map must be one of"),
        (["figure", "sensing", "WORLD", *SHORT, "--planner", "a-star"], "--planner"),
        (["figure", "summary", "WORLD", *SHORT, "--planners", "ggwp,a-star"], "--planners"),
        (["figure", "summary", "WORLD", *SHORT, "--planners", ","], "--planners must name one"),
        (["fly", "WORLD", *SHORT, "--spacing", "1e-9"], "--spacing must cut --length = 120 m"),
        (["figure", "paths", "WORLD", *SHORT, "--scenario", "-1"], "--scenario must be >= 0"),
        (["compare", "EMPTY"], "holds no flights"),
        (["figure", "gap", "missing"], "No such file"),
        (["figure", "front", "BAD"], "not a set of recorded queries"),
        (["evaluate", "WORLD", *SHORT, "--paths", "0"], "--paths must be"),
        (["evaluate", "WORLD", *SHORT, "--reference", "sea"], "--reference must be one of"),
        (["evaluate", "WORLD", *SHORT, "--altitude", "200"], "crossed no building"),
        (
            ["evaluate", "WORLD", *SHORT, "--altitude", "200"],
            "Change --altitude, --length, --margin or --through-buildings",
        ),
        (
            ["evaluate", "WORLD", *SHORT, "--clearance", "400"],
            "started too near to something solid (--clearance = 400 m)",
        ),
        (["fly", "WORLD", *SHORT, "--clearance", "-1"], "--clearance must be >= 0"),
        (["fly", "WORLD", *SHORT, "--clearance", "nan"], "--clearance must be >= 0"),
        (["table", "missing.csv"], "missing.csv: No such file"),
        (["table", "BAD"], "missing columns"),
        (["table", "EMPTY"], "holds no flights"),
        (["table", "ROWS", "--format", "latex"], "--format"),
        (["figure", "sweep", "ROWS", "WORLD"], "was flown over boxes, not over town"),
        (["figure", "scenarios", "WORLD", *SHORT, "--out", "OUT/a.bmp"], "--out must end in .png"),
        (["replay", "BAD"], "is not a recording"),
        (["replay", "missing.rrd"], "missing.rrd: No such file"),
        (["world", "show", "WORLD", "--out", "OUT/a.txt"], "--out must end in .png"),
        (["figure", "front", "QUERIES", "--memory", "0"], "--memory must be above zero"),
        (["figure", "front", "QUERIES", "--band", "low"], "--band: 'low'"),
        (["figure", "front", "QUERIES", "--planners", "a-star"], "--planners 'a-star'"),
        (["world", "show", "WORLD", "--altitude", "0", "-o", "OUT/a.png"], "--altitude"),
        (["world", "city", "--size", "10"], "--size must be"),
        (["world", "city", "--cell", "0"], "--cell"),
        (["world", "city", "--seed", "-1"], "--seed must be"),
        (
            ["world", "import", "geotiff", "--dsm", "a.tif", "--dem", "b.tif", "-o", "OUT/w.npz"],
            "a.tif",
        ),
        (["world", "import", "las", "BAD", "-o", "OUT/w.npz"], "BAD"),
        (["config", "--config", "BAD"], "unknown key"),
    ],
)
def test_a_mistake_takes_one_line(
    arguments: list[str], complaint: str, world: str, tmp_path: Path
) -> None:
    bad, rows, empty = tmp_path / "BAD", tmp_path / "rows.csv", tmp_path / "empty.csv"
    bad.write_text("speed = 3\n")
    write_rows(rows, [row()])
    write_rows(empty, [])
    queries = tmp_path / "queries.npz"
    QuerySet("town", "", "", [], {}).save(queries)
    names = {"WORLD": world, "BAD": bad, "ROWS": rows, "EMPTY": empty, "QUERIES": queries}
    given = [names.get(text, text.replace("OUT/", f"{tmp_path}/")) for text in arguments]
    if arguments[0] in ("fly", "evaluate"):
        given += ["--out", tmp_path / "out"]
    assert complaint in fail(*given)


def test_a_traceback_is_there_for_the_asking(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LTP_TRACEBACK", "1")
    result = run("fly", "nowhere.npz")
    assert isinstance(result.exception, ValueError)


def test_a_lack_of_memory_is_no_traceback(monkeypatch: pytest.MonkeyPatch, world: str) -> None:
    def greedy(path: str) -> World:
        raise MemoryError("Unable to allocate 3 TiB")

    monkeypatch.setattr(World, "load", greedy)
    assert "not enough memory: Unable to allocate 3 TiB" in fail("world", "show", world)


def test_ctrl_c_is_no_traceback(monkeypatch: pytest.MonkeyPatch, world: str) -> None:
    def interrupted(path: str) -> World:
        raise KeyboardInterrupt

    monkeypatch.setattr(World, "load", staticmethod(interrupted))
    result = run("world", "show", world)
    assert result.exit_code == 130
    assert result.stderr == "ltp: interrupted\n"


@pytest.mark.parametrize(
    ("told", "expected"),
    [
        ("max_gap must be >= 0, not -1", "--max-gap must be >= 0, not -1"),
        (
            "count = 0: more is expected, see --max_gap",
            "--paths = 0: more is expected, see --max_gap",
        ),
        ("count.csv, /a/count/b and count", "count.csv, /a/count/b and --paths"),
        ("the discount and recount are right", "the discount and recount are right"),
        ("no max_gap-2 at count = 3", "no max_gap-2 at --paths = 3"),
    ],
)
def test_whole_words_are_told_as_options(told: str, expected: str) -> None:
    with pytest.raises(ValueError) as caught, naming("max_gap", count="--paths"):
        raise ValueError(told)
    assert str(caught.value) == expected
    with pytest.raises(OSError, match="count"), naming(count="--paths"):
        raise OSError("count")
