# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The planners against scipy's Dijkstra and against the paper's search written out slowly."""

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import pytest
from scipy import ndimage, sparse
from scipy.sparse import csgraph

import ltp

CELLS = [(2.0, 2.0, 4.0), (1.0, 1.0, 1.0), (3.0, 1.0, 2.0)]
HALF_THE_STEPS = [s for s in itertools.product((-1, 0, 1), repeat=3) if s > (0, 0, 0)]
LP_PLANNERS = {"lp-dijkstra": 0.0, "lp-a-star": 1.0, "wlp-a-star": math.sqrt(3)}
OUR_PLANNERS = ["additive", "sweep", "exact", "ara-star", "auto"]
GRID_PLANNERS = [*LP_PLANNERS, "ggwp", *OUR_PLANNERS, "risk-a-star"]
Cell = tuple[int, int, int]


@dataclass
class Puzzle:
    """A random grid, a start and a goal at centres of free cells."""

    blocked: np.ndarray
    cell: tuple[float, float, float]
    start: Cell
    goal: Cell
    priority: np.ndarray  # one value a column

    @classmethod
    def random(cls, rng: np.random.Generator, shape: Cell = (8, 7, 5)) -> "Puzzle":
        blocked = rng.random(shape) < rng.uniform(0.1, 0.65)
        start, goal = (tuple(int(rng.integers(n)) for n in shape) for _ in range(2))
        blocked[start] = blocked[goal] = False
        cell = CELLS[rng.integers(len(CELLS))]
        return cls(blocked, cell, start, goal, rng.random(shape[:2]))

    @property
    def grid(self) -> ltp.OccupancyGrid:
        frame = ltp.GridFrame((-3, 5, 1), self.cell, self.blocked.shape)
        return ltp.OccupancyGrid.from_array(self.blocked, frame)

    @property
    def raster(self) -> ltp.Raster:
        # Its cells are squares: the columns are cut into squares of 1 m.
        x, y = int(self.cell[0]), int(self.cell[1])
        values = np.repeat(np.repeat(self.priority, x, axis=0), y, axis=1)
        return ltp.Raster(values, origin=(-3, 5), cell=1.0)

    @property
    def scene(self) -> ltp.Scene:
        return ltp.Scene(self.grid, self.raster)

    def centre(self, cell: Cell) -> np.ndarray:
        return np.array((-3, 5, 1)) + (np.array(cell) + 0.5) * self.cell

    def query(self, band: tuple[float, float] = (math.inf, math.inf)) -> ltp.Query:
        return ltp.Query(self.centre(self.start), self.centre(self.goal), band)


def graph(blocked: np.ndarray, cell: tuple[float, float, float]) -> sparse.csr_matrix:
    """Steps to 26 neighbours, each legal if every cell of its bounding box is free."""
    free = np.pad(~blocked, 1)
    index = np.pad(np.arange(blocked.size).reshape(blocked.shape), 1)

    def moved(array: np.ndarray, step: tuple[int, ...]) -> np.ndarray:
        return array[
            tuple(slice(1 + d, n + 1 + d) for d, n in zip(step, blocked.shape, strict=True))
        ]

    rows, columns, lengths = [], [], []
    for step in HALF_THE_STEPS:
        legal = np.ones(blocked.shape, bool)
        for part in itertools.product(*[{0, d} for d in step]):
            legal &= moved(free, part)
        rows.append(moved(index, (0, 0, 0))[legal])
        columns.append(moved(index, step)[legal])
        lengths.append(np.full(legal.sum(), np.linalg.norm(np.multiply(step, cell))))
    entries = (np.concatenate(lengths), (np.concatenate(rows), np.concatenate(columns)))
    return sparse.coo_matrix(entries, shape=(blocked.size, blocked.size)).tocsr()


