# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The names of version 0.1: for one release they still work, and warn."""

import numpy as np
import pytest

import ltp
import ltp.sim

from ..scenes import event, record, row

START = np.array([20.0, 60.0, 30.0])
ROUTE = np.array([[20.0, 60.0, 30.0], [90.0, 60.0, 30.0]])  # the first is reached at once
NOTHING = np.empty((0, 3))


def make(kind: type):
    map_options = ltp.ObstacleMapOptions(dims=[80, 80, 20])
    return kind(ltp.Raster(np.zeros((1, 1))), START, map_options=map_options)


def decided():
    """What either loop decides: its planner, and what an old name is looked up on."""
    local, concurrent = make(ltp.LocalTrajectoryPlanner), make(ltp.ConcurrentTrajectoryPlanner)
    for planner in (local, concurrent):
        planner.set_waypoints(ROUTE)
        planner.sense(START, NOTHING)
    local.update(START)
    concurrent.plan()
    return local, concurrent


LOCAL, CONCURRENT = decided()
FLOWN = record([event(0), event(1)])


@pytest.mark.parametrize(
    ("owner", "old", "new"),
    [
        (LOCAL, "way_points", "waypoints"),
        (LOCAL, "way_point_index", "waypoint_index"),
        (LOCAL.plans[0], "way_point", "waypoint"),
        (CONCURRENT, "way_points", "waypoints"),
        (CONCURRENT.decision, "way_point_index", "waypoint_index"),
        (FLOWN, "way_points", "waypoints"),
        (FLOWN, "way_point_index", "waypoint_index"),
        (FLOWN.plans[0], "way_point", "waypoint"),
        (row(), "way_points", "waypoints"),
        (ltp.sim, "WayPointEvent", "WaypointEntry"),
        (ltp, "ParetoOptions", "ExactOptions"),
        (ltp, "BugOptions", "TangentBugOptions"),
    ],
)
def test_an_old_name_warns_and_gives_what_the_new_one_gives(owner, old: str, new: str) -> None:
    with pytest.warns(DeprecationWarning, match=f"`{old}` is now `{new}`") as warnings:
        value = getattr(owner, old)
    assert warnings[0].filename == __file__  # where it is to be changed
    np.testing.assert_array_equal(value, getattr(owner, new))


@pytest.mark.parametrize("kind", [ltp.LocalTrajectoryPlanner, ltp.ConcurrentTrajectoryPlanner])
def test_the_old_way_to_set_waypoints_warns_and_sets_them(kind: type) -> None:
    planner = make(kind)
    with pytest.warns(DeprecationWarning, match="`set_way_points` is now `set_waypoints`"):
        planner.set_way_points(ROUTE)
    np.testing.assert_array_equal(planner.waypoints, ROUTE)
    with pytest.warns(DeprecationWarning):
        planner.set_way_points(way_points=ROUTE[:1])
    assert len(planner.waypoints) == 1


@pytest.mark.parametrize(
    ("old", "new", "options"),
    [
        ("pareto", "exact", ltp.ExactOptions(eps=0.25)),
        ("bug", "tangent_bug", ltp.TangentBugOptions(range=7.0)),
    ],
)
def test_the_old_options_of_a_planner_warn_and_are_the_new_ones(old: str, new: str, options):
    made = ltp.PlannerOptions()
    with pytest.warns(DeprecationWarning, match=f"`{old}` is now `{new}`") as warnings:
        setattr(made, old, options)
    assert warnings[0].filename == __file__
    with pytest.warns(DeprecationWarning, match=f"`{old}` is now `{new}`"):
        assert repr(getattr(made, old)) == repr(getattr(made, new)) == repr(options)
    assert f" {old}=" not in repr(made)


def test_no_other_old_name_is_made_up() -> None:
    with pytest.raises(AttributeError, match="WayPoints"):
        _ = ltp.sim.WayPoints
