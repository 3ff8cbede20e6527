// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Nothing is allocated while flying: the map takes its memory when it is made.
#include "allocations.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "ltp/mapping/obstacle_map.hpp"

namespace ltp {
namespace {

TEST(Allocations, AreCounted) {
  const std::int64_t before = test::allocations();
  const std::int64_t taken_before = test::bytes();
  {
    const std::vector<int> vector(10);
    const Path path(2, 3);
  }
  const std::int64_t count = test::allocations() - before;
  const std::int64_t most = test::most_bytes() - taken_before;
  const std::int64_t left = test::bytes() - taken_before;
  EXPECT_EQ(count, 2);
  EXPECT_GE(most, static_cast<std::int64_t>(10 * sizeof(int) + 6 * sizeof(double)));
  EXPECT_EQ(left, 0);
}

TEST(Allocations, AMapThatForgetsMakesNoneOnceItExists) {
  std::mt19937_64 random(9);
  std::normal_distribution<double> normal;
  for (const bool carve : {false, true}) {
    for (const bool keep_hits : {true, false}) {
      ObstacleMapOptions options;
      options.dims = {50, 50, 40};
      options.carve_free_space = carve;
      options.keep_hits = keep_hits;
      options.remember = false;  // what is new to a mission is allocated for
      Point position = Point::Zero();
      ObstacleMap map(options, position);
      std::vector<Point> hits(500), misses(500);
      std::int64_t inserted = 0;
      for (int scan = 0; scan < 50; ++scan) {
        for (Point& hit : hits)
          hit = position + 15.0 * Point(normal(random), normal(random), normal(random));
        for (Point& miss : misses)
          miss = position + 90.0 * Point(normal(random), normal(random), normal(random));
        const std::int64_t before = test::allocations();
        const Eigen::Map<const Path> hit_rows(hits.front().data(), hits.size(), 3);
        const Eigen::Map<const Path> miss_rows(misses.front().data(), misses.size(), 3);
        inserted += map.insert(position, hit_rows, miss_rows).marked;
        inserted += map.insert(position, hit_rows).marked;
        map.recentre(position);
        EXPECT_EQ(test::allocations() - before, 0) << "scan " << scan << ", carving " << carve;
        position += Point(2.5 * normal(random), 2.5 * normal(random), 2.5 * normal(random));
      }
      EXPECT_GT(inserted, 10000);
    }
  }
}

}  // namespace
}  // namespace ltp
