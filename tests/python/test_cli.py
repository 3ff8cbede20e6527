# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line: what it writes, what it says, and that mistakes take one line."""

import subprocess
import sys
from pathlib import Path

import pytest
from typer.testing import CliRunner, Result

import ltp
from ltp.cli import app
from ltp.config import MissionConfig
from ltp.evaluation.rows import read_rows, write_rows
from ltp.sim.record import FlightRecord
from ltp.world import World

from .scenes import row, town

SHORT = ["--length", "120", "--spacing", "40", "--altitude", "30", "--margin", "10"]


@pytest.fixture(scope="module")
def world(tmp_path_factory: pytest.TempPathFactory) -> str:
    path = tmp_path_factory.mktemp("world") / "town.npz"
    town().save(path)
    return str(path)


def run(*arguments: object) -> Result:
    return CliRunner().invoke(app, [str(argument) for argument in arguments])


def succeed(*arguments: object) -> str:
    result = run(*arguments)
    assert result.exit_code == 0, result.output
    return result.output


def fail(*arguments: object) -> str:
    """The one line that a mistake earns."""
    result = run(*arguments)
    assert result.exit_code == 2, result.output
    assert "Traceback" not in result.output
    assert result.stderr.startswith("ltp: error: ") and result.stderr.count("\n") == 1
    return result.stderr


