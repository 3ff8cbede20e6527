// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays cast together are the rays cast one by one, to the last bit.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "all_vectors.hpp"
#include "height_scenes.hpp"

namespace ltp {
namespace {

using namespace test;  // NOLINT: the scenes

/// Compares a bundle with its rays; how many hit.
int expect_same_as_single(const Surface& surface, const Point& from, const Eigen::Matrix3d& turn,
                          const Path& directions, double max_range) {
  RayHits hits;
  hits.reset(directions.rows());
  surface.cast_bundle(from, turn, directions, max_range, hits);
  std::int64_t n = 0;
  for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
    const Point direction = turned(turn, directions.row(ray));
    const RayHit single = surface.cast(from, direction, max_range);
    const bool found = n < hits.size() && hits.ray(n) == ray;
    EXPECT_EQ(found, single.hit()) << "from " << from.transpose() << " towards "
                                   << direction.transpose() << ", " << single.range;
    if (found != single.hit()) return 0;
    if (!found) continue;
    EXPECT_EQ(hits.range(n), single.range);
    EXPECT_EQ(hits.inside(n), single.inside)
        << (hits.inside(n) - single.inside).transpose() << " towards " << direction.transpose();
    ++n;
  }
  EXPECT_EQ(n, hits.size());
  return static_cast<int>(n);
}

/// With each set of vectors.
int expect_same(const Surface& surface, const Point& from, const Eigen::Matrix3d& turn,
                const Path& directions, double max_range) {
  int hits = 0;
  with_all_vectors(
      [&] { hits = expect_same_as_single(surface, from, turn, directions, max_range); });
  return hits;
}

Eigen::Matrix3d random_turn(Random& random) {
  return Eigen::AngleAxisd(uniform(random, -kPi, kPi), random_direction(random)).toRotationMatrix();
}

TEST(HeightSurface, ABundleIsItsRays) {
  Random random(11);
  std::int64_t hits = 0, rays = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const int nx = 1 + static_cast<int>(random() % 90);
    const int ny = 1 + static_cast<int>(random() % 90);
    const HeightSurface surface(random_city(random, nx, ny,
                                            {uniform(random, -9, 9), uniform(random, -9, 9)},
                                            scene % 2 == 0 ? 1.0 : uniform(random, 0.3, 3)));
    Path directions(scene % 3 == 0 ? 12000 : 2000, 3);
    for (auto row : directions.rowwise()) row = random_direction(random).transpose();
    for (int n = 0; n < 3; ++n) {
      const Point from = random_point(random, surface.heights());
      const Eigen::Matrix3d turn = random_turn(random);
      hits += expect_same(surface, from, turn, directions, uniform(random, 1, 80));
      rays += directions.rows();
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(hits, rays / 10);
  EXPECT_LT(hits, rays - rays / 10);
}

TEST(HeightSurface, ABundleIsItsRaysAlongTheLatticeToo) {
  Random random(12);
  // Level, along the axes and diagonals, straight up and down, and slopes that meet tops' edges.
  std::vector<Point> rays;
  for (int x = -4; x <= 4; ++x) {
    for (int y = -4; y <= 4; ++y) {
      for (int z = -8; z <= 8; ++z) {
        if (x != 0 || y != 0 || z != 0) rays.push_back(Point(x, y, z).normalized());
      }
    }
  }
  const Path directions = path(rays);
  int hits = 0;
  for (int scene = 0; scene < 20; ++scene) {
    Raster::Values values(19, 17);
    for (Eigen::Index n = 0; n < values.size(); ++n) values.data()[n] = random() % 5;
    const HeightSurface surface(Raster(values, {-3, 2}, 1.0));
    for (int n = 0; n < 40; ++n) {
      // On corners, faces and centres; on tops, below and above them; beside the raster.
      const Point from(-5 + 0.5 * (random() % 47), 0.5 * (random() % 43), 0.5 * (random() % 14));
      hits += expect_same(surface, from, Eigen::Matrix3d::Identity(), directions, 20);
      if (HasFailure()) return;
    }
  }
  EXPECT_GT(hits, 100000);
}

TEST(HeightSurface, ABundleIsItsRaysFarFromTheOriginOfTheWorldAndFarAbove) {
  Random random(13);
  Path directions(4000, 3);
  for (auto row : directions.rowwise()) row = random_direction(random).transpose();
  const Raster here = random_city(random, 120, 100, {0, 0}, 1.0);
  Raster::Values mountains = here.values() + 8848.0;
  mountains(50, 60) = 1e12;
  const HeightSurface far_surface(Raster(mountains, {448262.5, 5411932.25}, 1.0));
  int hits = 0;
  for (int n = 0; n < 20; ++n) {
    const Point from = random_point(random, here) + Point(448262.5, 5411932.25, 8848);
    hits += expect_same(far_surface, from, random_turn(random), directions, n % 2 ? 50 : 1e5);
  }
  EXPECT_GT(hits, 10000);
}

TEST(HeightSurface, TheWidestVectorsAreUsed) { EXPECT_EQ(vectors(), all_vectors().back()); }

TEST(HeightSurface, RaysOfManyOriginsKeepTheirOrder) {
  Random random(14);
  const HeightSurface surface(random_city(random, 60, 60, {0, 0}, 1.0));
  const int sizes[] = {1, 3000, 1, 1, 5, 2000};
  std::vector<Point> from, towards;
  for (const int size : sizes) {
    const Point origin = random_point(random, surface.heights());
    from.insert(from.end(), size, origin);
    for (int n = 0; n < size; ++n) towards.push_back(random_direction(random));
  }
  Eigen::VectorXd ranges(from.size());
  surface.cast_rays(path(from), path(towards), 40, ranges);
  int hits = 0;
  for (std::size_t n = 0; n < from.size(); ++n) {
    ASSERT_EQ(ranges[n], surface.cast(from[n], towards[n], 40).range) << n;
    hits += ranges[n] < kInfinity;
  }
  EXPECT_GT(hits, 500);
}

}  // namespace
}  // namespace ltp
