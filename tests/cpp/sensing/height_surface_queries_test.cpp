// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Collisions, clearances and occupancy of a height surface agree with slow and obvious answers.
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

TEST(HeightSurface, OccupancyAgreesWithOverlapsOfBoxes) {
  Random random(5);
  const double least = 1e-6;
  for (int scene = 0; scene < 20; ++scene) {
    const HeightSurface surface(random_city(random, 12, 15, {-3, 4}, scene % 2 == 0 ? 1.0 : 1.5));
    const Raster& heights = surface.heights();
    const GridFrame frame(scene % 4 < 2 ? Point(-6, 0, -4) : Point(-5.3, 1.1, -2.7), {2, 2, 4},
                          {10, 9, 9});
    const OccupancyGrid grid = surface.occupancy(frame);
    for (std::int64_t n = 0; n < frame.size(); ++n) {
      const Cell cell = frame.cell_at(n);
      const Point low = frame.centre(cell) - 0.5 * frame.cell();
      const Point high = frame.centre(cell) + 0.5 * frame.cell();
      bool expected = false;
      for (int i = 0; i < heights.nx(); ++i) {
        for (int j = 0; j < heights.ny(); ++j) {
          const double x = heights.origin().x() + i * heights.cell();
          const double y = heights.origin().y() + j * heights.cell();
          const bool overlaps =
              std::min(high.x(), x + heights.cell()) - std::max(low.x(), x) > least &&
              std::min(high.y(), y + heights.cell()) - std::max(low.y(), y) > least &&
              heights(i, j) - low.z() > least;
          expected = expected || overlaps;
        }
      }
      ASSERT_EQ(grid.blocked(cell), expected) << "scene " << scene << ", cell " << cell.transpose();
    }
  }
}

TEST(HeightSurface, ATopInACellsLowerFaceDoesNotFillThatCell) {
  Raster::Values values = Raster::Values::Constant(2, 2, 8.0);
  const GridFrame frame(Point(0, 0, 0), {2, 2, 4}, {1, 1, 4});
  EXPECT_EQ(HeightSurface(Raster(values, {0, 0}, 1.0)).occupancy(frame).count(), 2);
  values(1, 1) = 8.001;
  EXPECT_EQ(HeightSurface(Raster(values, {0, 0}, 1.0)).occupancy(frame).count(), 3);
  values.setConstant(0.0);
  EXPECT_EQ(HeightSurface(Raster(values, {0, 0}, 1.0)).occupancy(frame).count(), 0);
  values.setConstant(1e12);
  EXPECT_EQ(HeightSurface(Raster(values, {0, 0}, 1.0)).occupancy(frame).count(), 4);
}

TEST(HeightSurface, FirstCollisionAgreesWithTryingEveryColumn) {
  Random random(6);
  int collisions = 0, free = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const HeightSurface surface(random_city(random, 1 + random() % 30, 1 + random() % 30,
                                            {uniform(random, -9, 9), 3}, scene % 2 ? 1.0 : 0.7));
    for (int n = 0; n < 100; ++n) {
      Point a = random_point(random, surface.heights());
      a.z() = uniform(random, 5, 35);
      const Point b = a + uniform(random, 0.01, 20) * random_direction(random);
      const Point c = b + uniform(random, 0.01, 20) * random_direction(random);
      const double first = slow_touch(surface.heights(), a, b);
      const double second = slow_touch(surface.heights(), b, c);
      const std::optional<double> arc = surface.first_collision(path({a, b, c}));
      ASSERT_EQ(arc.has_value(), first <= 1 || second <= 1) << "scene " << scene << ", path " << n;
      if (!arc) {
        ++free;
        continue;
      }
      ++collisions;
      const double expected =
          first <= 1 ? first * (b - a).norm() : (b - a).norm() + second * (c - b).norm();
      ASSERT_NEAR(*arc, expected, 1e-7);
    }
  }
  EXPECT_GT(collisions, 500);
  EXPECT_GT(free, 500);
}

TEST(HeightSurface, ThePathOfARayCollidesWhereTheRayHits) {
  Random random(7);
  const HeightSurface surface(random_city(random, 40, 40, {0, 0}, 1.0));
  int hits = 0;
  for (int ray = 0; ray < 2000; ++ray) {
    const Point from = random_point(random, surface.heights());
    const Point direction = random_direction(random);
    const RayHit hit = surface.cast(from, direction, 80);
    const std::optional<double> arc =
        surface.first_collision(path({from, Point(from + 80 * direction)}));
    ASSERT_EQ(arc.has_value(), hit.hit());
    if (!hit.hit()) continue;
    ++hits;
    ASSERT_NEAR(*arc, hit.range, 1e-6);
  }
  EXPECT_GT(hits, 500);
}