def shortest_length(puzzle: Puzzle, planar: bool) -> float:
    blocked = puzzle.blocked.copy()
    if planar:
        levels = np.arange(blocked.shape[2])
        blocked[:, :, levels != puzzle.start[2]] = True
    goal, start = (np.ravel_multi_index(c, blocked.shape) for c in (puzzle.goal, puzzle.start))
    lengths = csgraph.dijkstra(graph(blocked, puzzle.cell), directed=False, indices=goal)
    return float(lengths[start])


def flooded(puzzle: Puzzle, planar: bool) -> bool:
    """Whether a flood over faces from the start wets the goal."""
    free = ~puzzle.blocked
    if planar:
        free = free[:, :, puzzle.start[2]]
    labels, _ = ndimage.label(free)
    places = [c[: labels.ndim] for c in (puzzle.start, puzzle.goal)]
    return bool(labels[places[0]] == labels[places[1]])


def test_on_1000_random_grids_lengths_are_scipys_and_reachability_is_a_floods() -> None:
    rng = np.random.default_rng(2)
    # W_L = 1, so that Eq. (9) is the length that it estimates.
    shortest = ltp.PenaltyWeights(length=1.0, priority=0.0)
    planners = {name: ltp.make_planner(name, weights=shortest) for name in GRID_PLANNERS}
    found = dict.fromkeys(planners, 0)
    longer = dict.fromkeys(planners, 0)
    sealed = 0
    for number in range(1000):
        puzzle = Puzzle.random(rng)
        planar = number % 4 == 0
        if planar:
            puzzle.goal = (*puzzle.goal[:2], puzzle.start[2])
            puzzle.blocked[puzzle.goal] = False
        scene, query = puzzle.scene, puzzle.query((0, 0) if planar else (math.inf, math.inf))
        shortest = shortest_length(puzzle, planar)
        reachable = flooded(puzzle, planar)
        assert reachable == math.isfinite(shortest)
        wet = ltp.flood_fill(puzzle.grid, query)
        assert wet[puzzle.goal] == reachable
        sealed += not reachable
        steps = [s for s in HALF_THE_STEPS if not (planar and s[2])]
        step_lengths = [float(np.linalg.norm(np.multiply(s, puzzle.cell))) for s in steps]
        bounds = {
            "lp-dijkstra": 1.0,
            "lp-a-star": 1.0,
            "wlp-a-star": math.sqrt(3),
            "ggwp": max(step_lengths) / min(step_lengths),
            **dict.fromkeys(OUR_PLANNERS, 1.0),
            # A metre costs 0.1 to 1.1.
            "risk-a-star": 11.0,
        }
        for name, planner in planners.items():
            plan = planner.plan(scene, query)
            assert (plan.status == ltp.PlanStatus.FOUND) == reachable, (number, name)
            if not reachable:
                assert plan.status == ltp.PlanStatus.UNREACHABLE
                continue
            length = plan.tally.length
            assert shortest * (1 - 1e-12) <= length, (number, name)
            assert length <= shortest * bounds[name] * (1 + 1e-12), (number, name)
            found[name] += 1
            longer[name] += length > shortest * (1 + 1e-9)
    assert min(found.values()) == max(found.values()) == 1000 - sealed
    assert sealed > 100
    exact = ("lp-dijkstra", "lp-a-star", *OUR_PLANNERS)
    assert [longer[name] for name in exact] == [0] * len(exact)
    assert longer["ggwp"] > 0
    assert longer["wlp-a-star"] > 0