def test_fly_writes_record_figure_and_recording(world: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    said = succeed("fly", world, *SHORT, "--planner", "ggwp", "--out", out)
    assert {path.name for path in out.iterdir()} == {"flight.npz", "flight.png", "flight.rrd"}
    record = FlightRecord.load(out / "flight.npz")
    assert record.config.planner == "ggwp"
    assert f"mean priority {record.mean_priority:.2f}" in said.replace("\n", " ")
    for name in ("flight.npz", "flight.png", "flight.rrd"):
        assert str(out / name) in said


def test_fly_takes_settings_from_a_file_and_waypoints_from_a_table(
    world: str, tmp_path: Path
) -> None:
    config, points = tmp_path / "config.toml", tmp_path / "points.csv"
    settings = MissionConfig(planner="lp-a-star", length_weight=0.25)
    settings.save(config)
    points.write_text("# x,y,z\n20,20,30\n20,60,30\n20,100.5,30\n")
    options = [
        "--config",
        config,
        "--waypoints",
        points,
        "--no-recording",
        "--out",
        tmp_path / "o",
    ]
    succeed("fly", world, *options, "--priority-weight", "2")
    record = FlightRecord.load(tmp_path / "o" / "flight.npz")
    assert record.global_path.tolist() == [[20, 20, 30], [20, 60, 30], [20, 100.5, 30]]
    assert (record.config.planner, record.config.length_weight) == ("lp-a-star", 0.25)
    assert record.config.priority_weight == 2.0
    assert not (tmp_path / "o" / "flight.rrd").exists()


def test_evaluate_table_and_sweep(world: str, tmp_path: Path) -> None:
    out = tmp_path / "campaign"
    command = ["evaluate", world, *SHORT, "--paths", "2", "--out", out, "--processes", "1"]
    command += ["--rows", "1", "--planners", "lp-dijkstra,bezier", "--ratios", "0,2"]
    said = succeed(*command)
    rows = read_rows(out / "flights.csv")
    variants = {r.variant for r in rows}
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


def test_a_sweep_of_chosen_planners_is_compared_and_drawn(world: str, tmp_path: Path) -> None:
    out = tmp_path / "campaign"
    command = ["evaluate", world, *SHORT, "--paths", "3", "--out", out, "--processes", "1"]
    command += ["--rows", "none", "--planners", "lp-a-star,ggwp", "--ratios", "0,2"]
    succeed(*command, "--maps", "lpf")
    rows = read_rows(out / "flights.csv")
    assert {r.variant for r in rows} == {
        (planner, *weights, "lpf", False)
        for planner in ("lp-a-star", "ggwp")
        for weights in ((1.0, 0.0), (0.5, 1.0))
    }
    said = succeed("compare", out, "--planners", "lp-a-star,ggwp", "--out", tmp_path / "compare.md")
    assert "GGWP less LP-A*, lpf map, W_P/W_L = 2: 3 pairs of 3" in said
    assert "| GGWP – LP-A* | lpf | 3/3 |" in (tmp_path / "compare.md").read_text()
    succeed("figure", "curve", out, world, "--out", tmp_path / "curve.png")
    assert (tmp_path / "curve.png").stat().st_size > 20_000
    assert "no map flown by all" in fail("compare", out, "--planners", "lp-a-star,bezier")
    assert "was flown over town" in fail("figure", "curve", out, "city", "-o", tmp_path / "n.png")


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


def test_evaluate_flies_with_and_without_refinement(world: str, tmp_path: Path) -> None:
    out = tmp_path / "campaign"
    command = ["evaluate", world, *SHORT, "--paths", "2", "--out", out, "--processes", "1"]
    said = succeed(*command, "--rows", "1", "--planners", "ggwp", "--refine")
    rows = read_rows(out / "flights.csv")
    assert [row.refine for row in rows] == [False, False, True, True]
    assert sum(row.length for row in rows[2:]) < sum(row.length for row in rows[:2])
    assert "GGWP, refined" in said
    assert "| GGWP, refined | 1 | 0 |" in (out / "tables.md").read_text()


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


def test_the_built_in_city_is_written_and_shown(tmp_path: Path) -> None:
    path = tmp_path / "city.npz"
    said = succeed("world", "city", "--size", "200", "--seed", "3", "--out", path)
    city = World.load(path)
    assert city.extent == (0.0, 0.0, 200.0, 200.0) and city.name in said
    picture = tmp_path / "city.png"
    succeed("world", "show", path, "--out", picture)
    assert picture.read_bytes().startswith(b"\x89PNG")


def test_the_demo_flies_the_papers_planners_and_ours(tmp_path: Path) -> None:
    said = succeed("demo", "--out", tmp_path, "--paths", "1", "--processes", "2")
    rows = read_rows(tmp_path / "flights.csv")
    assert {r.planner for r in rows} == {*ltp.PLANNERS[:5], "sweep", "auto"}
    for name in ("flights.csv", "demo.png", "demo.rrd", "tables.md"):
        assert (tmp_path / name).stat().st_size > 500
        assert str(tmp_path / name) in said.replace("\n", "")


def test_settings_are_printed_as_toml_that_reads_back(tmp_path: Path) -> None:
    text = succeed("config")
    assert MissionConfig.from_toml(text).to_dict() == MissionConfig().to_dict()
    file = tmp_path / "mine.toml"
    file.write_text('planner = "ggwp"\n')
    assert 'planner = "ggwp"' in succeed("config", "--config", file)


def test_version_and_module_are_the_same_program() -> None:
    assert succeed("version").strip() == ltp.__version__
    command = [sys.executable, "-m", "ltp", "version"]
    assert subprocess.run(command, capture_output=True, text=True, check=True).stdout == (
        f"{ltp.__version__}\n"
    )


def test_help_comes_without_the_heavy_libraries() -> None:
    code = (
        "import sys\nfrom typer.testing import CliRunner\nfrom ltp.cli import app\n"
        "assert CliRunner().invoke(app, ['--help']).exit_code == 0\n"
        "print([m for m in ('matplotlib', 'rerun', 'rasterio', 'scipy') if m in sys.modules])"
    )
    result = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True
    )
    assert result.stdout.strip() == "[]"


