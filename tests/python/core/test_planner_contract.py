# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""One contract for every planner, from Python: random worlds, wrong arguments, what results own."""

import gc
import itertools
import math
import re
import threading
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage

import ltp
from ltp import PlanStatus

NAN, INF = math.nan, math.inf
CELL = np.array((2.0, 2.0, 4.0))


def make(name: str, **options: object) -> ltp.Planner:
    """A planner whose curves are few and fit into a small window."""
    bezier = ltp.BezierOptions(offsets=7, reach=8.0, segments=12)
    hermite = ltp.HermiteOptions(segments=12, starts=3, refined=2, iterations=6)
    return ltp.make_planner(name, bezier=bezier, hermite=hermite, **options)


TRAITS = {info.name: info for info in ltp.planners()}
PLANNERS = tuple(TRAITS)
SWEPT = ltp.LinearisedOptions()

# The most that a planner expands in so many cells, where that is more than the cells themselves.
MOST: dict[str, Callable[[int], int]] = {
    "bezier": lambda _: 7 * 7,
    "sweep": lambda cells: SWEPT.searches * cells + SWEPT.closing,
    "exact": lambda cells: cells << 32,  # many labels a cell
    "ara-star": lambda cells: 5 * cells,  # weights 3, 2.5, ... 1
    "tangent-bug": lambda cells: 8 * cells + 8,  # looks, in two planes
    "hermite": lambda _: 3 * 3 + 2 * 6 * 16,
    "auto": lambda cells: SWEPT.searches * cells + SWEPT.closing,
}


def scene_of(blocked: np.ndarray, seed: int = 0) -> ltp.Scene:
    frame = ltp.GridFrame((0, 0, 0), CELL, blocked.shape)
    priority = np.random.default_rng(seed).random(blocked.shape[:2])
    return ltp.Scene(ltp.OccupancyGrid.from_array(blocked, frame), ltp.Raster(priority, cell=2.0))


def centre(*cell: int) -> np.ndarray:
    return (np.array(cell) + 0.5) * CELL


def passes_through(blocked: np.ndarray, path: np.ndarray, shrunk: float) -> bool:
    """Whether a segment meets the box of a blocked cell, made smaller on all sides [m]."""
    for low in np.argwhere(blocked) * CELL + shrunk:
        high = low + CELL - 2 * shrunk
        for a, b in itertools.pairwise(path):
            enter, leave = 0.0, 1.0
            for axis in range(3):
                delta = b[axis] - a[axis]
                if delta == 0:
                    if not low[axis] <= a[axis] <= high[axis]:
                        leave = -1.0
                    continue
                t = sorted(((low[axis] - a[axis]) / delta, (high[axis] - a[axis]) / delta))
                enter, leave = max(enter, t[0]), min(leave, t[1])
            if enter <= leave:
                return True
    return False


def test_the_planners_are_those_of_the_paper_and_the_new_ones() -> None:
    assert PLANNERS[:5] == ("lp-dijkstra", "lp-a-star", "wlp-a-star", "ggwp", "bezier")
    assert {name for name, info in TRAITS.items() if info.family == "paper"} == set(PLANNERS[:5])
    assert ltp.PLANNERS == PLANNERS
    assert [make(name).name for name in PLANNERS] == list(PLANNERS)
    assert {n: make(n).complete for n in PLANNERS} == {n: t.complete for n, t in TRAITS.items()}
    with pytest.raises(ValueError, match=r"^planner = 'a-star': expected one of lp-dijkstra, "):
        ltp.make_planner("a-star")