def test_the_distance_field_is_scipys_in_every_cell() -> None:
    rng = np.random.default_rng(7)
    reached = 0
    for number in range(200):
        puzzle = Puzzle.random(rng)
        blocked = puzzle.blocked.copy()
        levels = None
        if number % 2:
            levels = (int(rng.integers(puzzle.start[2] + 1)), puzzle.start[2])
            blocked[:, :, : levels[0]] = blocked[:, :, levels[1] + 1 :] = True
        # Anywhere in its cell.
        source = puzzle.centre(puzzle.start) + rng.uniform(-0.49, 0.49, 3) * puzzle.cell
        field = ltp.distance_field(puzzle.grid, source, levels=levels)
        start = np.ravel_multi_index(puzzle.start, blocked.shape)
        lengths = csgraph.dijkstra(graph(blocked, puzzle.cell), directed=False, indices=start)
        assert (field.dtype, field.shape) == (np.float64, blocked.shape)
        np.testing.assert_allclose(field.ravel(), lengths, rtol=0, atol=1e-9)
        assert np.isinf(field[blocked]).all()
        reached += int(np.isfinite(field).sum())
    assert reached > 5000


def test_a_distance_field_needs_a_source_inside() -> None:
    grid = ltp.OccupancyGrid(ltp.GridFrame((0, 0, 0), (2, 2, 4), (5, 4, 3)))
    assert ltp.distance_field(grid, (1, 1, 2))[4, 0, 0] == 8.0
    for outside in ((-0.1, 1, 2), (1, 8, 2), (1, 1, math.nan), (math.inf, 1, 1)):
        with pytest.raises(ValueError, match=r"^source = "):
            ltp.distance_field(grid, outside)
    with pytest.raises(ValueError, match=r"^source = "):
        ltp.distance_field(grid, (1, 1, 2), levels=(1, 2))
    for wrong in ((-1, 2), (0, 3), (2, 1)):
        with pytest.raises(ValueError, match=r"^levels = "):
            ltp.distance_field(grid, (1, 1, 2), levels=wrong)
    grid = ltp.OccupancyGrid.from_array(np.ones((5, 4, 3), bool), grid.frame)
    field = ltp.distance_field(grid, (1, 1, 2))  # as if its own cell were free
    assert np.flatnonzero(np.isfinite(field)).tolist() == [0]


def literal_search(
    puzzle: Puzzle, w_l: float, w_p: float, w_a: float, scaled: bool
) -> list[Cell] | None:
    """The paper's search with dictionaries: the chain of cells from start to goal.

    One label (L, P) a cell, from the goal; the open cell with the least f = g + W_A* h of Eq. (10)
    is closed for good; among equals the one with the least h, then the first cell.
    """
    l_direct = math.dist(puzzle.centre(puzzle.start), puzzle.centre(puzzle.goal))

    def g(length: float, priority: float) -> float:  # Eq. (8)
        mean = priority / length if length > 0 else puzzle.priority[puzzle.goal[:2]]
        return w_l * (length / l_direct if l_direct > 0 else 1.0) - w_p * mean

    def h(cell: Cell) -> float:  # Eq. (9)
        distance = math.dist(puzzle.centre(cell), puzzle.centre(puzzle.start))
        return distance / l_direct * (w_l if scaled else 1.0) if l_direct > 0 else 0.0

    def legal(cell: Cell, step: Cell) -> bool:
        """Eq. (1), for every cell of the step's bounding box."""
        for part in itertools.product(*[{0, d} for d in step]):
            other = tuple(c + d for c, d in zip(cell, part, strict=True))
            inside = all(0 <= c < n for c, n in zip(other, puzzle.blocked.shape, strict=True))
            if not inside or puzzle.blocked[other]:
                return False
        return True

    labels = {puzzle.goal: (0.0, 0.0)}
    towards_goal: dict[Cell, Cell] = {}
    closed: set[Cell] = set()
    while openly := [c for c in labels if c not in closed]:
        cell = min(openly, key=lambda c: (g(*labels[c]) + w_a * h(c), h(c), c))
        closed.add(cell)
        if cell == puzzle.start:
            chain = [cell]
            while chain[-1] != puzzle.goal:
                chain.append(towards_goal[chain[-1]])
            return chain
        for step in itertools.product((-1, 0, 1), repeat=3):
            if step == (0, 0, 0) or not legal(cell, step):
                continue
            other = tuple(c + d for c, d in zip(cell, step, strict=True))
            if other in closed:
                continue
            length = math.hypot(*np.multiply(step, puzzle.cell))
            mean = 0.5 * (puzzle.priority[cell[:2]] + puzzle.priority[other[:2]])
            label = (labels[cell][0] + length, labels[cell][1] + length * mean)
            # Rounding must not make the label of an equal path the better one.
            if other not in labels or g(*label) < g(*labels[other]) - 1e-12:
                labels[other] = label
                towards_goal[other] = cell
    return None


