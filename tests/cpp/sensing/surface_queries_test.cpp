// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Collisions with, and distances to, surfaces that are no height raster.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "ltp/sensing/octree_surface.hpp"

namespace ltp {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (random() >> 11) * 0x1p-53;
}

Path random_points(Random& random, int count, double reach) {
  Path points(count, 3);
  for (int i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) points(i, axis) = uniform(random, -reach, reach);
  }
  return points;
}

/// From a point to the nearest of all occupied voxels, each tried [m].
double slow_clearance(const OctreeSurface& surface, const Point& point, double most) {
  const GridFrame& frame = surface.voxels().frame();
  double nearest = most;
  for (std::int64_t index = 0; index < frame.size(); ++index) {
    const Cell cell = frame.cell_at(index);
    if (!surface.voxels().blocked(cell)) continue;
    const Point offset = (point - frame.centre(cell)).cwiseAbs() - 0.5 * frame.cell();
    nearest = std::min(nearest, offset.cwiseMax(0.0).norm());
  }
  return nearest;
}

TEST(SurfaceQueries, ClearanceToVoxelsIsThatOfTryingEach) {
  Random random(5);
  int inside = 0;
  for (int scene = 0; scene < 24; ++scene) {
    const double edge = scene % 2 == 0 ? 1.0 : 0.25;
    // Tall ones have columns of several words.
    Path points = random_points(random, 1 + static_cast<int>(random() % 40), 2.5);
    if (scene % 3 == 0) points.col(2) *= 8.0;
    const OctreeSurface surface(points, edge);
    const Path asked = random_points(random, 16, scene % 5 == 0 ? 60.0 : 5.0);
    for (Eigen::Index i = 0; i < asked.rows(); ++i) {
      const Point point = asked.row(i).transpose();
      const double most = i % 4 == 0 ? 2.0 : 50.0;
      EXPECT_NEAR(surface.clearance(point, most), slow_clearance(surface, point, most), 1e-9);
    }
    const Point centre = surface.voxels().frame().centre(
        surface.voxels().frame().cell_of(points.row(0).transpose()));
    inside += surface.clearance(centre, 50.0) == 0.0;
  }
  EXPECT_EQ(inside, 24);
}

TEST(SurfaceQueries, NoVoxelsAreFarAway) {
  const OctreeSurface nothing(Path(0, 3), 1.0);
  EXPECT_EQ(nothing.clearance(Point::Zero(), 50.0), 50.0);
  EXPECT_FALSE(nothing.first_collision(Path::Zero(2, 3)).has_value());
}

/// What a user's own surface has to say: `cast` alone.
class CastOnly final : public Surface {
 public:
  explicit CastOnly(const OctreeSurface& surface) : surface_(surface) {}
  RayHit cast(const Point& origin, const Point& direction, double max_range) const override {
    return surface_.cast(origin, direction, max_range);
  }

 private:
  const OctreeSurface& surface_;
};

TEST(SurfaceQueries, APathCollidesWhereItsRaysHit) {
  Random random(9);
  int hits = 0;
  for (int scene = 0; scene < 200; ++scene) {
    const OctreeSurface surface(random_points(random, 60, 5.0), 0.5);
    const CastOnly plain(surface);
    const Path path = random_points(random, 1 + static_cast<int>(random() % 4), 8.0);
    const auto exact = surface.first_collision(path);
    const auto by_rays = plain.first_collision(path);
    ASSERT_EQ(exact.has_value(), by_rays.has_value());
    if (exact) {
      EXPECT_NEAR(*exact, *by_rays, 1e-9);
    }
    hits += exact.has_value();
  }
  EXPECT_GT(hits, 20);
  EXPECT_LT(hits, 180);
  const OctreeSurface voxel(Path::Constant(1, 3, 0.5), 1.0);
  EXPECT_EQ(CastOnly(voxel).first_collision(Path::Constant(1, 3, 0.5)), 0.0);
  EXPECT_TRUE(std::isnan(CastOnly(voxel).clearance(Point::Zero(), 5.0))) << "it does not know";
}

TEST(SurfaceQueries, StrangeNumbersAreRefused) {
  const OctreeSurface voxel(Path::Constant(1, 3, 0.5), 1.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Surface* surface : {static_cast<const Surface*>(&voxel)}) {
    EXPECT_THROW(surface->first_collision(Path::Constant(2, 3, nan)), std::invalid_argument);
    EXPECT_THROW(surface->clearance(Point::Constant(nan), 1.0), std::invalid_argument);
    EXPECT_THROW(surface->clearance(Point::Zero(), -1.0), std::invalid_argument);
  }
  EXPECT_THROW(CastOnly(voxel).first_collision(Path::Constant(2, 3, nan)), std::invalid_argument);
  EXPECT_THROW(CastOnly(voxel).clearance(Point::Zero(), nan), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
