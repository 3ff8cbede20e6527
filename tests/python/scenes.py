# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small worlds and made-up flights for the tests of evaluation, viewer and command line."""

import math

import numpy as np

from ltp._core import GridFrame, OccupancyGrid, Query, Raster, flood_fill
from ltp.config import MissionConfig
from ltp.evaluation.campaign import FlightRow
from ltp.evaluation.campaign.variants import at_ratio
from ltp.evaluation.gap.queries import QuerySet, RecordedQuery
from ltp.evaluation.regret import RegretRow
from ltp.evaluation.sensed import CellMap
from ltp.sim.record import FlightRecord, Outcome, PlanEntry, WaypointEntry
from ltp.world import LandClass, World

ATTRIBUTION = "Made-up boxes, for tests only"


def box_world(boxes, size=(200, 160), name="boxes", cell=1.0, height=80.0):
    """Flat grass with solid buildings (x0, x1, y0, y1) [cells]."""
    surface = np.zeros(size)
    classes = np.full(size, LandClass.GRASS, dtype=np.uint8)
    for x0, x1, y0, y1 in boxes:
        surface[x0:x1, y0:y1] = height
        classes[x0:x1, y0:y1] = LandClass.BUILDING
    return World(name, np.zeros(size), surface, classes, cell, attribution=ATTRIBUTION)


def town():
    """Four towers on grass, 260 m x 220 m: room for short flights that meet something."""
    return box_world(
        [(60, 90, 50, 80), (150, 185, 60, 100), (70, 100, 130, 170), (165, 195, 140, 170)],
        size=(260, 220),
        name="town",
    )


def patchwork(seed, count=6, size=(30, 30, 6), density=0.2):
    """Made-up queries through random blocks, over a random binary map and its smooth like."""
    rng = np.random.default_rng(seed)
    frame = GridFrame((0.0, 0.0, 0.0), (2.0, 2.0, 4.0), size)
    queries, priorities = [], {}
    while len(queries) < count:
        blocked = np.repeat(rng.random((*size[:2], 1)) < density, size[2], axis=2)
        blocked[:, :, 3:] = False  # one may fly over everything
        start, goal = frame.centre((2, 3, 2)), frame.centre((size[0] - 4, size[1] - 3, 2))
        blocked[2, 3] = blocked[size[0] - 4, size[1] - 3] = False
        grid = OccupancyGrid.from_array(blocked, frame)
        if not flood_fill(grid, Query(start, goal, (0.0, 0.0)))[tuple(frame.cell_of(goal))]:
            continue
        ground = np.kron(rng.random((size[0] // 3, size[1] // 3)), np.ones((3, 3)))
        maps = {"binary": np.where(ground < 0.4, 1.0, 0.0), "lpf": ground}
        number = len(queries)
        priorities[number] = {name: Raster(values, cell=2.0) for name, values in maps.items()}
        cells = CellMap.of(grid)
        queries.append(RecordedQuery(number, 0.0, 1, start, goal, (0.0, 0.0), math.inf, cells))
    return QuerySet("patchwork", ATTRIBUTION, "", queries, priorities)


def event(index, outcome="reached", reason="", goal=(0, 0, 0), position=(0, 0, 0)):
    return WaypointEntry(
        index=index,
        outcome=outcome,
        reason=reason,
        time=float(index),
        position=tuple(map(float, position)),
        goal=tuple(map(float, goal)),
        window_origin=(-200.0, -200.0, -80.0),
    )


def plan(seconds, status="found", waypoint=0):
    return PlanEntry(
        time=0.0,
        waypoint=waypoint,
        status=status,
        path=np.array([[0.0, 0.0, 30.0], [10.0, 0.0, 30.0]][: 2 * (status == "found")]),
        penalty=-0.1,
        length=10.0,
        priority=5.0,
        direct_length=10.0,
        expanded=7,
        seconds=seconds,
    )


def record(events=(), seconds=(0.001, 0.003), length=60.0, world="boxes", **config):
    """A flight along x that never flew: 50 m of global path at z = 30 m."""
    path = np.array([[0.0, 20.0, 30.0], [25.0, 20.0, 30.0], [50.0, 20.0, 30.0]])
    positions = np.linspace(path[0], path[-1], 6)
    return FlightRecord(
        config=MissionConfig(**config),
        world_name=world,
        attribution=ATTRIBUTION,
        global_path=path,
        times=np.arange(6) * 0.1,
        positions=positions,
        velocities=np.zeros((6, 3)),
        plan_index=np.zeros(6, dtype=np.int64),
        waypoint_index=np.zeros(6, dtype=np.int64),
        waypoints=list(events),
        plans=[plan(s) for s in seconds],
        outcome=Outcome.REACHED,
        collision=None,
        min_clearance=3.5,
        mean_priority=0.75,
        length=length,
    )


def row(**changes):
    """A row of a campaign."""
    values = {
        "key": "k0",
        "world": "boxes",
        "planner": "lp-dijkstra",
        "length_weight": 0.5,
        "priority_weight": 1.0,
        "priority_map": "binary",
        "scenario": 0,
        "seed": 1,
        "crosses_building": True,
        "outcome": "reached",
        "waypoints": 10,
        "reached": 9,
        "dropped": 1,
        "dropped_goal_blocked": 1,
        "dropped_unreachable": 0,
        "wrongly_dropped": 0,
        "collided": False,
        "mean_priority": 0.5,
        "length": 550.0,
        "length_ratio": 1.1,
        "penalty": 0.05,
        "min_clearance": 2.5,
        "end_distance": 1.0,
        "duration": 180.0,
        "plans": 3,
        "plans_found": 3,
        "expanded": 100,
        "time_plan_mean": 2.0,
        "time_plan_median": 2.0,
        "time_plan_p95": 2.9,
        "time_plans": "1|2|3",
        "time_flight": 0.5,
    }
    return FlightRow(**(values | changes))


def regret_row(**changes):
    """A flight held against the best routes."""
    values = {
        "key": "k",
        "world": "boxes",
        "planner": "auto",
        "length_weight": 0.5,
        "priority_weight": 1.0,
        "priority_map": "binary",
        "refine": False,
        "scenario": 0,
        "seed": 1,
        "outcome": "reached",
        "waypoints": 10,
        "served": 9,
        "gates": "point",
        "flown_gates": "point",
        "gate": 2.8,
        "last_gate": 2.8,
        "global_length": 500.0,
        "flown": 0.1,
        "flown_length": 600.0,
        "flown_priority": 0.5,
        "legs": 0.0,
        "legs_length": 550.0,
        "legs_priority": 0.55,
        "joint": -0.1,
        "joint_length": 550.0,
        "joint_priority": 0.65,
        "joint_bound": -0.101,
        "time_legs": 1.0,
        "time_joint": 1.0,
    }
    return RegretRow(**(values | changes))


def flight(planner: str, scenario: int, ratio: float = 2.0, kind: str = "binary", **values):
    """A row of a campaign: a contender at a ratio W_P / W_L over a map."""
    wanted = at_ratio(ratio, planner, kind)
    return row(
        key=f"{planner}{scenario}{ratio}{kind}",
        planner=wanted.planner,
        refine=wanted.refine,
        scenario=scenario,
        length_weight=wanted.length_weight,
        priority_weight=wanted.priority_weight,
        priority_map=kind,
        **values,
    )
