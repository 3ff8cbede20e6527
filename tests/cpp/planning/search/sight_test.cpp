// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The quick looks along straight lines against the slow judges and the exact walks.
#include "planning/search/sight.hpp"

#include <gtest/gtest.h>

#include "scenes.hpp"

namespace ltp::planning {
namespace {

/// Cubes with sparse clutter, far from the origin, more than one word of levels high.
struct Clutter {
  GridFrame frame{Point(-104, 51, 20), Point(1, 1, 1), {9, 8, 70}};
  OccupancyGrid grid{frame};
  Raster priority = test::random_priority(frame, 3);
  std::mt19937_64 random{5};

  Clutter() {
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      if (cell.z() > 57 && random() % 100 < 6) grid.set(cell);
    }
  }

  /// A point in the upper part, now and then a little outside, on a face, or on a centre.
  Point point() {
    std::uniform_real_distribution<double> unit(-0.05, 1.05);
    Point at = frame.origin() + Point(9 * unit(random), 8 * unit(random), 57 + 13 * unit(random));
    const auto kind = random() % 8;
    if (kind == 0) at = at.array().floor();
    if (kind == 1) at = at.array().floor() + 0.5;
    return at;
  }
};

TEST(Sight, IsClearOnlyWhereTheGrownBoxesAreNotMet) {
  Clutter clutter;
  const Sight sight(clutter.grid, {0, 69}, clutter.priority);
  int clear = 0;
  int planar_hidden = 0;
  for (int i = 0; i < 3000; ++i) {
    const Point a = clutter.point();
    Point b = clutter.point();
    const bool planar = i % 2 == 0;
    if (planar) b.z() = a.z();
    if (i % 16 == 1) b.head<2>() = a.head<2>();  // straight up
    const double margin = 0.1 * (1 + i % 4);
    Path path(2, 3);
    path << a.transpose(), b.transpose();
    const bool answer = sight.clear(a, b, margin, margin);
    if (answer) {
      EXPECT_FALSE(test::meets_blocked(clutter.grid, path, margin - 1e-9)) << path;
      EXPECT_FALSE(clutter.grid.first_blocked(path)) << path;
    } else if (planar) {  // not one line too many is refused
      EXPECT_TRUE(test::meets_blocked(clutter.grid, path, margin + 1e-9)) << path;
      ++planar_hidden;
    }
    clear += answer;
    EXPECT_EQ(answer, sight.clear(b, a, margin, margin)) << path;
  }
  EXPECT_GT(clear, 300);
  EXPECT_GT(planar_hidden, 300);
}

TEST(Sight, TapersItsBoxFromOneMarginToTheOther) {
  Clutter clutter;
  const Sight sight(clutter.grid, {0, 69}, clutter.priority);
  int between = 0;
  for (int i = 0; i < 3000; ++i) {
    const Point a = clutter.point();
    Point b = clutter.point();
    if (i % 2 == 0) b.z() = a.z();
    const bool tapered = sight.clear(a, b, 0.05, 0.45);
    EXPECT_EQ(tapered, sight.clear(b, a, 0.45, 0.05));
    if (!tapered) continue;
    // What it passes at each place: the box there, no more.
    for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) {
      const Point at = a + t * (b - a);
      Path here(2, 3);
      here << at.transpose(), at.transpose();
      EXPECT_FALSE(test::meets_blocked(clutter.grid, here, 0.05 + 0.4 * t - 1e-9));
    }
    between += !sight.clear(a, b, 0.45, 0.45);
  }
  EXPECT_GT(between, 30);
}

TEST(Sight, AddsUpThePriorityAsTheExactWalkDoes) {
  Clutter clutter;
  const Point cell = clutter.frame.cell();
  for (const double edge : {1.0, 0.7, 5.0, 1e-9}) {
    // Its own lattice, askew to the grid's; the finest is left to the exact walk.
    Raster::Values values = (Raster::Values::Random(6, 7) + 1.0) / 2.0;
    const Raster raster(values, Eigen::Vector2d(-103.3, 52.4), edge, 0.25);
    const Sight sight(clutter.grid, {0, 69}, raster);
    for (int i = 0; i < 1000; ++i) {
      const Point a = clutter.point();
      Point b = clutter.point();
      if (i % 8 == 0) b.head<2>() = a.head<2>();
      if (i % 8 == 1) b.x() = a.x();
      if (i % 8 == 2) b = a + Point(1.5, 1.5, 0.0).cwiseProduct(cell);
      const double slack = 1e-9 * (1.0 + (b - a).norm());
      EXPECT_NEAR(sight.priority(a, b), raster.integral(a, b), slack)
          << a.transpose() << " to " << b.transpose();
    }
  }
}

TEST(Sight, KnowsTheWindowAndTheLevels) {
  Clutter clutter;
  const Sight sight(clutter.grid, {60, 61}, clutter.priority);
  const Point low = clutter.frame.origin();
  EXPECT_TRUE(sight.inside(low + Point(0.5, 0.5, 60.5)));
  EXPECT_TRUE(sight.inside(low + Point(8.9, 7.9, 61.9)));
  EXPECT_FALSE(sight.inside(low + Point(9.1, 7.9, 61.9)));
  EXPECT_FALSE(sight.inside(low + Point(8.9, -0.1, 61.9)));
  EXPECT_FALSE(sight.inside(low + Point(0.5, 0.5, 59.9)));
  EXPECT_FALSE(sight.inside(low + Point(0.5, 0.5, 62.0)));
}

}  // namespace
}  // namespace ltp::planning
