// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A height surface agrees with slow and obvious answers: every column is a box, try them all.
#include "ltp/sensing/height_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kPi = 3.141592653589793;

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

/// Ground, blocks and single poles; a third of the heights are exact multiples of 4 m.
Raster random_city(Random& random, int nx, int ny, const Eigen::Vector2d& origin, double cell) {
  Raster::Values values = Raster::Values::Zero(nx, ny);
  const auto height = [&] {
    const double h = uniform(random, -8, 30);
    return random() % 3 == 0 ? 4.0 * std::round(h / 4.0) : h;
  };
  for (int block = 0; block < nx * ny / 24; ++block) {
    const int i = static_cast<int>(random() % nx);
    const int j = static_cast<int>(random() % ny);
    const int di = std::min<int>(1 + random() % 5, nx - i);
    const int dj = std::min<int>(1 + random() % 5, ny - j);
    values.block(i, j, di, dj) = height();
  }
  for (int pole = 0; pole < nx; ++pole) values(random() % nx, random() % ny) = height();
  return Raster(values, origin, cell);
}

/// When a + t * d lies in the half-open [low, high).
std::pair<double, double> slab(double a, double d, double low, double high) {
  if (d == 0.0) {
    return a >= low && a < high ? std::pair(-kInfinity, kInfinity) : std::pair(1.0, -1.0);
  }
  return std::minmax((low - a) / d, (high - a) / d);
}

/// How far a point lies inside the column that holds it: from its top and its walls [m].
double depth_in_column(const Raster& heights, const Point& point) {
  const int i = heights.index_of(0, point.x());
  const int j = heights.index_of(1, point.y());
  const double x = point.x() - (heights.origin().x() + i * heights.cell());
  const double y = point.y() - (heights.origin().y() + j * heights.cell());
  return std::min({x, y, heights.cell() - x, heights.cell() - y, heights(i, j) - point.z()});
}

/// The slow answer: the nearest of all columns whose interior the ray enters.
double slow_range(const Raster& heights, const Point& origin, const Point& direction,
                  double max_range) {
  double nearest = kInfinity;
  for (int i = 0; i < heights.nx(); ++i) {
    for (int j = 0; j < heights.ny(); ++j) {
      const double x = heights.origin().x() + i * heights.cell();
      const double y = heights.origin().y() + j * heights.cell();
      const auto [x_in, x_out] = slab(origin.x(), direction.x(), x, x + heights.cell());
      const auto [y_in, y_out] = slab(origin.y(), direction.y(), y, y + heights.cell());
      const auto [z_in, z_out] = slab(origin.z(), direction.z(), -1e9, heights(i, j));
      const double t_in = std::max({0.0, x_in, y_in, z_in});
      if (t_in < std::min({x_out, y_out, z_out})) nearest = std::min(nearest, t_in);
    }
  }
  return nearest < max_range ? nearest : kInfinity;
}

/// The slow answer for a closed solid: the smallest t in [0, 1] of a + t * (b - a) in any box.
double slow_touch(const Raster& heights, const Point& a, const Point& b) {
  const Point d = b - a;
  const auto closed = [&](int axis, double low, double high) {
    if (d[axis] != 0.0) return slab(a[axis], d[axis], low, high);
    return a[axis] >= low && a[axis] <= high ? std::pair(-kInfinity, kInfinity)
                                             : std::pair(1.0, -1.0);
  };
  double first = kInfinity;
  for (int i = 0; i < heights.nx(); ++i) {
    for (int j = 0; j < heights.ny(); ++j) {
      const double x = heights.origin().x() + i * heights.cell();
      const double y = heights.origin().y() + j * heights.cell();
      const auto [x_in, x_out] = closed(0, x, x + heights.cell());
      const auto [y_in, y_out] = closed(1, y, y + heights.cell());
      const auto [z_in, z_out] = closed(2, -1e9, heights(i, j));
      const double t_in = std::max({0.0, x_in, y_in, z_in});
      if (t_in <= std::min({1.0, x_out, y_out, z_out})) first = std::min(first, t_in);
    }
  }
  return first;
}

double slow_clearance(const Raster& heights, const Point& point, double max_distance) {
  double nearest = max_distance;
  for (int i = 0; i < heights.nx(); ++i) {
    for (int j = 0; j < heights.ny(); ++j) {
      const Point low(heights.origin().x() + i * heights.cell(),
                      heights.origin().y() + j * heights.cell(), -1e9);
      const Point high(low.x() + heights.cell(), low.y() + heights.cell(), heights(i, j));
      nearest = std::min(nearest, (point - point.cwiseMax(low).cwiseMin(high)).norm());
    }
  }
  return nearest;
}

Path path(const std::vector<Point>& points) {
  Path rows(points.size(), 3);
  for (std::size_t n = 0; n < points.size(); ++n) rows.row(n) = points[n].transpose();
  return rows;
}

/// A point in, above, below or beside a raster.
Point random_point(Random& random, const Raster& heights) {
  const double width = heights.nx() * heights.cell();
  const double depth = heights.ny() * heights.cell();
  return {heights.origin().x() + uniform(random, -0.3, 1.3) * width,
          heights.origin().y() + uniform(random, -0.3, 1.3) * depth, uniform(random, -12, 40)};
}

/// 4 x 4 cells of 1 m; cell (2, 1) is 5 m high, the rest lies at 0.
HeightSurface tower() {
  Raster::Values values = Raster::Values::Zero(4, 4);
  values(2, 1) = 5.0;
  return HeightSurface(Raster(values, {0, 0}, 1.0));
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
  std::vector<RayHit> hits;
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
      surface.cast_fan(from, heading, fan, max_range, hits);
      ASSERT_EQ(hits.size(), elevations.size());
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
  std::vector<RayHit> hits;
  surface.cast_fan({0.5, 1.5, 3}, {1, 0}, BeamFan({0.0}), 1.5, hits);
  EXPECT_FALSE(hits[0].hit());
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

TEST(BeamFan, ElevationsMustAscendBelowTheZenith) {
  EXPECT_THROW(BeamFan({0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(BeamFan({kPi / 2}), std::invalid_argument);
  EXPECT_THROW(BeamFan({std::nan("")}), std::invalid_argument);
  EXPECT_EQ(BeamFan({}).size(), 0);
}

}  // namespace
}  // namespace ltp