@pytest.mark.parametrize("name", LP_PLANNERS)
@pytest.mark.parametrize(
    ("w_l", "w_p", "scaled"),
    [(0.5, 1.0, False), (0.5, 1.0, True), (1.0, 5.0, False), (0.2, 0.1, True)],
)
def test_the_papers_search_written_out(name: str, w_l: float, w_p: float, scaled: bool) -> None:
    weights = ltp.PenaltyWeights(length=w_l, priority=w_p)
    planner = ltp.make_planner(name, weights=weights, scaled_heuristic=scaled)
    rng = np.random.default_rng(4)
    found = 0
    for number in range(60):
        puzzle = Puzzle.random(rng, (5, 4, 1 + number % 3))
        plan = planner.plan(puzzle.scene, puzzle.query())
        chain = literal_search(puzzle, w_l, w_p, LP_PLANNERS[name], scaled)
        assert (plan.status == ltp.PlanStatus.FOUND) == (chain is not None)
        if chain is None:
            continue
        path = np.array([puzzle.centre(c) for c in chain])
        direct = math.dist(path[0], path[-1])
        if direct == 0:
            penalty = w_l - w_p * puzzle.priority[puzzle.goal[:2]]
        else:
            tally = ltp.tally(path, puzzle.raster)
            penalty = ltp.penalty(tally, direct, weights)
        assert plan.penalty == pytest.approx(penalty, abs=1e-9), number
        found += 1
    assert found > 30


@pytest.mark.parametrize("new", ["length", "priority"])
def test_the_old_names_of_the_weights_still_make_a_planner(new: str) -> None:
    puzzle = Puzzle.random(np.random.default_rng(4), (5, 4, 1))
    old = f"{new}_weight"
    says = rf"{old}.*weights=PenaltyWeights\({new}="
    with pytest.warns(DeprecationWarning, match=says) as caught:
        planner = ltp.make_planner("lp-a-star", **{old: 3.0})
    assert [warning.filename for warning in caught] == [__file__]
    same = ltp.make_planner("lp-a-star", weights=ltp.PenaltyWeights(**{new: 3.0}))
    plans = [each.plan(puzzle.scene, puzzle.query()) for each in (planner, same)]
    assert plans[0].penalty == plans[1].penalty
    assert plans[0].status == ltp.PlanStatus.FOUND


def test_the_label_is_the_tally() -> None:
    """From centre to centre, over one priority a column, Eq. (8) at the start is Eq. (5)."""
    rng = np.random.default_rng(5)
    for _ in range(50):
        puzzle = Puzzle.random(rng)
        plan = ltp.make_planner("lp-a-star").plan(puzzle.scene, puzzle.query())
        if plan.status != ltp.PlanStatus.FOUND or len(plan.path) < 3:
            continue
        columns = [tuple(puzzle.grid.frame.cell_of(p)[:2]) for p in plan.path]
        steps = np.linalg.norm(np.diff(plan.path, axis=0), axis=1)
        means = [
            0.5 * (puzzle.priority[a] + puzzle.priority[b]) for a, b in itertools.pairwise(columns)
        ]
        assert plan.tally.priority == pytest.approx(float(steps @ means), rel=1e-12)


# --- Hollow houses: only their surfaces are sensed, so their insides count as free.

BOX = np.array([20.0, 20.0, 30.0])
WINDOW = (26, 26, 16)


