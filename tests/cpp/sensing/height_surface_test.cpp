// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Rays against a height surface agree with slow and obvious answers.
#include "ltp/sensing/height_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "height_scenes.hpp"

namespace ltp {
namespace {

using namespace test;  // NOLINT: the scenes

/// The hits of a fan, one a beam.
std::vector<RayHit> cast_fan(const Surface& surface, const Point& from,
                             const Eigen::Vector2d& heading, const BeamFan& fan, double max_range) {
  RayHits found;
  found.reset(fan.size());
  surface.cast_fans(from, {heading}, fan, max_range, found);
  std::vector<RayHit> hits(fan.size());
  for (std::int64_t n = 0; n < found.size(); ++n) {
    EXPECT_TRUE(n == 0 || found.ray(n) > found.ray(n - 1));
    hits.at(found.ray(n)) = {found.range(n), found.inside(n)};
  }
  return hits;
}

TEST(HeightSurface, CastAgreesWithTryingEveryColumn) {
  Random random(1);
  int hits = 0, misses = 0, starts_inside = 0, from_outside = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const int nx = 1 + static_cast<int>(random() % 40);
    const int ny = 1 + static_cast<int>(random() % 40);
    const Eigen::Vector2d origin(uniform(random, -50, 50), uniform(random, -50, 50));
    const HeightSurface surface(
        random_city(random, nx, ny, origin, scene % 2 == 0 ? 1.0 : uniform(random, 0.3, 3)));
    for (int ray = 0; ray < 400; ++ray) {
      const Point from = random_point(random, surface.heights());
      const Point direction = random_direction(random);
      const double max_range = uniform(random, 1, 80);
      const RayHit hit = surface.cast(from, direction, max_range);
      const double expected = slow_range(surface.heights(), from, direction, max_range);
      ASSERT_EQ(hit.hit(), expected < kInfinity) << "scene " << scene << ", ray " << ray;
      if (!hit.hit()) {
        ++misses;
        EXPECT_TRUE(hit.inside.array().isNaN().all());
        continue;
      }
      ++hits;
      starts_inside += hit.range == 0.0;
      from_outside += slow_clearance(surface.heights(), Point(from.x(), from.y(), -11), 1e9) > 0;
      ASSERT_NEAR(hit.range, expected, 1e-9) << "scene " << scene << ", ray " << ray;
      EXPECT_LT(hit.range, max_range);
      const double moved = (hit.inside - (from + hit.range * direction)).norm();
      EXPECT_LE(moved, kHitDepth + 2 * kHitMargin);
    }
  }
  // The scenes hold what they should.
  EXPECT_GT(hits, 3000);
  EXPECT_GT(misses, 3000);
  EXPECT_GT(starts_inside, 300);
  EXPECT_GT(from_outside, 300);
}

TEST(HeightSurface, CastAgreesOnRaysThatRunAlongTheLattice) {
  Random random(2);
  const double diagonal = std::sqrt(0.5);
  const std::vector<Point> directions = {{1, 0, 0},
                                         {-1, 0, 0},
                                         {0, 1, 0},
                                         {0, -1, 0},
                                         {0, 0, 1},
                                         {0, 0, -1},
                                         {diagonal, diagonal, 0},
                                         {diagonal, -diagonal, 0},
                                         {-diagonal, diagonal, 0},
                                         {-diagonal, -diagonal, 0},
                                         {0.6, 0, -0.8},
                                         {0, -0.6, -0.8},
                                         {-0.6, 0, 0.8}};
  int hits = 0;
  for (int scene = 0; scene < 20; ++scene) {
    Raster::Values values(9, 7);
    for (Eigen::Index n = 0; n < values.size(); ++n) values.data()[n] = random() % 5;
    const HeightSurface surface(Raster(values, {-3, 2}, 1.0));
    for (int ray = 0; ray < 500; ++ray) {
      // On corners, faces and centres; on tops, below and above them.
      const Point from(-5 + 0.5 * (random() % 27), 0.5 * (random() % 23), 0.5 * (random() % 14));
      const Point& direction = directions[ray % directions.size()];
      const double expected = slow_range(surface.heights(), from, direction, 100);
      const RayHit hit = surface.cast(from, direction, 100);
      // A ray that starts on a wall and leaves it is the one case the two may see differently.
      const double backed = slow_range(surface.heights(), from + 1e-7 * direction, direction, 100);
      if (expected == 0.0 && backed != 0.0) continue;
      ASSERT_EQ(hit.hit(), expected < kInfinity)
          << "from " << from.transpose() << " towards " << direction.transpose();
      if (!hit.hit()) continue;
      ++hits;
      ASSERT_NEAR(hit.range, expected, 1e-9);
      ASSERT_GT(depth_in_column(surface.heights(), hit.inside), 0.9 * kHitMargin);
    }
  }
  EXPECT_GT(hits, 2000);
}

TEST(HeightSurface, AFanIsItsRays) {
  Random random(3);
  int found = 0, missed = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const HeightSurface surface(random_city(random, 1 + random() % 50, 1 + random() % 50,
                                            {uniform(random, -9, 9), 3}, scene % 2 ? 1.0 : 0.7));
    std::vector<double> elevations(1 + random() % 64);
    for (double& e : elevations) e = uniform(random, -1.5, 1.5);
    std::sort(elevations.begin(), elevations.end());
    const BeamFan fan(elevations);
    for (int azimuth = 0; azimuth < 60; ++azimuth) {
      const double angle = azimuth < 8 ? azimuth * kPi / 4 : uniform(random, -kPi, kPi);
      const Eigen::Vector2d heading(std::cos(angle), std::sin(angle));
      const Point from = random_point(random, surface.heights());
      const double max_range = uniform(random, 1, 80);
      const std::vector<RayHit> hits = cast_fan(surface, from, heading, fan, max_range);
      for (int row = 0; row < fan.size(); ++row) {
        const Point direction(fan[row].cosine * heading.x(), fan[row].cosine * heading.y(),
                              fan[row].sine);
        const RayHit single = surface.cast(from, direction, max_range);
        ASSERT_EQ(hits[row].hit(), single.hit()) << scene << " " << azimuth << " " << row;
        if (!single.hit()) {
          ++missed;
          continue;
        }
        ++found;
        ASSERT_NEAR(hits[row].range, single.range, 1e-9);
        ASSERT_LT((hits[row].inside - single.inside).norm(), 1e-8);
      }
    }
  }
  EXPECT_GT(found, 10000);
  EXPECT_GT(missed, 10000);
}

