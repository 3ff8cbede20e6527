// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Stories of the loop that flies: given a scene, when it is sensed, then this is decided.
#include "ltp/navigation/local_trajectory_planner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "allocations.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/planning/planners.hpp"

namespace ltp {
namespace {

constexpr double kAltitude = 50.0;
const Path kNothing(0, 3);

ObstacleMapOptions small_map() {
  ObstacleMapOptions options;
  options.dims = {60, 60, 8};  // 120 x 120 x 32 m
  return options;
}

Raster no_priority() { return Raster(Raster::Values::Zero(1, 1), {0, 0}, 1.0); }

LocalTrajectoryPlanner make(const Point& position, std::string_view planner = "lp-dijkstra",
                            const NavigationOptions& options = {}) {
  return LocalTrajectoryPlanner(make_planner(planner), small_map(), options, no_priority(),
                                position);
}

Path points(const std::vector<Point>& list) {
  Path path(static_cast<Eigen::Index>(list.size()), 3);
  for (std::size_t i = 0; i < list.size(); ++i)
    path.row(static_cast<Eigen::Index>(i)) = list[i].transpose();
  return path;
}

Point at(double x, double y) { return {x, y, kAltitude}; }

/// Hits on a vertical wall from one ground point to another, about the flight's altitude.
std::vector<Point> wall(const Point& from, const Point& to, double half_height = 6.0) {
  std::vector<Point> hits;
  const int steps = static_cast<int>((to - from).norm() / 0.5);
  for (int i = 0; i <= steps; ++i) {
    for (double dz = -half_height; dz <= half_height; dz += 0.5) {
      hits.push_back(from + (to - from) * (static_cast<double>(i) / steps) + Point(0, 0, dz));
    }
  }
  return hits;
}

std::vector<Point> box(const Point& centre, double half) {
  std::vector<Point> hits;
  const Point corners[] = {centre + Point(-half, -half, 0), centre + Point(half, -half, 0),
                           centre + Point(half, half, 0), centre + Point(-half, half, 0)};
  for (int i = 0; i < 4; ++i) {
    const std::vector<Point> side = wall(corners[i], corners[(i + 1) % 4]);
    hits.insert(hits.end(), side.begin(), side.end());
  }
  return hits;
}

/// Flies at 3 m/s and 10 Hz along whatever path there is, without inertia. Returns the steps flown.
int fly(LocalTrajectoryPlanner& ltp, Point& position, int most = 2000) {
  for (int step = 0; step < most; ++step) {
    if (ltp.update(position) == NavigationStatus::Finished) return step;
    if (ltp.path().rows() == 0) continue;
    const double arc = closest_point(ltp.path(), position).arc_length;
    position = point_at(ltp.path(), arc + 0.3);
  }
  return most;
}

TEST(LocalTrajectoryPlanner, ReachesWaypointsInOrderAndPlansOncePerLeg) {
  Point position = at(0, 0);
  LocalTrajectoryPlanner ltp = make(position);
  ltp.set_waypoints(points({at(20, 0), at(20, 20), at(-10, 20)}));
  EXPECT_LT(fly(ltp, position), 2000);
  ASSERT_EQ(ltp.events().size(), 3u);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(ltp.events()[i].index, i);
    EXPECT_TRUE(ltp.events()[i].reached);
  }
  EXPECT_EQ(ltp.plans_made(), 3);
  EXPECT_EQ(ltp.path().rows(), 0);
}

TEST(LocalTrajectoryPlanner, HasNothingToDoWithoutWaypoints) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Finished);
  ltp.set_waypoints(kNothing);
  EXPECT_EQ(ltp.update(at(1, 0)), NavigationStatus::Finished);
  EXPECT_TRUE(ltp.events().empty());
}

TEST(LocalTrajectoryPlanner, ReplansOnlyWhenTheWallThatAppearsIsInItsWay) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(40, 0)}));
  ASSERT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  ltp.sense(at(0, 0), points(wall(at(10, 20), at(30, 20))), kNothing);
  ltp.update(at(0.3, 0));
  EXPECT_EQ(ltp.plans_made(), 1);
  ltp.sense(at(0, 0), points(wall(at(20, -15), at(20, 15))), kNothing);
  ASSERT_EQ(ltp.update(at(0.6, 0)), NavigationStatus::Following);
  EXPECT_EQ(ltp.plans_made(), 2);
  EXPECT_FALSE(ltp.map().blocked().first_blocked(ltp.path()).has_value());
  EXPECT_GT(length(ltp.path()), 45.0);
}

