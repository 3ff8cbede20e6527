// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// How high a UAV may climb: over its waypoints, not over where it has got to.
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "ltp/navigation/local_trajectory_planner.hpp"
#include "navigation/mazes.hpp"
#include "scenes.hpp"

namespace ltp {
namespace {

using namespace test;

constexpr double kWithin = 1e-9;  // [m]

TEST(Climb, NoPathRisesAboveTheCeilingOfItsLegUnlessTheUavIsThere) {
  Random random(20);
  int legs = 0;
  int rising = 0;
  for (int number = 0; number < 200; ++number) {
    const int edge = draw(random, 28, 40);
    const World world = number % 2 == 0 ? maze(random, edge) : city(random, edge);
    const GridFrame& frame = world.truth.frame();
    Cell start;
    do start = random_cell(random, world, draw(random, 1, kLevels - 1));
    while (!world.is_free(start));
    Path waypoints(4, 3);
    for (int i = 0; i < 4; ++i) {
      const Cell cell = random_cell(random, world, draw(random, 1, kLevels - 1));
      waypoints.row(i) = frame.centre(cell).transpose();
    }
    NavigationOptions options;
    options.climb = 0.1 * draw(random, 1, 120);
    options.band.above = 0.5 * draw(random, 0, 20);  // counts for nothing
    options.horizon = draw(random, 1, 3);
    options.gate_radius = 2.0 * draw(random, 0, 3);
    options.gate_height = 2.0 * draw(random, 0, 6);
    PlannerOptions planner;
    planner.weights = {1.0, number % 3 == 0 ? 1.0 : 0.0};
    Flight flight(world, "auto", planner, options, random_priority(frame, random()),
                  frame.centre(start));
    flight.fly(waypoints, 4000.0);
    const int last = std::min(flight.navigator().waypoint_index(), 3);
    for (int i = 0; i <= last; ++i, ++legs) {
      const int ahead = std::min(options.horizon, 4 - i);
      const double highest = waypoints.col(2).segment(i, ahead).maxCoeff();
      const double begin = flight.begin_of(i).z();
      const double allowed = std::max(begin, highest + options.climb);
      EXPECT_LE(flight.highest_to(i), allowed + kWithin) << "world " << number << ", leg " << i;
      rising += flight.highest_to(i) > std::max(begin, highest) + kWithin;
    }
  }
  EXPECT_GT(legs, 600);
  EXPECT_GT(rising, 50);
}

/// A wall across the whole window before a UAV that has climbed: the highest point of its path [m].
double over_the_wall(const NavigationOptions& options) {
  const Point position(0, 0, 62);
  ObstacleMapOptions map;
  map.dims = {60, 60, 12};  // 120 x 120 x 48 m
  LocalTrajectoryPlanner ltp(map, options, Raster(Raster::Values::Zero(1, 1), {0, 0}, 1.0),
                             position);
  Path waypoint(1, 3);
  waypoint << 40, 0, 50;
  ltp.set_waypoints(waypoint);
  Path hits(241 * 12, 3);
  for (int i = 0; i < hits.rows(); ++i) hits.row(i) << 20, 0.5 * (i % 241) - 60, 44 + 2 * (i / 241);
  ltp.sense(position, hits, Path(0, 3));
  EXPECT_EQ(ltp.update(position), NavigationStatus::Following);
  return ltp.path().col(2).maxCoeff();
}

TEST(Climb, WhoHasClimbedMayNotClimbAgain) {
  NavigationOptions options;
  options.band = {0.0, 16.0};
  EXPECT_GT(over_the_wall(options), 70.0) << "the band counts from where it is";
  options.climb = 16.0;
  EXPECT_LE(over_the_wall(options), 66.0) << "it flies round";
  options.climb = 28.0;
  EXPECT_GT(over_the_wall(options), 70.0);
}

TEST(Climb, GivesTheBandOfALeg) {
  NavigationOptions options;
  options.band = {4.0, 8.0};
  EXPECT_EQ(options.band_from(60.0, 50.0).above, 8.0);
  options.climb = 20.0;
  EXPECT_EQ(options.band_from(30.0, 50.0).above, 20.0);
  EXPECT_EQ(options.band_from(60.0, 50.0).above, 10.0);
  EXPECT_EQ(options.band_from(80.0, 50.0).above, 0.0);
  EXPECT_EQ(options.band_from(80.0, 50.0).below, 4.0);
  options.climb = kInfinity;
  EXPECT_EQ(options.band_from(80.0, 50.0).above, kInfinity);
  options.climb = -1.0;
  EXPECT_THROW(options.check(), std::invalid_argument);
  options.climb = kNan;
  EXPECT_THROW(options.check(), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