TEST(HeightSurface, AFanIsItsRaysAlongTheLatticeToo) {
  Random random(10);
  const double d = std::sqrt(0.5);
  const std::vector<Eigen::Vector2d> headings = {{1, 0}, {-1, 0}, {0, 1},  {0, -1},
                                                 {d, d}, {-d, d}, {d, -d}, {-d, -d}};
  const BeamFan fan({-1.2, -kPi / 4, -0.3, 0.0, 0.3, kPi / 4});
  int found = 0;
  for (int scene = 0; scene < 20; ++scene) {
    Raster::Values values(9, 7);
    for (Eigen::Index n = 0; n < values.size(); ++n) values.data()[n] = random() % 5;
    const HeightSurface surface(Raster(values, {-3, 2}, 1.0));
    for (int n = 0; n < 500; ++n) {
      const Point from(-5 + 0.5 * (random() % 27), 0.5 * (random() % 23), 0.5 * (random() % 14));
      const Eigen::Vector2d& heading = headings[n % headings.size()];
      const std::vector<RayHit> hits = cast_fan(surface, from, heading, fan, 20);
      for (int row = 0; row < fan.size(); ++row) {
        const Point direction(fan[row].cosine * heading.x(), fan[row].cosine * heading.y(),
                              fan[row].sine);
        // Sloping beams meet the tops' edges exactly here: rounding may let one of the two pass.
        const RayHit above = surface.cast(from + Point(0, 0, 1e-9), direction, 20);
        const RayHit below = surface.cast(from - Point(0, 0, 1e-9), direction, 20);
        if (above.hit() != below.hit() || std::abs(above.range - below.range) > 1e-6) continue;
        ASSERT_EQ(hits[row].hit(), above.hit());
        if (!above.hit()) continue;
        ++found;
        ASSERT_NEAR(hits[row].range, above.range, 1e-6);
        ASSERT_GT(depth_in_column(surface.heights(), hits[row].inside), 0.9 * kHitMargin);
      }
    }
  }
  EXPECT_GT(found, 10000);
}

