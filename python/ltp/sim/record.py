# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""`FlightRecord`: everything needed to replay a flight and to compute every metric of it."""

import enum
import json
import math
import os
import warnings
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Self

import numpy as np
from numpy.typing import NDArray

from ltp._core import NavigationReason, PlanRecord, WaypointEvent
from ltp.brief import brief
from ltp.config import MissionConfig
from ltp.files import atomic_write, blamed_on
from ltp.files.typed import typed
from ltp.sim.record_file import ARRAYS, FORMAT, read_record


def _old_name(old: str, name: str) -> property:
    """An attribute under its name of version 0.1, for one release."""

    def read(self: object) -> Any:
        warnings.warn(f"`{old}` is now `{name}`", DeprecationWarning, stacklevel=2)
        return getattr(self, name)

    return property(read, doc=f"The old name of `{name}`.")


class Outcome(enum.StrEnum):
    """How a flight ended."""

    REACHED = "reached"  # a waypoint was reached, and all others were reached or dropped
    NOTHING_REACHED = "nothing_reached"  # every waypoint was dropped
    TIMED_OUT = "timed_out"
    COLLIDED = "collided"
    STOPPED = "stopped"  # by whoever flew it, on its way


def fate_of(event: WaypointEvent) -> str:
    """What became of its waypoint: "reached", "dropped" on proof, or "skipped" as too far."""
    if event.why == NavigationReason.TOO_FAR:
        return "skipped"
    return "reached" if event.reached else "dropped"


@dataclass(frozen=True)
class WaypointEntry:
    """What became of a waypoint, and when. Points are (x, y, z), world [m]."""

    index: int
    outcome: str  # "reached", "dropped" on proof, or "skipped" as too far
    reason: str  # why: "goal_blocked", "unreachable" or "too_far"; "" if it was reached
    time: float  # [s]
    position: tuple[float, float, float]  # of the UAV
    goal: tuple[float, float, float]  # the waypoint
    window_origin: tuple[float, float, float]  # lowest corner of the map's window
    gate_radius: float = 0.0  # of the gate it was to be served in; 0: a point, or not recorded

    @property
    def distance(self) -> float:
        """From the UAV to the waypoint [m]: how near it was served, or was when it was given up."""
        return math.dist(self.position, self.goal)

    @property
    def reason_text(self) -> str:
        """The reason as a plain sentence without its full stop; "" if it was reached."""
        known = NavigationReason.__members__.get(self.reason.upper())
        return known.text if known is not None else self.reason.replace("_", " ")

    @classmethod
    def of(
        cls, event: WaypointEvent, time: float, before: int = 0, gate_radius: float = 0.0
    ) -> Self:
        """An event of the planner's at a time [s]; before: waypoints that it no longer counts."""
        return cls(
            index=before + event.index,
            outcome=fate_of(event),
            reason="" if event.reached else event.why.name.lower(),
            time=time,
            position=_point(event.position),
            goal=_point(event.goal),
            window_origin=_point(event.window_origin),
            gate_radius=gate_radius,
        )


