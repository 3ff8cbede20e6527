// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Escapes: looked at again with every scan, never through what was hit; and why a UAV holds.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "allocations.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/navigation/concurrent_trajectory_planner.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planners.hpp"

namespace ltp {
namespace {

const Path kNothing(0, 3);
const Point kStart(1, 1, 50);  // the centre of cell (0, 0, 12) but for its height
const Point kGoal(41, 1, 50);

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (random() >> 11) * 0x1p-53;
}

ObstacleMapOptions small_map() {
  ObstacleMapOptions options;
  options.dims = {40, 40, 8};
  return options;
}

Raster no_priority() { return Raster(Raster::Values::Zero(1, 1), {0, 0}, 1.0); }

LocalTrajectoryPlanner make(const NavigationOptions& options = {},
                            const ObstacleMapOptions& map = small_map(),
                            const Path& waypoints = kGoal.transpose(),
                            std::string_view planner = "ggwp") {
  LocalTrajectoryPlanner ltp(make_planner(planner), map, options, no_priority(), kStart);
  ltp.set_waypoints(waypoints);
  return ltp;
}

/// The centres of cells, counted from the UAV's own, at its height.
Path cells(const std::vector<std::array<int, 2>>& list) {
  Path path(static_cast<Eigen::Index>(list.size()), 3);
  Eigen::Index row = 0;
  for (const auto& [dx, dy] : list) {
    path.row(row++) = (kStart + Point(2.0 * dx, 2.0 * dy, 0)).transpose();
  }
  return path;
}

Point end_of(const Path& path) { return path.row(path.rows() - 1).transpose(); }

/// What every escape keeps: its end is free, and no cell that was hit lies on it but the UAV's own.
void expect_sound(const LocalTrajectoryPlanner& ltp, const Point& position) {
  const OccupancyGrid& blocked = ltp.map().blocked();
  OccupancyGrid occupied = ltp.map().occupied();
  const Cell own = occupied.frame().cell_of(position);
  ASSERT_EQ(ltp.path().rows(), 2);
  EXPECT_FALSE(blocked.blocked_at(end_of(ltp.path())));
  occupied.set(own, false);
  const double progress = closest_point(ltp.path(), position, 0.0).arc_length;
  EXPECT_FALSE(occupied.first_blocked(ltp.path(), progress).has_value());
}

TEST(Escape, TurnsAwayFromAHitThatAppearsOnIt) {
  LocalTrajectoryPlanner ltp = make();
  ltp.sense(kStart, cells({{-1, 0}}), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Escaping);
  EXPECT_EQ(ltp.reason(), NavigationReason::StartBlocked);
  const Point first = end_of(ltp.path());
  ASSERT_NEAR((first - (kStart + Point(2, 0, 0))).head<2>().norm(), 0.0, 1e-9);
  ltp.sense(kStart, first.transpose(), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Escaping);
  EXPECT_NE(end_of(ltp.path()), first);
  expect_sound(ltp, kStart);
}

TEST(Escape, HoldsWhereAHitClosesTheLastWayOut) {
  NavigationOptions options;
  options.escape_distance = 5.0;
  LocalTrajectoryPlanner ltp = make(options);
  // A lane along x, closed in the west; free cells lie in the east alone.
  std::vector<std::array<int, 2>> lane;
  for (int dx = -3; dx <= 3; ++dx) {
    for (const int dy : {-3, -2, -1, 1, 2, 3}) {
      if (dx < 1 || std::abs(dy) > 1) lane.push_back({dx, dy});
    }
  }
  lane.push_back({-1, 0});
  ltp.sense(kStart, cells(lane), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Escaping);
  ltp.sense(kStart, cells({{1, 0}, {1, 1}, {1, -1}}), kNothing);
  EXPECT_EQ(ltp.update(kStart), NavigationStatus::Holding);
  EXPECT_EQ(ltp.reason(), NavigationReason::NoEscape);
  EXPECT_EQ(ltp.path().rows(), 0);
  ltp.update(kStart);
  EXPECT_EQ(ltp.status(), NavigationStatus::Holding);
  EXPECT_TRUE(ltp.events().empty());
}

TEST(Escape, IsLookedForAgainWhereAHoldingUavHasGot) {
  NavigationOptions options;
  options.escape_distance = 5.0;
  LocalTrajectoryPlanner ltp = make(options);
  std::vector<std::array<int, 2>> plate;
  for (int dx = -3; dx <= 3; ++dx) {
    for (int dy = -3; dy <= 3; ++dy) {
      if (dx != 0 || dy != 0) plate.push_back({dx, dy});
    }
  }
  ltp.sense(kStart, cells(plate), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Holding);
  ASSERT_EQ(ltp.reason(), NavigationReason::NoEscape);
  EXPECT_EQ(ltp.update(kStart + Point(0.5, 0, 0)), NavigationStatus::Holding);
  // It brakes, or the wind carries it; the map stays as it is.
  EXPECT_EQ(ltp.update(kStart + Point(0, 8, 0)), NavigationStatus::Escaping);
  EXPECT_EQ(ltp.update(kStart + Point(0, 20, 0)), NavigationStatus::Following);
}

TEST(Escape, IsBegunWhereAHoldingUavDriftsTooNearToWhatWasHit) {
  LocalTrajectoryPlanner ltp = make();
  std::vector<std::array<int, 2>> ring;
  for (int i = -4; i <= 4; ++i) {
    ring.insert(ring.end(), {{i, -4}, {i, 4}, {-4, i}, {4, i}});
  }
  ltp.sense(kStart, cells(ring), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Holding);
  ASSERT_EQ(ltp.reason(), NavigationReason::WalledIn);
  const int plans = ltp.plans_made();
  EXPECT_EQ(ltp.update(kStart + Point(2, 0, 0)), NavigationStatus::Holding);
  EXPECT_EQ(ltp.plans_made(), plans) << "elsewhere in the same court";
  EXPECT_EQ(ltp.update(kStart + Point(6, 0, 0)), NavigationStatus::Escaping);
}

TEST(Escape, EndsElsewhereWhenItsEndIsFreeNoMore) {
  LocalTrajectoryPlanner ltp = make();
  ltp.sense(kStart, cells({{-1, 0}, {-1, 1}, {-1, -1}, {1, 1}, {0, 1}}), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Escaping);
  const Point first = end_of(ltp.path());
  // Beside its end, not on its way.
  const Point beside = first + (first - kStart).normalized() * 2.5;
  ltp.sense(kStart, beside.transpose(), kNothing);
  ASSERT_TRUE(ltp.map().blocked().blocked_at(first));
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Escaping);
  EXPECT_NE(end_of(ltp.path()), first);
  expect_sound(ltp, kStart);
}

