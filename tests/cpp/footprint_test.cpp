// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the loop that flies takes from the heap, over whole flights at the paper's size: 200 x 200 x
// 40 cells.
#include <gtest/gtest.h>

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "allocations.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "ltp/sensing/lidar.hpp"

namespace ltp {
namespace {

constexpr std::int64_t kMegabyte = 1 << 20;
constexpr double kStep = 1.0;  // between scans [m]
const Point kStart(62, 62, 50);

/// Blocks of 28 m, a street every 40 m, a third of them above the flight.
Raster town() {
  Raster::Values heights = Raster::Values::Zero(700, 400);
  std::mt19937 random(1);
  for (int x = 66; x + 28 < 700; x += 40) {
    for (int y = 66; y + 28 < 400; y += 40) {
      heights.block(x, y, 28, 28) = 10.0 + static_cast<double>(random() % 60);
    }
  }
  return Raster(heights, {0, 0}, 1.0);
}

Raster priority() {
  Raster::Values values(350, 200);
  std::mt19937 random(2);
  for (auto& value : values.reshaped()) value = (random() % 1000) / 999.0;
  return Raster(values, {0, 0}, 2.0);
}

/// 500 m straight across the town, waypoints every 50 m, some of them inside of blocks.
Path global_path() {
  Path path(10, 3);
  for (int i = 0; i < 10; ++i) {
    path.row(i) = (kStart + 50.0 * (i + 1) * Point(0.9, 0.43589, 0)).transpose();
  }
  return path;
}

Eigen::Map<const Path> rows(const std::vector<Point>& points) {
  return {points.empty() ? nullptr : points.front().data(),
          static_cast<Eigen::Index>(points.size()), 3};
}

Pose pose(const Point& position) { return {position, Eigen::Quaterniond::Identity()}; }

struct Footprint {
  std::int64_t most = 0;      ///< bytes at any time, from before the planner was made
  std::int64_t standing = 0;  ///< allocations of all steps at which no plan was made
  std::int64_t planning = 0;  ///< of the others
  std::int64_t plans = 0;
  int steps = 0;
  bool finished = false;
};

/// By the default planner and options, remembering the mission or not. Flies along whatever path
/// there is, without inertia; the world and its scans are not counted.
Footprint fly(bool remember) {
  const HeightSurface world(town());
  const Lidar lidar;
  const Path waypoints = global_path();
  Scan scan;
  Point position = kStart;
  lidar.scan(world, pose(position), 0, scan);
  Footprint footprint;
  const std::int64_t before = test::bytes();
  ObstacleMapOptions options;
  options.remember = remember;
  LocalTrajectoryPlanner ltp(options, {}, priority(), position);
  ltp.set_waypoints(waypoints);
  while (footprint.steps < 3000 && !footprint.finished) {
    lidar.scan(world, pose(position), ++footprint.steps, scan);
    const std::int64_t allocations = test::allocations();
    ltp.sense(scan.origin, rows(scan.hits), rows(scan.misses));
    footprint.finished = ltp.update(position) == NavigationStatus::Finished;
    const std::int64_t made = std::exchange(footprint.plans, ltp.plans_made());
    (made == footprint.plans ? footprint.standing : footprint.planning) +=
        test::allocations() - allocations;
    if (ltp.path().rows() == 0) continue;
    position = point_at(ltp.path(), closest_point(ltp.path(), position).arc_length + kStep);
  }
  footprint.most = test::most_bytes() - before;
  return footprint;
}

TEST(Footprint, OfAPlanarFlightStaysUnder32MegabytesAndAllocatesOnlyToPlan) {
  for (const bool remember : {false, true}) {
    const Footprint footprint = fly(remember);
    EXPECT_TRUE(footprint.finished);
    EXPECT_GT(footprint.plans, 10);
    EXPECT_LT(footprint.most, 32 * kMegabyte);
    // The mission allocates for voxels that are new to it.
    if (!remember) {
      EXPECT_EQ(footprint.standing, 0) << "in " << footprint.steps << " steps";
    }
    const std::string suffix = remember ? "_remembering" : "";
    RecordProperty("megabytes" + suffix, std::to_string(footprint.most / kMegabyte));
    RecordProperty("allocations_per_plan" + suffix,
                   std::to_string(footprint.planning / footprint.plans));
  }
}

}  // namespace
}  // namespace ltp