TEST(LocalTrajectoryPlanner, ReplansWhenBlownOffItsPath) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(40, 0)}));
  ltp.update(at(0, 0));
  ltp.update(at(5, 3.5));
  EXPECT_EQ(ltp.plans_made(), 1);
  ltp.update(at(6, 4.5));
  EXPECT_EQ(ltp.plans_made(), 2);
  EXPECT_EQ(ltp.path().row(0), at(6, 4.5).transpose());
}

TEST(LocalTrajectoryPlanner, DropsAWaypointInAMappedWall) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(20, 0), at(0, 20)}));
  ltp.sense(at(0, 0), points(wall(at(20, -4), at(20, 4))), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_FALSE(ltp.events()[0].reached);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::GoalBlocked);
  EXPECT_EQ(ltp.waypoint_index(), 1);
}

class CompletePlanners : public testing::TestWithParam<std::string_view> {};

TEST_P(CompletePlanners, DropTheHollowGoalOnceItsBoxIsClosed) {
  LocalTrajectoryPlanner ltp = make(at(0, 0), GetParam());
  ltp.set_waypoints(points({at(30, 0), at(0, 20)}));
  std::vector<Point> hits = box(at(30, 0), 9.0);
  const std::vector<Point> front(hits.begin(), hits.begin() + static_cast<int>(hits.size()) / 2);
  ltp.sense(at(0, 0), points(front), kNothing);
  ASSERT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  EXPECT_TRUE(ltp.events().empty()) << "half a box proves nothing";
  ltp.sense(at(0, 0), points(hits), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::Unreachable);
  ASSERT_EQ(ltp.plans().size(), 2u) << "the proof, and the plan to the next waypoint";
  EXPECT_EQ(ltp.plans()[0].plan.status, PlanStatus::Unreachable);
}

INSTANTIATE_TEST_SUITE_P(All, CompletePlanners,
                         testing::Values("lp-dijkstra", "lp-a-star", "wlp-a-star", "ggwp"));

/// Three walls, open away from the UAV: no single curve leads in.
std::vector<Point> pocket() {
  std::vector<Point> hits = wall(at(15, -20), at(15, 20));
  for (const double y : {-20.0, 20.0}) {
    const std::vector<Point> side = wall(at(15, y), at(45, y));
    hits.insert(hits.end(), side.begin(), side.end());
  }
  return hits;
}

TEST(LocalTrajectoryPlanner, HoldsWithoutProofAndTriesAgainWhenTheMapChanges) {
  LocalTrajectoryPlanner ltp = make(at(0, 0), "bezier");
  ltp.set_waypoints(points({at(25, 0)}));
  ltp.sense(at(0, 0), points(pocket()), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Holding);
  EXPECT_EQ(ltp.reason(), NavigationReason::NoPath);
  EXPECT_EQ(ltp.plans_made(), 1);
  ltp.update(at(0, 0));
  EXPECT_EQ(ltp.plans_made(), 1) << "the same map gives the same answer";
  ltp.sense(at(0, 0), points({at(0, 40)}), kNothing);
  ltp.update(at(0, 0));
  EXPECT_EQ(ltp.plans_made(), 2);
  EXPECT_TRUE(ltp.events().empty()) << "giving up proves nothing";
}

TEST(LocalTrajectoryPlanner, FliesTheShortestWayWhereThePlannerFindsNoneIfItMay) {
  NavigationOptions options;
  options.fly_route = true;
  Point position = at(0, 0);
  LocalTrajectoryPlanner ltp = make(position, "bezier", options);
  ltp.set_waypoints(points({at(25, 0)}));
  ltp.sense(position, points(pocket()), kNothing);
  EXPECT_LT(fly(ltp, position), 2000);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_TRUE(ltp.events()[0].reached);
}