@pytest.mark.parametrize(
    ("arguments", "complaint"),
    [
        (["fly", "nowhere.npz"], "nowhere.npz: no such world file"),
        (["fly", "city:one"], "the seed of the city must be a whole number"),
        (["fly", "WORLD", "--planner", "a-star"], "a-star"),
        (["fly", "WORLD", "--priority-map", "blurred"], "priority_map"),
        (["fly", "WORLD", "--scenario", "-1"], "--scenario"),
        (["fly", "WORLD", "--config", "missing.toml"], "missing.toml: No such file"),
        (["fly", "WORLD", "--config", "BAD"], "unknown key 'speed'"),
        (["fly", "WORLD", "--waypoints", "BAD"], "not a list of numbers x,y,z"),
        (["fly", "BAD"], "not a sound world file"),
        (["fly", "WORLD"], "does not fit into town"),
        (["evaluate", "WORLD", *SHORT, "--rows", "3"], "--rows"),
        (["evaluate", "WORLD", *SHORT, "--planners", "a-star"], "--planners: 'a-star'"),
        (["evaluate", "WORLD", *SHORT, "--ratios", "0;2"], "--ratios"),
        (["evaluate", "WORLD", *SHORT, "--ratios", "-1"], "ratio"),
        (["evaluate", "WORLD", *SHORT, "--rows", "none"], "nothing to fly"),
        (["evaluate", "WORLD", *SHORT, "--maps", "blurred"], "--maps: 'blurred'"),
        (["gap", "WORLD", "--planners", "a-star"], "planner 'a-star'"),
        (["compare", "ROWS", "--planners", "lp-dijkstra"], "two planners"),
        (["compare", "EMPTY"], "holds no flights"),
        (["figure", "gap", "missing"], "No such file"),
        (["figure", "front", "BAD"], "not a set of recorded queries"),
        (["evaluate", "WORLD", *SHORT, "--paths", "0"], "count"),
        (["evaluate", "WORLD", *SHORT, "--reference", "sea"], "reference"),
        (["evaluate", "WORLD", *SHORT, "--altitude", "200"], "crossed no building"),
        (["table", "missing.csv"], "missing.csv: No such file"),
        (["table", "BAD"], "missing columns"),
        (["table", "EMPTY"], "holds no flights"),
        (["table", "ROWS", "--format", "latex"], "--format"),
        (["figure", "sweep", "ROWS", "WORLD"], "was flown over boxes, not over town"),
        (["figure", "scenarios", "WORLD", *SHORT, "--out", "OUT/a.bmp"], "must end in .png"),
        (["replay", "BAD"], "is not a recording"),
        (["replay", "missing.rrd"], "missing.rrd: No such file"),
        (["world", "show", "WORLD", "--out", "OUT/a.txt"], "must end in .png"),
        (["world", "city", "--size", "10"], "size"),
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
    names = {"WORLD": world, "BAD": bad, "ROWS": rows, "EMPTY": empty}
    given = [names.get(text, text.replace("OUT/", f"{tmp_path}/")) for text in arguments]
    if arguments[0] in ("fly", "evaluate"):
        given += ["--out", tmp_path / "out"]
    assert complaint in fail(*given)


def test_classes_of_rasters_need_a_meaning(tmp_path: Path) -> None:
    command = ["world", "import", "geotiff", "--dsm", "a", "--dem", "b", "--classes", "c"]
    said = fail(*command, "--class", "building=4", "-o", tmp_path / "w.npz")
    assert "--class: expected CODE=CLASS" in said


def test_a_missing_extra_is_told_with_its_command(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, world: str
) -> None:
    survey = tmp_path / "survey.las"
    points = pytest.importorskip("laspy").create(point_format=6, file_version="1.4")
    points.x, points.y, points.z = [0.0, 9.0], [0.0, 9.0], [1.0, 2.0]
    points.write(survey)
    monkeypatch.setitem(sys.modules, "laspy", None)
    assert 'pip install "ltp[geo]"' in fail("world", "import", "las", survey, "-o", "w.npz")
    monkeypatch.setitem(sys.modules, "rerun", None)
    said = fail("fly", world, *SHORT, "--recording", "--out", tmp_path)
    assert 'pip install "ltp[viewer]"' in said


def test_a_traceback_is_there_for_the_asking(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("LTP_TRACEBACK", "1")
    result = run("fly", "nowhere.npz")
    assert isinstance(result.exception, ValueError)


def test_replan_compares_two_planners_at_every_scan(world: str) -> None:
    said = succeed("replan", world, *SHORT, "--alpha", "1.4")
    assert "times fewer" in said
    assert "the same answer always; the same cost in 100 %" in " ".join(said.split())
    assert "expected one of" in fail("replan", world, *SHORT, "--planner", "none")


def test_ctrl_c_is_no_traceback(monkeypatch: pytest.MonkeyPatch, world: str) -> None:
    def interrupted(path: str) -> World:
        raise KeyboardInterrupt

    monkeypatch.setattr(World, "load", staticmethod(interrupted))
    result = run("world", "show", world)
    assert result.exit_code == 130
    assert result.stderr == "ltp: interrupted\n"
