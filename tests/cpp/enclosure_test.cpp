// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The glance at a goal's surroundings: what it calls parted is parted, and a closed room it sees.
#include "ltp/planning/enclosure.hpp"

#include <gtest/gtest.h>

#include "ltp/planning/flood.hpp"
#include "slow_distances.hpp"

namespace ltp {
namespace {

TEST(Enclosure, PartsNothingThatAFloodJoins) {
  std::mt19937_64 random(1);
  Enclosure enclosure;
  int parted = 0;
  int joined = 0;
  for (int k = 0; k < 2000; ++k) {
    OccupancyGrid grid = test::random_grid(random);
    const Cell inside = test::random_cell(random, grid.frame());
    const Cell outside = test::random_cell(random, grid.frame());
    if (inside == outside) continue;
    grid.set(inside, false);
    grid.set(outside, false);
    const LevelRange levels{std::min(inside.z(), outside.z()), grid.frame().nz() - 1};
    Flood flood;
    flood.fill(grid, inside, levels);
    const bool answer = enclosure.parts(grid, inside, outside, levels);
    if (flood.reached(outside)) {
      ASSERT_FALSE(answer) << k;
    }
    (answer ? parted : joined) += 1;
  }
  EXPECT_GT(parted, 200);
  EXPECT_GT(joined, 500);
}

TEST(Enclosure, SeesAClosedRoomAndItsDoor) {
  OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {80, 80, 20}));
  for (int x = 30; x <= 50; ++x) {
    for (int y = 30; y <= 50; ++y) {
      for (int z = 0; z <= 15; ++z) {
        grid.set(Cell(x, y, z), x % 20 == 10 || y % 20 == 10 || z % 15 == 0);
      }
    }
  }
  const LevelRange all{0, 19};
  Enclosure enclosure;
  EXPECT_TRUE(enclosure.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), all));
  EXPECT_TRUE(enclosure.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), {8, 8}));
  EXPECT_FALSE(enclosure.parts(grid, Cell(40, 40, 8), Cell(45, 32, 2), all));
  EXPECT_FALSE(enclosure.parts(grid, Cell(3, 3, 8), Cell(40, 40, 8), all)) << "it sees far";
  grid.set(Cell(30, 42, 1), false);
  EXPECT_FALSE(enclosure.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), all));
  EXPECT_TRUE(enclosure.parts(grid, Cell(40, 40, 8), Cell(3, 3, 8), {8, 8}));
}

}  // namespace
}  // namespace ltp
