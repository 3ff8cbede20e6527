# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mission's settings: in and out of TOML, and what is refused."""

import copy
import dataclasses
import errno
import math
import os
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from ltp._core import LidarOptions, PlannerOptions, RiskOptions
from ltp.config import MissionConfig, VehicleOptions
from ltp.world import LandClass, LandingLimits

ROOT = Path(__file__).parents[3]


def test_defaults_are_the_papers() -> None:
    config = MissionConfig()
    assert config.lidar.max_range == 50.0
    assert list(config.mapping.dims) == [200, 200, 40]
    assert list(config.mapping.cell) == [2.0, 2.0, 4.0]
    assert config.vehicle.speed == 3.0
    assert config.fov_deg == 53.0
    weights = config.planner_options.weights
    assert weights.priority / weights.length == 2.0


def test_toml_round_trip_keeps_every_setting() -> None:
    config = MissionConfig(planner="ggwp", priority_map="lpf")
    config.planner_options.weights.length = 0.25
    config.vehicle = VehicleOptions(speed=5.0)
    config.lidar.pattern.rows = 16
    config.lidar.drop_out = 0.125
    config.planner_options.refine = True
    config.mapping.inflation_radius = 2.5
    config.mapping.dims = [100, 120, 20]
    config.navigation.band = (4.0, math.inf)
    config.planner_options.bezier.offsets = 21
    again = MissionConfig.from_toml(config.to_toml())
    assert again.to_dict() == config.to_dict()
    assert again.to_dict() != MissionConfig().to_dict()
    assert again.navigation.band == (4.0, math.inf)


def test_the_file_is_readable(tmp_path) -> None:
    path = tmp_path / "mission.toml"
    MissionConfig().save(path)
    text = path.read_text()
    for table in ("lidar.pattern", "planner_options", "planner_options.weights"):
        assert f"[{table}]" in text
    assert MissionConfig.load(path).to_dict() == MissionConfig().to_dict()


def test_a_file_that_cannot_be_written_leaves_the_old_one(tmp_path, monkeypatch) -> None:
    path = tmp_path / "mission.toml"
    MissionConfig(planner="ggwp").save(path)

    def full(descriptor: int) -> None:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC))

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(OSError, match=r"mission\.toml"):
        MissionConfig().save(path)
    assert MissionConfig.load(path).planner == "ggwp"
    assert [file.name for file in tmp_path.iterdir()] == ["mission.toml"]


