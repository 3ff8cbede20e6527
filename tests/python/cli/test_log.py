# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`ltp --version` and `ltp --log FILE`: what is logged, by whom, and that it ends."""

import logging
import re
from pathlib import Path

import pytest

import ltp
from ltp.config import MissionConfig
from ltp.sim import fly
from ltp.world import World

from .runner import SHORT, fail, run, succeed

LINE = re.compile(
    r"\d{4}-\d\d-\d\d \d\d:\d\d:\d\d,\d{3} (?P<level>INFO|ERROR) (?P<name>ltp[\w.]*): (?P<text>.+)"
)


def entries(path: Path) -> list[tuple[str, str]]:
    """Logger and text of each line that begins an entry."""
    found = map(LINE.fullmatch, path.read_text("utf-8").splitlines())
    return [(match["name"], match["text"]) for match in found if match]


def test_the_version_is_told_with_and_without_a_command() -> None:
    assert succeed("--version").strip() == succeed("version").strip() == ltp.__version__


def test_a_flight_and_its_decisions_are_logged(tmp_path: Path, world: str) -> None:
    log = tmp_path / "ltp.log"
    succeed("--log", log, "fly", world, *SHORT, "--no-recording", "--out", tmp_path / "out")
    said = entries(log)
    assert said[0][0] == "ltp.cli.log" and ltp.__version__ in said[0][1]
    decisions = [text for name, text in said if name == "ltp.sim.decisions"]
    assert re.match(r"auto over town: \d+ waypoints, at most \d+ s", decisions[0])
    assert any("waypoint" in text and re.search("reached|dropped", text) for text in decisions)
    assert decisions[-1].startswith("FlightRecord(auto over 'town'")
    assert logging.getLogger("ltp").handlers == []  # it has ended
    before = log.read_bytes()
    succeed("version")
    assert log.read_bytes() == before
    succeed("--log", log, "version")  # goes on with the file
    assert log.read_bytes().startswith(before) and len(log.read_bytes()) > len(before)


def test_a_campaign_logs_its_progress(tmp_path: Path, world: str) -> None:
    log = tmp_path / "ltp.log"
    command = [
        "evaluate",
        world,
        *SHORT,
        "--paths",
        "2",
        "--ratios",
        "2",
        "--out",
        tmp_path / "out",
    ]
    succeed("--log", log, *command, "--planners", "lp-dijkstra", "--processes", "1")
    said = [text for name, text in entries(log) if name.startswith("ltp.evaluation")]
    assert re.search(r"\d+ flights to fly, 0 flown before, in 1 processes", said[0])
    assert sum("flight 1: FlightRow(" in text for text in said) == 1
    assert all(len(text) < 4000 for text in said)


def test_a_mistake_is_logged_with_its_traceback(tmp_path: Path) -> None:
    log = tmp_path / "ltp.log"
    fail("--log", log, "world", "show", tmp_path / "nowhere.npz")
    text = log.read_text("utf-8")
    assert "ERROR ltp.cli.log: " in text and "nowhere.npz" in text
    assert "Traceback (most recent call last)" in text


def test_a_log_that_cannot_be_written_is_told() -> None:
    assert "nowhere" in fail("--log", "/nowhere/at/all.log", "version")
    assert run("--log").exit_code == 2


def test_an_import_logs_what_it_found(
    tmp_path: Path, caplog: pytest.LogCaptureFixture, monkeypatch: pytest.MonkeyPatch
) -> None:
    from ltp.world.importers.log import logged

    def read(path: Path, *, cell: float) -> World:
        import numpy as np

        values = np.zeros((3, 4))
        kinds = np.zeros((3, 4), np.uint8)
        return World("made", values, values, kinds, cell, report=("2 lakes were read",))

    read.__module__ = "ltp.world.importers.made"
    with caplog.at_level(logging.INFO, logger="ltp"):
        logged(read)(tmp_path / "a.tif", cell=2.0)
    assert [record.name for record in caplog.records] == ["ltp.world.importers.made"] * 3
    assert "a.tif, cell=2.0" in caplog.messages[0]
    assert "World('made', 3 x 4 cells" in caplog.messages[1]
    assert caplog.messages[2] == "2 lakes were read"


def test_a_program_of_ones_own_listens_by_name(caplog: pytest.LogCaptureFixture) -> None:
    from tests.python.scenes import town

    path = [[20.0, 20.0, 30.0], [40.0, 20.0, 30.0]]
    with caplog.at_level(logging.INFO, logger="ltp.sim"):
        fly(town(), MissionConfig(), path)
    assert {record.name for record in caplog.records} == {"ltp.sim.decisions"}
    caplog.clear()
    fly(town(), MissionConfig(), path)
    assert caplog.records == []
