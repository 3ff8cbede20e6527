# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Regret of real flights: none where nothing is to be known, some where walls are seen late."""

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

from ltp.config import MissionConfig
from ltp.evaluation.campaign import Campaign, run_campaign
from ltp.evaluation.campaign.variants import at_ratio
from ltp.evaluation.regret import (
    TABLE,
    RegretJudge,
    RegretRow,
    gates_of,
    read_regrets,
    run_regret,
)
from ltp.evaluation.regret.gating import asked_gates
from ltp.evaluation.regret.tables import markdown_regrets, summarise_regrets
from ltp.evaluation.scenarios import Scenario
from ltp.evaluation.served import served_radius
from ltp.sim import MissionSetup
from ltp.world import World
from tests.python.scenes import box_world, regret_row

AUTO = at_ratio(2.0, "auto")
STRAIGHT = np.array([[21.0, 81.0, 30.0], [61.0, 81.0, 30.0], [101.0, 81.0, 30.0]])


def flown(world: World, path: np.ndarray, folder: Path):
    """One flight along a global path, its record kept."""
    campaign = Campaign(world, [AUTO], [Scenario(0, 1, path, False)], MissionConfig())
    return run_campaign(campaign, folder, keep_records=True)


def test_a_straight_flight_over_empty_ground_has_no_regret(tmp_path: Path) -> None:
    world = box_world([])
    flights = flown(world, STRAIGHT, tmp_path)
    assert flights[0].path_distance_max == pytest.approx(0.0, abs=1e-9)
    (row,) = run_regret(world, flights, tmp_path)
    assert (row.served, row.waypoints, row.flown_priority) == (2, 2, 1.0)
    assert row.gate == row.last_gate == served_radius(MissionConfig()) == pytest.approx(2 * 2**0.5)
    # Both end where the last waypoint is served: the flight anywhere, routes amid a cell.
    one_cell = 0.5 * 2.0 / 80.0
    for ideal in (row.legs, row.joint):
        assert ideal is not None and abs(row.flown - ideal) < one_cell


def test_gates_are_those_that_were_flown() -> None:
    world, path = box_world([]), STRAIGHT
    reach = served_radius(MissionConfig())
    half = math.tan(math.radians(53.0 / 2))
    for gate, first in {"point": reach, "camera": 30.0 * half, 12.0: 12.0, 1.0: reach}.items():
        setup = MissionSetup.of(world, MissionConfig(gate=gate), path)
        np.testing.assert_allclose(gates_of(setup), [first, reach])
    config = MissionConfig()
    config.navigation.gate_radius = 9.0
    np.testing.assert_allclose(gates_of(MissionSetup.of(world, config, path)), [9.0, reach])


def test_what_is_seen_late_is_regretted_and_gates_serve_more(tmp_path: Path) -> None:
    # A wall across the way with a yard before it that opens to the UAV: it is flown into.
    walls = [(110, 116, 40, 124), (80, 116, 40, 46), (80, 116, 118, 124)]
    world = box_world(walls)
    path = np.array([[21.0, 81.0, 30.0], [161.0, 81.0, 30.0]])
    (row,) = run_regret(world, flown(world, path, tmp_path), tmp_path)
    assert row.joint is not None and row.legs is not None and row.joint_bound is not None
    assert row.joint_bound <= row.joint <= row.legs < row.flown - 0.05
    (wide,) = run_regret(world, flown(world, path, tmp_path), tmp_path, gate=25.0)
    assert (wide.gate, wide.last_gate) == (25.0, row.last_gate)
    assert wide.joint == pytest.approx(row.joint)  # its only waypoint is the last


