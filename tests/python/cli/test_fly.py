# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp fly`: what it writes, and where its settings and waypoints come from."""

from pathlib import Path

import numpy as np
import pytest

from ltp.cli.waypoints import read_waypoints
from ltp.config import MissionConfig
from ltp.sim.record import FlightRecord
from ltp.viewer.rerun_module import has_rerun

from .runner import SHORT, fail, run, succeed


def test_fly_writes_record_figure_and_recording(world: str, tmp_path: Path) -> None:
    out = tmp_path / "out"
    said = succeed("fly", world, *SHORT, "--planner", "ggwp", "--out", out)
    written = {"flight.npz", "flight.png"} | ({"flight.rrd"} if has_rerun() else set())
    assert {path.name for path in out.iterdir()} == written
    record = FlightRecord.load(out / "flight.npz")
    assert record.config.planner == "ggwp"
    assert f"mean priority {record.mean_priority:.2f}" in said.replace("\n", " ")
    for name in written:
        assert str(out / name) in said


def test_fly_takes_settings_from_a_file_and_waypoints_from_a_table(
    world: str, tmp_path: Path
) -> None:
    config, points = tmp_path / "config.toml", tmp_path / "points.csv"
    settings = MissionConfig(planner="lp-a-star")
    settings.planner_options.weights.length = 0.25
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
    weights = record.config.planner_options.weights
    assert record.config.planner == "lp-a-star"
    assert (weights.length, weights.priority) == (0.25, 2.0)
    assert not (tmp_path / "o" / "flight.rrd").exists()


def test_the_uav_may_climb_unless_a_file_or_an_option_says_otherwise(
    world: str, tmp_path: Path
) -> None:
    config = tmp_path / "config.toml"
    config.write_text("[navigation]\nclimb = 8.0\n")
    points = tmp_path / "points.csv"
    points.write_text("20,65,30\n40,65,30\n")
    for options, climb in (
        ((), 20.0),
        (("--climb", "5"), 5.0),
        (("--climb", "0"), 0.0),
        (("--config", config), 8.0),
        (("--config", config, "--climb", "inf"), float("inf")),
    ):
        out = ("--waypoints", points, "--no-recording", "--out", tmp_path)
        said = " ".join(succeed("fly", world, *options, *out).split())
        record = FlightRecord.load(tmp_path / "flight.npz")
        assert record.config.navigation.climb == climb
        assert (f"may climb {climb:g} m above its waypoints" in said) == (climb > 0.0)
    assert "--climb = -1" in fail("fly", world, "--climb", "-1", *out)


def test_a_byte_order_mark_is_no_part_of_the_first_number(tmp_path: Path) -> None:
    points = tmp_path / "points.csv"
    points.write_text("20,20,30\n20,60,30\n", encoding="utf-8-sig")
    assert read_waypoints(points).tolist() == [[20, 20, 30], [20, 60, 30]]


@pytest.mark.parametrize(
    ("table", "complaint"),
    [
        ("20,20,0.5\n20,60,0.5\n", "points.csv: waypoints[0]: the start's altitude is 0.5 m"),
        ("20,20,30\n20,20,30\n", "points.csv: waypoints: expected a path longer than 0 m"),
    ],
)
def test_waypoints_that_cannot_be_flown_are_told_by_their_file(
    table: str, complaint: str, world: str, tmp_path: Path
) -> None:
    points = tmp_path / "points.csv"
    points.write_text(table)
    options = ("--climb", 0, "--no-recording", "--out", tmp_path / "o")
    assert complaint in fail("fly", world, "--waypoints", points, *options)


@pytest.mark.parametrize(
    ("table", "complaint"),
    [
        ("20,20,30\n20,700,30\n", "points.csv: waypoints[1] = (20, 700) lies off town"),
        ("2.3501,48.8502,30\n2.3511,48.8513,30\n", "look like degrees"),
        ("584100,4511200,30\n584300,4511500,30\n", "look like map coordinates"),
        ("20,20,nan\n20,60,30\n", "points.csv: waypoint 0 is not finite"),
        ("20,20\n20,60\n", "points.csv: expected two lines x,y,z or more"),
    ],
)
def test_waypoints_that_are_not_over_the_world_are_refused(
    table: str, complaint: str, world: str, tmp_path: Path
) -> None:
    points = tmp_path / "points.csv"
    points.write_text(table)
    told = fail("fly", world, "--waypoints", points, "--out", tmp_path / "o")
    assert complaint in told
    assert "lies off" not in told or "covers x = 0 ... 260 m, y = 0 ... 220 m" in told
    assert not (tmp_path / "o").exists()


def own_map(path: Path, size: int = 130) -> Path:
    values = np.full((size, 110), 0.25)
    values[:, ::2] = 0.75
    np.savez(path, values=values, origin=(0, 0), cell=2)
    return path


def test_a_priority_map_of_ones_own_is_flown_with(world: str, tmp_path: Path) -> None:
    own, out = own_map(tmp_path / "own.npz"), tmp_path / "out"
    options = [*SHORT, "--planner", "ggwp", "--no-recording", "--out", out, "--priority", own]
    succeed("fly", world, *options)
    assert 0.25 < FlightRecord.load(out / "flight.npz").mean_priority < 0.75
    succeed("fly", world, *options, "--priority-map", "lpf")
    seen = FlightRecord.load(out / "flight.npz")
    assert seen.mean_priority == pytest.approx(0.5, abs=0.03)
    result = run("fly", world, *options, "--priority", own_map(tmp_path / "half.npz", 65))
    assert result.exit_code == 0
    assert "half.npz covers 50.0 % of town; elsewhere the priority is 0" in result.stderr


