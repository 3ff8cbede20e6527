# SPDX-FileCopyrightText: 2026 The ltp authors
# SPDX-License-Identifier: BSD-3-Clause
"""The planner on a thread of its own, from Python."""

import numpy as np
import pytest

import ltp

START = np.array([20.0, 60.0, 30.0])


def options() -> ltp.ObstacleMapOptions:
    return ltp.ObstacleMapOptions(dims=[80, 80, 20])


def priority() -> ltp.Raster:
    return ltp.Raster(np.zeros((1, 1)), origin=(0.0, 0.0), cell=1.0)


def make(kind: type = ltp.ConcurrentTrajectoryPlanner, **values):
    planner = kind(priority(), START, map_options=options(), **values)
    planner.set_waypoints(np.array([[110.0, 60.0, 30.0], [150.0, 90.0, 30.0]]))
    return planner


def tower() -> ltp.HeightSurface:
    heights = np.zeros((200, 160))
    heights[60:80, 40:90] = 60.0
    return ltp.HeightSurface(ltp.Raster(heights, origin=(0.0, 0.0), cell=1.0))


def test_each_scan_waited_for_gives_the_flight_of_one_thread() -> None:
    surface, lidar = tower(), ltp.Lidar()
    one, two = make(ltp.LocalTrajectoryPlanner), make()
    other = ltp.Raster(np.arange(12000.0).reshape(120, 100) % 7 / 7, origin=(0.0, 0.0), cell=2.0)
    two.start()
    position = START
    for tick in range(2000):
        if tick in (60, 160):
            for planner in (one, two):
                planner.set_priority(other if tick == 60 else priority())
        scan = lidar.scan(surface, ltp.Pose(position), tick)
        one.sense(scan.origin, scan.hits)
        status = one.update(position)
        two.sense(scan.origin, scan.hits)
        assert two.wait()
        decision = two.decision
        assert decision.scan == two.scans == tick + 1
        assert decision.status == status
        assert np.array_equal(decision.path, one.path)
        assert decision.plans_made == one.plans_made
        assert decision.waypoint_index == one.waypoint_index
        assert two.blocked_at is None
        if status == ltp.NavigationStatus.FINISHED:
            break
        path = one.path
        _, arc, _ = ltp._core.closest_point(path, position)
        position = ltp._core.point_at(path, arc + 0.5)
    assert status == ltp.NavigationStatus.FINISHED
    assert [event.reached for event in two.decision.events] == [True, True]
    assert one.plans_made > 2


def test_without_a_thread_it_plans_when_it_is_told_to() -> None:
    planner = make()
    planner.sense(START, np.empty((0, 3)))
    assert planner.decision.scan == 0
    assert planner.decision.status == ltp.NavigationStatus.HOLDING
    assert not planner.wait(0.01)
    assert planner.plan()
    assert not planner.plan()
    assert planner.decision.status == ltp.NavigationStatus.FOLLOWING
    wall = np.array([[50.0, y, 30.0] for y in np.arange(40.0, 80.0, 0.5)])
    planner.sense(START, wall)
    assert 20.0 < planner.blocked_at < 30.0


def test_another_priority_takes_back_the_path_until_the_next_scan() -> None:
    planner = make()
    planner.sense(START, np.empty((0, 3)))
    planner.plan()
    assert planner.decision.status == ltp.NavigationStatus.FOLLOWING
    planner.set_priority(ltp.Raster(np.ones((1, 1))))
    assert planner.decision.status == ltp.NavigationStatus.HOLDING
    assert len(planner.decision.path) == 0
    planner.sense(START, np.empty((0, 3)))
    planner.plan()
    assert planner.decision.status == ltp.NavigationStatus.FOLLOWING
    assert planner.decision.plans_made == 2


def test_a_decision_is_a_copy_that_stays() -> None:
    planner = make()
    planner.sense(START, np.empty((0, 3)))
    planner.plan()
    decision = planner.decision
    planner.set_waypoints(np.empty((0, 3)))
    planner.sense(START, np.empty((0, 3)))
    planner.plan()
    assert planner.decision.status == ltp.NavigationStatus.FINISHED
    assert decision.status == ltp.NavigationStatus.FOLLOWING
    assert len(decision.path) >= 2


def test_strange_waypoints_are_refused() -> None:
    with pytest.raises(ValueError, match="waypoints"):
        make().set_waypoints(np.array([[np.nan, 0.0, 0.0]]))