@pytest.mark.parametrize(
    ("text", "culprit"),
    [
        ("plannner = 'ggwp'", "plannner"),
        ("[lidar]\nrange = 3", "lidar.range"),
        ("[lidar.pattern]\nrow = 3", "lidar.pattern.row"),
        ("[vehicle]\nspeeed = 3", "vehicle.speeed"),
        ("[vehicle]\nspeed = -3", "vehicle.speed"),
        ("[vehicle]\nspeed = 'fast'", "vehicle.speed"),
        ("lidar = 3", "lidar"),
        ("[planner_options.weights]\nlength = -1", "weights.length"),
        ("[planner_options.weights]\nlength = nan", "weights.length"),
        ("[planner_options.weights]\nlength = 0.0\npriority = 0.0", "weights.length"),
        ("[planner_options.weights]\nlength = 'much'", "planner_options.weights.length"),
        ("[planner_options.weights]\nlenght = 1", "planner_options.weights.lenght"),
        ("[planner_options]\nweights = 1", "planner_options.weights"),
        ("planner_options = 1", "planner_options"),
        ("step = 0.0", "step"),
        ("planner = 'astar'", "lp-a-star"),
        ("priority_map = 'red'", "priority_map"),
        ("[planner_options.bezier]\noffsets = 40", "bezier.offsets"),
        ("[planner_options.bezier]\noffsets = 'x'", "bezier.offsets"),
        ("[planner_options]\nscaled_heuristic = 3", "scaled_heuristic"),
        ("[mapping]\ninflation_radius = nan", "inflation_radius"),
        ("[lidar]\nmax_range = -1", "max_range"),
        ("[navigation]\nband = [-1, 0]", "band"),
        ("[navigation]\nband = 3", "navigation.band = 3: expected 2 numbers"),
        ("[navigation]\nband = [0]", r"navigation.band = \[0\]: expected 2 numbers"),
        ("[mapping]\ndims = [1.5, 2, 3]", "mapping.dims = .*: expected 3 whole numbers"),
        ("[mapping]\ncell = [1.0, 2.0]", "mapping.cell = .*: expected 3 numbers"),
        ("[lidar]\nseed = -1", "lidar.seed = -1: expected a whole number in its range"),
        ("planner = 3", "planner = 3: expected a text"),
        ("landable = 'grass'", "landable must be one of strict, wide"),
        ("landable = 'Strict'", "landable must be one of strict, wide"),
        ("landable = ['gras']", "landable must be land classes: 'gras' is none of unknown, grass"),
        ("landable = ['grass', 'trees']", "landable must not contain TREES"),
        ("landable = ['strict']", "landable must be land classes: 'strict'"),
        ("landable = [1.5]", "landable must be land classes: 1.5"),
        ("landable = [['grass']]", "landable must be land classes: .'grass'."),
        ("landable = 3", "landable"),
        ("landable = true", "landable"),
        ("landing = 3", "landing = 3: expected a table"),
        ("[landing]\nslope = 3", "landing.slope.*expected one of max_slope"),
        ("[landing]\nmax_slope = 91", "landing.max_slope must lie in"),
        ("[landing]\nmax_slope = true", "landing.max_slope must be a finite number"),
        ("[landing]\nmax_slope = 'flat'", "landing.max_slope must be a finite number"),
        ("[landing]\nmax_roughness = nan", "landing.max_roughness must be a finite number"),
        ("[landing]\ngear_radius = 0", "landing.gear_radius must be above zero"),
        ("[landing]\nclearance = -1", "landing.clearance must not be negative"),
        ("step = ", "TOML"),
    ],
)
def test_mistakes_are_named(text: str, culprit: str) -> None:
    with pytest.raises(ValueError, match=culprit):
        MissionConfig.from_toml(text)


@pytest.mark.parametrize(
    "name",
    [
        "planner",
        "planner_options",
        "landing",
        "vehicle",
        "guidance",
        "lidar",
        "mapping",
        "navigation",
    ],
)
def test_a_part_of_another_kind_is_refused_by_name(name: str) -> None:
    for wrong in (3, None, {}, "x" if name != "planner" else 1.0, RiskOptions()):
        with pytest.raises(ValueError, match=f"{name} = .*: expected ") as caught:
            MissionConfig(**{name: wrong})
        assert "\n" not in str(caught.value)
        config = MissionConfig()
        setattr(config, name, wrong)
        with pytest.raises(ValueError, match=f"{name} = .*: expected "):
            config.check()


def test_a_byte_order_mark_is_no_part_of_a_file(tmp_path) -> None:
    path = tmp_path / "mission.toml"
    path.write_text("planner = 'ggwp'", encoding="utf-8-sig")
    assert MissionConfig.load(path).planner == "ggwp"


def test_errors_in_a_file_name_the_file(tmp_path) -> None:
    path = tmp_path / "mission.toml"
    path.write_text("plannner = 1")
    with pytest.raises(ValueError, match=r"mission\.toml.*plannner"):
        MissionConfig.load(path)


def test_the_planners_options_are_the_cores_own_object() -> None:
    config = MissionConfig()
    assert type(config.planner_options) is PlannerOptions
    assert list(config.to_dict()["planner_options"]) == list(PlannerOptions.__fields__)