TEST(HeightSurface, ThePathThatTouchesTheSolidCollides) {
  const HeightSurface surface = tower();
  const auto top = surface.first_collision(path({{0.5, 1.5, 5}, {3.5, 1.5, 5}}));  // along the top
  ASSERT_TRUE(top);
  EXPECT_NEAR(*top, 1.5, 1e-8);
  EXPECT_FALSE(surface.first_collision(path({{0.5, 1.5, 5.0001}, {3.5, 1.5, 5.0001}})));
  for (const double y : {1.0, 2.0}) {  // along either wall
    const auto arc = surface.first_collision(path({{0.5, y, 3}, {3.5, y, 3}}));
    ASSERT_TRUE(arc) << y;
    EXPECT_NEAR(*arc, 1.5, 1e-8);
  }
  EXPECT_FALSE(surface.first_collision(path({{0.5, 0.999, 3}, {3.5, 0.999, 3}})));
  // Past a corner, exactly through it; ending on a wall; starting on one.
  EXPECT_FALSE(surface.first_collision(path({{1.5, 1.499, 3}, {2.5, 0.499, 3}})));
  EXPECT_TRUE(surface.first_collision(path({{1.5, 1.5, 3}, {2.5, 0.5, 3}})));
  EXPECT_TRUE(surface.first_collision(path({{1, 1.5, 3}, {2, 1.5, 3}})));
  EXPECT_EQ(surface.first_collision(path({{3, 1.5, 3}, {4, 1.5, 3}})), 0.0);
  EXPECT_EQ(surface.first_collision(path({{2.5, 1.5, 9}, {2.5, 1.5, 1}})), 4.0);  // straight down
}

TEST(HeightSurface, ShortPathsHaveAnAnswer) {
  const HeightSurface surface = tower();
  EXPECT_FALSE(surface.first_collision(Path(0, 3)));
  EXPECT_FALSE(surface.first_collision(path({{0.5, 0.5, 3}})));
  EXPECT_EQ(surface.first_collision(path({{2.5, 1.5, 3}})), 0.0);
  EXPECT_EQ(surface.first_collision(path({{2.5, 1.5, 3}, {2.5, 1.5, 3}})), 0.0);
  const auto waited = surface.first_collision(path({{0.5, 1.5, 3}, {0.5, 1.5, 3}, {3.5, 1.5, 3}}));
  ASSERT_TRUE(waited);
  EXPECT_NEAR(*waited, 1.5, 1e-8);
  EXPECT_THROW(surface.first_collision(path({{0, 0, std::nan("")}})), std::invalid_argument);
}

TEST(HeightSurface, ClearanceAgreesWithTryingEveryColumn) {
  Random random(8);
  int inside = 0, capped = 0;
  for (int scene = 0; scene < 30; ++scene) {
    const HeightSurface surface(random_city(random, 1 + random() % 40, 1 + random() % 40,
                                            {uniform(random, -9, 9), 3}, scene % 2 ? 1.0 : 0.7));
    for (int n = 0; n < 200; ++n) {
      const Point point = random_point(random, surface.heights());
      const double max_distance = uniform(random, 0, 30);
      const double distance = surface.clearance(point, max_distance);
      ASSERT_NEAR(distance, slow_clearance(surface.heights(), point, max_distance), 1e-9);
      inside += distance == 0.0;
      capped += distance == max_distance;
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(capped, 100);
}

TEST(HeightSurface, ClearanceIsGivenInMetres) {
  const HeightSurface surface = tower();
  EXPECT_DOUBLE_EQ(surface.clearance({0.5, 1.5, 4}, 50), 1.5);
  EXPECT_DOUBLE_EQ(surface.clearance({2.5, 1.5, 9}, 50), 4.0);
  EXPECT_DOUBLE_EQ(surface.clearance({2.5, 1.5, 9}, 3), 3.0);
  EXPECT_DOUBLE_EQ(surface.clearance({-3, 8, 0}, 50), 5.0);  // from outside the raster
  EXPECT_EQ(surface.clearance({2.5, 1.5, 5}, 50), 0.0);
  EXPECT_THROW(surface.clearance({2.5, 1.5, kInfinity}, 50), std::invalid_argument);
  EXPECT_THROW(surface.clearance({2.5, 1.5, 5}, -1), std::invalid_argument);
}

}  // namespace
}  // namespace ltp