TEST(LocalTrajectoryPlanner, NeedsNoCompletePlannerToProve) {
  LocalTrajectoryPlanner ltp = make(at(0, 0), "bezier");
  ltp.set_waypoints(points({at(30, 0)}));
  ltp.sense(at(0, 0), points(box(at(30, 0), 9.0)), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Finished);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::Unreachable);
}

TEST(LocalTrajectoryPlanner, DropsNothingWhenItIsTheUavThatIsWalledIn) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(40, 0)}));
  ltp.sense(at(0, 0), points(box(at(0, 0), 10.0)), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Holding);
  EXPECT_TRUE(ltp.events().empty());
}

TEST(LocalTrajectoryPlanner, LeavesABlockedCellByTheNearestFreeOneAndDropsNothing) {
  LocalTrajectoryPlanner ltp = make(at(1, 1));
  ltp.set_waypoints(points({at(40, 1)}));
  ltp.sense(at(1, 1), points(wall(at(-1.5, -10), at(-1.5, 10))), kNothing);
  ASSERT_TRUE(ltp.map().blocked().blocked_at(at(1, 1)));
  ASSERT_EQ(ltp.update(at(1, 1)), NavigationStatus::Escaping);
  ASSERT_EQ(ltp.path().rows(), 2);
  const Point out = ltp.path().row(1).transpose();
  EXPECT_FALSE(ltp.map().blocked().blocked_at(out));
  EXPECT_NEAR((out - at(3, 1)).head<2>().norm(), 0.0, 1e-9);
  EXPECT_EQ(ltp.update(out), NavigationStatus::Following);
  EXPECT_TRUE(ltp.events().empty());
}

TEST(LocalTrajectoryPlanner, HoldsWhereNoFreeCellIsNear) {
  NavigationOptions options;
  options.escape_distance = 3.0;
  LocalTrajectoryPlanner ltp = make(at(1, 1), "lp-dijkstra", options);
  ltp.set_waypoints(points({at(40, 1)}));
  std::vector<Point> hits;
  for (double x = -9; x <= 11; x += 2) {
    for (double y = -9; y <= 11; y += 2) hits.push_back(at(x, y));
  }
  ltp.sense(at(1, 1), points(hits), kNothing);
  EXPECT_EQ(ltp.update(at(1, 1)), NavigationStatus::Holding);
  EXPECT_TRUE(ltp.events().empty());
}

TEST(LocalTrajectoryPlanner, FliesToAGoalBeyondTheWindow) {
  Point position = at(0, 0);
  LocalTrajectoryPlanner ltp = make(position);
  ltp.set_waypoints(points({at(300, 40)}));
  ltp.update(position);
  const GridFrame& frame = ltp.map().blocked().frame();
  ASSERT_EQ(ltp.status(), NavigationStatus::Following);
  const Point end = ltp.path().row(ltp.path().rows() - 1).transpose();
  EXPECT_TRUE(frame.contains(end));
  EXPECT_GT(end.x(), 50.0) << "the last point of the leg inside the window";
  EXPECT_NEAR(end.y(), end.x() * 40 / 300, 1e-9) << "on the global path";
  EXPECT_LT(fly(ltp, position, 4000), 4000);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_TRUE(ltp.events()[0].reached);
}

TEST(LocalTrajectoryPlanner, FliesRoundWhatLiesAcrossTheWindowsBorder) {
  ObstacleMapOptions map = small_map();
  map.dims = {40, 40, 8};  // the window ends inside the box
  LocalTrajectoryPlanner ltp(make_planner("lp-dijkstra"), map, {}, no_priority(), at(0, 0));
  ltp.set_waypoints(points({at(300, 0)}));
  ltp.sense(at(0, 0), points(box(at(36, 0), 12.0)), kNothing);
  ASSERT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  EXPECT_TRUE(ltp.events().empty());
  const Point end = ltp.path().row(ltp.path().rows() - 1).transpose();
  EXPECT_GT(end.x(), 30.0);
  EXPECT_GT(std::abs(end.y()), 12.0);
}

