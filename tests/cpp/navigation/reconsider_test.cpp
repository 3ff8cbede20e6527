// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Another priority or other weights in mid-air: when a path is kept, and when a better one is
// taken.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "ltp/cost/penalty.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

constexpr double kAltitude = 50.0;
const Path kNothing(0, 3);

ObstacleMapOptions small_map() {
  ObstacleMapOptions options;
  options.dims = {60, 60, 8};  // 120 x 120 x 32 m
  return options;
}

/// 0, but for a strip of the given priority beside the straight way from (0, 0) to (40, 0).
Raster strip(double priority) {
  Raster::Values values = Raster::Values::Zero(80, 80);
  values.block(0, 43, 80, 4) = priority;
  return Raster(values, {-80, -80}, 2.0);
}

LocalTrajectoryPlanner make(const NavigationOptions& options = {},
                            const PlannerOptions& planner = {}) {
  return LocalTrajectoryPlanner(make_planner("auto", planner), small_map(), options, strip(0.0),
                                Point(0, 0, kAltitude));
}

Path one(double x, double y) {
  Path path(1, 3);
  path << x, y, kAltitude;
  return path;
}

/// Eq. (5) of a path from where it is nearest to a position, in many small pieces.
double rest_penalty(const Path& path, const Point& position, const Raster& priority,
                    const PenaltyWeights& weights, double direct) {
  const double from = closest_point(path, position).arc_length;
  const double left = length(path) - from;
  std::vector<Point> points{position};
  for (int i = 1; i <= 4000; ++i) points.push_back(point_at(path, from + left * i / 4000.0));
  Path rest(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    rest.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  }
  return Penalty(weights, direct)(tally(rest, priority));
}

/// One that has flown a third of its straight way.
struct UnderWay {
  explicit UnderWay(const NavigationOptions& options = {}) : ltp(make(options)) {
    ltp.set_waypoints(one(40, 0));
    ltp.update({0, 0, kAltitude});
    position = point_at(ltp.path(), 13.0);
    ltp.update(position);
    id = ltp.path_id();
  }
  LocalTrajectoryPlanner ltp;
  Point position;
  std::int64_t id;
};

/// What a new path gains on the rest of the old one, in the strip's priority.
double gain_of(double priority) {
  UnderWay uav;
  const Path old = uav.ltp.path();
  uav.ltp.set_priority(strip(priority));
  uav.ltp.update(uav.position);
  const PenaltyWeights weights;
  const double direct = (Point(40, 0, kAltitude) - uav.position).norm();
  return rest_penalty(old, uav.position, strip(priority), weights, direct) -
         uav.ltp.plans().back().plan.penalty;
}

TEST(Reconsider, WithoutAMarginThePathIsGivenUpAtOnce) {
  UnderWay uav;
  uav.ltp.set_priority(strip(0.0));
  EXPECT_EQ(uav.ltp.path().rows(), 0);
  uav.ltp.update(uav.position);
  EXPECT_NE(uav.ltp.path_id(), uav.id);
  EXPECT_EQ(uav.ltp.plans_made(), 2);
}

TEST(Reconsider, APathIsKeptUnlessTheNewOneIsBetterByMoreThanTheMargin) {
  const double gain = gain_of(1.0);
  ASSERT_GT(gain, 0.05);
  for (const double share : {0.5, 0.98, 1.02, 3.0}) {
    UnderWay uav;
    const Path old = uav.ltp.path();
    uav.ltp.set_priority(strip(1.0), share * gain);
    EXPECT_EQ(uav.ltp.path(), old) << "it stands until there is a better one";
    EXPECT_EQ(uav.ltp.update(uav.position), NavigationStatus::Following);
    EXPECT_EQ(uav.ltp.plans_made(), 2);
    EXPECT_EQ(uav.ltp.path_id() == uav.id, share > 1.0) << "share " << share;
    EXPECT_EQ(uav.ltp.path() == old, share > 1.0) << "share " << share;
    uav.ltp.update(uav.position);
    EXPECT_EQ(uav.ltp.plans_made(), 2) << "it is asked once";
  }
}

TEST(Reconsider, AsManySmallChangesAsOneLikesTurnNobodyAbout) {
  for (const double margin : {0.0, 0.02}) {
    UnderWay uav;
    for (int i = 0; i < 20; ++i) {
      uav.ltp.set_priority(strip(i % 2 == 0 ? 0.01 : 0.0), margin);
      uav.ltp.update(uav.position);
    }
    EXPECT_EQ(uav.ltp.path_id() == uav.id, margin > 0.0);
    EXPECT_EQ(uav.ltp.plans_made(), 21);
  }
}

