# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`MissionConfig`: everything that a flight depends on but the world and the global path.

It holds the core's own option objects, so each option is defined once, in C++, with its default.
"""

import dataclasses
import math
import os
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

from ltp._core import (
    AraOptions,
    BezierOptions,
    BugOptions,
    HermiteOptions,
    LidarOptions,
    LinearisedOptions,
    NavigationOptions,
    ObstacleMapOptions,
    ParetoOptions,
    Planner,
    PlannerOptions,
    RiskOptions,
)


@dataclass(frozen=True)
class VehicleOptions:
    """Limits of the point-mass vehicle."""

    speed: float = 3.0  # designated velocity, the paper's [m/s]
    max_acceleration: float = 3.0  # [m/s^2]
    max_climb: float = 2.0  # largest vertical speed, up or down [m/s]

    def __post_init__(self) -> None:
        for name in ("speed", "max_acceleration", "max_climb"):
            _positive(f"vehicle.{name}", getattr(self, name))


@dataclass
class MissionConfig:
    """What a mission flies with. Every default is the paper's, or a choice of docs/method.md.

    Raises:
        ValueError: for a value out of range, or a key that does not exist; it is named.
    """

    planner: str = "auto"  # one of `ltp.planners.PLANNERS`
    length_weight: float = 0.5  # W_L of Eq. 5
    priority_weight: float = 1.0  # W_P of Eq. 5
    scaled_heuristic: bool = False  # multiply Eq. 9 by W_L, which it lacks as printed
    max_expansions: int = 0  # per plan; 0: no limit
    refine: bool = False  # free every path from the grid's directions; never a larger Eq. 5
    priority_map: str = "binary"  # "binary" or "lpf"
    landable: str = "wide"  # preset of the classes that may be landed on
    fov_deg: float = 53.0  # of the look-down camera [deg]
    step: float = 0.1  # of the simulation: scan, plan and move at 10 Hz [s]
    time_limit_factor: float = 5.0  # of the time that the global path takes at full speed
    hold_limit: float = 30.0  # after holding so long without a path the flight has timed out [s]
    vehicle: VehicleOptions = field(default_factory=VehicleOptions)
    bezier: BezierOptions = field(default_factory=BezierOptions)
    linearised: LinearisedOptions = field(default_factory=LinearisedOptions)
    pareto: ParetoOptions = field(default_factory=ParetoOptions)
    ara: AraOptions = field(default_factory=AraOptions)
    risk: RiskOptions = field(default_factory=RiskOptions)
    bug: BugOptions = field(default_factory=BugOptions)
    hermite: HermiteOptions = field(default_factory=HermiteOptions)
    lidar: LidarOptions = field(default_factory=LidarOptions)
    mapping: ObstacleMapOptions = field(default_factory=ObstacleMapOptions)
    navigation: NavigationOptions = field(default_factory=NavigationOptions)

    def __post_init__(self) -> None:
        self.check()

    def check(self) -> None:
        """Raise `ValueError` that names the first value out of range."""
        Planner(self.planner, self.planner_options())  # the core checks what is its own
        for part in (self.lidar, self.mapping, self.navigation):
            part.check()
        if self.priority_map not in ("binary", "lpf"):
            raise ValueError(f'priority_map = {self.priority_map!r}: expected "binary" or "lpf"')
        for name in ("fov_deg", "step", "time_limit_factor", "hold_limit"):
            _positive(name, getattr(self, name))

    def planner_options(self) -> PlannerOptions:
        """The part of the configuration that the planner is made with."""
        return PlannerOptions(
            length_weight=self.length_weight,
            priority_weight=self.priority_weight,
            scaled_heuristic=self.scaled_heuristic,
            max_expansions=self.max_expansions,
            refine=self.refine,
            bezier=self.bezier,
            linearised=self.linearised,
            pareto=self.pareto,
            ara=self.ara,
            risk=self.risk,
            bug=self.bug,
            hermite=self.hermite,
        )

    def to_dict(self) -> dict[str, Any]:
        """All settings as plain values: numbers, strings, lists, nested dictionaries."""
        return {name: _plain(getattr(self, name)) for name in _fields(self)}

    @classmethod
    def from_dict(cls, values: dict[str, Any]) -> Self:
        """The configuration with these settings; the others keep their defaults."""
        config = cls()
        _assign(config, values, "")
        config.check()
        return config

    def to_toml(self) -> str:
        """All settings as a TOML document."""
        return "\n".join(_toml_lines(self.to_dict(), "")) + "\n"

    @classmethod
    def from_toml(cls, text: str) -> Self:
        """Read a TOML document; unknown keys are refused."""
        try:
            return cls.from_dict(tomllib.loads(text))
        except tomllib.TOMLDecodeError as error:
            raise ValueError(f"not a TOML document: {error}") from error

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a TOML file."""
        try:
            return cls.from_toml(Path(path).read_text(encoding="utf-8"))
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a TOML file."""
        Path(path).write_text(self.to_toml(), encoding="utf-8")


def _positive(name: str, value: float) -> None:
    if not (isinstance(value, int | float) and math.isfinite(value) and value > 0):
        raise ValueError(f"{name} = {value!r}: expected a positive finite number")


def _fields(holder: object) -> tuple[str, ...]:
    """Names of the settings of a dataclass or of one of the core's option objects."""
    if dataclasses.is_dataclass(holder):
        return tuple(item.name for item in dataclasses.fields(holder))
    return tuple(getattr(type(holder), "__fields__", ()))