TEST(HeightSurface, FansCastTogetherAreFansCastOneByOne) {
  // Together they look round first, one by one they do not.
  Random random(15);
  RayHits together, alone;
  std::int64_t found = 0, rays = 0;
  for (int scene = 0; scene < 120; ++scene) {
    const bool lattice = scene % 4 == 0;
    const HeightSurface surface(random_city(random, 1 + random() % 90, 1 + random() % 90,
                                            {lattice ? 3 : uniform(random, -9, 9), 3},
                                            scene % 2 == 0 ? 1.0 : 0.7));
    std::vector<double> elevations(1 + random() % 64);
    for (double& e : elevations) e = uniform(random, -1.5, 1.5);
    std::sort(elevations.begin(), elevations.end());
    const BeamFan fan(elevations);
    std::vector<Eigen::Vector2d> headings;
    for (int n = 0; n < (scene % 3 == 0 ? 1024 : 128); ++n) {
      const double angle = n < 8 ? n * kPi / 4 : uniform(random, -kPi, kPi);
      headings.emplace_back(std::cos(angle), std::sin(angle));
    }
    Point from = random_point(random, surface.heights());
    if (lattice) from = from.array().round();
    const double max_range = uniform(random, 1, 80);
    together.reset(static_cast<std::int64_t>(headings.size()) * fan.size());
    surface.cast_fans(from, headings, fan, max_range, together);
    std::int64_t n = 0;
    for (std::size_t azimuth = 0; azimuth < headings.size(); ++azimuth) {
      alone.reset(fan.size());
      surface.cast_fans(from, {headings[azimuth]}, fan, max_range, alone);
      ASSERT_LE(n + alone.size(), together.size());
      for (std::int64_t hit = 0; hit < alone.size(); ++hit, ++n) {
        ASSERT_EQ(together.ray(n), alone.ray(hit) + static_cast<int>(azimuth) * fan.size());
        ASSERT_EQ(together.range(n), alone.range(hit));
        ASSERT_EQ(together.inside(n), alone.inside(hit));
      }
      rays += fan.size();
    }
    ASSERT_EQ(n, together.size());
    found += n;
  }
  EXPECT_GT(found, rays / 10);
  EXPECT_LT(found, rays - rays / 10);
}

TEST(HeightSurface, EveryHitFallsIntoACellThatOccupancySets) {
  Random random(4);
  const std::vector<Point> cells = {{2, 2, 4}, {1, 1, 1}, {0.7, 1.3, 0.9}, {5, 3, 0.0005}};
  int checked = 0;
  for (int scene = 0; scene < 60; ++scene) {
    const Eigen::Vector2d corner =
        scene % 3 == 0 ? Eigen::Vector2d(0, 0)
                       : Eigen::Vector2d(uniform(random, -5, 5), uniform(random, -5, 5));
    const HeightSurface surface(random_city(random, 24, 20, corner, 1.0));
    Point cell = cells[scene % cells.size()];
    const bool thin = cell.z() < 0.1;
    const GridFrame frame(Point(-40, -40, thin ? 3.99 : -40), cell,
                          {static_cast<int>(90 / cell.x()), static_cast<int>(90 / cell.y()),
                           thin ? 60 : static_cast<int>(90 / cell.z())});
    const OccupancyGrid occupied = surface.occupancy(frame);
    for (int ray = 0; ray < 400; ++ray) {
      const Point from = random_point(random, surface.heights());
      const RayHit hit = surface.cast(from, random_direction(random), 80);
      if (!hit.hit()) continue;
      EXPECT_LT(hit.inside.z(), surface.heights().at(hit.inside.x(), hit.inside.y()));
      if (!frame.contains(hit.inside)) continue;
      ++checked;
      EXPECT_TRUE(occupied.blocked_at(hit.inside)) << hit.inside.transpose();
    }
  }
  EXPECT_GT(checked, 4000);
}

TEST(HeightSurface, NothingChangesFarFromTheOriginOfTheWorld) {
  // Projected coordinates, as real cities have them.
  Random random(9);
  const Eigen::Vector2d far(448262.5, 5411932.25);
  const Point shift(far.x(), far.y(), 0);
  const Raster here = random_city(random, 40, 40, {0, 0}, 1.0);
  const HeightSurface near_surface(here);
  const HeightSurface far_surface(Raster(here.values(), far, 1.0));
  const OccupancyGrid occupied =
      far_surface.occupancy(GridFrame(shift - Point(20, 20, 40), {2, 2, 4}, {40, 40, 30}));
  int hits = 0;
  for (int ray = 0; ray < 2000; ++ray) {
    const Point from = random_point(random, here);
    const Point direction = random_direction(random);
    const RayHit a = near_surface.cast(from, direction, 80);
    const RayHit b = far_surface.cast(from + shift, direction, 80);
    ASSERT_EQ(a.hit(), b.hit());
    if (!a.hit()) continue;
    ++hits;
    ASSERT_NEAR(a.range, b.range, 1e-6);
    ASSERT_LT((b.inside - shift - a.inside).norm(), 1e-6);
    ASSERT_TRUE(occupied.blocked_at(b.inside) || !occupied.frame().contains(b.inside));
  }
  EXPECT_GT(hits, 500);
}