TEST(Reconsider, OtherWeightsCountInPlaceWithoutLosingMapOrWaypoints) {
  for (const double margin : {0.0, 0.01, 10.0}) {
    UnderWay uav;
    uav.ltp.sense(uav.position, one(0, 40), kNothing);
    uav.ltp.set_priority(strip(0.5), 10.0);
    uav.ltp.update(uav.position);
    ASSERT_EQ(uav.ltp.path_id(), uav.id);
    PlannerOptions options;
    options.weights = {0.1, 5.0};
    uav.ltp.set_planner(make_planner("auto", options), margin);
    EXPECT_EQ(uav.ltp.planner().weights().priority, 5.0);
    uav.ltp.update(uav.position);
    const bool turned = uav.ltp.path().col(1).maxCoeff() > 6.0;
    EXPECT_EQ(turned, margin < 10.0) << "margin " << margin;
    EXPECT_EQ(uav.ltp.waypoints().rows(), 1);
    EXPECT_EQ(uav.ltp.map().occupied().count(), 1);
  }
}

TEST(Reconsider, ABlockedPathIsNotKeptWhateverTheMargin) {
  UnderWay uav;
  Path wall(160, 3);
  for (int i = 0; i < 160; ++i) wall.row(i) << 28, -8 + 0.1 * i, kAltitude;
  uav.ltp.set_priority(strip(0.0), 100.0);
  uav.ltp.sense(uav.position, wall, kNothing);
  EXPECT_EQ(uav.ltp.update(uav.position), NavigationStatus::Following);
  EXPECT_NE(uav.ltp.path_id(), uav.id);
  EXPECT_FALSE(uav.ltp.map().blocked().first_blocked(uav.ltp.path()).has_value());
  EXPECT_EQ(uav.ltp.plans_made(), 2);
}

TEST(Reconsider, WhoHoldsTriesAgainAndWhoHasArrivedGoesOn) {
  UnderWay uav;
  uav.ltp.set_priority(strip(1.0), 0.5);
  uav.ltp.update({40, 0, kAltitude});
  EXPECT_EQ(uav.ltp.status(), NavigationStatus::Finished);
  EXPECT_EQ(uav.ltp.plans_made(), 1);

  LocalTrajectoryPlanner held = make();
  Path court(160, 3);
  for (int i = 0; i < 40; ++i) {
    const double along = 0.5 * i - 10.0;
    court.row(4 * i) << along, -10, kAltitude;
    court.row(4 * i + 1) << along, 10, kAltitude;
    court.row(4 * i + 2) << -10, along, kAltitude;
    court.row(4 * i + 3) << 10, along, kAltitude;
  }
  held.set_waypoints(one(40, 0));
  held.sense(Point(0, 0, kAltitude), court, kNothing);
  ASSERT_EQ(held.update({0, 0, kAltitude}), NavigationStatus::Holding);
  const std::int64_t before = held.plans_made();
  held.set_planner(make_planner("ggwp"), 0.5);
  EXPECT_EQ(held.update({0, 0, kAltitude}), NavigationStatus::Holding);
  EXPECT_EQ(held.plans_made(), before + 1);
}

TEST(Reconsider, AnEscapeStaysWhereThereIsAMargin) {
  LocalTrajectoryPlanner ltp = make();
  const Point position(1, 1, kAltitude);
  ltp.set_waypoints(one(40, 0));
  ltp.sense(position, one(3, 1), kNothing);
  ASSERT_EQ(ltp.update(position), NavigationStatus::Escaping);
  const Path way = ltp.path();
  ltp.set_priority(strip(1.0), 0.1);
  EXPECT_EQ(ltp.path(), way) << "it knows no priorities";
  EXPECT_EQ(ltp.update(position), NavigationStatus::Escaping);
  EXPECT_EQ(ltp.path(), way);
  EXPECT_EQ(ltp.plans_made(), 0);
  ltp.set_priority(strip(1.0));
  EXPECT_EQ(ltp.path().rows(), 0);
  EXPECT_EQ(ltp.update(position), NavigationStatus::Escaping);
}

