# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The map of a planner that flies: who may change it, and that a change wakes a holding UAV."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import ltp

START = np.array([0.0, 0.0, 50.0])
GOAL = np.array([[40.0, 0.0, 50.0]])
NOTHING = np.empty((0, 3))
OPTIONS = ltp.ObstacleMapOptions(dims=[60, 60, 8])


def court(half: float = 10.0) -> np.ndarray:
    """Hits on four walls round the start."""
    along = np.arange(-half, half, 0.5)
    sides = [(along, -half), (along, half), (-half, along), (half, along)]
    return np.concatenate(
        [np.column_stack(np.broadcast_arrays(x, y, 50.0)) for x, y in sides]
    ).astype(np.float64)


class Alone:
    """A UAV whose planner is asked by whoever flies it."""

    kind = ltp.LocalTrajectoryPlanner

    def __init__(self) -> None:
        self.planner = self.kind(ltp.Raster(np.zeros((1, 1))), START, map_options=OPTIONS)
        self.planner.set_waypoints(GOAL)

    def decide(self) -> tuple[ltp.NavigationStatus, int]:
        """The status and how many plans were made."""
        return self.planner.update(START), self.planner.plans_made


class Beside(Alone):
    """A UAV whose planner plans on a thread of its own."""

    kind = ltp.ConcurrentTrajectoryPlanner

    def decide(self) -> tuple[ltp.NavigationStatus, int]:
        """What was decided on the newest map."""
        self.planner.start()
        assert self.planner.wait()
        return self.planner.decision.status, self.planner.decision.plans_made


@pytest.fixture(params=[Alone, Beside])
def held(request: pytest.FixtureRequest) -> Alone:
    """A UAV that holds because of the walls round it."""
    uav = request.param()
    uav.planner.sense(START, court())
    assert uav.decide() == (ltp.NavigationStatus.HOLDING, 1)
    assert uav.decide() == (ltp.NavigationStatus.HOLDING, 1)  # the same map, the same answer
    return uav


def test_a_cleared_map_wakes_a_holding_uav(held: Alone) -> None:
    before = held.planner.map.version
    held.planner.clear_map()
    assert held.planner.map.version == before + 1
    assert held.planner.map.occupied.count() == 0
    assert held.decide() == (ltp.NavigationStatus.FOLLOWING, 2)


def test_a_loaded_map_wakes_a_holding_uav(held: Alone, tmp_path: Path) -> None:
    tower = ltp.ObstacleMap(OPTIONS, START)
    tower.insert(START, GOAL)
    tower.save(tmp_path / "tower.bt")
    held.planner.load_map(tmp_path / "tower.bt")
    assert held.planner.map.occupied.blocked_at(GOAL).all()
    assert held.decide()[0] == ltp.NavigationStatus.FINISHED  # the waypoint lies in the tower


def test_a_file_that_is_none_is_named(held: Alone, tmp_path: Path) -> None:
    with pytest.raises(ValueError, match=r"none\.bt"):
        held.planner.load_map(tmp_path / "none.bt")
    assert held.decide() == (ltp.NavigationStatus.HOLDING, 1)


@pytest.mark.parametrize(
    "change",
    [
        lambda view: view.insert(START, NOTHING),
        lambda view: view.recentre(START + 10.0),
        lambda view: view.clear(),
        lambda view: view.load("map.bt"),
        lambda view: view.occupied.roll((1, 0, 0)),
        lambda view: view.blocked.roll((1, 0, 0)),
        lambda view: view.voxels.roll((1, 0, 0)),
    ],
)
def test_the_map_of_a_planner_is_read_only(held: Alone, change: Callable) -> None:
    view = held.planner.map
    cells, version = view.occupied.to_array(), view.version
    with pytest.raises(ValueError, match="belongs to another object and is read-only"):
        change(view)
    np.testing.assert_array_equal(view.occupied.to_array(), cells)
    assert view.version == version


def test_the_map_of_a_planner_can_be_asked_and_saved(held: Alone, tmp_path: Path) -> None:
    view = held.planner.map
    assert view.log_odds_at(court()[0]) > 0.0
    assert view.voxels.count() > view.occupied.count() / 2 > 0
    view.save(tmp_path / "map.bt")
    mine = ltp.ObstacleMap(view.options, START)
    mine.load(tmp_path / "map.bt")  # one's own map may be changed
    assert mine.occupied == view.occupied
    mine.clear()
    assert mine.version == 2


@pytest.mark.parametrize("name", ltp.PLANNERS)
def test_a_uav_whose_plan_runs_out_of_budget_holds(name: str) -> None:
    uav = ltp.LocalTrajectoryPlanner(
        ltp.Raster(np.zeros((1, 1))),
        START,
        planner=name,
        map_options=OPTIONS,
        options=ltp.NavigationOptions(max_expansions=1),
    )
    uav.set_waypoints(GOAL)
    uav.sense(START, NOTHING)
    assert uav.update(START) == ltp.NavigationStatus.HOLDING
    assert uav.plans[0].plan.status == ltp.PlanStatus.OUT_OF_BUDGET


