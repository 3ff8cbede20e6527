# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`MissionConfig`: everything that a flight depends on but the world and the global path.

It holds the core's own option objects, so each option is defined once, in C++, with its default.
"""

import copy
import dataclasses
import functools
import os
import tomllib
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated, Any, Self

from ltp._core import (
    LidarOptions,
    NavigationOptions,
    ObstacleMapOptions,
    PlannerOptions,
    planner_info,
)
from ltp.config.guidance import GuidanceOptions
from ltp.config.moved import MOVED, warn_of, with_new_names
from ltp.config.presets import preset
from ltp.config.ranges import GATE, check_ranges, check_window
from ltp.config.tables import assign, differences, field_names, plain, read_toml, toml_lines
from ltp.files import atomic_write
from ltp.world.classes import Landable, landable_classes
from ltp.world.landable import LandingLimits


@dataclass(frozen=True)
class VehicleOptions:
    """Limits of the point-mass vehicle."""

    speed: Annotated[float, "designated velocity, the paper's [m/s]"] = 3.0
    max_acceleration: Annotated[float, "in any direction [m/s^2]"] = 3.0
    max_climb: Annotated[float, "largest vertical speed, up or down [m/s]"] = 2.0

    def __post_init__(self) -> None:
        check_ranges(self, "vehicle.")


@dataclass
class MissionConfig:
    """What a mission flies with. Every default is the paper's, or a choice of docs/method.md.

    It keeps copies of the option objects that it is given, so no two configurations share one.

    Raises:
        ValueError: for a value out of range, or a key that does not exist; it is named.
    """

    planner: Annotated[str, "one of `ltp.PLANNERS`; docs/planners.md says which is for what"] = (
        "auto"
    )
    planner_options: Annotated[PlannerOptions, "what planners go by, each its own"] = field(
        default_factory=PlannerOptions
    )
    priority_map: Annotated[str, '"binary", or "lpf" for the low-pass map'] = "binary"
    landable: Annotated[
        Landable,
        '"strict", "wide", or what may be landed on, by class: ["grass", "ground"]',
    ] = "wide"
    fov_deg: Annotated[float, "opening angle of the look-down camera [deg]"] = 53.0
    gate: Annotated[
        str | float,
        'where a waypoint but the last is served: at its "point", anywhere within half the '
        '"camera"\'s footprint, or within so many metres',
    ] = "point"
    step: Annotated[float, "of the simulation: scan, plan and move at 10 Hz [s]"] = 0.1
    time_limit_factor: Annotated[
        float, "a flight may take so many times as long as the global path takes at full speed"
    ] = 10.0
    hold_limit: Annotated[
        float, "after holding so long without a path the flight has timed out [s]"
    ] = 30.0
    landing: Annotated[LandingLimits, "how level landable ground must be"] = field(
        default_factory=LandingLimits
    )
    vehicle: Annotated[VehicleOptions, "limits of the point-mass vehicle"] = field(
        default_factory=VehicleOptions
    )
    guidance: Annotated[GuidanceOptions, "how closely and how fast a path is followed"] = field(
        default_factory=GuidanceOptions
    )
    lidar: Annotated[LidarOptions, "the simulated sensor"] = field(default_factory=LidarOptions)
    mapping: Annotated[ObstacleMapOptions, "the map of what was sensed"] = field(
        default_factory=ObstacleMapOptions
    )
    navigation: Annotated[NavigationOptions, "when to plan, and within what limits"] = field(
        default_factory=NavigationOptions
    )

    def __post_init__(self) -> None:
        self.check()

    def check(self) -> None:
        """Raise `ValueError` that names the first value out of range, or of another kind."""
        for item in dataclasses.fields(self):
            kind, value = item.default_factory, getattr(self, item.name)
            if isinstance(kind, type) and not isinstance(value, kind):
                raise ValueError(f"{item.name} = {value!r:.80}: expected {kind.__name__}")
        if not isinstance(self.planner, str):
            raise ValueError(f"planner = {self.planner!r:.80}: expected a planner's name")
        self.planner = planner_info(self.planner).name  # an old name becomes the new one
        check_ranges(self)
        check_window(self.mapping)
        for part in (self.planner_options, self.lidar, self.mapping, self.navigation):
            part.check()  # the core checks what is its own
        if self.mapping.max_range < self.lidar.max_range:
            raise ValueError(
                f"mapping.max_range = {self.mapping.max_range!r}: expected at least"
                f" lidar.max_range = {self.lidar.max_range!r}, or the map ignores far hits"
            )
        if self.priority_map not in ("binary", "lpf"):
            raise ValueError(f'priority_map = {self.priority_map!r}: expected "binary" or "lpf"')
        if self.gate not in ("point", "camera") and self.gate not in GATE:
            raise ValueError(f'gate = {self.gate!r}: expected "point", "camera" or {GATE}')
        allowed = landable_classes(self.landable)
        if not isinstance(self.landable, str):
            self.landable = tuple(kind.name.lower() for kind in sorted(allowed))

    def to_dict(self) -> dict[str, Any]:
        """All settings as plain values: numbers, strings, lists, nested dictionaries."""
        return {name: plain(getattr(self, name)) for name in field_names(self)}

    @classmethod
    def from_dict(cls, values: dict[str, Any]) -> Self:
        """The configuration with these settings; the others keep their defaults."""
        for name in MOVED.keys() & values.keys():
            warn_of(name)
        config, values = cls(), with_new_names(values)
        # The settings of two kinds.
        if isinstance(values.get("landable"), list | tuple):
            config.landable = values.pop("landable")
        if type(values.get("gate")) in (int, float):
            config.gate = values.pop("gate")
        assign(config, values)
        config.check()
        return config

    @classmethod
    def preset(cls, name: str) -> Self:
        """The defaults, but for those of a preset: `paper`, `fly`, `low` or `landing`."""
        return cls.from_dict(dict(preset(name)))

    def use_preset(self, name: str) -> None:
        """Take the settings of a preset; all others keep their values."""
        assign(self, dict(preset(name)))
        self.check()

    def to_toml(self) -> str:
        """All settings as a TOML document, each with its unit and what it means."""
        return "\n".join(toml_lines(self)) + "\n"

    @classmethod
    def from_toml(cls, text: str) -> Self:
        """Read a TOML document; unknown keys are refused."""
        try:
            return cls.from_dict(read_toml(text))
        except tomllib.TOMLDecodeError as error:
            raise ValueError(f"not a TOML document: {error}") from error

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a TOML file."""
        try:
            return cls.from_toml(Path(path).read_text(encoding="utf-8-sig"))
        except ValueError as error:
            raise ValueError(f"{path}: {error}") from error

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a TOML file, all at once or not at all."""
        with atomic_write(path) as file:
            file.write(self.to_toml().encode())

    def __repr__(self) -> str:
        """The planner, and what differs from the defaults."""
        changed = differences(self.to_dict(), _defaults())
        texts = [f"{key}={value!r}" for key, value in changed.items() if key != "planner"]
        return f"MissionConfig({', '.join([f'planner={self.planner!r}', *texts])})"

    def __copy__(self) -> Self:
        return dataclasses.replace(self)

    def __setattr__(self, name: str, value: Any) -> None:
        if name in MOVED:
            warn_of(name)
            _set(self, MOVED[name], value)
        else:
            object.__setattr__(self, name, copy.copy(value) if field_names(value) else value)

    def __getattr__(self, name: str) -> Any:  # only asked for what is not there
        if name not in MOVED:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        warn_of(name)
        return functools.reduce(getattr, MOVED[name].split("."), self)


@functools.cache
def _defaults() -> dict[str, Any]:
    return MissionConfig().to_dict()


_init = MissionConfig.__init__


@functools.wraps(_init)
def _init_with_old_names(self: MissionConfig, *arguments: Any, **settings: Any) -> None:
    old = {name: settings.pop(name) for name in MOVED if name in settings}
    _init(self, *arguments, **settings)
    for name, value in old.items():
        warn_of(name)
        _set(self, MOVED[name], value)
    if old:
        self.check()


MissionConfig.__init__ = _init_with_old_names  # type: ignore[method-assign]


def _set(holder: Any, key: str, value: Any) -> None:
    *tables, name = key.split(".")
    setattr(functools.reduce(getattr, tables, holder), name, value)