def _plain(value: Any) -> Any:
    names = _fields(value)
    if names:
        return {name: _plain(getattr(value, name)) for name in names}
    if hasattr(value, "tolist"):
        return value.tolist()
    if isinstance(value, tuple | list):
        return [_plain(item) for item in value]
    return value


def _assign(holder: Any, values: dict[str, Any], prefix: str) -> None:
    known = _fields(holder)
    for name, value in values.items():
        key = prefix + name
        if name not in known:
            raise ValueError(f"unknown key {key!r}: expected one of {', '.join(known)}")
        current = getattr(holder, name)
        try:
            if _fields(current):
                if not isinstance(value, dict):
                    raise ValueError(f"{key} = {value!r}: expected a table")
                if dataclasses.is_dataclass(current):  # frozen: checked as a whole
                    _refuse_unknown(current, value, key)
                    value = dataclasses.replace(current, **value)  # type: ignore[type-var]
                else:
                    _assign(current, value, key + ".")
                    value = current
            elif any(isinstance(current, t) != isinstance(value, t) for t in (bool, str)):
                raise ValueError(f"{key} = {value!r}: expected {type(current).__name__}")
            setattr(holder, name, value)
        except TypeError as error:
            expected = type(current).__name__
            raise ValueError(f"{key} = {value!r}: expected {expected}") from error


def _refuse_unknown(holder: object, values: dict[str, Any], key: str) -> None:
    for name in values:
        if name not in _fields(holder):
            known = ", ".join(_fields(holder))
            raise ValueError(f"unknown key '{key}.{name}': expected one of {known}")


def _toml_lines(values: dict[str, Any], prefix: str) -> list[str]:
    lines = [f"{k} = {_toml(v)}" for k, v in values.items() if not isinstance(v, dict)]
    for name, table in values.items():
        if isinstance(table, dict):
            lines += ["", f"[{prefix}{name}]", *_toml_lines(table, f"{prefix}{name}.")]
    return lines


def _toml(value: Any) -> str:
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, str):
        return '"' + value.replace("\\", "\\\\").replace('"', '\\"') + '"'
    if isinstance(value, list):
        return "[" + ", ".join(_toml(item) for item in value) + "]"
    return repr(value)  # numbers; inf and nan are TOML's own words
