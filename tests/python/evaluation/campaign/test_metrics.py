# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""Metrics of a flight, and the judge of dropped waypoints against an obvious reference."""

import dataclasses
import math

import numpy as np
import pytest
from scipy import ndimage

from ltp import _core as core
from ltp._core import PenaltyWeights, PlannerOptions
from ltp.evaluation.campaign.drops import DropJudge
from ltp.evaluation.campaign.fine_cells import FineCells
from ltp.evaluation.campaign.metrics import (
    TimeStatistics,
    end_distance,
    flight_row,
    flown_penalty,
)
from ltp.evaluation.campaign.reachability import TrueCells
from ltp.evaluation.scenarios import Scenario
from ltp.sim.record import WaypointEntry
from ltp.world import World
from tests.python.scenes import box_world, event, record

MAPPING = core.ObstacleMapOptions()


def random_world(seed: int) -> World:
    """Random 10 m blocks on a slope: yards and dead ends at every altitude."""
    rng = np.random.default_rng(seed)
    heights = rng.uniform(2.0, 30.0, (12, 10)) * (rng.random((12, 10)) < 0.6)
    ground = np.broadcast_to(np.linspace(0.0, 6.0, 120)[:, None], (120, 100))
    surface = ground + np.kron(heights, np.ones((10, 10)))
    return World("blocks", ground, surface, np.zeros((120, 100), np.uint8), 1.0)