TEST(LocalTrajectoryPlanner, ReachesAWaypointInTheWindowByAWayOutsideOfIt) {
  ObstacleMapOptions map = small_map();
  map.dims = {20, 20, 8};  // 40 m
  Point position = at(0, 0);
  LocalTrajectoryPlanner ltp(make_planner("lp-dijkstra"), map, {}, no_priority(), position);
  ltp.set_waypoints(points({at(14, 0)}));
  const Path hits = points(wall(at(7, -40), at(7, 60)));
  ltp.sense(position, hits, kNothing);
  ASSERT_TRUE(ltp.map().blocked().frame().contains(at(14, 0)));
  ASSERT_EQ(ltp.update(position), NavigationStatus::Following);
  double flown = 0.0;
  for (int step = 0; step < 2000 && ltp.status() == NavigationStatus::Following; ++step) {
    const double arc = closest_point(ltp.path(), position).arc_length;
    const Point next = point_at(ltp.path(), arc + 0.3);
    flown += (next - position).norm();
    position = next;
    ltp.sense(position, hits, kNothing);
    ltp.update(position);
  }
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_TRUE(ltp.events()[0].reached);
  EXPECT_LT(flown, 200.0);
}

TEST(LocalTrajectoryPlanner, FliesTowardsAWaypointThatIsFartherThanItCanRemember) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(50e3, 0)}));
  ASSERT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  EXPECT_GT(ltp.path()(ltp.path().rows() - 1, 0), 50.0);
}

TEST(LocalTrajectoryPlanner, SaysThatItIsWalledInWhereverTheWaypointLies) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(400, 0)}));
  ltp.sense(at(0, 0), points(box(at(0, 0), 10.0)), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Holding);
  EXPECT_EQ(ltp.reason(), NavigationReason::WalledIn);
  EXPECT_TRUE(ltp.events().empty());
}

TEST(LocalTrajectoryPlanner, SkipsAWaypointThatIsTooFarAndNeverCallsItUnreachable) {
  for (const double most : {0.0, 20.0, 300.0}) {
    NavigationOptions options;
    options.max_detour = most;
    Point position = at(0, 0);
    LocalTrajectoryPlanner ltp = make(position, "lp-dijkstra", options);
    ltp.set_waypoints(points({at(30, 0), at(-20, 0)}));
    ltp.update(position);  // along the straight line
    ltp.sense(position, points(wall(at(15, -45), at(15, 45))), kNothing);
    EXPECT_LT(fly(ltp, position), 2000);
    ASSERT_EQ(ltp.events().size(), 2u);
    const WaypointEvent& event = ltp.events()[0];
    EXPECT_EQ(event.reached, most != 20.0);
    if (!event.reached) {
      EXPECT_EQ(event.why, NavigationReason::TooFar);
      EXPECT_EQ(event.reason, PlanStatus::NoneFound);
    }
    EXPECT_TRUE(ltp.events()[1].reached);
  }
}

/// All round a block of 100 m about (70, 0), to its north side: never are all its walls in view.
template <typename Visit>
void walk_round_the_block(const Visit& visit) {
  for (double x = 0; x <= 140; x += 10) visit(at(x, -60));
  for (double y = -60; y <= 60; y += 10) visit(at(130, y));
  for (double x = 140; x >= 0; x -= 10) visit(at(x, 60));
  for (double y = 60; y >= -60; y -= 10) visit(at(10, y));
  for (double x = 10; x <= 90; x += 10) visit(at(x, 60));
}

TEST(LocalTrajectoryPlanner, ProvesABlockClosedThatIsLargerThanItsWindow) {
  ObstacleMapOptions map = small_map();
  map.dims = {40, 40, 8};  // 80 m, for a block of 100 m
  LocalTrajectoryPlanner ltp(make_planner("ggwp"), map, {}, no_priority(), at(0, 0));
  ltp.set_waypoints(points({at(90, 40)}));
  const Path hits = points(box(at(70, 0), 50.0));
  walk_round_the_block([&](const Point& here) { ltp.sense(here, hits, kNothing); });
  ASSERT_TRUE(ltp.map().occupied().frame().contains(at(90, 40)));
  EXPECT_EQ(ltp.update(at(90, 60)), NavigationStatus::Finished);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::Unreachable);
}