TEST(Escape, StandsWhileNothingComesInItsWay) {
  LocalTrajectoryPlanner ltp = make();
  // Far to go: the way out is longer than the distance within which an end counts as reached.
  std::vector<std::array<int, 2>> west;
  for (int dy = -4; dy <= 4; ++dy) {
    for (int dx = -4; dx <= -1; ++dx) west.push_back({dx, dy});
    if (dy != 0) west.push_back({0, dy}), west.push_back({1, dy}), west.push_back({2, dy});
  }
  ltp.sense(kStart, cells(west), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Escaping);
  const std::int64_t id = ltp.path_id();
  const Path far = Point(kStart + Point(0, 30, 0)).transpose();
  Point position = kStart;
  ASSERT_GT(length(ltp.path()), 4.0);
  for (int step = 0; step < 4; ++step) {
    position = point_at(ltp.path(), 0.3 * step);
    ltp.sense(position, far, kNothing);  // what is new to the mission is allocated for
    const std::int64_t before = test::allocations();
    ltp.sense(position, far, kNothing);
    ltp.update(position);
    EXPECT_EQ(test::allocations() - before, 0);
    EXPECT_EQ(ltp.path_id(), id) << "step " << step;
  }
}

TEST(Escape, NeverLeadsThroughACellThatWasHit) {
  Random random(7);
  int escapes = 0;
  int behind = 0;  // the nearest free cell lay behind a hit
  for (int scene = 0; scene < 400; ++scene) {
    NavigationOptions options;
    if (scene % 3 == 0) options.band = {8.0, 8.0};
    LocalTrajectoryPlanner ltp = make(options);
    Point position = kStart + Point(uniform(random, -1, 1), uniform(random, -1, 1), 0);
    const int count = 2 + static_cast<int>(random() % 60);
    Path hits(count, 3);
    for (int i = 0; i < count; ++i) {
      hits.row(i) = (position + Point(uniform(random, -9, 9), uniform(random, -9, 9),
                                      scene % 3 == 0 ? uniform(random, -8, 8) : 0.0))
                        .transpose();
    }
    // Scans bring the hits a few at a time (a blind sector, drop-outs); the UAV flies meanwhile.
    for (int first = 0; first < count; first += 5) {
      const int some = std::min(5, count - first);
      if (random() % 4 > 0) ltp.sense(position, hits.middleRows(first, some), kNothing);
      ltp.update(position);
      if (ltp.status() == NavigationStatus::Escaping) {
        ++escapes;
        expect_sound(ltp, position);
        const GridFrame& frame = ltp.map().blocked().frame();
        const double size = length(ltp.path());
        const Cell own = frame.cell_of(position);
        for (int dx = -3; dx <= 3; ++dx) {
          for (int dy = -3; dy <= 3; ++dy) {
            const Cell cell = own + Cell(dx, dy, 0);
            const double distance = (frame.centre(cell) - position).norm();
            behind += !ltp.map().blocked().blocked(cell) && distance < size - 1e-9;
          }
        }
      }
      if (ltp.path().rows() > 0) {
        const double arc = closest_point(ltp.path(), position, 0.0).arc_length;
        position = point_at(ltp.path(), arc + 0.3);
      }
      if (testing::Test::HasFailure()) return;
    }
  }
  EXPECT_GT(escapes, 300);
  EXPECT_GT(behind, 50);
}