@dataclass(frozen=True, eq=False)
class PlanEntry:
    """One answer of the planner, and when it was given."""

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

    __repr__ = brief
    way_point = _old_name("way_point", "waypoint")

    @classmethod
    def of(cls, answer: PlanRecord, time: float, before: int = 0) -> Self:
        """An answer of the planner's at a time [s]; before: waypoints that it no longer counts."""
        plan = answer.plan
        return cls(
            time=time,
            waypoint=before + answer.waypoint,
            status=plan.status.name.lower(),
            path=plan.path,
            penalty=plan.penalty,
            length=plan.tally.length,
            priority=plan.tally.priority,
            direct_length=answer.direct_length,
            expanded=plan.stats.expanded,
            seconds=plan.stats.seconds,
        )


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
    waypoints: list[WaypointEntry]
    plans: list[PlanEntry]
    outcome: Outcome
    collision: tuple[float, float, float] | None  # where the true world was first touched
    min_clearance: float  # smallest distance to the true world at the positions, at most 50 m
    mean_priority: float  # along the flown path, exact
    length: float  # of the flown path [m]
    metadata: dict[str, Any] = field(default_factory=dict)  # the user's own, JSON values
    reason: str = ""  # why it ended so, a sentence without its full stop; "": not recorded
    # What became of all points sensed, by the names of `ltp.InsertStatistics`; {}: not recorded.
    map_totals: dict[str, int] = field(default_factory=dict)
    map_losses: list[str] = field(default_factory=list)  # sentences: which hits the map lost

    way_points = _old_name("way_points", "waypoints")
    way_point_index = _old_name("way_point_index", "waypoint_index")

    def __repr__(self) -> str:
        far = f", {len(self.skipped)} too far" if self.skipped else ""
        touched = "" if self.collision is None else f" at {self.collision}"
        seconds = f"{self.times[-1]:.1f} s" if len(self.times) else "no time"
        return (
            f"FlightRecord({self.config.planner} over {self.world_name!r}: "
            f"{self.outcome.value}{touched}, {self.length:.1f} m in {seconds}, "
            f"{len(self.reached)} waypoints reached, {len(self.dropped)} dropped{far}, "
            f"{len(self.plans)} plans)"
        )

    @property
    def global_length(self) -> float:
        """L_GP: length of the global path [m]."""
        return float(np.linalg.norm(np.diff(self.global_path, axis=0), axis=1).sum())

    @property
    def length_ratio(self) -> float:
        """L_LP / L_GP: length flown over length of the global path; NaN without one."""
        return self.length / self.global_length if self.global_length > 0.0 else math.nan

    @property
    def reached(self) -> list[WaypointEntry]:
        """The waypoints that were served."""
        return [event for event in self.waypoints if event.outcome == "reached"]

    @property
    def dropped(self) -> list[WaypointEntry]:
        """The waypoints that were proved unreachable."""
        return [event for event in self.waypoints if event.outcome == "dropped"]

    @property
    def skipped(self) -> list[WaypointEntry]:
        """The waypoints that were too far: see `NavigationOptions.max_detour`."""
        return [event for event in self.waypoints if event.outcome == "skipped"]

    @property
    def duration(self) -> float:
        """Flight time [s]."""
        return float(self.times[-1])

    @property
    def complete(self) -> bool:
        """Whether every waypoint was reached."""
        return self.outcome is Outcome.REACHED and not self.dropped and not self.skipped

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
            "format": FORMAT,
            "config": self.config.to_dict(),
            "world_name": self.world_name,
            "attribution": self.attribution,
            "outcome": self.outcome.value,
            "reason": self.reason,
            "map_totals": self.map_totals,
            "map_losses": self.map_losses,
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
                **{name: getattr(self, name) for name in ARRAYS},
            )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """Read a record.

        Nothing in the file is executed or trusted: sizes are checked before anything is unpacked.

        Raises:
            OSError: if the file cannot be opened or read.
            ValueError: that names the file and what is wrong with it.
        """
        with Path(path).open("rb") as file, blamed_on(path, "a flight record"):
            header, arrays, paths = read_record(file)
            config, plans, waypoints = (
                header.pop(name) for name in ("config", "plans", "waypoints")
            )
            return cls(
                config=MissionConfig.from_dict(config),
                plans=[
                    PlanEntry(**typed(PlanEntry, plan, without=("path",)), path=path)
                    for plan, path in zip(plans, paths, strict=True)
                ],
                waypoints=[WaypointEntry(**typed(WaypointEntry, entry)) for entry in waypoints],
                **arrays,
                **typed(cls, header, without=arrays),
            )


def _point(values: NDArray[np.float64]) -> tuple[float, float, float]:
    x, y, z = (float(value) for value in values)
    return x, y, z
