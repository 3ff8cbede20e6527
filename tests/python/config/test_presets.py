# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Presets: what they set, and which of them a height asks for."""

import math

import pytest

from ltp.config import PRESETS, MissionConfig, finer_preset


def test_a_preset_sets_map_and_climb_and_nothing_else() -> None:
    for name in PRESETS:
        config = MissionConfig.preset(name)
        assert config.navigation.climb == (20.0 if name == "fly" else 0.0)
        config.mapping, config.navigation.climb = MissionConfig().mapping, 0.0
        assert config.to_dict() == MissionConfig().to_dict()
    assert list(MissionConfig.preset("low").mapping.cell) == [1.0, 1.0, 1.0]
    landing = MissionConfig.preset("landing").mapping
    assert [n * edge for n, edge in zip(landing.dims, landing.cell, strict=True)] == [60.0] * 3


def test_the_papers_map_inflates_cells_and_forgets() -> None:
    paper = MissionConfig.preset("paper").mapping
    assert paper.inflate_whole_cells and not paper.remember
    assert not MissionConfig().mapping.inflate_whole_cells and MissionConfig().mapping.remember


def test_what_is_set_already_keeps_its_value() -> None:
    config = MissionConfig(planner="ggwp")
    config.mapping.margin = 0.5
    config.navigation.climb = 7.0
    config.use_preset("low")
    assert config.navigation.climb == 7.0
    config.use_preset("paper")
    assert config.navigation.climb == 0.0
    assert config.planner == "ggwp" and config.mapping.margin == 0.5
    with pytest.raises(ValueError, match=r"'high': expected one of paper, fly, low, landing"):
        config.use_preset("high")


@pytest.mark.parametrize(
    ("height", "cell_height", "preset"),
    [
        (50.0, 4.0, None),
        (12.0, 4.0, None),
        (8.0, 4.0, "low"),
        (2.0, 4.0, "landing"),
        (8.0, 1.0, None),
        (2.0, 1.0, "landing"),
        (0.5, 4.0, "landing"),
        (0.5, 0.5, None),
        (math.inf, 4.0, None),
    ],
)
def test_low_flight_asks_for_fine_cells(
    height: float, cell_height: float, preset: str | None
) -> None:
    assert finer_preset(height, cell_height) == preset
