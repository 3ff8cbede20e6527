# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every public object says on one line what it is, with numbers."""

import dataclasses
import enum
import re
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import ltp
import ltp.evaluation
import ltp.sim
import ltp.world
from ltp import _core
from ltp.config import MissionConfig
from ltp.evaluation.gap.queries import QuerySet
from ltp.sim import Flight, Mission, MountedLidar, look_down
from ltp.world import World
from tests.python.scenes import event, plan, record, row

FRAME = ltp.GridFrame((0.0, 0.0, 0.0), (2.0, 2.0, 4.0), (20, 10, 5))
GRID = ltp.OccupancyGrid(FRAME)
RASTER = ltp.Raster(np.arange(200.0).reshape(20, 10), origin=(1.0, 2.5), cell=2.0)
WORLD = World(
    "boxes", np.zeros((60, 40)), np.full((60, 40), 3.0), np.zeros((60, 40), np.uint8), 1.0
)
PATH = np.array([[5.0, 5.0, 20.0], [50.0, 30.0, 20.0]])


def steps() -> Any:
    """One step of a mission."""
    seen: list[Any] = []

    class Watch:
        def on_start(self, setup: Any) -> None:
            seen.append(setup)

        def on_step(self, step: Any) -> None:
            seen.append(step)

        def on_end(self, record: Any) -> None:
            seen.append(record)

    Mission(WORLD, MissionConfig(hold_limit=0.1, time_limit_factor=0.01), PATH, [Watch()]).fly()
    return seen


def scan() -> Any:
    return ltp.Lidar().scan(ltp.HeightSurface(RASTER), ltp.Pose((20.0, 10.0, 300.0)), 0)


#: Class -> how to make one, and what its repr must hold.
EXAMPLES: dict[str, tuple[Callable[[], object], tuple[str, ...]]] = {
    "World": (lambda: WORLD, ("boxes", "60 x 40", "1 m", "top at 3.0 m")),
    "FlightRecord": (
        lambda: record([event(1)]),
        ("auto", "boxes", "reached", "60.0 m", "2 plans", "1 waypoints"),
    ),
    "MissionConfig": (
        lambda: MissionConfig.from_dict({"planner": "ggwp", "vehicle": {"speed": 5.0}}),
        ("planner='ggwp'", "vehicle.speed=5.0"),
    ),
    "Datum": (lambda: WORLD.datum, ("crs=None",)),
    "GridFrame": (lambda: FRAME, ("20, 10, 5",)),
    "OccupancyGrid": (lambda: GRID, ("20 x 10 x 5 cells", "(2, 2, 4) m", "0 set")),
    "Raster": (lambda: RASTER, ("20 x 10 cells", "2 m", "(1, 2.5)", "0 to 199", "outside=0")),
    "HeightSurface": (lambda: ltp.HeightSurface(RASTER), ("20 x 10 cells", "0 to 199")),
    "OctreeSurface": (lambda: ltp.OctreeSurface(np.array([[1.0, 2, 3]]), 0.5), ("1 vox", "0.5 m")),
    "Lidar": (lambda: ltp.Lidar(), ("360 x 32 rays", "max_range=50 m")),
    "Scan": (scan, ("hits", "misses", "(20, 10, 300)")),
    "Pose": (lambda: ltp.Pose((1.0, 2.0, 3.5)), ("(1, 2, 3.5)",)),
    "Scene": (lambda: ltp.Scene(GRID, RASTER), ("20 x 10 x 5 cells", "20 x 10 cells")),
    "Query": (
        lambda: ltp.Query((1, 2, 3), (4, 5, 6)),
        ("start=(1, 2, 3)", "goal=(4, 5, 6)", "band"),
    ),
    "ObstacleMap": (lambda: ltp.ObstacleMap(), ("200 x 200 x 40 cells", "inflation_radius=1 m")),
    "Planner": (lambda: ltp.make_planner("ggwp"), ("'ggwp'",)),
    "Plan": (
        lambda: ltp.make_planner().plan(ltp.Scene(GRID, RASTER), ltp.Query((5, 5, 5), (30, 9, 5))),
        ("FOUND", "penalty"),
    ),
    "LocalTrajectoryPlanner": (
        lambda: ltp.LocalTrajectoryPlanner(RASTER, (0.0, 0.0, 10.0)),
        ("waypoint", "0 plans made"),
    ),
    "ConcurrentTrajectoryPlanner": (
        lambda: ltp.ConcurrentTrajectoryPlanner(RASTER, (0.0, 0.0, 10.0)),
        ("0 waypoints", "0 scans"),
    ),
    "Front": (
        lambda: ltp.pareto_front(ltp.Scene(GRID, RASTER), ltp.Query((5, 5, 5), (30, 9, 5))),
        (),
    ),
    "QuerySet": (
        lambda: QuerySet("boxes", "nobody", "made up", [], {3: {}}),
        ("0 queries", "'boxes'", "3"),
    ),
    "PlanEntry": (lambda: plan(0.1), ("<2 x 3 array>", "found")),
    "WaypointEntry": (lambda: event(2), ("index=2", "reached")),
    "MissionSetup": (lambda: steps()[0], ("array>",)),
    "Step": (lambda: steps()[1], ("time=0.0", "position=[5.0, 5.0, 20.0]")),
    "Mission": (lambda: Mission(WORLD, MissionConfig(), PATH), ("auto", "boxes")),
    "Flight": (
        lambda: Flight(WORLD, MissionConfig(), PATH[0]),
        ("auto", "boxes", "0 waypoints", "stopped at 0.0 s"),
    ),
    "MountedLidar": (
        lambda: MountedLidar(look_down(), ltp.Pose((0.0, 0.0, -0.2)), 5.0),
        ("(0, 0, -0.2)", "rate=5.0"),
    ),
    "FlightRow": (lambda: row(), ("planner=",)),
    "RayHit": (
        lambda: ltp.HeightSurface(RASTER).cast((20.0, 10.0, 300.0), (0.0, 0.0, -1.0), 400.0),
        ("range=",),
    ),
}