@pytest.mark.parametrize("name", PLANNERS)
@settings(deadline=None, max_examples=120)
@given(
    shape=st.tuples(st.integers(1, 7), st.integers(1, 7), st.integers(1, 5)),
    density=st.sampled_from([0.0, 0.2, 0.4, 0.6]),
    where=st.tuples(*[st.sampled_from([0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 0.999999])] * 6),
    band=st.sampled_from([(INF, INF), (0.0, 0.0), (0.0, 4.0), (1.5, 2.7), (5.0, INF)]),
    seed=st.integers(0, 2**32 - 1),
    refine=st.booleans(),
)
def test_random_worlds(
    name: str,
    shape: tuple[int, int, int],
    density: float,
    where: tuple[float, ...],
    band: tuple[float, float],
    seed: int,
    refine: bool,
) -> None:
    blocked = np.random.default_rng(seed).random(shape) < density
    start, goal = (np.array(w) * shape * CELL for w in (where[:3], where[3:]))
    first, last = (tuple(np.floor(p / CELL).astype(int)) for p in (start, goal))
    scene, query = scene_of(blocked, seed), ltp.Query(start, goal, band)
    planner = make(name, refine=refine)
    plan = planner.plan(scene, query)

    low, high = sorted((start[2], goal[2]))
    # A level that the band only touches is not open, unless an end lies in it.
    lowest = max(0, math.floor(max(-1.0, low - band[0] + 1e-9) / CELL[2]))
    highest = min(shape[2] - 1, math.floor(min(1e6, high + band[1] - 1e-9) / CELL[2]))
    lowest, highest = min(lowest, first[2], last[2]), max(highest, first[2], last[2])
    if blocked[last]:
        assert plan.status == PlanStatus.GOAL_BLOCKED
    elif blocked[first]:
        assert plan.status == PlanStatus.START_BLOCKED
    else:
        free = ~blocked
        free[:, :, :lowest] = free[:, :, highest + 1 :] = False
        wet, _ = ndimage.label(free)
        if wet[first] != wet[last]:
            failure = PlanStatus.UNREACHABLE if planner.complete else PlanStatus.NONE_FOUND
            assert plan.status == failure
        elif planner.complete:
            assert plan.status == PlanStatus.FOUND
    if plan.status != PlanStatus.FOUND:
        assert plan.path.shape == (0, 3)
        assert plan.penalty == INF
        return

    np.testing.assert_array_equal(plan.path[0], start)
    np.testing.assert_array_equal(plan.path[-1], goal)
    cells = np.floor(plan.path / CELL)
    assert (cells >= (0, 0, lowest)).all()
    assert (cells <= np.array((*shape[:2], highest + 1)) - 1).all()
    assert plan.path[:, 2].min() >= low - band[0] - 1e-9
    assert plan.path[:, 2].max() <= high + band[1] + 1e-9
    assert (plan.bound is not None) == TRAITS[name].bounds
    assert not passes_through(blocked, plan.path, shrunk=1e-9)
    again = ltp.tally(
        plan.path, ltp.Raster(np.random.default_rng(seed).random(shape[:2]), cell=2.0)
    )
    assert (plan.tally.length, plan.tally.priority) == (again.length, again.priority)
    direct = math.dist(start, goal)
    if direct > 0:
        assert plan.penalty == pytest.approx(ltp.penalty(again, direct), rel=1e-12)
    else:
        assert plan.tally.length == 0
    assert plan.stats.expanded <= MOST.get(name, int)(blocked.size)
    twice = (make(name, refine=refine) if TRAITS[name].remembers else planner).plan(scene, query)
    assert twice.path.tobytes() == plan.path.tobytes()
    assert twice.penalty == plan.penalty


@pytest.mark.parametrize("name", PLANNERS)
def test_a_goal_outside_the_window_is_a_status(name: str) -> None:
    scene = scene_of(np.zeros((4, 4, 2), bool))
    here = centre(1, 1, 0)
    for far in ((8.0, 1, 1), (-1e-9, 1, 1), (1, 1, 8), (1e300, 1, 1), (1, -1e15, 1)):
        assert make(name).plan(scene, ltp.Query(here, far)).status == PlanStatus.OUTSIDE_MAP
        assert make(name).plan(scene, ltp.Query(far, here)).status == PlanStatus.OUTSIDE_MAP


