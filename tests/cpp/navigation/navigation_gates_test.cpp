// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Flights through gates: where waypoints are served, when they are dropped, alone and jointly.
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "ltp/geometry/polyline.hpp"
#include "ltp/navigation/concurrent_trajectory_planner.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planners.hpp"

namespace ltp {
namespace {

const Path kNothing(0, 3);
const Point kStart(0, 0, 50);

ObstacleMapOptions small_map() {
  ObstacleMapOptions options;
  options.dims = {80, 80, 8};
  return options;
}

Raster no_priority() { return Raster(Raster::Values::Zero(1, 1), {0, 0}, 1.0); }

LocalTrajectoryPlanner make(const NavigationOptions& options, std::string_view planner = "auto") {
  return LocalTrajectoryPlanner(make_planner(planner), small_map(), options, no_priority(), kStart);
}

Path points(const std::vector<Point>& list) {
  Path path(static_cast<Eigen::Index>(list.size()), 3);
  for (std::size_t i = 0; i < list.size(); ++i) {
    path.row(static_cast<Eigen::Index>(i)) = list[i].transpose();
  }
  return path;
}

/// A turn of 90 degrees about the second waypoint.
const Path kTurn = points({{30, 0, 50}, {60, 0, 50}, {60, 30, 50}, {60, 60, 50}});

/// Hits in every voxel of a solid block about a point, two levels high either way.
Path block(const Point& centre, double half) {
  std::vector<Point> hits;
  for (double x = -half; x <= half; x += 1.0) {
    for (double y = -half; y <= half; y += 1.0) {
      for (double z = -7; z <= 7; z += 1.0) hits.push_back(centre + Point(x, y, z));
    }
  }
  return points(hits);
}

/// Flies without inertia; the way flown [m].
double fly(LocalTrajectoryPlanner& ltp) {
  Point position = kStart;
  double flown = 0.0;
  for (int step = 0; step < 3000; ++step) {
    if (ltp.update(position) == NavigationStatus::Finished) return flown;
    if (ltp.path().rows() == 0) continue;
    const double arc = closest_point(ltp.path(), position).arc_length;
    const Point next = point_at(ltp.path(), arc + 0.3);
    flown += (next - position).norm();
    position = next;
  }
  ADD_FAILURE() << "it does not arrive";
  return flown;
}

NavigationOptions gates(double radius, int horizon = 1) {
  NavigationOptions options;
  options.gate_radius = radius;
  options.horizon = horizon;
  return options;
}

TEST(NavigationGates, ShortenTheWayAndTellHowNearItCame) {
  double before = 1e9;
  for (const double radius : {0.0, 5.0, 15.0}) {
    LocalTrajectoryPlanner ltp = make(gates(radius));
    ltp.set_waypoints(kTurn);
    const double flown = fly(ltp);
    EXPECT_LT(flown, before) << radius;
    before = flown;
    ASSERT_EQ(ltp.events().size(), 4u);
    for (const WaypointEvent& event : ltp.events()) {
      EXPECT_TRUE(event.reached);
      EXPECT_NEAR(event.distance, (event.position - event.goal).norm(), 1e-12);
      EXPECT_LE(event.distance, std::max(radius, 2.83));
    }
    EXPECT_LE(ltp.events().back().distance, 2.83) << "the last one is a point";
    EXPECT_LE(ltp.plans_made(), 5);
  }
}

TEST(NavigationGates, AHorizonCutsTheCorner) {
  LocalTrajectoryPlanner one = make(gates(15.0, 1));
  LocalTrajectoryPlanner three = make(gates(15.0, 3));
  one.set_waypoints(kTurn);
  three.set_waypoints(kTurn);
  EXPECT_LT(fly(three), fly(one));
  ASSERT_EQ(three.events().size(), 4u);
  for (const WaypointEvent& event : three.events()) EXPECT_TRUE(event.reached);
}

TEST(NavigationGates, EveryPlannerFliesThroughThem) {
  for (const PlannerInfo& info : planners()) {
    SCOPED_TRACE(info.name);
    LocalTrajectoryPlanner ltp = make(gates(10.0, 2), info.name);
    ltp.set_waypoints(kTurn);
    fly(ltp);
    ASSERT_EQ(ltp.events().size(), 4u);
    for (const WaypointEvent& event : ltp.events()) EXPECT_TRUE(event.reached);
  }
}

TEST(NavigationGates, AreServedWhereTheirPointIsBlocked) {
  for (const bool gated : {false, true}) {
    LocalTrajectoryPlanner ltp = make(gates(gated ? 15.0 : 0.0));
    ltp.set_waypoints(kTurn);
    ltp.sense(kTurn.row(0).transpose(), block(kTurn.row(1).transpose(), 3.0), kNothing);
    fly(ltp);
    ASSERT_EQ(ltp.events().size(), 4u);
    EXPECT_EQ(ltp.events()[1].reached, gated);
    if (gated) {
      EXPECT_GT(ltp.events()[1].distance, 4.0);
    } else {
      EXPECT_EQ(ltp.events()[1].why, NavigationReason::GoalBlocked);
    }
  }
}

TEST(NavigationGates, AreDroppedWhereNoCellOfThemCanBeReached) {
  LocalTrajectoryPlanner ltp = make(gates(6.0, 2));
  ltp.set_waypoints(kTurn);
  ltp.sense(kTurn.row(0).transpose(), block(kTurn.row(1).transpose(), 9.0), kNothing);
  fly(ltp);
  EXPECT_EQ(ltp.events()[1].why, NavigationReason::GoalBlocked);
  EXPECT_TRUE(ltp.events()[2].reached);
  // Hollow: free inside, closed all round.
  LocalTrajectoryPlanner walled = make(gates(6.0, 2));
  walled.set_waypoints(kTurn);
  const Path solid = block(kTurn.row(1).transpose(), 13.0);
  std::vector<Point> shell;
  for (Eigen::Index i = 0; i < solid.rows(); ++i) {
    const Point hit = solid.row(i).transpose();
    if ((hit - Point(60, 0, 50)).head<2>().cwiseAbs().maxCoeff() > 11.0) shell.push_back(hit);
  }
  walled.sense(kTurn.row(0).transpose(), points(shell), kNothing);
  fly(walled);
  ASSERT_EQ(walled.events().size(), 4u);
  EXPECT_EQ(walled.events()[1].why, NavigationReason::Unreachable);
  EXPECT_TRUE(walled.events()[2].reached);
}

TEST(NavigationGates, CanBeGivenOneByOneInBothLoops) {
  GateSizes sizes = GateSizes::Zero(4, 2);
  sizes(1, 0) = 20.0;
  sizes(3, 0) = 12.0;
  LocalTrajectoryPlanner ltp = make(gates(0.0));
  ltp.set_waypoints(kTurn, sizes);
  fly(ltp);
  EXPECT_LE(ltp.events()[0].distance, 2.83);
  EXPECT_GT(ltp.events()[1].distance, 19.0);
  EXPECT_GT(ltp.events()[3].distance, 11.0) << "the last one, too, if it is given one";

  ConcurrentTrajectoryPlanner concurrent(make_planner("auto"), small_map(), gates(0.0),
                                         no_priority(), kStart);
  concurrent.set_waypoints(kTurn, sizes);
  Point position = kStart;
  for (int step = 0; step < 1000; ++step) {
    concurrent.sense(position, kNothing, kNothing);
    concurrent.plan();
    if (concurrent.decision().status == NavigationStatus::Finished) break;
    const Path& path = concurrent.decision().path;
    position = point_at(path, closest_point(path, position).arc_length + 0.3);
  }
  const std::vector<WaypointEvent>& events = concurrent.decision().events;
  ASSERT_EQ(events.size(), 4u);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(events[i].distance, ltp.events()[i].distance) << i;
}

TEST(NavigationGates, NameWhatIsWrong) {
  const auto message = [](const GateSizes& sizes) {
    LocalTrajectoryPlanner ltp = make({});
    try {
      ltp.set_waypoints(kTurn, sizes);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("nothing was thrown");
  };
  EXPECT_EQ(message(GateSizes::Zero(3, 2)).rfind("gates.rows() = 3", 0), 0u);
  EXPECT_EQ(message(GateSizes::Constant(4, 2, -1.0)).rfind("gates[0].radius = -1", 0), 0u);
  NavigationOptions options;
  options.horizon = 0;
  EXPECT_THROW(make(options), std::invalid_argument);
  options = gates(-1.0);
  EXPECT_THROW(make(options), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
