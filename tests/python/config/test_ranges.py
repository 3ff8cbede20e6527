# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every number among the settings has a range; what lies outside is refused by name at once."""

import functools
import math
from typing import Any

import pytest

from ltp._core import LidarOptions, NavigationOptions, ObstacleMapOptions, PlannerOptions
from ltp.config import MissionConfig, VehicleOptions
from ltp.config.ranges import ANY, RANGES, numbers


def nested(key: str, value: Any) -> dict[str, Any]:
    """The settings with one of them given."""
    return functools.reduce(lambda inner, name: {name: inner}, reversed(key.split(".")), value)


def given(key: str, current: Any, value: Any) -> dict[str, Any]:
    return nested(key, [value, *current[1:]] if isinstance(current, list) else value)


DEFAULTS = {key: value for key, value, _ in numbers(MissionConfig())}


def test_every_row_is_a_setting_and_the_defaults_are_within() -> None:
    assert RANGES.keys() <= DEFAULTS.keys()
    assert len(RANGES) > 40
    for key, value in DEFAULTS.items():
        for number in value if isinstance(value, list) else [value]:
            assert number in RANGES.get(key, ANY), key


@pytest.mark.parametrize("key", sorted(DEFAULTS))
def test_what_is_no_number_or_beyond_the_range_is_refused_by_name(key: str) -> None:
    current = DEFAULTS[key]
    allowed = RANGES.get(key, ANY)
    bad: list[Any] = [True, False, "3", math.nan, [], {}, "inf", None, 10**400, -(10**400)]
    bad += [math.nextafter(allowed.most, math.inf) if allowed.most < 1e9 else 1e300, -1e300]
    bad += [] if allowed.infinite else [math.inf]
    for value in [*bad, -math.inf]:
        with pytest.raises(ValueError, match=key.rpartition(".")[2]) as caught:
            MissionConfig.from_dict(given(key, current, value))
        assert len(str(caught.value)) < 1500


@pytest.mark.parametrize(
    ("key", "value"),
    [
        ("fov_deg", 180.0),
        ("fov_deg", 0.0),
        ("fov_deg", 1e-300),
        ("step", 1e-9),
        ("step", 1e9),
        ("hold_limit", 0),
        ("hold_limit", 0.0),
        ("hold_limit", -1.0),
        ("time_limit_factor", 1e12),
        ("vehicle.speed", 1e-300),
        ("vehicle.speed", 1e300),
        ("vehicle.max_climb", 0.0),
        ("planner_options.bezier.offsets", 1_000_001),
        ("planner_options.bezier.z_offsets", 100_001),
        ("planner_options.bezier.reach", 1e300),
        ("planner_options.hermite.starts", 100_001),
        ("planner_options.hermite.iterations", 10**9),
        ("planner_options.linearised.searches", 10**9),
        ("planner_options.exact.memory", 1e-300),
        ("planner_options.tangent_bug.range", 1e300),
        ("mapping.inflation_radius", 1e6),
        ("mapping.inflation_radius", 1e300),
        ("mapping.dims", [10_000, 10_000, 40]),
        ("mapping.cell", [1e-9, 1e-9, 1e-9]),
        ("mapping.max_range", 1e300),
        ("lidar.max_range", 1e-300),
        ("navigation.max_detour", 1e300),
        ("navigation.escape_distance", 1e300),
    ],
)
def test_what_would_hang_or_overflow_a_flight_is_refused(key: str, value: Any) -> None:
    with pytest.raises(ValueError, match=rf"{key} = .*: expected"):
        MissionConfig.from_dict(nested(key, value))


def test_a_radius_of_very_many_cells_is_refused() -> None:
    fine = {"cell": [0.1, 0.1, 0.2], "inflation_radius": 6.4}
    assert MissionConfig.from_dict({"mapping": fine}).mapping.inflation_radius == 6.4
    with pytest.raises(ValueError, match=r"mapping\.inflation_radius = 7.0: .* 64 cells of 0\.1 m"):
        MissionConfig.from_dict({"mapping": fine | {"inflation_radius": 7.0}})


def test_the_message_says_range_and_unit() -> None:
    with pytest.raises(ValueError, match=r"^step = 1e-09: expected a number from 0\.001 to 10 \["):
        MissionConfig(step=1e-9)
    with pytest.raises(ValueError, match=r"^vehicle\.speed = True: expected a number from"):
        VehicleOptions(speed=True)
    with pytest.raises(ValueError, match=r"^hold_limit = nan: expected a number from"):
        MissionConfig(hold_limit=math.nan)


@pytest.mark.parametrize(
    ("text", "near"),
    [
        ("stepp = 0.1", "step"),
        ("[lidar]\nmax_rnage = 3", "max_range"),
        ("[vehicle]\nspead = 3", "speed"),
        ("[planner_options.weights]\nlenght = 1", "length"),
    ],
)
def test_an_unknown_key_names_the_nearest(text: str, near: str) -> None:
    with pytest.raises(ValueError, match=rf"unknown key .*did you mean '{near}'"):
        MissionConfig.from_toml(text)
    with pytest.raises(ValueError, match="unknown key 'colour': expected one of planner, "):
        MissionConfig.from_toml("colour = 3")


@pytest.mark.parametrize(
    ("table", "kind"),
    [
        ("planner_options", PlannerOptions),
        ("lidar", LidarOptions),
        ("mapping", ObstacleMapOptions),
        ("navigation", NavigationOptions),
    ],
)
def test_every_option_of_the_core_arrives_where_it_belongs(table: str, kind: Any) -> None:
    config = MissionConfig()
    assert type(getattr(config, table)) is kind
    written = config.to_dict()[table]
    assert list(written) == list(kind.__fields__)
    for key, current, _ in numbers(getattr(config, table), f"{table}."):
        value = current[0] if isinstance(current, list) else current
        allowed = RANGES.get(key, ANY)
        # Another number of the same kind that the core takes, too.
        for other in (value / 2, value + 2, value - 1e-3, value + 0.25):
            other = int(other) if isinstance(value, int) else other
            if other == value or other not in allowed:
                continue
            changed = [other] * len(current) if isinstance(current, list) else other
            try:
                read = MissionConfig.from_dict(nested(key, changed))
            except ValueError:
                continue
            found = functools.reduce(dict.__getitem__, key.split("."), read.to_dict())
            assert found == changed, key
            break
        else:
            raise AssertionError(f"{key} takes none of the values")