TEST(LocalTrajectoryPlanner, ProvesAWaypointBeyondTheWindowUnreachable) {
  ObstacleMapOptions map = small_map();
  map.dims = {40, 40, 8};
  LocalTrajectoryPlanner ltp(make_planner("ggwp"), map, {}, no_priority(), at(0, 0));
  ltp.set_waypoints(points({at(90, 40)}));
  const Path hits = points(box(at(70, 0), 50.0));
  walk_round_the_block([&](const Point& here) { ltp.sense(here, hits, kNothing); });
  ltp.sense(at(-50, 0), hits, kNothing);
  ASSERT_FALSE(ltp.map().occupied().frame().contains(at(90, 40)));
  EXPECT_EQ(ltp.update(at(-50, 0)), NavigationStatus::Finished);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::Unreachable);
}

/// Holds no more than some of the block that one walks round.
LocalTrajectoryPlanner before_the_block() {
  ObstacleMapOptions map = small_map();
  map.dims = {40, 40, 8};
  LocalTrajectoryPlanner ltp(make_planner("ggwp"), map, {}, no_priority(), at(0, 0));
  ltp.set_waypoints(points({at(90, 40)}));
  return ltp;
}

TEST(LocalTrajectoryPlanner, ProvesNothingFromWhatWasCleared) {
  LocalTrajectoryPlanner ltp = before_the_block();
  const Path hits = points(box(at(70, 0), 50.0));
  walk_round_the_block([&](const Point& here) { ltp.sense(here, hits, kNothing); });
  ltp.clear_map();
  ltp.sense(at(90, 60), hits, kNothing);
  EXPECT_EQ(ltp.update(at(90, 60)), NavigationStatus::Following) << "round what is left of it";
  EXPECT_TRUE(ltp.events().empty()) << "three of the four walls are forgotten";
}

TEST(LocalTrajectoryPlanner, ProvesFromWhatWasLoaded) {
  const std::string path = testing::TempDir() + "ltp_block.bt";
  ObstacleMapOptions whole = small_map();
  whole.dims = {100, 100, 8};
  whole.max_range = 100.0;
  ObstacleMap block(whole, at(70, 0));
  block.insert(at(70, 0), points(box(at(70, 0), 50.0)));
  block.save(path);

  LocalTrajectoryPlanner ltp = before_the_block();
  walk_round_the_block([&](const Point& here) {
    ltp.sense(here, kNothing, kNothing);
    ltp.load_map(path);
  });
  EXPECT_EQ(ltp.update(at(90, 60)), NavigationStatus::Finished);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::Unreachable);
}

TEST(LocalTrajectoryPlanner, ReckonsWithAnEarlierMissionBeyondItsWindow) {
  const std::string path = testing::TempDir() + "ltp_far_block.bt";
  ObstacleMapOptions whole = small_map();
  whole.max_range = 400.0;
  ObstacleMap earlier(whole, at(300, 0));
  earlier.insert(at(300, 0), points(box(at(300, 0), 20.0)));
  earlier.save(path);

  for (const bool remember : {true, false}) {
    ObstacleMapOptions options = small_map();
    options.remember = remember;
    LocalTrajectoryPlanner ltp(make_planner(), options, {}, no_priority(), at(0, 0));
    ltp.set_waypoints(points({at(300, 0)}));
    ltp.load_map(path);
    const NavigationStatus status = ltp.update(at(0, 0));
    if (!remember) {
      EXPECT_EQ(status, NavigationStatus::Following) << "it has seen nothing of the block";
      continue;
    }
    EXPECT_EQ(status, NavigationStatus::Finished);
    ASSERT_EQ(ltp.events().size(), 1u);
    EXPECT_EQ(ltp.events()[0].reason, PlanStatus::Unreachable);
  }
}

/// A UAV that holds in a closed courtyard, and the waypoint outside.
LocalTrajectoryPlanner walled_in() {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_waypoints(points({at(40, 0)}));
  ltp.sense(at(0, 0), points(box(at(0, 0), 10.0)), kNothing);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Holding);
  ltp.update(at(0, 0));
  EXPECT_EQ(ltp.plans_made(), 1) << "the same map gives the same answer";
  return ltp;
}

TEST(LocalTrajectoryPlanner, AClearedMapWakesAHoldingUav) {
  LocalTrajectoryPlanner ltp = walled_in();
  ltp.clear_map();
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Following);
  EXPECT_EQ(ltp.plans_made(), 2);
}

