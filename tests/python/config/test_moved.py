# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The settings that have moved: old names are understood, and say the new ones."""

import warnings

import pytest

from ltp._core import BezierOptions
from ltp.config import MissionConfig
from ltp.config.moved import MOVED, with_new_names


def value_at(config: MissionConfig, key: str) -> object:
    value: object = config
    for name in key.split("."):
        value = getattr(value, name)
    return value


OLD_VALUES = {
    "length_weight": 0.25,
    "priority_weight": 2.0,
    "scaled_heuristic": True,
    "max_expansions": 7,
    "refine": True,
}


@pytest.mark.parametrize("old", OLD_VALUES)
def test_an_old_name_is_understood_and_says_the_new_one(old: str) -> None:
    new, value = MOVED[old], OLD_VALUES[old]
    says = rf"{old}.*{new}"
    with pytest.warns(DeprecationWarning, match=says) as caught:
        config = MissionConfig(**{old: value})
    assert value_at(config, new) == value
    with pytest.warns(DeprecationWarning, match=says) as read:
        assert getattr(config, old) == value
    config = MissionConfig()
    with pytest.warns(DeprecationWarning, match=says) as written:
        setattr(config, old, value)
    assert value_at(config, new) == value
    with pytest.warns(DeprecationWarning, match=says) as loaded:
        assert MissionConfig.from_dict({old: value}).to_dict() == config.to_dict()
    each = [*caught, *read, *written, *loaded]
    assert [warning.filename for warning in each] == [__file__] * 4


OLD_TABLES = {
    "bezier": ("offsets", 21),
    "linearised": ("alpha", 1.5),
    "pareto": ("eps", 0.5),
    "ara": ("step", 0.25),
    "risk": ("length_factor", 0.5),
    "bug": ("range", 7.0),
    "hermite": ("starts", 7),
}


def test_every_old_name_leads_to_a_setting() -> None:
    assert OLD_VALUES.keys() | OLD_TABLES.keys() == MOVED.keys()
    for new in MOVED.values():
        value_at(MissionConfig(), new)


def test_an_old_file_is_understood(tmp_path) -> None:
    path = tmp_path / "old.toml"
    tables = [f"[{table}]\n{key} = {value}\n" for table, (key, value) in OLD_TABLES.items()]
    path.write_text("planner = 'bezier'\nlength_weight = 0.25\nrefine = true\n" + "".join(tables))
    with pytest.warns(DeprecationWarning) as caught:
        config = MissionConfig.load(path)
    assert {warning.filename for warning in caught} == {__file__}
    told = " ".join(str(warning.message) for warning in caught)
    assert all(repr(MOVED[name]) in told for name in ["length_weight", "refine", *OLD_TABLES])
    assert (config.planner, config.planner_options.refine) == ("bezier", True)
    assert config.planner_options.weights.length == 0.25
    for table, (key, value) in OLD_TABLES.items():
        assert value_at(config, f"{MOVED[table]}.{key}") == value
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        again = MissionConfig.from_toml(config.to_toml())
    assert again.to_dict() == config.to_dict()


def test_old_options_are_understood_as_keywords_and_attributes() -> None:
    with pytest.warns(DeprecationWarning, match=r"planner_options\.bezier"):
        config = MissionConfig(bezier=BezierOptions(offsets=21))
    assert config.planner_options.bezier.offsets == 21
    with pytest.warns(DeprecationWarning, match=r"planner_options\.bezier"):
        config.bezier.offsets = 11
    assert config.planner_options.bezier.offsets == 11
    with pytest.warns(DeprecationWarning), pytest.raises(ValueError, match="offsets = 4"):
        MissionConfig(bezier=BezierOptions(offsets=4))


def test_a_setting_has_one_name_at_a_time() -> None:
    both = {"length_weight": 0.5, "planner_options": {"weights": {"length": 0.5}}}
    with pytest.raises(ValueError, match=r"length_weight.*weights\.length"):
        with_new_names(both)
    with pytest.raises(ValueError, match="planner_options = 3: expected a table"):
        with_new_names({"length_weight": 0.5, "planner_options": 3})
    with pytest.raises(AttributeError, match="lenght_weight"):
        MissionConfig().lenght_weight  # noqa: B018


def test_old_and_new_names_meet_in_one_table_and_leave_the_values_alone() -> None:
    values = {"length_weight": 0.25, "planner_options": {"weights": {"priority": 2.0}}}
    assert with_new_names(values) == {
        "planner_options": {"weights": {"length": 0.25, "priority": 2.0}}
    }
    assert values == {"length_weight": 0.25, "planner_options": {"weights": {"priority": 2.0}}}


def test_a_setting_without_effect_is_passed_over() -> None:
    assert with_new_names({"navigation": {"memory_widths": 3, "reach_distance": 1.0}}) == {
        "navigation": {"reach_distance": 1.0}
    }
    config = MissionConfig.from_toml("[navigation]\nmemory_widths = 1\n")
    assert config.to_dict() == MissionConfig().to_dict()
    with pytest.warns(DeprecationWarning, match="memory_widths"):
        config.navigation.memory_widths = 1