TEST(Escape, GivesWayToAnObstacleThatMoves) {
  ObstacleMapOptions map = small_map();
  map.carve_free_space = true;
  map.keep_hits = false;
  LocalTrajectoryPlanner ltp = make({}, map);
  Point position = kStart;
  std::set<std::string> seen;
  // It crosses the way out from the north, 1 m a scan; every second scan is lost.
  for (int scan = 0; scan < 60; ++scan) {
    const Point other(4.0, 16.0 - scan, kStart.z());
    Path hits(6, 3);
    for (int i = 0; i < 3; ++i) {
      hits.row(i) = (other + Point(0, i - 1.0, 0)).transpose();
      hits.row(3 + i) = Point(-1.5, i - 1.0, kStart.z()).transpose();  // a wall in the west
    }
    if (scan % 2 == 0) {
      Path misses(90, 3);
      for (int i = 0; i < 90; ++i) {
        const double turn = i * M_PI / 45;
        misses.row(i) = (position + 30.0 * Point(std::cos(turn), std::sin(turn), 0.0)).transpose();
      }
      ltp.sense(position, hits, misses);
    }
    ltp.update(position);
    seen.insert(std::string(to_string(ltp.status())));
    if (ltp.status() == NavigationStatus::Escaping) expect_sound(ltp, position);
    if (ltp.path().rows() > 0) {
      const double arc = closest_point(ltp.path(), position, 0.0).arc_length;
      position = point_at(ltp.path(), arc + 0.3);
    }
    ASSERT_FALSE(testing::Test::HasFailure()) << "scan " << scan;
  }
  EXPECT_EQ(seen.count("escaping"), 1u);
  EXPECT_EQ(seen.count("following"), 1u);
}

TEST(Escape, IsWatchedByTheSensorsThreadToo) {
  ConcurrentTrajectoryPlanner ltp(make_planner("ggwp"), small_map(), {}, no_priority(), kStart);
  ltp.set_waypoints(kGoal.transpose());
  ltp.sense(kStart, cells({{-1, 0}}), kNothing);
  ltp.plan();
  ASSERT_EQ(ltp.decision().status, NavigationStatus::Escaping);
  EXPECT_EQ(ltp.decision().reason, NavigationReason::StartBlocked);
  EXPECT_FALSE(ltp.blocked_at().has_value());
  const Point out = end_of(ltp.decision().path);
  ltp.sense(kStart, out.transpose(), kNothing);
  ASSERT_TRUE(ltp.blocked_at().has_value()) << "before the planning thread knows";
  EXPECT_LE(*ltp.blocked_at(), 2.0);
  ltp.plan();
  ltp.decision();
  EXPECT_FALSE(ltp.blocked_at().has_value());
  EXPECT_NE(end_of(ltp.decision().path), out);
}

TEST(Reason, IsNoneWhereThereIsAPathAndSaidWhereThereIsNone) {
  LocalTrajectoryPlanner ltp = make();
  EXPECT_EQ(ltp.reason(), NavigationReason::Undecided);
  ltp.update(kStart);
  EXPECT_EQ(ltp.status(), NavigationStatus::Following);
  EXPECT_EQ(ltp.reason(), NavigationReason::None);
  for (int i = 1; i <= static_cast<int>(NavigationReason::AllDropped); ++i) {
    EXPECT_GT(sentence(static_cast<NavigationReason>(i)).size(), 20u);
  }
}

