# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The mission's settings: in and out of TOML, and what is refused."""

import math

import pytest

from ltp.config import MissionConfig, VehicleOptions


def test_defaults_are_the_papers() -> None:
    config = MissionConfig()
    assert config.lidar.max_range == 50.0
    assert list(config.mapping.dims) == [200, 200, 40]
    assert list(config.mapping.cell) == [2.0, 2.0, 4.0]
    assert config.vehicle.speed == 3.0
    assert config.fov_deg == 53.0
    assert config.priority_weight / config.length_weight == 2.0


def test_toml_round_trip_keeps_every_setting() -> None:
    config = MissionConfig(planner="ggwp", priority_map="lpf", length_weight=0.25)
    config.vehicle = VehicleOptions(speed=5.0)
    config.lidar.pattern.rows = 16
    config.lidar.drop_out = 0.125
    config.refine = True
    config.mapping.inflation_radius = 2.5
    config.mapping.dims = [100, 120, 20]
    config.navigation.band = (4.0, math.inf)
    config.bezier.offsets = 21
    again = MissionConfig.from_toml(config.to_toml())
    assert again.to_dict() == config.to_dict()
    assert again.to_dict() != MissionConfig().to_dict()
    assert again.navigation.band == (4.0, math.inf)


def test_the_file_is_readable(tmp_path) -> None:
    path = tmp_path / "mission.toml"
    MissionConfig().save(path)
    assert "[lidar.pattern]" in path.read_text()
    assert MissionConfig.load(path).to_dict() == MissionConfig().to_dict()


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
        ("length_weight = -1", "length_weight"),
        ("length_weight = nan", "length_weight"),
        ("length_weight = 0.0\npriority_weight = 0.0", "length_weight"),
        ("length_weight = 'much'", "length_weight"),
        ("step = 0.0", "step"),
        ("planner = 'astar'", "lp-a-star"),
        ("priority_map = 'red'", "priority_map"),
        ("[bezier]\noffsets = 40", "bezier.offsets"),
        ("[bezier]\noffsets = 'x'", "bezier.offsets"),
        ("scaled_heuristic = 3", "scaled_heuristic"),
        ("[mapping]\ninflation_radius = nan", "inflation_radius"),
        ("[lidar]\nmax_range = -1", "max_range"),
        ("[navigation]\nband = [-1, 0]", "band"),
        ("[navigation]\nband = 3", "band"),
        ("step = ", "TOML"),
    ],
)
def test_mistakes_are_named(text: str, culprit: str) -> None:
    with pytest.raises(ValueError, match=culprit):
        MissionConfig.from_toml(text)


def test_errors_in_a_file_name_the_file(tmp_path) -> None:
    path = tmp_path / "mission.toml"
    path.write_text("plannner = 1")
    with pytest.raises(ValueError, match=r"mission\.toml.*plannner"):
        MissionConfig.load(path)
