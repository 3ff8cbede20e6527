// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays through bricks: as by trying every voxel, to the last bit, on every processor.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "all_vectors.hpp"
#include "ltp/sensing/lidar.hpp"
#include "ltp/sensing/octree_surface.hpp"
#include "sensing/voxel_bricks.hpp"
#include "voxel_scenes.hpp"

namespace ltp {
namespace {

using test::Random;
using test::random_rays;
using test::random_voxels;
using test::slow_range;
using test::uniform;
using test::uniform_point;
using test::Voxels;

TEST(OctreeRays, AreThoseOfTryingEveryVoxelToTheLastBit) {
  Random random(21);
  int hits = 0, misses = 0, inside = 0;
  for (int scene = 0; scene < 30; ++scene) {
    const Voxels voxels = random_voxels(random, scene);
    const OctreeSurface surface = voxels.surface();
    Path origins, directions;
    random_rays(random, voxels, 200, origins, directions);
    for (Eigen::Index ray = 0; ray < origins.rows(); ++ray) {
      const Point from = origins.row(ray).transpose();
      const Point along = directions.row(ray).transpose();
      const double max_range = voxels.edge * uniform(random, 1, ray % 4 == 0 ? 20 : 3000);
      const RayHit hit = surface.cast(from, along, max_range);
      const double expected = slow_range(voxels, from, along, max_range);
      ASSERT_EQ(hit.range, expected) << scene << " " << ray;
      (hit.hit() ? hits : misses) += 1;
      inside += hit.range == 0.0;
      if (!hit.hit()) continue;
      const Cell cell = (hit.inside / voxels.edge).array().floor().matrix().cast<int>();
      ASSERT_NE(std::find(voxels.all.begin(), voxels.all.end(), cell), voxels.all.end()) << ray;
      ASSERT_LE((hit.inside - (from + hit.range * along)).norm(), kHitDepth + 2 * kHitMargin);
    }
  }
  EXPECT_GT(hits, 3000);
  EXPECT_GT(misses, 1000);
  EXPECT_GT(inside, 300);
}

TEST(OctreeRays, BundlesAndFansSayWhatSingleRaysDo) {
  Random random(22);
  std::int64_t hits = 0;
  for (int scene = 0; scene < 10; ++scene) {
    const Voxels voxels = random_voxels(random, scene);
    const OctreeSurface surface = voxels.surface();
    Path origins, directions;
    random_rays(random, voxels, 1500, origins, directions);
    const Point origin = origins.row(scene).transpose();
    const double max_range = 200 * voxels.edge;
    std::vector<RayHit> expected;
    for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
      expected.push_back(surface.cast(origin, directions.row(ray).transpose(), max_range));
    }
    std::vector<Eigen::Vector2d> headings;
    for (int n = 0; n < 90; ++n) headings.emplace_back(std::cos(0.07 * n), std::sin(0.07 * n));
    const BeamFan fan({-1.2, -0.6, -0.1, 0.0, 0.2, 0.9, 1.4});
    RayHits expected_fans;
    expected_fans.reset(7 * 90);
    surface.Surface::cast_fans(origin, headings, fan, max_range, expected_fans);
    test::with_all_vectors([&] {
      RayHits bundle;
      bundle.reset(directions.rows());
      surface.cast_bundle(origin, Eigen::Matrix3d::Identity(), directions, max_range, bundle);
      std::int64_t next = 0;
      for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
        if (!expected[ray].hit()) continue;
        ASSERT_LT(next, bundle.size());
        ASSERT_EQ(bundle.ray(next), ray);
        ASSERT_EQ(bundle.range(next), expected[ray].range);
        ASSERT_EQ(bundle.inside(next++), expected[ray].inside);
      }
      ASSERT_EQ(next, bundle.size());
      hits += next;
      RayHits fans;
      fans.reset(7 * 90);
      surface.cast_fans(origin, headings, fan, max_range, fans);
      ASSERT_EQ(fans.size(), expected_fans.size());
      for (std::int64_t n = 0; n < fans.size(); ++n) {
        ASSERT_EQ(fans.ray(n), expected_fans.ray(n));
        ASSERT_EQ(fans.range(n), expected_fans.range(n));
        ASSERT_EQ(fans.inside(n), expected_fans.inside(n));
      }
    });
  }
  EXPECT_GT(hits, 1000);
}

TEST(OctreeRays, HoldAlongTheWholeOfOctoMapsWorld) {
  // Voxels at the ends of 65,536 keys along each axis, and one whole eighth of it: a word a cube.
  Voxels ends(0.05);
  for (const int x : {-32768, -3, 32767}) {
    for (const int y : {-32768, 5, 32767}) {
      for (const int z : {-32768, 0, 32767}) ends.add({x, y, z}, 1);
    }
  }
  const OctreeSurface surface = ends.surface();
  EXPECT_EQ(surface.size(), 27);
  EXPECT_LT(surface.memory(), 32 << 20);
  EXPECT_THROW(surface.voxels(), std::invalid_argument);
  Random random(23);
  int hits = 0;
  for (int ray = 0; ray < 400; ++ray) {
    const Point target =
        ends.edge *
        (ends.all[ray % 27].cast<double>().array() + uniform(random, 0.1, 0.9)).matrix();
    const Point from = uniform_point(random, ray % 2 == 0 ? 1600.0 : 30.0);
    const Point along = (target - from).normalized();
    const RayHit hit = surface.cast(from, along, 1e5);
    ASSERT_EQ(hit.range, slow_range(ends, from, along, 1e5)) << ray;
    hits += hit.hit();
  }
  EXPECT_EQ(hits, 400);
  const OctreeSurface eighth(OctreeLeaves{0.05, {{Point::Constant(819.2), 1638.4, 1.0}}});
  EXPECT_EQ(eighth.size(), std::int64_t{1} << 45);
  EXPECT_NEAR(eighth.cast({-10, 700, 700}, {1, 0, 0}, 50).range, 10.0, 1e-9);
  EXPECT_EQ(eighth.cast({800, 700, 700}, {1, 0, 0}, 50).range, 0.0);
  EXPECT_NEAR(eighth.clearance({-3, -4, 700}, 50), 5.0, 1e-9);
}

TEST(OctreeRays, VoxelsScatteredTooWidelyAreRefused) {
  // A brick, and the nodes above it, for each voxel.
  Random random(25);
  std::vector<sensing::VoxelCube> cubes;
  for (int n = 0; n < 80; ++n) {
    cubes.push_back({uniform_point(random, 3e4).cast<int>(), 1});
  }
  const std::int64_t bytes = sensing::VoxelBricks(cubes).bytes();
  EXPECT_LT(bytes, 2 << 20);
  EXPECT_THROW(sensing::VoxelBricks(cubes, bytes / 2), std::invalid_argument);
  Path points(2, 3);
  points << 0, 0, 0, 9e8, 9e8, 9e8;
  EXPECT_EQ(OctreeSurface(points, 1e3).size(), 2);
  EXPECT_THROW(OctreeSurface(points, 1.0), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