@pytest.mark.parametrize(
    ("limit", "value"), [("max_expansions", -1), ("time_limit", -0.1), ("time_limit", np.inf)]
)
def test_a_wrong_limit_of_the_loop_is_named(limit: str, value: float) -> None:
    with pytest.raises(ValueError, match=rf"^{limit} = "):
        ltp.NavigationOptions(**{limit: value}).check()


def test_it_says_why() -> None:
    reasons = ltp.NavigationReason.__members__
    assert ltp.NavigationReason.NONE.text == ""
    assert all(reason.text for name, reason in reasons.items() if name != "NONE")
    assert [reason.label for reason in reasons.values()] == [name.lower() for name in reasons]
    with pytest.raises(TypeError, match="no truth value"):
        bool(ltp.NavigationReason.NONE)

    ring = np.array([(8 * np.cos(t), 8 * np.sin(t), 50.0) for t in np.arange(0, 6.3, 0.1)])
    settings = {"planner": "ggwp", "map_options": ltp.ObstacleMapOptions(dims=[40, 40, 8])}
    raster = ltp.Raster(np.zeros((1, 1)))
    walled = ltp.LocalTrajectoryPlanner(raster, (0, 0, 50), **settings)
    walled.set_waypoints(np.array([[30.0, 0, 50]]))
    assert walled.reason == ltp.NavigationReason.UNDECIDED
    walled.sense((0, 0, 50), ring)
    assert walled.update((0, 0, 50)) == ltp.NavigationStatus.HOLDING
    assert walled.reason == ltp.NavigationReason.WALLED_IN
    walled.clear_map()
    assert walled.update((0, 0, 50)) == ltp.NavigationStatus.FOLLOWING
    assert walled.reason == ltp.NavigationReason.NONE

    dropping = ltp.ConcurrentTrajectoryPlanner(raster, (0, 0, 50), **settings)
    dropping.set_waypoints(np.array([[20.0, 0, 50]]))
    dropping.sense((0, 0, 50), np.array([[20.0, 0, 50]]))
    dropping.plan()
    assert dropping.decision.status == ltp.NavigationStatus.FINISHED
    assert dropping.decision.reason == ltp.NavigationReason.ALL_DROPPED
    assert dropping.decision.events[0].why == ltp.NavigationReason.GOAL_BLOCKED


def test_weights_planner_and_priority_change_without_losing_map_or_waypoints(held: Alone) -> None:
    planner = held.planner
    known = planner.map.occupied.count()
    for change in (
        lambda: planner.set_weights(ltp.PenaltyWeights(length=2.0, priority=0.0), 0.1),
        lambda: planner.set_planner("ggwp", keep_if_within=0.1),
        lambda: planner.set_weights(ltp.PenaltyWeights(length=1.0, priority=1.0)),
        lambda: planner.set_priority(ltp.Raster(np.ones((1, 1))), 0.1),
    ):
        before = held.decide()[1]
        change()
        planner.sense(START, court())
        # The court is closed: tried anew, to no avail.
        assert held.decide() == (ltp.NavigationStatus.HOLDING, before + 1)
    assert planner.map.occupied.count() == known
    np.testing.assert_array_equal(planner.waypoints, GOAL)
    for wrong in (
        lambda: planner.set_weights(ltp.PenaltyWeights(length=-1.0)),
        lambda: planner.set_weights(ltp.PenaltyWeights(), -0.1),
        lambda: planner.set_planner("no such"),
        lambda: planner.set_priority(ltp.Raster(np.ones((1, 1))), float("nan")),
    ):
        with pytest.raises(ValueError):
            wrong()


def test_events_are_told_once_also_of_waypoints_that_were_replaced(held: Alone) -> None:
    planner = held.planner
    planner.clear_map()
    for x in (1.0, 0.0):
        planner.set_waypoints(np.array([[x, 0.0, 50.0], [40.0, 0.0, 50.0]]))
        planner.sense(START, NOTHING)
        held.decide()
    events = planner.take_events()
    assert [(event.route, event.index, event.goal[0]) for event in events] == [
        (2, 0, 1.0),
        (3, 0, 0.0),
    ]
    assert planner.take_events() == []


def test_a_climb_counts_from_the_waypoints_a_band_from_the_uav_too() -> None:
    options = ltp.NavigationOptions(band=(4.0, 8.0))
    assert options.band_from(70.0, 50.0) == (4.0, 8.0)
    options.climb = 30.0
    assert options.band_from(40.0, 50.0) == (4.0, 30.0)
    assert options.band_from(70.0, 50.0) == (4.0, 10.0)
    assert options.band_from(90.0, 50.0) == (4.0, 0.0)
    with pytest.raises(ValueError, match="climb = -1: expected a number >= 0"):
        ltp.NavigationOptions(climb=-1.0).check()