TEST(LocalTrajectoryPlanner, ALoadedMapWakesAHoldingUav) {
  const std::string path = testing::TempDir() + "ltp_tower.bt";
  ObstacleMap tower(small_map(), at(0, 0));
  tower.insert(at(0, 0), points(wall(at(40, -2), at(40, 2))));
  tower.save(path);
  LocalTrajectoryPlanner ltp = walled_in();
  ltp.load_map(path);
  EXPECT_EQ(ltp.update(at(0, 0)), NavigationStatus::Finished);
  ASSERT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.events()[0].reason, PlanStatus::GoalBlocked) << "the waypoint lies in the tower";
}

TEST(LocalTrajectoryPlanner, ARecentredMapLeavesAHoldingUavAlone) {
  LocalTrajectoryPlanner ltp = walled_in();
  ASSERT_NE(ltp.map().occupied().frame().shift_to_centre(at(3, 0)), Cell::Zero());
  EXPECT_EQ(ltp.update(at(3, 0)), NavigationStatus::Holding);
  EXPECT_EQ(ltp.plans_made(), 1);
}

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
TEST(LocalTrajectoryPlanner, AnswersToItsOldNames) {
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  ltp.set_way_points(points({at(0, 0), at(40, 0)}));
  ltp.update(at(0, 0));
  EXPECT_EQ(ltp.way_points(), ltp.waypoints());
  EXPECT_EQ(ltp.way_point_index(), 1);
  const std::vector<WayPointEvent> events = ltp.events();
  EXPECT_EQ(events.size(), 1u);
}
#pragma GCC diagnostic pop

TEST(LocalTrajectoryPlanner, StaysInItsBand) {
  NavigationOptions options;
  LocalTrajectoryPlanner planar = make(at(0, 0), "lp-dijkstra", options);
  options.band = {12.0, 12.0};
  LocalTrajectoryPlanner open = make(at(0, 0), "lp-dijkstra", options);
  // A long wall that ends below the upper level of the open band.
  for (LocalTrajectoryPlanner* ltp : {&planar, &open}) {
    ltp->set_waypoints(points({at(40, 0)}));
    ltp->sense(at(0, 0), points(wall(at(20, -40), at(20, 40), 2.0)), kNothing);
    ASSERT_EQ(ltp->update(at(0, 0)), NavigationStatus::Following);
  }
  EXPECT_EQ(planar.path().col(2).minCoeff(), planar.path().col(2).maxCoeff());
  EXPECT_GT(length(planar.path()), length(open.path()));
}

TEST(LocalTrajectoryPlanner, AllocatesNothingWhileAPlanStands) {
  Point position = at(0, 0);
  LocalTrajectoryPlanner ltp = make(position);
  ltp.set_waypoints(points({at(200, 0)}));
  ltp.update(position);
  const std::int64_t plans = ltp.plans_made();
  for (int step = 1; step <= 100; ++step) {  // rolls the window as it goes
    position.x() += 0.3;
    const Path hits = points(wall(position + Point(0, 30, 0), position + Point(10, 35, 0)));
    ltp.sense(position, hits, kNothing);  // what is new to the mission is allocated for
    const std::int64_t before = test::allocations();
    ltp.sense(position, hits, kNothing);
    ltp.update(position);
    EXPECT_EQ(test::allocations() - before, 0) << "step " << step;
  }
  EXPECT_EQ(ltp.plans_made(), plans);
}

TEST(LocalTrajectoryPlanner, RefusesWhatIsNotANumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  LocalTrajectoryPlanner ltp = make(at(0, 0));
  EXPECT_THROW(ltp.set_waypoints(points({at(nan, 0)})), std::invalid_argument);
  EXPECT_THROW(ltp.update(at(0, nan)), std::invalid_argument);
  NavigationOptions options;
  options.band.below = nan;
  EXPECT_THROW(make(at(0, 0), "ggwp", options), std::invalid_argument);
  EXPECT_THROW(LocalTrajectoryPlanner(nullptr, small_map(), {}, no_priority(), at(0, 0)),
               std::invalid_argument);
}

}  // namespace
}  // namespace ltp