CLASSES = {
    name: found
    for module in (ltp, ltp.sim, ltp.world, ltp.evaluation)
    for name in module.__all__
    if isinstance(found := getattr(module, name), type)
    and not issubclass(found, enum.Enum)
    and not getattr(found, "_is_protocol", False)
    and not issubclass(found, dict)
    and found is not ltp.Surface  # nothing is one but those below it
}


def sound(text: str, longest: int = 700) -> bool:
    """One line, not too long, no address in memory, and more than a name."""
    return "\n" not in text and len(text) <= longest and " at 0x" not in text and "(" in text


@pytest.mark.parametrize("name", sorted(EXAMPLES))
def test_an_object_says_on_one_line_what_it_is(name: str) -> None:
    make, holds = EXAMPLES[name]
    text = repr(make())
    assert sound(text), text
    assert text.startswith(name)
    assert [part for part in holds if part not in text] == [], text


@pytest.mark.parametrize("name", sorted(CLASSES))
def test_every_public_class_has_a_repr_of_its_own(name: str) -> None:
    kind = CLASSES[name]
    assert kind.__repr__ is not object.__repr__
    if name in EXAMPLES:
        return
    try:
        made = kind()
    except TypeError:  # wants arguments
        return
    assert sound(repr(made)), repr(made)


def test_the_compiled_classes_have_one_each() -> None:
    silent = [
        name
        for name, kind in vars(_core).items()
        if isinstance(kind, type) and kind.__repr__ is object.__repr__ and name != "Surface"
    ]
    assert silent == []


def test_arrays_never_break_the_line() -> None:
    for kind in CLASSES.values():
        if dataclasses.is_dataclass(kind) and "NDArray" in str(kind.__annotations__):
            assert kind.__qualname__ + ".__repr__" != kind.__repr__.__qualname__ or (
                kind.__name__ in EXAMPLES
            ), kind


def test_defaults_say_little() -> None:
    assert repr(MissionConfig()) == "MissionConfig(planner='auto')"
    assert re.fullmatch(r"World\('boxes', .*\)", repr(WORLD))
