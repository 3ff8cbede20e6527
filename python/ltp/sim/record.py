# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRecord`: everything needed to replay a flight and to compute every metric of it."""

import enum
import json
import os
import zipfile
from dataclasses import dataclass, field
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ltp.config import MissionConfig
from ltp.files import atomic_write

_FORMAT = 1


class Outcome(enum.StrEnum):
    """How a flight ended."""

    REACHED = "reached"  # the last waypoint was reached, or proved unreachable
    TIMED_OUT = "timed_out"
    COLLIDED = "collided"


@dataclass(frozen=True)
class WaypointEvent:
    """What became of a waypoint. Points are (x, y, z), world [m]."""

    index: int
    outcome: str  # "reached" or "dropped"
    reason: str  # why it was dropped: "goal_blocked" or "unreachable"; "" if it was reached
    time: float  # [s]
    position: tuple[float, float, float]  # of the UAV
    goal: tuple[float, float, float]  # the waypoint
    window_origin: tuple[float, float, float]  # lowest corner of the map's window


@dataclass(frozen=True, eq=False)
class PlanEntry:
    """One answer of the planner."""

    time: float  # [s]
    waypoint: int
    status: str  # of `ltp.PlanStatus`, in lower case
    path: NDArray[np.float64]  # (k, 3), empty unless found [m]
    penalty: float  # Eq. 5; inf unless found
    length: float  # L [m]
    priority: float  # integral of the priority along the path [m]
    direct_length: float  # L_direct [m]
    expanded: int
    seconds: float  # wall time; the only entry that differs from run to run


@dataclass(eq=False)
class FlightRecord:
    """One flight. Arrays have one row a step; world ENU [m, m/s, s]."""

    config: MissionConfig
    world_name: str
    attribution: str
    global_path: NDArray[np.float64]  # (n, 3)
    times: NDArray[np.float64]  # (t,)
    positions: NDArray[np.float64]  # (t, 3)
    velocities: NDArray[np.float64]  # (t, 3)
    plan_index: NDArray[np.int64]  # (t,) which of `plans` was last made, -1 before the first
    waypoint_index: NDArray[np.int64]  # (t,) the waypoint flown to
    waypoints: list[WaypointEvent]
    plans: list[PlanEntry]
    outcome: Outcome
    collision: tuple[float, float, float] | None  # where the true world was first touched
    min_clearance: float  # smallest distance to the true world at the positions, at most 50 m
    mean_priority: float  # along the flown path, exact
    length: float  # of the flown path [m]
    metadata: dict[str, Any] = field(default_factory=dict)  # the user's own, JSON values

    @property
    def length_ratio(self) -> float:
        """L_LP / L_GP: length flown over length of the global path."""
        steps = np.diff(self.global_path, axis=0)
        return self.length / float(np.linalg.norm(steps, axis=1).sum())

    @property
    def dropped(self) -> list[WaypointEvent]:
        """The waypoints that were proved unreachable."""
        return [event for event in self.waypoints if event.outcome == "dropped"]

    @property
    def duration(self) -> float:
        """Flight time [s]."""
        return float(self.times[-1])

    @property
    def complete(self) -> bool:
        """Whether every waypoint was reached."""
        return self.outcome is Outcome.REACHED and not self.dropped

    @property
    def plan_seconds(self) -> NDArray[np.float64]:
        """Wall time of each plan, (number of plans,) [s]."""
        return np.array([plan.seconds for plan in self.plans])

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write one `.npz` file, all at once or not at all.

        Raises:
            OSError: that names the file, if it cannot be written; an older file then stays whole.
        """
        lengths = [len(plan.path) for plan in self.plans]
        paths = [plan.path for plan in self.plans] or [np.empty((0, 3))]
        header = {
            "format": _FORMAT,
            "config": self.config.to_dict(),
            "world_name": self.world_name,
            "attribution": self.attribution,
            "outcome": self.outcome.value,
            "collision": self.collision,
            "min_clearance": self.min_clearance,
            "mean_priority": self.mean_priority,
            "length": self.length,
            "waypoints": [vars(event) for event in self.waypoints],
            "plans": [{k: v for k, v in vars(plan).items() if k != "path"} for plan in self.plans],
            "metadata": self.metadata,
        }
        with atomic_write(path) as file:
            np.savez_compressed(
                file,
                header=np.frombuffer(json.dumps(header).encode(), dtype=np.uint8),
                plan_paths=np.concatenate(paths),
                plan_lengths=np.array(lengths, dtype=np.int64),
                **{name: getattr(self, name) for name in _ARRAYS},
            )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a record.

        Raises:
            ValueError: that names the file and what is wrong with it.
        """
        try:
            with np.load(path, allow_pickle=False) as archive:
                arrays = {name: archive[name] for name in archive.files}
            header = json.loads(arrays.pop("header").tobytes())
            if header.pop("format") != _FORMAT:
                raise ValueError("another version of the format")
            ends = np.cumsum(arrays.pop("plan_lengths"))
            paths = np.split(arrays.pop("plan_paths"), ends[:-1]) if len(ends) else []
            plans = [
                PlanEntry(**entry, path=line)
                for entry, line in zip(header.pop("plans"), paths, strict=True)
            ]
            events = [WaypointEvent(**_tuples(event)) for event in header.pop("waypoints")]
            return cls(
                config=MissionConfig.from_dict(header.pop("config")),
                outcome=Outcome(header.pop("outcome")),
                plans=plans,
                waypoints=events,
                **{name: arrays[name] for name in _ARRAYS},
                **_tuples(header),
            )
        except (ValueError, KeyError, TypeError, EOFError, zipfile.BadZipFile) as error:
            raise ValueError(f"{path}: not a flight record: {error}") from error


_ARRAYS = ("global_path", "times", "positions", "velocities", "plan_index", "waypoint_index")


def _tuples(values: dict[str, Any]) -> dict[str, Any]:
    return {k: tuple(v) if isinstance(v, list) else v for k, v in values.items()}