TEST(HeightSurface, AWallAndATopAreHitWhereTheyStand) {
  const HeightSurface surface = tower();
  const RayHit wall = surface.cast({0.5, 1.5, 3}, {1, 0, 0}, 50);
  EXPECT_DOUBLE_EQ(wall.range, 1.5);
  EXPECT_TRUE(wall.inside.isApprox(Point(2 + kHitDepth, 1.5, 3), 1e-12));
  const RayHit from_the_right = surface.cast({9, 1.5, 3}, {-1, 0, 0}, 50);
  EXPECT_DOUBLE_EQ(from_the_right.range, 6);
  EXPECT_TRUE(from_the_right.inside.isApprox(Point(3 - kHitDepth, 1.5, 3), 1e-12));
  const RayHit top = surface.cast({2.5, 1.5, 11}, {0, 0, -1}, 50);
  EXPECT_DOUBLE_EQ(top.range, 6);
  EXPECT_TRUE(top.inside.isApprox(Point(2.5, 1.5, 5 - kHitDepth), 1e-12));
  const RayHit started_inside = surface.cast({2.5, 1.5, 3}, {0, 0.6, 0.8}, 50);
  EXPECT_EQ(started_inside.range, 0);
  EXPECT_TRUE(started_inside.inside.isApprox(Point(2.5, 1.5, 3)));
}

TEST(HeightSurface, AWallHitJustBelowATopFallsIntoTheTopsCell) {
  const HeightSurface surface(Raster(Raster::Values::Constant(4, 4, 4.0), {0, 0}, 1.0));
  const OccupancyGrid occupied = surface.occupancy(GridFrame(Point(0, 0, 0), {2, 2, 4}, {2, 2, 3}));
  for (const double below : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const RayHit hit = surface.cast({-3, 1.5, 4 - below}, {1, 0, 0}, 50);
    ASSERT_TRUE(hit.hit()) << below;
    EXPECT_GT(depth_in_column(surface.heights(), hit.inside), 0.9 * kHitMargin) << below;
    EXPECT_TRUE(occupied.blocked_at(hit.inside)) << below;
  }
}

TEST(HeightSurface, NothingStandsBeyondTheRastersEdge) {
  const HeightSurface surface = tower();
  EXPECT_FALSE(surface.cast({-1, 2, 3}, {0, 0, -1}, 1e6).hit());
  EXPECT_FALSE(surface.cast({-1, -1, -5}, {1, -0.0, 0}, 1e6).hit());
  EXPECT_FALSE(surface.cast({0.5, 0.5, 3}, {-1, 0, 0}, 1e6).hit());
  // Below the tops, from outside: the raster's side is a wall.
  EXPECT_DOUBLE_EQ(surface.cast({-1, 2, -5}, {1, 0, 0}, 1e6).range, 1);
}

TEST(HeightSurface, ARangeIsHitOnlyBelowTheMaximum) {
  const HeightSurface surface = tower();
  EXPECT_FALSE(surface.cast({0.5, 1.5, 3}, {1, 0, 0}, 1.5).hit());
  EXPECT_TRUE(surface.cast({0.5, 1.5, 3}, {1, 0, 0}, std::nextafter(1.5, 2)).hit());
  EXPECT_FALSE(surface.cast({2.5, 1.5, 11}, {0, 0, -1}, 6).hit());
  EXPECT_TRUE(surface.cast({2.5, 1.5, 11}, {0, 0, -1}, std::nextafter(6, 7)).hit());
  EXPECT_FALSE(cast_fan(surface, {0.5, 1.5, 3}, {1, 0}, BeamFan({0.0}), 1.5)[0].hit());
}

TEST(HeightSurface, AGrazingRayGoesOn) {
  const HeightSurface surface = tower();
  EXPECT_FALSE(surface.cast({0.5, 1.5, 5}, {1, 0, 0}, 50).hit());  // in the plane of the top
  EXPECT_FALSE(surface.cast({0.5, 2, 3}, {1, 0, 0}, 50).hit());    // in the upper wall's plane
  EXPECT_TRUE(surface.cast({0.5, 1, 3}, {1, 0, 0}, 50).hit());     // the lower one is its own
  const double d = std::sqrt(0.5);
  EXPECT_FALSE(surface.cast({1, 0, 3}, {-d, d, 0}, 50).hit());
  EXPECT_FALSE(surface.cast({1, 3, 3}, {d, d, 0}, 50).hit());
}

TEST(BeamFan, ElevationsMustAscendBelowTheZenith) {
  EXPECT_THROW(BeamFan({0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(BeamFan({kPi / 2}), std::invalid_argument);
  EXPECT_THROW(BeamFan({std::nan("")}), std::invalid_argument);
  EXPECT_EQ(BeamFan({}).size(), 0);
}

}  // namespace
}  // namespace ltp
