// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays against voxels: as against a height surface of the same scene, and as trying every voxel.
#include "ltp/sensing/octree_surface.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "ltp/sensing/height_surface.hpp"
#include "ltp/sensing/lidar.hpp"

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (random() >> 11) * 0x1p-53;
}

Point random_direction(Random& random) {
  while (true) {
    const Point v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
  }
}

/// Blocks on the ground, 40 x 40 cells of 1 m; heights are multiples of `unit` or, if 0, anything.
HeightSurface scene(Random& random, double unit) {
  Raster::Values values = Raster::Values::Zero(40, 40);
  for (int block = 0; block < 40; ++block) {
    const double h = uniform(random, 0, 20);
    values.block(random() % 36, random() % 36, 1 + random() % 4, 1 + random() % 4) =
        unit > 0.0 ? unit * std::round(h / unit) : h;
  }
  return HeightSurface(Raster(values, {-20, -20}, 1.0));
}

/// The solid above z = -8 m, cut into voxels.
OctreeSurface voxelised(const HeightSurface& surface, double edge) {
  const int n = static_cast<int>(std::lround(40 / edge));
  const GridFrame frame({-20, -20, -8}, Point::Constant(edge), {n, n, n});
  const OccupancyGrid grid = surface.occupancy(frame);
  std::vector<Point> centres;
  for (std::int64_t index = 0; index < frame.size(); ++index) {
    if (grid.blocked(frame.cell_at(index))) centres.push_back(frame.centre(frame.cell_at(index)));
  }
  Path points(centres.size(), 3);
  for (std::size_t row = 0; row < centres.size(); ++row) points.row(row) = centres[row].transpose();
  return OctreeSurface(points, edge);
}

double slow_range(const OccupancyGrid& voxels, const Point& from, const Point& direction,
                  double max_range) {
  const GridFrame& frame = voxels.frame();
  double nearest = kInfinity;
  for (std::int64_t index = 0; index < frame.size(); ++index) {
    if (!voxels.blocked(frame.cell_at(index))) continue;
    const Point low =
        frame.origin() + frame.cell_at(index).cast<double>().cwiseProduct(frame.cell());
    double t_in = 0.0, t_out = max_range;
    for (int axis = 0; axis < 3; ++axis) {
      const double at_low = (low[axis] - from[axis]) / direction[axis];
      const double at_high = (low[axis] + frame.cell()[axis] - from[axis]) / direction[axis];
      t_in = std::max(t_in, std::min(at_low, at_high));
      t_out = std::min(t_out, std::max(at_low, at_high));
    }
    if (t_in < t_out) nearest = std::min(nearest, t_in);
  }
  return nearest;
}

TEST(OctreeSurface, CastAgreesWithTryingEveryVoxel) {
  Random random(1);
  int hits = 0, misses = 0, inside = 0;
  for (int n = 0; n < 20; ++n) {
    Path points(60, 3);
    for (Eigen::Index k = 0; k < points.size(); ++k) points.data()[k] = uniform(random, -4, 4);
    const OctreeSurface surface(points, uniform(random, 0.3, 1.5));
    for (int ray = 0; ray < 200; ++ray) {
      const Point from(uniform(random, -6, 6), uniform(random, -6, 6), uniform(random, -6, 6));
      const Point direction = random_direction(random);
      const double max_range = uniform(random, 1, 15);
      const double expected = slow_range(surface.voxels(), from, direction, max_range);
      const RayHit hit = surface.cast(from, direction, max_range);
      ASSERT_EQ(hit.hit(), expected < kInfinity) << n << " " << ray;
      if (!hit.hit()) {
        ++misses;
        continue;
      }
      ++hits;
      inside += hit.range == 0.0;
      ASSERT_NEAR(hit.range, expected, 1e-9);
      EXPECT_TRUE(surface.voxels().blocked_at(hit.inside));
      EXPECT_LE((hit.inside - (from + hit.range * direction)).norm(), kHitDepth + 2 * kHitMargin);
    }
  }
  EXPECT_GT(hits, 800);
  EXPECT_GT(misses, 800);
  EXPECT_GT(inside, 50);
}