def surface_points(centre: np.ndarray, yaw: float) -> np.ndarray:
    """Points every 0.25 m on the six faces of a box, its edges included, world frame [m]."""
    axes = [np.linspace(-0.5, 0.5, round(s / 0.25) + 1) * s for s in BOX]
    faces = []
    for axis in range(3):
        for side in (-0.5, 0.5):
            sides = [*axes[:axis], np.array([side * BOX[axis]]), *axes[axis + 1 :]]
            faces.append(np.stack(np.meshgrid(*sides, indexing="ij"), axis=-1).reshape(-1, 3))
    turn = np.array(
        [[math.cos(yaw), -math.sin(yaw), 0], [math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]]
    )
    return centre + np.concatenate(faces) @ turn.T


def plain_grid(points: np.ndarray, centre: np.ndarray, radius: float) -> ltp.OccupancyGrid:
    """The cells that hold a point; within 1 m of one lie its 26 neighbours and no other cell."""
    cell = np.array((2.0, 2.0, 4.0))
    origin = np.floor(centre / cell) * cell - np.array(WINDOW) // 2 * cell
    occupied = np.zeros(WINDOW, bool)
    occupied[tuple(np.floor((points - origin) / cell).astype(int).T)] = True
    if radius == 1.0:
        occupied = ndimage.binary_dilation(occupied, np.ones((3, 3, 3)))
    return ltp.OccupancyGrid.from_array(occupied, ltp.GridFrame(origin, cell, WINDOW))


def mapped_grid(points: np.ndarray, centre: np.ndarray, radius: float) -> ltp.OccupancyGrid:
    """What the obstacle map makes of a scan from inside."""
    options = ltp.ObstacleMapOptions(dims=WINDOW, inflation_radius=radius)
    obstacles = ltp.ObstacleMap(options, centre)
    obstacles.insert(centre, points)
    return obstacles.blocked


@pytest.mark.parametrize("radius", [0.0, 1.0])
@pytest.mark.parametrize("make_grid", [plain_grid, mapped_grid])
def test_no_planner_gets_into_200_hollow_boxes(
    make_grid: Callable[[np.ndarray, np.ndarray, float], ltp.OccupancyGrid], radius: float
) -> None:
    rng = np.random.default_rng(6)
    planners = [ltp.make_planner(n) for n in GRID_PLANNERS]
    planners.append(ltp.make_planner("bezier", bezier=ltp.BezierOptions(offsets=5, reach=30.0)))
    hermite = ltp.HermiteOptions(segments=16, starts=3, refined=1, iterations=6)
    planners += [ltp.make_planner("tangent-bug"), ltp.make_planner("hermite", hermite=hermite)]
    priority = ltp.Raster(np.ones((1, 1)), outside=1.0)
    for number in range(200):
        centre = rng.uniform((-500, -500, 20), (500, 500, 100))
        points = surface_points(centre, rng.uniform(0, 2 * math.pi))
        grid = make_grid(points, centre, radius)
        goal = centre + rng.uniform(-3, 3, 3)
        start = np.array(grid.frame.centre((0, int(rng.integers(WINDOW[1])), WINDOW[2] // 2)))
        assert not grid.blocked_at(np.stack([start, goal])).any()
        scene = ltp.Scene(grid, priority)
        for planner in planners:
            for a, b in ((start, goal), (goal, start)):
                plan = planner.plan(scene, ltp.Query(a, b))
                failure = "UNREACHABLE" if planner.complete else "NONE_FOUND"
                assert plan.status == ltp.PlanStatus.__members__[failure], (number, planner.name)
                assert len(plan.path) == 0
    # The same with a hole in the wall: then they find their way in.
    away = np.linalg.norm(points - points[len(points) // 20], axis=1)
    opened = ltp.Scene(make_grid(points[away > 9.0], centre, radius), priority)
    for planner in planners[: len(GRID_PLANNERS)]:
        assert planner.plan(opened, ltp.Query(start, goal)).status == ltp.PlanStatus.FOUND