@pytest.mark.parametrize("command", ["fly", "evaluate"])
def test_what_is_no_priority_map_is_refused(command: str, world: str, tmp_path: Path) -> None:
    bad = tmp_path / "bad.npz"
    np.savez(bad, values=np.full((9, 9), 7.0), origin=(0, 0), cell=2)
    out = ["--out", tmp_path / "out"]
    told = fail(command, world, *SHORT, "--priority", bad, *out)
    assert "bad.npz: values must hold shares from 0 to 1" in told
    assert "no such file" in fail(command, world, *SHORT, "--priority", tmp_path / "no.npz", *out)
    assert "is not a sound" in fail(command, world, *SHORT, "--priority", world, *out)
    assert not (tmp_path / "out").exists()


def test_a_list_of_classes_and_the_limits_come_from_a_file(world: str, tmp_path: Path) -> None:
    config, out = tmp_path / "config.toml", tmp_path / "out"
    config.write_text('planner = "ggwp"\nlandable = ["water"]\n[landing]\nmax_slope = 5\n')
    succeed("fly", world, *SHORT, "--config", config, "--no-recording", "--out", out)
    record = FlightRecord.load(out / "flight.npz")
    assert record.mean_priority == 0.0
    assert record.config.landable == ("water",) and record.config.landing.max_slope == 5.0
    config.write_text('landable = ["watr"]\n')
    told = fail("fly", world, *SHORT, "--config", config, "--out", out)
    assert "config.toml: landable must be land classes: 'watr' is none of unknown, grass" in told


def table(path: Path, *points: str) -> Path:
    path.write_text("# x,y,z\n" + "\n".join(points) + "\n")
    return path


@pytest.mark.parametrize(
    ("points", "words"),
    [
        (("70,65,30", "200,65,30"), ("collided", "why: the true world was touched")),
        (("20,20,30", "75,65,30"), ("nothing reached", "all waypoints were dropped")),
        (("20,20,30", "240,20,30"), ("timed out", "no more time")),
    ],
)
def test_a_flight_that_fails_exits_with_1_and_says_why(
    world: str, tmp_path: Path, points: tuple[str, ...], words: tuple[str, ...]
) -> None:
    config = tmp_path / "config.toml"
    config.write_text("time_limit_factor = 0.9\n" if words[0] == "timed out" else "")
    waypoints = table(tmp_path / "points.csv", *points)
    options = ("--waypoints", waypoints, "--config", config, "--no-recording", "--out", tmp_path)
    result = run("fly", world, *options)
    assert result.exit_code == 1
    said = " ".join(result.output.split())
    assert all(word in said for word in words), said
    assert FlightRecord.load(tmp_path / "flight.npz").reason in said


def test_the_summary_tells_what_was_too_far_and_what_the_map_lost(
    world: str, tmp_path: Path
) -> None:
    config = tmp_path / "config.toml"
    config.write_text(
        "[navigation]\nmax_detour = 1.0\n[mapping]\ndims = [12, 12, 20]\nremember = false\n"
    )
    waypoints = table(tmp_path / "points.csv", "20,65,30", "40,65,30", "130,65,30")
    options = ("--waypoints", waypoints, "--config", config, "--no-recording", "--out", tmp_path)
    result = run("fly", world, *options)
    assert result.exit_code == 0, result.output
    said = " ".join(result.stdout.split())
    assert "waypoints: 1 reached (within 2." in said and " m), 1 too far" in said
    assert "waypoint 2 skipped at" in said
    assert "ltp: map: " in result.stderr and "outside the map's window" in result.stderr
    record = FlightRecord.load(tmp_path / "flight.npz")
    assert record.map_losses and record.map_totals["outside"] > 0


def test_a_start_too_low_is_a_mistake_that_names_the_least_altitude(
    world: str, tmp_path: Path
) -> None:
    waypoints = table(tmp_path / "points.csv", "20,20,2", "60,20,2")
    options = ("--climb", 0, "--no-recording", "--out", tmp_path)
    said = fail("fly", world, "--waypoints", waypoints, *options)
    assert "start's altitude is 2 m" in said
    assert "at least 4 m" in said


def test_a_flight_leaves_a_map_and_another_begins_with_it(world: str, tmp_path: Path) -> None:
    short = [*SHORT, "--out", tmp_path / "out"]
    said = succeed("fly", world, *short, "--save-map", tmp_path / "seen.ot")
    assert "seen.ot" in said
    record = FlightRecord.load(tmp_path / "out" / "flight.npz")
    succeed("fly", world, *short, "--known-map", tmp_path / "seen.ot")
    again = FlightRecord.load(tmp_path / "out" / "flight.npz")
    assert len(again.plans) < len(record.plans)
    said = fail("fly", world, *short, "--known-map", tmp_path / "seen.ot", "--preset", "low")
    assert "resolution = 2" in said
    assert "--save-map must end in .bt or .ot" in fail("fly", world, "--save-map", "seen.txt")


def test_a_low_flight_is_told_of_finer_cells(world: str, tmp_path: Path) -> None:
    low = [*SHORT, "--altitude", "10", "--out", tmp_path / "out"]
    said = run("fly", world, *low).output.replace("\n", " ")
    assert "cells are 4 m high: --preset low" in said
    record = FlightRecord.load(tmp_path / "out" / "flight.npz")
    run("fly", world, *low, "--preset", "low")
    fine = FlightRecord.load(tmp_path / "out" / "flight.npz")
    assert record.config.mapping.cell[2] == 4.0
    assert fine.config.mapping.cell[2] == 1.0
    assert "--preset = 'high'" in fail("fly", world, *SHORT, "--preset", "high")