@pytest.mark.parametrize("name", PLANNERS)
def test_a_wrong_query_is_an_error_that_names_it(name: str) -> None:
    scene = scene_of(np.zeros((4, 4, 2), bool))
    good = {"start": centre(0, 0, 0), "goal": centre(3, 3, 1), "band": (0.0, INF)}
    planner = make(name)
    for argument, value, text in [
        ("start", (NAN, 1, 1), r"^start = "),
        ("start", (1, INF, 1), r"^start = "),
        ("goal", (1, 1, NAN), r"^goal = "),
        ("goal", (-INF, 1, 1), r"^goal = "),
        ("band", (-1.0, 0.0), r"^band.below = -1"),
        ("band", (0.0, -0.5), r"^band.above = -0.5"),
        ("band", (NAN, 0.0), r"^band.below = nan"),
        ("band", (0.0, NAN), r"^band.above = nan"),
    ]:
        with pytest.raises(ValueError, match=text):
            planner.plan(scene, ltp.Query(**(good | {argument: value})))
    for argument, value in [
        ("start", (1, 2)),
        ("goal", np.zeros((2, 3))),
        ("start", "abc"),
        ("goal", None),
        ("band", 3.0),
        ("band", (1, 2, 3)),
        ("bend", (1, 2)),
    ]:
        with pytest.raises((TypeError, ValueError)):
            ltp.Query(**(good | {argument: value}))
    for wrong in [(None, ltp.Query(**good)), (scene, None), (scene,)]:
        with pytest.raises(TypeError):
            planner.plan(*wrong)
    assert planner.plan(scene, ltp.Query(**good)).status == PlanStatus.FOUND


@pytest.mark.parametrize("name", PLANNERS)
def test_a_wrong_option_is_an_error_that_names_it(name: str) -> None:
    for option, value in [("length", -1.0), ("length", NAN), ("priority", INF)]:
        weights = ltp.PenaltyWeights(**{option: value})
        with pytest.raises(ValueError, match=rf"^weights\.{option} = "):
            ltp.make_planner(name, weights=weights)
    for option, value in [
        ("bezier.offsets", 4),
        ("bezier.reach", -1.0),
        ("bezier.z_offsets", 0),
        ("bezier.z_reach", NAN),
        ("bezier.segments", 1),
        ("ara.first_weight", 0.5),
        ("ara.step", 0.0),
        ("risk.length_factor", -0.1),
        ("tangent_bug.range", NAN),
        ("hermite.segments", 1),
        ("hermite.starts", 2),
        ("hermite.reach", INF),
        ("hermite.refined", 0),
        ("hermite.iterations", -1),
    ]:
        group, field = option.split(".")
        kind = "".join(word.capitalize() for word in group.split("_")) + "Options"
        options = getattr(ltp, kind)(**{field: value})
        with pytest.raises(ValueError, match=rf"^{option} = "):
            ltp.make_planner(name, **{group: options})
    with pytest.raises(TypeError, match="length_wieght"):
        ltp.make_planner(name, length_wieght=1.0)
    for option in ("weights", "refine", "bezier"):
        with pytest.raises(TypeError):
            ltp.make_planner(name, **{option: "much"})


@pytest.mark.parametrize("name", PLANNERS)
def test_a_budget_ends_the_search(name: str) -> None:
    blocked = np.zeros((9, 9, 3), bool)
    blocked[4, :8] = True
    scene, query = scene_of(blocked), ltp.Query(centre(1, 1, 1), centre(7, 1, 1))
    needed = make(name).plan(scene, query).stats.expanded
    stopped = make(name).plan(scene, query, ltp.Budget(max_expansions=needed - 1))
    assert stopped.stats.expanded == needed - 1
    if TRAITS[name].anytime and stopped.status == PlanStatus.FOUND:  # it keeps what it has
        stopped = make(name).plan(scene, query, ltp.Budget(max_expansions=3))
    assert stopped.status == PlanStatus.OUT_OF_BUDGET
    enough = ltp.Budget(max_expansions=needed + 1)
    assert make(name).plan(scene, query, enough).status != stopped.status


