// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The memory of obstacles: what it keeps, and that it proves what a fresh one would prove.
#include "ltp/navigation/obstacle_memory.hpp"

#include <gtest/gtest.h>

#include <random>

#include "allocations.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp {
namespace {

constexpr double kRadius = 4.0;
const GridFrame kWindow({0, 0, 0}, {2, 2, 4}, {20, 20, 6});

/// A window, moved, with random obstacles in it.
OccupancyGrid window(std::mt19937& random, const Cell& shift, int count) {
  OccupancyGrid grid(kWindow.shifted(shift));
  for (int i = 0; i < count; ++i) {
    grid.set(Cell(static_cast<int>(random() % 20), static_cast<int>(random() % 20),
                  static_cast<int>(random() % 6)));
  }
  return grid;
}

/// The obvious answer: inflate all that is remembered, and flood all of it.
bool seals_by_brute_force(const OccupancyGrid& occupied, const Query& query) {
  const OccupancyGrid blocked = inflate(occupied, kRadius);
  const GridFrame& frame = blocked.frame();
  const Cell goal = frame.cell_of(query.goal);
  if (!frame.contains(goal) || blocked.blocked(goal)) return false;
  planning::Flood flood;
  flood.fill(blocked, goal, levels_of(frame, query));
  return !flood.touched_edge() && !flood.reached(frame.cell_of(query.start));
}

TEST(ObstacleMemory, ProvesAtAnyTimeWhatAllThatItRemembersProves) {
  std::mt19937 random(4);
  int sealed = 0, open = 0;
  for (int trial = 0; trial < 20; ++trial) {
    ObstacleMemory memory(kWindow, 3, kRadius);
    Cell shift = Cell::Zero();
    for (int step = 0; step < 40; ++step) {  // far enough for the memory to move along
      shift += Cell(static_cast<int>(random() % 5) - 1, static_cast<int>(random() % 5) - 2, 0);
      const OccupancyGrid seen = window(random, shift, 5);
      memory.remember(seen);
      const auto anywhere = [&] {
        return seen.frame().centre(
            Cell(static_cast<int>(random() % 20), static_cast<int>(random() % 20), 3));
      };
      for (int i = 0; i < 3; ++i) {
        const Query query{anywhere(), anywhere(), {0.0, 0.0}};
        const bool expected = seals_by_brute_force(memory.occupied(), query);
        ASSERT_EQ(memory.seals(query), expected) << "trial " << trial << ", step " << step;
        ++(expected ? sealed : open);
      }
    }
  }
  EXPECT_GT(sealed, 20);
  EXPECT_GT(open, 20);
}

TEST(ObstacleMemory, ProvesNothingFromWhatItWasToldToForget) {
  ObstacleMemory memory(kWindow, 3, kRadius);
  OccupancyGrid ring(kWindow);
  for (int i = 4; i <= 16; ++i) {
    for (const Cell& cell : {Cell(i, 4, 3), Cell(i, 16, 3), Cell(4, i, 3), Cell(16, i, 3)}) {
      ring.set(cell);
    }
  }
  const Query query{kWindow.centre({0, 0, 3}), kWindow.centre({10, 10, 3}), {0, 0}};
  memory.remember(ring);
  EXPECT_TRUE(memory.seals(query));
  memory.clear();
  EXPECT_EQ(memory.occupied().count(), 0);
  EXPECT_FALSE(memory.seals(query));
  memory.remember(ring);
  EXPECT_TRUE(memory.seals(query));
}

TEST(ObstacleMemory, RemembersWithoutAllocating) {
  std::mt19937 random(5);
  ObstacleMemory memory(kWindow, 3, kRadius);
  for (int step = 0; step < 30; ++step) {
    const OccupancyGrid seen = window(random, Cell(2 * step, step, 0), 5);
    const Query query{seen.frame().centre({10, 10, 3}), seen.frame().centre({2, 2, 3}), {0, 0}};
    const std::int64_t before = test::allocations();
    memory.remember(seen);
    EXPECT_EQ(test::allocations() - before, 0) << "step " << step;
    memory.seals(query);
  }
}

}  // namespace
}  // namespace ltp