TEST(Reason, TellsGroundFromWallFromBudget) {
  NavigationOptions near;
  near.escape_distance = 5.0;
  std::vector<std::array<int, 2>> all;
  for (int dx = -6; dx <= 6; ++dx) {
    for (int dy = -6; dy <= 6; ++dy) all.push_back({dx, dy});
  }
  const Path plate = cells(all);
  ObstacleMapOptions map = small_map();
  map.blind_distance = 0.0;                // the UAV stands in what it hits
  for (const double below : {0.0, 4.0}) {  // the UAV's own cells, and the ground's just below
    LocalTrajectoryPlanner ltp = make(near, map);
    ltp.sense(kStart, Path(plate.rowwise() - Eigen::RowVector3d(0, 0, below)), kNothing);
    EXPECT_EQ(ltp.update(kStart), NavigationStatus::Holding);
    EXPECT_EQ(ltp.reason(), NavigationReason::StartInGround);
  }
  std::vector<std::array<int, 2>> ring;
  for (int i = -4; i <= 4; ++i) {
    ring.insert(ring.end(), {{i, -4}, {i, 4}, {-4, i}, {4, i}});
  }
  LocalTrajectoryPlanner walled = make();
  walled.sense(kStart, cells(ring), kNothing);
  EXPECT_EQ(walled.update(kStart), NavigationStatus::Holding);
  EXPECT_EQ(walled.reason(), NavigationReason::WalledIn);

  NavigationOptions poor;
  poor.max_expansions = 1;
  LocalTrajectoryPlanner spent = make(poor, small_map(), Point(31, 1, 50).transpose(), "lp-a-star");
  std::vector<std::array<int, 2>> wall;
  for (int dy = -6; dy <= 6; ++dy) wall.push_back({5, dy});
  spent.sense(kStart, cells(wall), kNothing);
  EXPECT_EQ(spent.update(kStart), NavigationStatus::Holding);
  EXPECT_EQ(spent.reason(), NavigationReason::OutOfBudget);
}

TEST(Reason, SaysThatAllWaypointsWereDropped) {
  Path two(2, 3);
  two << 21, 1, 50, 21, 21, 50;
  LocalTrajectoryPlanner ltp = make({}, small_map(), two);
  ltp.sense(kStart, two, kNothing);
  EXPECT_EQ(ltp.update(kStart), NavigationStatus::Finished);
  EXPECT_EQ(ltp.reason(), NavigationReason::AllDropped);
  ASSERT_EQ(ltp.events().size(), 2u);
  for (const WaypointEvent& event : ltp.events()) {
    EXPECT_EQ(event.why, NavigationReason::GoalBlocked);
    EXPECT_EQ(event.reason, PlanStatus::GoalBlocked);
  }
}

TEST(Reach, AWaypointAboveOrBelowByMoreThanACellIsNotYetReached) {
  for (const double dz : {-12.0, -4.5, -3.5, 0.0, 3.5, 4.5, 12.0}) {
    NavigationOptions options;
    options.band = {20.0, 20.0};
    LocalTrajectoryPlanner ltp = make(options, small_map(), (kStart + Point(0, 0, dz)).transpose());
    ltp.update(kStart);
    EXPECT_EQ(ltp.status() == NavigationStatus::Finished, std::abs(dz) <= 4.0) << dz;
  }
}

TEST(Reach, AUavThatHeldTurnsToTheNextWaypointWhenItHasReachedOne) {
  Path two(2, 3);
  two << 21, 1, 50, 1, 31, 50;
  NavigationOptions poor;
  poor.max_expansions = 1;
  LocalTrajectoryPlanner ltp = make(poor, small_map(), two, "lp-a-star");
  std::vector<std::array<int, 2>> wall;
  for (int dy = -6; dy <= 6; ++dy) wall.push_back({5, dy});
  ltp.sense(kStart, cells(wall), kNothing);
  ASSERT_EQ(ltp.update(kStart), NavigationStatus::Holding);
  EXPECT_EQ(ltp.reason(), NavigationReason::OutOfBudget);
  ltp.update(Point(19.5, 1, 50));  // carried there; the map is the same
  EXPECT_EQ(ltp.events().size(), 1u);
  EXPECT_EQ(ltp.plans_made(), 2);
}

}  // namespace
}  // namespace ltp