TEST(OctreeSurface, TheSameRayAgreesWithAHeightSurfaceOnAScenesOwnLattice) {
  // Heights are multiples of the voxel: both are the same solid.
  Random random(2);
  const HeightSurface heights = scene(random, 0.5);
  const OctreeSurface octree = voxelised(heights, 0.5);
  int hits = 0;
  for (int ray = 0; ray < 5000; ++ray) {
    const Point from(uniform(random, -19, 19), uniform(random, -19, 19), uniform(random, 1, 25));
    const Point direction = random_direction(random);
    const RayHit a = heights.cast(from, direction, 30);
    const RayHit b = octree.cast(from, direction, 30);
    if (a.hit() && a.inside.z() < -7.9) continue;  // below what was voxelised: the raster's side
    ASSERT_EQ(a.hit(), b.hit()) << ray;
    if (!a.hit()) continue;
    ++hits;
    ASSERT_NEAR(a.range, b.range, 1e-6) << ray;
    ASSERT_LT((a.inside - b.inside).norm(), 1e-3);
  }
  EXPECT_GT(hits, 1500);
}

TEST(OctreeSurface, TheSameRayAgreesWithAHeightSurfaceWithinAVoxel) {
  // Voxels that hold any of the solid reach over it by less than one: a ray ends on the solid or
  // at most a voxel before it, and what it ends on is within a voxel of the solid.
  Random random(3);
  const double edge = 0.5;
  const HeightSurface heights = scene(random, 0.0);
  const OctreeSurface octree = voxelised(heights, edge);
  int hits = 0;
  for (int ray = 0; ray < 5000; ++ray) {
    const Point from(uniform(random, -19, 19), uniform(random, -19, 19), uniform(random, 1, 25));
    const Point direction = random_direction(random);
    const RayHit a = heights.cast(from, direction, 30);
    const RayHit b = octree.cast(from, direction, 30);
    if (a.hit() && a.inside.z() < -7.9) continue;
    if (a.hit()) {
      ASSERT_LE(b.range, a.range + 1e-6) << ray;
    }
    if (!b.hit()) continue;
    ++hits;
    ASSERT_LE(heights.clearance(b.inside, 30), edge) << ray;
  }
  EXPECT_GT(hits, 2000);
}

TEST(OctreeSurface, ALidarScansIt) {
  Random random(4);
  const HeightSurface heights = scene(random, 0.5);
  const OctreeSurface octree = voxelised(heights, 0.5);
  const Lidar lidar;
  Pose pose;
  pose.position = {0.3, 0.4, 22};
  Scan a, b;
  lidar.scan(heights, pose, 0, a);
  lidar.scan(octree, pose, 0, b);
  EXPECT_GT(a.hits.size(), 1000u);
  ASSERT_EQ(a.hits.size(), b.hits.size());
  for (std::size_t n = 0; n < a.hits.size(); ++n) ASSERT_LT((a.hits[n] - b.hits[n]).norm(), 1e-3);
  EXPECT_EQ(a.misses.size(), b.misses.size());
}

TEST(OctreeSurface, AFarRayFindsTheBoxAndAnEmptyOneFindsNothing) {
  Path points(1, 3);
  points << 0.5, 0.5, 0.5;
  const OctreeSurface surface(points, 1.0);
  EXPECT_EQ(surface.size(), 1);
  EXPECT_DOUBLE_EQ(surface.resolution(), 1.0);
  const RayHit hit = surface.cast({-1e6, 0.5, 0.5}, {1, 0, 0}, 2e6);
  EXPECT_DOUBLE_EQ(hit.range, 1e6);
  EXPECT_TRUE(hit.inside.isApprox(Point(kHitDepth, 0.5, 0.5), 1e-9));
  EXPECT_FALSE(surface.cast({-1e6, 0.5, 0.5}, {1, 0, 0}, 1e6).hit());
  EXPECT_FALSE(surface.cast({-1e6, 0.5, 0.5}, {-1, 0, 0}, 2e6).hit());
  EXPECT_FALSE(surface.cast({2, 0.5, 0.5}, {0, 0, 1}, 2e6).hit());
  EXPECT_FALSE(OctreeSurface(Path(0, 3), 1.0).cast({0, 0, 0}, {1, 0, 0}, 1e6).hit());
}