def test_it_goes_on_where_it_was(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    world = box_world([])
    flights = flown(world, STRAIGHT, tmp_path)
    told = []

    class Observer:
        def on_start(self, total: int, done: int) -> None:
            told.append((total, done))

        def on_regret(self, row: RegretRow) -> None:
            told.append(row.key)

        def on_end(self) -> None:
            told.append("end")

    rows = run_regret(world, flights, tmp_path, observers=[Observer()])
    assert read_regrets(tmp_path / TABLE) == rows
    monkeypatch.setattr(RegretJudge, "row", None)  # judged again it would fail
    assert run_regret(world, flights, tmp_path, observers=[Observer()]) == rows
    assert told == [(1, 0), rows[0].key, "end", (1, 1), "end"]
    with pytest.raises(ValueError, match=r"gate must be a radius >= 0 \[m\], not -1"):
        run_regret(world, flights, tmp_path, gate=-1.0)
    lost = dataclasses.replace(flights[0], key="lost")
    with pytest.raises(OSError, match="lost"):
        run_regret(world, [lost], tmp_path)


def test_rows_are_gathered_by_what_was_asked_not_by_metres() -> None:
    camera = {"gates": "camera", "flown_gates": "camera"}
    rows = [regret_row(scenario=i, gate=25.0 + i, **camera) for i in range(3)]
    rows += [regret_row(scenario=i, gate=25.0 + i, horizon=3, **camera) for i in range(3)]
    rows += [regret_row(gates="10", flown_gates="camera", gate=10.0)]
    rows += [regret_row(gates="25", flown_gates="25", gate=gate) for gate in (25.0, 2.8)]
    summaries = summarise_regrets(rows)
    assert [summary.flights for summary in summaries] == [3, 3, 1, 2]
    assert [summary.gating.title for summary in summaries] == [
        "camera gates",
        "camera gates, horizon 3",
        "gates of 10 m, flown with camera gates",
        "gates of 25 m",
    ]
    # Of files that do not say what was asked, the radius is all there is.
    (old,) = summarise_regrets([regret_row(gates="", flown_gates="", gate=2.828)])
    assert old.gating.title == "gates of 2.828 m"


def test_what_a_configuration_asks_for() -> None:
    asked = {"point": "point", "camera": "camera", 25.0: "25", 12: "12"}
    for gate, text in asked.items():
        assert asked_gates(MissionConfig(gate=gate)) == text
    config = MissionConfig()
    config.navigation.gate_radius = 9.5
    assert asked_gates(config) == "9.5"
    config.navigation.reach_distance = 25.0
    assert asked_gates(config) == "25"


def test_camera_gates_over_hills_are_one_line(tmp_path: Path) -> None:
    world = box_world([])
    scenarios = [Scenario(i, 1, STRAIGHT + np.array([0.0, 0.0, 20.0 * i]), False) for i in range(2)]
    campaign = Campaign(world, [AUTO], scenarios, MissionConfig(gate="camera"))
    flights = run_campaign(campaign, tmp_path, keep_records=True)
    rows = run_regret(world, flights, tmp_path)
    assert rows[0].gate < rows[1].gate  # half the footprint follows the altitude
    assert read_regrets(tmp_path / TABLE) == rows
    (summary,) = summarise_regrets(rows)
    assert (summary.flights, summary.gating.title) == (2, "camera gates")
    (wide,) = summarise_regrets(run_regret(world, flights, tmp_path, gate=10.0))
    assert wide.gating.title == "gates of 10 m, flown with camera gates"


def test_means_are_over_flights_that_ended_and_can_be_compared() -> None:
    rows = [
        regret_row(),
        regret_row(scenario=1, flown=0.2),
        regret_row(scenario=2, outcome="timed_out"),
    ]
    rows += [regret_row(scenario=3, legs=None, joint=None), regret_row(planner="sweep")]
    first, second = summarise_regrets(rows)
    assert (first.flights, first.counted, second.counted) == (4, 2, 1)
    assert first.over_legs.mean == pytest.approx(0.15)
    assert first.over_joint.mean == pytest.approx(0.25)
    assert (first.flown_length, first.joint_length) == (1.2, 1.1)
    assert math.isnan(second.over_joint.low)
    text = markdown_regrets(rows)
    assert "## Binary priority map, W_P/W_L = 2, exact waypoints" in text
    assert "| Auto | 2/4 | +0.150 | +0.000 | +0.150 [" in text
    assert {line.count("|") for line in text.splitlines()} - {0} == {11}
    none = regret_row(legs=None, joint=None)
    assert "| 0/1 | – | – | – | – | – | – |" in markdown_regrets([none])
    with pytest.raises(ValueError, match="several worlds"):
        summarise_regrets([*rows, regret_row(world="elsewhere")])