@pytest.mark.parametrize("name", PLANNERS)
def test_a_time_limit_ends_the_search(name: str) -> None:
    blocked = np.zeros((60, 60, 10), bool)
    blocked[30] = True  # a wall from edge to edge: whichever side a proof begins at, it is long
    scene, query = scene_of(blocked), ltp.Query(centre(3, 30, 3), centre(50, 30, 5))
    whole, late = ltp.make_planner(name), ltp.make_planner(name)
    expected = whole.plan(scene, query)
    stopped = late.plan(scene, query, ltp.Budget(time_limit=1e-9))
    assert stopped.status == PlanStatus.OUT_OF_BUDGET
    assert stopped.stats.expanded < expected.stats.expanded
    assert stopped.path.shape == (0, 3)
    # It is as good as new, and time enough changes nothing.
    again = late.plan(scene, query, budget=ltp.Budget(time_limit=600.0))
    assert (again.status, again.stats.expanded) == (expected.status, expected.stats.expanded)


@pytest.mark.parametrize("name", [name for name in PLANNERS if TRAITS[name].anytime])
def test_an_anytime_planner_keeps_its_path_when_the_budget_ends(name: str) -> None:
    blocked = np.zeros((60, 60, 10), bool)
    blocked[30] = True
    blocked[30, 0, 0] = False  # a hole in the wall, far from the straight line
    scene, query = scene_of(blocked), ltp.Query(centre(3, 30, 3), centre(50, 30, 5))
    whole = make(name).plan(scene, query)
    ends = np.linspace(1000, whole.stats.expanded + 1, 12, dtype=int).tolist()
    plans = [make(name).plan(scene, query, ltp.Budget(max_expansions=n)) for n in ends]
    assert [plan.stats.expanded for plan in plans[:-1]] == ends[:-1]
    found = [plan for plan in plans if plan.status == PlanStatus.FOUND]
    first = len(plans) - len(found)
    assert {plan.status for plan in plans[:first]} == {PlanStatus.OUT_OF_BUDGET}
    assert 2 < len(found) < len(plans)
    penalties = [plan.penalty for plan in found]
    assert penalties == sorted(penalties, reverse=True)  # more effort, no worse path
    assert penalties[-1] == whole.penalty


@pytest.mark.parametrize("name", PLANNERS)
def test_a_wrong_limit_is_an_error_that_names_it(name: str) -> None:
    scene, query = scene_of(np.zeros((4, 4, 2), bool)), ltp.Query(centre(0, 0, 0), centre(3, 3, 1))
    wrong = [("max_expansions", -1), *(("time_limit", value) for value in (-0.1, INF, NAN))]
    for limit, value in wrong:
        with pytest.raises(ValueError, match=rf"^{limit} = "):
            make(name).plan(scene, query, ltp.Budget(**{limit: value}))
    for no_budget in (3, {"time_limit": 1.0}):
        with pytest.raises(TypeError):
            make(name).plan(scene, query, no_budget)


def test_the_registry_is_what_the_document_lists() -> None:
    text = (Path(__file__).parents[3] / "docs/planners.md").read_text()
    for info in ltp.planners():
        row = rf"\| \**`{info.name}`\** \|"
        rows = [line for line in text.splitlines() if re.match(row, line)]
        assert len(rows) == 1, info.name
        assert make(info.name).info.name == info.name
    listed = re.findall(r"^\| \**`([^`]+)`\** \|", text, re.MULTILINE)
    assert sorted(listed) == sorted(PLANNERS)