TEST(OctreeSurface, ARayThroughTheEdgeBetweenTwoVoxelsGoesOn) {
  Path points(2, 3);
  points << 0.5, 0.5, 0.5, 1.5, 1.5, 0.5;
  const OctreeSurface surface(points, 1.0);
  const double d = std::sqrt(0.5);
  EXPECT_FALSE(surface.cast({2, 0, 0.5}, {-d, d, 0}, 50).hit());
  EXPECT_TRUE(surface.cast({2, 0.001, 0.5}, {-d, d, 0}, 50).hit());
}

TEST(OctreeSurface, LargeLeavesAreCutIntoVoxelsAndFreeOnesLeftOut) {
  const OctreeLeaves octree{0.5, {{{2, 2, 2}, 4.0, 1.0}, {{-1, -1, -1}, 2.0, -1.0}}};
  const OctreeSurface surface(octree);
  EXPECT_EQ(surface.size(), 512);
  EXPECT_EQ(surface.voxels().frame().origin(), Point(0, 0, 0));
  EXPECT_DOUBLE_EQ(surface.cast({-10, 1, 1}, {1, 0, 0}, 50).range, 10);
  // More levels than a word of the grid has bits.
  const OctreeSurface tall(OctreeLeaves{0.5, {{{32, 32, 32}, 64.0, 1.0}}});
  EXPECT_EQ(tall.size(), 128 * 128 * 128);
}

TEST(OctreeSurface, ComesFromAFile) {
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("ltp_octree_surface_" + std::to_string(::getpid()) + ".bt");
  write_octree(path.string(),
               {0.5, {{{0.25, 0.25, 0.25}, 0.5, 1.0}, {{5.25, 0.25, 0.25}, 0.5, -1}}});
  const OctreeSurface surface(path.string());
  std::filesystem::remove(path);
  EXPECT_EQ(surface.size(), 1);
  EXPECT_DOUBLE_EQ(surface.cast({-3, 0.25, 0.25}, {1, 0, 0}, 50).range, 3);
  EXPECT_THROW(OctreeSurface(path.string()), std::invalid_argument);
}

TEST(OctreeSurface, OnlyADenseGridNeedsASmallBox) {
  Path points(2, 3);
  points << 0, 0, 0, 1300, 1300, 1300;
  const OctreeSurface wide(points, 1.0);
  EXPECT_EQ(wide.size(), 2);
  EXPECT_TRUE(wide.cast({1300.5, 1300.5, 0}, {0, 0, 1}, 2000).hit());
  EXPECT_THROW(wide.voxels(), std::invalid_argument);
  // A whole eighth of OctoMap's world is one small leaf in a file.
  const OctreeSurface eighth(OctreeLeaves{0.1, {{Point::Constant(1638.4), 3276.8, 1.0}}});
  EXPECT_EQ(eighth.size(), std::int64_t{1} << 45);
  EXPECT_THROW(eighth.voxels(), std::invalid_argument);
}

TEST(OctreeSurface, WhatIsNoVoxelIsRefused) {
  Path points(2, 3);
  points << 0, 0, 0, 0, 0, 0;
  points.row(1) << 1e300, 0, 0;
  EXPECT_THROW(OctreeSurface(points, 1.0), std::invalid_argument);
  for (int axis = 0; axis < 3; ++axis) {
    points.row(1) << 0, 0, 0;
    points(1, axis) = std::nan("");
    EXPECT_THROW(OctreeSurface(points, 1.0), std::invalid_argument) << axis;
  }
  points.row(1) << 0, 0, 0;
  EXPECT_THROW(OctreeSurface(points, 0.0), std::invalid_argument);
  EXPECT_THROW(OctreeSurface(points, std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