TEST(Reconsider, RefusesWhatIsNoMarginAndNoPlanner) {
  UnderWay uav;
  EXPECT_THROW(uav.ltp.set_priority(strip(1.0), -1.0), std::invalid_argument);
  EXPECT_THROW(uav.ltp.set_priority(strip(1.0), test::kNan), std::invalid_argument);
  EXPECT_THROW(uav.ltp.set_planner(make_planner(), test::kInfinity), std::invalid_argument);
  EXPECT_THROW(uav.ltp.set_planner(nullptr), std::invalid_argument);
  EXPECT_EQ(uav.ltp.path_id(), uav.id) << "nothing has changed";
  EXPECT_TRUE((uav.ltp.priority().values() == 0.0).all());
}

/// On random maps, priorities, weights, gates and horizons: what is flown afterwards is never worse
/// than the rest of the old path, nor than the new one by more than the margin.
TEST(Reconsider, OnRandomMapsTheBetterOneByTheMarginIsFlown) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int kept = 0;
  int taken = 0;
  for (int trial = 0; trial < 150; ++trial) {
    NavigationOptions options;
    options.horizon = 1 + trial % 3;
    options.gate_radius = trial % 2 == 0 ? 0.0 : 8.0;
    const GridFrame area({-80, -80, 0}, {2, 2, 4}, {80, 80, 20});
    LocalTrajectoryPlanner ltp(make_planner(), small_map(), options,
                               test::random_priority(area, random()), {-30, 0, kAltitude});
    Path waypoints(3, 3);
    waypoints << 0, 20 * unit(random) - 10, kAltitude, 20, 20 * unit(random) - 10, kAltitude, 45,
        30 * unit(random) - 15, kAltitude;
    Path hits(12, 3);
    for (int i = 0; i < 12; ++i) {
      hits.row(i) << 60 * unit(random) - 25, 50 * unit(random) - 25, kAltitude;
    }
    Point position(-30, 0, kAltitude);
    ltp.set_waypoints(waypoints);
    ltp.sense(position, hits, kNothing);
    if (ltp.update(position) != NavigationStatus::Following) continue;
    position = point_at(ltp.path(), 10.0 * unit(random));
    if (ltp.update(position) != NavigationStatus::Following) continue;
    const Path old = ltp.path();
    const std::int64_t id = ltp.path_id();
    const std::int64_t plans = ltp.plans_made();
    const Raster other = test::random_priority(area, random());
    const double margin = 0.001 + 0.8 * unit(random);
    PenaltyWeights weights;
    ltp.set_priority(other, margin);
    if (trial % 2 == 0) {
      weights = {0.2 + unit(random), 2.0 * unit(random)};
      PlannerOptions planner;
      planner.weights = weights;
      ltp.set_planner(make_planner("auto", planner), margin);
    }
    ASSERT_EQ(ltp.update(position), NavigationStatus::Following);
    ASSERT_EQ(ltp.plans_made(), plans + 1);
    const PlanRecord& record = ltp.plans().back();
    ASSERT_EQ(record.plan.status, PlanStatus::Found);
    const double fresh = record.plan.penalty;
    const double rest = rest_penalty(old, position, other, weights, record.direct_length);
    const double slack = 2e-3 * (weights.length + weights.priority);  // of the small pieces
    if (ltp.path_id() == id) {
      ++kept;
      EXPECT_EQ(ltp.path(), old);
      EXPECT_LE(rest, fresh + margin + slack) << "trial " << trial;
    } else {
      ++taken;
      EXPECT_EQ(ltp.path(), record.plan.path);
      EXPECT_LT(fresh + margin, rest + slack) << "trial " << trial;
    }
    EXPECT_FALSE(ltp.map().blocked().first_blocked(ltp.path()).has_value());
  }
  EXPECT_GT(kept, 20);
  EXPECT_GT(taken, 20);
}

TEST(Reconsider, EventsOutliveTheirWaypointsUntilTheyAreTaken) {
  LocalTrajectoryPlanner ltp = make();
  ltp.set_waypoints(one(1, 0));
  ltp.update({0, 0, kAltitude});
  ltp.set_waypoints(one(0, 1));
  EXPECT_TRUE(ltp.events().empty()) << "these are about the waypoints that are flown";
  ltp.update({0, 0, kAltitude});
  const std::vector<WaypointEvent> events = ltp.take_events();
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].route, 1);
  EXPECT_EQ(events[0].goal, Point(1, 0, kAltitude));
  EXPECT_EQ(events[1].route, 2);
  EXPECT_EQ(events[1].goal, Point(0, 1, kAltitude));
  EXPECT_TRUE(ltp.take_events().empty()) << "each is told once";
  EXPECT_EQ(ltp.events().size(), 1u);
}

}  // namespace
}  // namespace ltp