@pytest.mark.parametrize(("old", "new"), [("pareto", "exact"), ("bug", "tangent-bug")])
def test_an_old_name_of_a_planner_warns(old: str, new: str) -> None:
    with pytest.warns(DeprecationWarning, match=f"the planner '{old}' is now '{new}'"):
        assert ltp.make_planner(old).name == new
    with pytest.warns(DeprecationWarning, match=f"the planner '{old}' is now '{new}'"):
        assert ltp.MissionConfig(planner=old).planner == new


@pytest.mark.parametrize("name", PLANNERS)
def test_scenes_keep_their_parts_and_plans_their_paths(name: str) -> None:
    scene = ltp.Scene(
        ltp.OccupancyGrid(ltp.GridFrame((0, 0, 0), CELL, (40, 40, 10))),
        ltp.Raster(np.full((40, 40), 0.5), cell=2.0),
    )
    gc.collect()
    plan = make(name).plan(scene, ltp.Query(centre(1, 1, 1), centre(38, 35, 8)))
    assert plan.status == PlanStatus.FOUND
    assert plan.tally.mean_priority == pytest.approx(0.5)
    path = plan.path
    copy = path.copy()
    assert (path.dtype, path.flags.c_contiguous) == (np.float64, True)
    text = repr(plan)
    assert "FOUND" in text
    assert f"length={plan.tally.length}" in text
    del plan, scene
    gc.collect()
    noise = [np.random.default_rng(i).random((len(copy), 3)) for i in range(50)]
    np.testing.assert_array_equal(path, copy)
    assert len(noise) == 50


@pytest.mark.parametrize("name", PLANNERS)
def test_threads_take_turns_with_a_planner(name: str) -> None:
    rng = np.random.default_rng(1)
    planner = make(name)
    tasks = []
    for seed in range(4):
        blocked = rng.random((20, 20, 4 + seed)) < 0.2
        blocked[1, 1, 1] = blocked[18, 17, 2] = False
        tasks.append((scene_of(blocked, seed), ltp.Query(centre(1, 1, 1), centre(18, 17, 2))))
    alone = [make(name).plan(*task) for task in tasks]
    together: list[list[ltp.Plan]] = [[] for _ in tasks]

    def work(number: int) -> None:
        together[number] = [planner.plan(*tasks[number]) for _ in range(20)]

    threads = [threading.Thread(target=work, args=(n,)) for n in range(len(tasks))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for expected, plans in zip(alone, together, strict=True):
        assert len(plans) == 20
        for plan in plans:
            assert plan.status == expected.status
            if TRAITS[name].remembers:
                continue
            assert plan.path.tobytes() == expected.path.tobytes()
            assert plan.stats.expanded == expected.stats.expanded


def test_a_flood_needs_a_start_inside() -> None:
    grid = ltp.OccupancyGrid(ltp.GridFrame((0, 0, 0), CELL, (4, 4, 2)))
    assert ltp.flood_fill(grid, ltp.Query(centre(0, 0, 0), centre(3, 3, 1))).all()
    with pytest.raises(ValueError, match=r"^from = "):
        ltp.flood_fill(grid, ltp.Query((100, 0, 0), centre(3, 3, 1)))
    for bad in ((NAN, 0, 0), (INF, 0, 0)):
        with pytest.raises(ValueError, match=r"^start = "):
            ltp.flood_fill(grid, ltp.Query(bad, centre(3, 3, 1)))
        with pytest.raises(ValueError, match=r"^goal = "):
            ltp.flood_fill(grid, ltp.Query(centre(3, 3, 1), bad))


def test_no_status_turns_into_a_bool_by_itself() -> None:
    members = [*PlanStatus.__members__.values(), *ltp.NavigationStatus.__members__.values()]
    assert len(members) == 7 + 4
    for status in members:
        with pytest.raises(TypeError, match="has no truth value"):
            bool(status)
        assert status == type(status)(int(status))
        assert (status == 0) is False
        assert {status: 1}[status] == 1
