# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp fly`: what it writes, and where its settings and waypoints come from."""

from pathlib import Path

import pytest

from ltp.config import MissionConfig
from ltp.sim.record import FlightRecord

from .runner import SHORT, fail, succeed


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