def reference_free(world: World, ring: int = 8) -> tuple[np.ndarray, np.ndarray]:
    """Free 2 x 2 x 4 m cells, inflated by a voxel of 2 m, by loops over the world; their origin."""
    nx, ny = (n // 2 + 2 * ring for n in world.shape)
    nz = math.ceil(world.surface.max() / 4.0) + 4
    solid = np.zeros((nx, ny, 2 * nz), dtype=bool)
    for i in range(world.shape[0] // 2):
        for j in range(world.shape[1] // 2):
            top = world.surface[2 * i : 2 * i + 2, 2 * j : 2 * j + 2].max()
            for k in range(2 * nz):
                solid[i + ring, j + ring, k] = 2.0 * k < top
    voxels = ndimage.binary_dilation(solid, np.ones((3, 3, 3)))  # 1 m reaches each neighbour
    blocked = voxels.reshape(nx, ny, nz, 2).any(axis=3)
    return ~blocked, np.array([-2.0 * ring, -2.0 * ring, 0.0])


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("band", [(0.0, 0.0), (4.0, 8.0), (math.inf, math.inf)])
def test_reachable_is_being_in_one_component(seed: int, band: tuple[float, float]) -> None:
    # Without corner cutting 26 neighbours reach what 6 reach: scipy's labels are the reference.
    world = random_world(seed)
    cells = TrueCells(world, MAPPING)
    free, origin = reference_free(world)
    rng = np.random.default_rng(100 + seed)
    spots = np.argwhere(free[8:-8, 8:-8, :4]) + np.array([8, 8, 0])  # over the world, low
    answers = set()
    for _ in range(60):
        a, b = spots[rng.integers(len(spots), size=2)]
        low = max(0, int(min(a[2], b[2]) - min(band[0], 1e3) // 4))
        high = min(free.shape[2] - 1, int(max(a[2], b[2]) + min(band[1], 1e3) // 4))
        labels, _ = ndimage.label(free[:, :, low : high + 1])
        expected = labels[a[0], a[1], a[2] - low] == labels[b[0], b[1], b[2] - low]
        start, goal = (origin + (cell + 0.5) * (2.0, 2.0, 4.0) for cell in (a, b))
        found = cells.reachable(start, goal, below=band[0], above=band[1])
        assert found == expected
        answers.add(found)
    assert answers == {True, False} or band[1] > 0.0  # planar flight has dead ends


def courtyard() -> World:
    """A closed yard with free cells in the middle, 40 m x 40 m inside."""
    return box_world(
        [(60, 120, 50, 60), (60, 120, 100, 110), (60, 70, 50, 110), (110, 120, 50, 110)]
    )


def test_a_yard_is_reached_over_the_roof_only() -> None:
    cells = TrueCells(courtyard(), MAPPING)
    outside, inside = (20.0, 80.0, 40.0), (90.0, 80.0, 40.0)
    assert not cells.reachable(outside, inside, below=0.0, above=0.0)
    assert not cells.reachable(outside, inside, below=0.0, above=36.0)
    assert cells.reachable(outside, inside, below=0.0, above=60.0)
    assert cells.reachable(inside, (80.0, 70.0, 40.0), below=0.0, above=0.0)


def test_one_may_fly_round_the_edge_of_the_world() -> None:
    wall = box_world([(90, 110, 0, 160)])
    cells = TrueCells(wall, MAPPING)
    assert cells.reachable((20.0, 80.0, 30.0), (180.0, 80.0, 30.0), below=0.0, above=0.0)
    assert cells.reachable((20.0, 80.0, 300.0), (180.0, 80.0, 300.0), below=0.0, above=0.0)
    assert cells.reachable((-500.0, 80.0, 30.0), (180.0, 900.0, 30.0), below=0.0, above=0.0)


def test_a_goal_in_the_solid_is_out_of_reach() -> None:
    cells = TrueCells(box_world([(60, 120, 50, 110)]), MAPPING)
    assert not cells.reachable((20.0, 80.0, 30.0), (90.0, 80.0, 30.0))


def test_from_a_blocked_cell_one_leaves_on_the_side_where_one_is() -> None:
    # 1.2 m beside the yard's inner wall: blocked by inflation; the nearest free cell is inside.
    cells = TrueCells(courtyard(), MAPPING)
    beside_wall = (71.2, 80.0, 40.0)
    assert cells.reachable(beside_wall, (90.0, 80.0, 40.0), below=0.0, above=0.0)
    assert not cells.reachable(beside_wall, (20.0, 80.0, 40.0), below=0.0, above=0.0)


def test_wrong_drops_are_found_and_right_ones_left_alone() -> None:
    where = {"position": (20.0, 80.0, 40.0)}
    inside = event(0, "dropped", "unreachable", goal=(90.0, 80.0, 40.0), **where)
    in_wall = event(1, "dropped", "goal_blocked", goal=(65.0, 80.0, 40.0), **where)
    open_field = event(2, "dropped", "unreachable", goal=(180.0, 80.0, 40.0), **where)
    reached = event(3, goal=(180.0, 80.0, 40.0), **where)
    flight = record([inside, in_wall, open_field, reached])
    judge = DropJudge(courtyard(), flight.config)
    for wrong in (judge.wrong_by_the_maps_cells, judge.wrong_by_fine_cells):
        assert wrong(flight) == [open_field]
        assert wrong(record([reached])) == []


def gated(drop: WaypointEntry, radius: float) -> WaypointEntry:
    return dataclasses.replace(drop, gate_radius=radius)


def test_a_drop_is_wrong_if_any_of_its_gate_can_be_reached() -> None:
    # The point lies in the wall, 5 m from its outer face; the yard behind it is closed.
    drop = event(0, "dropped", "unreachable", goal=(65.0, 80.0, 40.0), position=(20.0, 80.0, 40.0))
    judge = DropJudge(courtyard(), record().config)
    wrongs = (judge.wrong_by_the_maps_cells, judge.wrong_by_fine_cells)
    for radius, wrong in ((0.0, False), (2.8, False), (4.0, False), (12.0, True)):
        flight = record([gated(drop, radius)])
        assert [bool(judged(flight)) for judged in wrongs] == [wrong, wrong], radius
    # Amid the yard a gate of 12 m has free cells enough, but no way leads to any of them.
    inside = event(
        0, "dropped", "unreachable", goal=(90.0, 80.0, 40.0), position=(20.0, 80.0, 40.0)
    )
    assert all(judged(record([gated(inside, 12.0)])) == [] for judged in wrongs)
    assert all(judged(record([gated(inside, 45.0)])) != [] for judged in wrongs)


@pytest.mark.parametrize("seed", range(3))
def test_a_region_is_reachable_where_one_of_its_cells_is(seed: int) -> None:
    world = random_world(seed)
    cells, fine = TrueCells(world, MAPPING), FineCells(world, radius=1.0)
    rng, answers = np.random.default_rng(seed), []
    for _ in range(12):
        start, goal = (np.array([*rng.uniform(20, 100, 2), 18.0]) for _ in range(2))
        radius = float(rng.uniform(2.0, 7.0))
        spots = {edge: spots_round(goal, radius, edge) for edge in (2.0, 0.5)}
        one_by_one = any(cells.reachable(start, spot, above=0.0) for spot in spots[2.0])
        assert cells.reachable(start, goal, above=0.0, radius=radius) == one_by_one
        answers.append(one_by_one)
        some = [spots[0.5][i] for i in rng.integers(len(spots[0.5]), size=10)]
        if any(fine.reachable(start, spot, above=0.0) for spot in some):
            assert fine.reachable(start, goal, above=0.0, radius=radius)
    assert set(answers) == {True, False}


def spots_round(goal: np.ndarray, radius: float, edge: float) -> list[np.ndarray]:
    """A point, and the centres of the cells near it, at its height."""
    first = np.floor((goal[:2] - radius) / edge)
    found = [first + step for step in np.ndindex(2 * (math.ceil(2 * radius / edge) + 1,))]
    centres = [np.array([*(edge * (cell + 0.5)), goal[2]]) for cell in found]
    return [goal, *(c for c in centres if np.linalg.norm(c - goal) <= radius)]


def test_the_fine_judge_sees_a_gap_that_the_maps_cells_close() -> None:
    # Of the courtyard's wall 4 m are missing: open for a radius of 1 m, shut for cells of 2 m that
    # are inflated by 1 m.
    world = courtyard()
    surface = world.surface.copy()
    surface[60:70, 78:82] = 0.0
    world = dataclasses.replace(world, surface=surface)
    drop = event(0, "dropped", "unreachable", goal=(90.0, 80.0, 40.0), position=(20.0, 80.0, 40.0))
    judge = DropJudge(world, record().config)
    assert judge.wrong_by_the_maps_cells(record([drop])) == []
    assert judge.wrong_by_fine_cells(record([drop])) == [drop]


def labels_of_levels(world: World, height: int, pad: int) -> np.ndarray:
    """Blocked cells of 0.5 m, by dilation: of all within 1 m, gaps of 0, 1 and 2 cells."""
    solid = np.zeros((*(2 * n + 2 * pad for n in world.shape), height), dtype=bool)
    tops = np.kron(world.surface, np.ones((2, 2)))
    solid[pad:-pad, pad:-pad] = 0.5 * np.arange(height) < tops[..., None]
    gaps = np.maximum(np.abs(np.mgrid[-3:4, -3:4, -3:4]) - 1, 0) * 0.5
    return ndimage.binary_dilation(solid, np.square(gaps).sum(axis=0) <= 1.0)


@pytest.mark.parametrize("above", [0.0, 8.0, math.inf])
def test_fine_cells_reach_what_labels_at_every_level_reach(above: float) -> None:
    answers = []
    pad, height = 12, 80
    for seed in range(3):
        blocks = random_world(seed)
        part = {name: getattr(blocks, name)[:70, :60] for name in ("ground", "surface", "classes")}
        world = dataclasses.replace(blocks, **part)
        cells = FineCells(world, radius=1.0)
        blocked = labels_of_levels(world, height, pad)
        rng = np.random.default_rng(seed)
        free = np.argwhere(~blocked[pad:-pad, pad:-pad, :12])  # low, where yards are closed
        for a, b in free[rng.integers(len(free), size=(15, 2))]:
            low = min(a[2], b[2])
            high = int(min(height - 1, max(a[2], b[2]) + min(above, 1e3) * 2))
            labels, _ = ndimage.label(~blocked[:, :, low : high + 1])
            i, j = (tuple(np.add(end, (pad, pad, -low))) for end in (a, b))
            found = cells.reachable((a + 0.5) * 0.5, (b + 0.5) * 0.5, above=above)
            assert found == (labels[i] == labels[j])
            answers.append(found)
    assert len(answers) == 45 and (set(answers) == {True, False} or above > 0.0)


def test_a_window_off_the_lattice_is_refused() -> None:
    strange = event(0, "dropped", "unreachable", goal=(90.0, 80.0, 40.0))
    object.__setattr__(strange, "window_origin", (0.7, 0.0, 0.0))
    with pytest.raises(ValueError, match="window_origin"):
        DropJudge(courtyard(), record().config).wrong_by_the_maps_cells(record([strange]))


def test_the_penalty_of_a_flight_is_equation_5() -> None:
    options = PlannerOptions(weights=PenaltyWeights(length=0.5, priority=2.0))
    flight = record(length=60.0, planner_options=options)
    assert flown_penalty(flight) == pytest.approx(0.5 * 60.0 / 50.0 - 2.0 * 0.75)
    assert end_distance(flight) == 0.0
    away = dataclasses.replace(flight, positions=np.add(flight.positions, (3.0, 0.0, 4.0)))
    assert end_distance(away) == pytest.approx(5.0)  # its height counts


def test_time_statistics() -> None:
    seconds = np.array([0.004, 0.001, 0.002, 0.003])
    statistics = TimeStatistics.of(seconds)
    assert statistics is not None
    assert statistics.mean == pytest.approx(0.0025)
    assert statistics.median == pytest.approx(0.0025)
    assert statistics.p95 == pytest.approx(np.quantile(seconds, 0.95))
    assert TimeStatistics.of(np.array([])) is None


def test_a_row_holds_what_the_record_says() -> None:
    drop = event(0, "dropped", "unreachable", goal=(180.0, 80.0, 40.0), position=(20.0, 80.0, 40.0))
    flight = record([drop, event(1)], seconds=(0.001, 0.003))
    flight.reason = "2 of 3"
    scenario = Scenario(4, 9, flight.global_path, crosses_building=True)
    judge = DropJudge(courtyard(), flight.config)
    row = flight_row(flight, scenario, "abc", 1.5, judge)
    assert (row.key, row.scenario, row.seed, row.crosses_building) == ("abc", 4, 9, True)
    assert (row.waypoints, row.reached, row.dropped) == (2, 1, 1)
    assert (row.dropped_unreachable, row.dropped_goal_blocked, row.wrongly_dropped) == (1, 0, 1)
    assert row.wrongly_dropped_fine == 1
    assert (row.outcome, row.collided, row.plans, row.expanded) == ("reached", False, 2, 14)
    assert row.length_ratio == pytest.approx(60.0 / 50.0)
    assert row.path_distance_mean == row.path_distance_max == 0.0  # along the global path itself
    assert row.reason == "2 of 3"
    assert row.plan_times == [1.0, 3.0]
    assert (row.time_plan_mean, row.time_plan_median, row.time_flight) == (2.0, 2.0, 1.5)
    unplanned = flight_row(record(seconds=()), scenario, "abc", 1.5, judge)
    assert unplanned.time_plan_mean is None and unplanned.plan_times == []
