// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// In mazes and cities larger than any window every waypoint is reached or dropped by proof.
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "navigation/mazes.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using namespace test;

constexpr int kEdge = 100;  ///< of the largest worlds [cells]

struct Kind {
  std::string_view planner;
  double priority_weight;
  AltitudeBand band;
  double climb = 0.0;
};

const Kind kKinds[] = {
    {"additive", 0.0, {0.0, 0.0}},
    {"auto", 2.0, {0.0, 0.0}},
    {"ggwp", 0.0, {0.0, 0.0}},
    {"lp-dijkstra", 1.0, {0.0, 0.0}},
    {"auto", 0.0, {0.0, 0.0}},
    {"additive", 0.0, {4.0, 4.0}},
    {"auto", 2.0, {4.0, 6.0}},
    {"ggwp", 0.0, {4.0, 8.0}},
    {"additive", 0.0, {0.0, 0.0}, 4.0},
    {"auto", 2.0, {4.0, 0.0}, 8.0},
    {"lp-dijkstra", 1.0, {0.0, 0.0}, 5.5},
};

struct Tally {
  int reached = 0;
  int dropped = 0;
  int walled_in = 0;
  int beyond = 0;  ///< unreachable ones that lay beyond the window when they were dropped
};

void fly_one(Random& random, int number, Tally& tally) {
  const int edge = number % 20 == 0 ? kEdge : draw(random, 28, 44);
  const World world = number % 2 == 0 ? maze(random, edge) : city(random, edge);
  const GridFrame& frame = world.truth.frame();
  const Kind& kind = kKinds[random() % std::size(kKinds)];
  Cell start;
  do start = random_cell(random, world, kLevel);
  while (!world.is_free(start));
  Path waypoints(3, 3);
  for (int i = 0; i < 3; ++i) {
    waypoints.row(i) = frame.centre(random_cell(random, world, kLevel)).transpose();
  }
  const std::string what = "world " + std::to_string(number) + ", " + std::string(kind.planner);
  PlannerOptions options;
  options.weights = {1.0, kind.priority_weight};
  NavigationOptions navigation;
  navigation.band = kind.band;
  navigation.climb = kind.climb;
  Flight flight(world, kind.planner, options, navigation, random_priority(frame, random()),
                frame.centre(start));
  // No farther than once through every column of the world; the worst measured took a third of it.
  const double cells = static_cast<double>(frame.nx()) * frame.ny();
  const double most = cells * kCell.x();
  ASSERT_TRUE(flight.fly(waypoints, most)) << what << " flies for ever";
  EXPECT_FALSE(flight.crashed()) << what;

  const Navigator& navigator = flight.navigator();
  /// Over the altitudes that the leg to a waypoint leaves open.
  const auto reached_from = [&](const Point& from, int waypoint) {
    const Point goal = waypoints.row(waypoint).transpose();
    const Point& begin = flight.begin_of(waypoint);
    const AltitudeBand band = navigation.band_from(begin.z(), goal.z());
    const LevelRange levels = levels_of(frame, {begin, goal, band});
    const auto seen = reachable(world.truth, frame.cell_of(goal), levels);
    return seen[static_cast<std::size_t>(frame.index(frame.cell_of(from)))] != 0;
  };
  for (const WaypointEvent& event : navigator.events()) {
    if (event.reached) {
      ++tally.reached;
      continue;
    }
    ++tally.dropped;
    if (event.why == NavigationReason::GoalBlocked) {
      EXPECT_TRUE(world.truth.blocked_at(event.goal)) << what;
    } else {
      ASSERT_EQ(event.why, NavigationReason::Unreachable) << what;
      EXPECT_FALSE(reached_from(event.position, event.index)) << what;
      tally.beyond +=
          ((event.goal - event.position).head<2>().cwiseAbs().array() > kWindow / 2 * kCell.x())
              .any();
    }
  }
  if (navigator.status() == NavigationStatus::Holding) {
    ASSERT_EQ(navigator.reason(), NavigationReason::WalledIn) << what;
    EXPECT_FALSE(reached_from(flight.position(), navigator.waypoint_index())) << what;
    ++tally.walled_in;
  }
}

TEST(Termination, EveryWaypointIsReachedOrDroppedByProof) {
  Random random(11);
  Tally tally;
  for (int number = 0; number < 1000; ++number) {
    fly_one(random, number, tally);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(tally.reached, 1000);
  EXPECT_GT(tally.dropped, 200);
  EXPECT_GT(tally.beyond, 10);
  EXPECT_GT(tally.walled_in, 10);
}

}  // namespace
}  // namespace ltp