def test_checking_makes_no_planner(monkeypatch: pytest.MonkeyPatch) -> None:
    config = MissionConfig()

    def refuse(*_: object) -> None:
        raise AssertionError("a planner was made")

    monkeypatch.setattr("ltp._core.Planner", refuse)
    monkeypatch.setattr("ltp.registry.Planner", refuse)
    config.check()
    config.planner_options.weights.length = -1.0
    with pytest.raises(ValueError, match=r"weights\.length = -1"):
        config.check()
    config.planner_options.weights.length, config.planner = 0.5, "astar"
    with pytest.raises(ValueError, match=r"planner = 'astar': expected one of lp-dijkstra"):
        config.check()


OPTIONS = ["planner_options", "lidar", "mapping", "navigation"]


@pytest.mark.parametrize(
    "copied",
    [copy.copy, copy.deepcopy, dataclasses.replace, lambda c: MissionConfig(**vars(c))],
    ids=["copy", "deepcopy", "replace", "keywords"],
)
def test_no_two_configurations_share_options(copied: Callable) -> None:
    first = MissionConfig()
    second = copied(first)
    for name in OPTIONS:
        assert getattr(first, name) is not getattr(second, name)
    second.planner_options.weights.length = 0.25
    second.planner_options.bezier.offsets = 5
    second.lidar.pattern.rows = 3
    second.mapping.dims = [10, 10, 10]
    second.navigation.leave_distance = 9.0
    assert first.to_dict() == MissionConfig().to_dict()
    assert all(second.to_dict()[name] != first.to_dict()[name] for name in OPTIONS)


def test_options_that_are_given_are_copied() -> None:
    options, lidar = PlannerOptions(), LidarOptions()
    config = MissionConfig(planner_options=options)
    config.lidar = lidar
    options.refine, lidar.max_range = True, 7.0
    assert not config.planner_options.refine
    assert config.lidar.max_range == 50.0
    config.lidar.max_range = 9.0  # in place
    assert config.lidar.max_range == 9.0


def test_the_settings_of_the_docs_are_current() -> None:
    files = sorted((ROOT / "docs").glob("*.toml"))
    assert files
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for file in files:
            MissionConfig.load(file)


@pytest.mark.parametrize(
    "landable",
    [["grass", "ground"], ("GROUND", "Grass"), {LandClass.GROUND, LandClass.GRASS}, [14, 1, 1]],
)
def test_what_may_be_landed_on_is_a_list_of_classes_too(landable: Any) -> None:
    config = MissionConfig(landable=landable)
    assert config.landable == ("grass", "ground")
    assert config.to_dict()["landable"] == ["grass", "ground"]
    assert MissionConfig.from_toml(config.to_toml()).landable == ("grass", "ground")
    assert MissionConfig.from_dict(config.to_dict()).landable == ("grass", "ground")
    assert MissionConfig.from_toml("landable = ['water']").landable == ("water",)
    assert MissionConfig.from_toml("landable = 'strict'").landable == "strict"


def test_the_landing_limits_are_a_table() -> None:
    config = MissionConfig.from_toml("[landing]\nmax_slope = 4\ngear_radius = 0.5")
    assert config.landing == LandingLimits(max_slope=4.0, gear_radius=0.5)
    assert MissionConfig.from_toml(config.to_toml()).landing == config.landing
    assert MissionConfig().landing == LandingLimits()
    with pytest.raises(ValueError, match="landing = 3: expected LandingLimits"):
        MissionConfig(landing=3)  # type: ignore[arg-type]


def test_every_setting_is_written_with_what_it_means_and_reads_back() -> None:
    config = MissionConfig(planner="ggwp", landable=["grass"])
    lines = config.to_toml().splitlines()
    settings = [line for line in lines if line]
    assert len(settings) > 70
    for line in settings:
        key, _, meaning = line.partition("  # ")
        assert len(meaning) > 5, key
        if "deg" in key.partition("=")[0] or "slope" in key:
            assert "[deg]" in meaning
    text = config.to_toml()
    for unit in ("[m/s]", "[m/s^2]", "[m]", "[s]", "[deg]", "[MB]"):
        assert unit in text
    assert MissionConfig.from_toml(text).to_dict() == config.to_dict()
    assert MissionConfig.from_toml(text).to_toml() == text
