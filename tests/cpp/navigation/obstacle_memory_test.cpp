// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The memory of obstacles: it keeps all that a window has passed, without end, and proves what a
// flood over all of it proves.
#include "ltp/navigation/obstacle_memory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <set>

#include "allocations.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp {
namespace {

constexpr double kRadius = 4.0;
const GridFrame kWindow({0, 0, 0}, {2, 2, 4}, {20, 20, 6});

using Key = std::array<int, 3>;

Key key(const Cell& cell) { return {cell.x(), cell.y(), cell.z()}; }

/// A window, moved, with random obstacles in it.
OccupancyGrid window(std::mt19937& random, const Cell& shift, int count) {
  OccupancyGrid grid(kWindow.shifted(shift));
  for (int i = 0; i < count; ++i) {
    grid.set(Cell(static_cast<int>(random() % 20), static_cast<int>(random() % 20),
                  static_cast<int>(random() % 6)));
  }
  return grid;
}

/// The blocked cells, counted from the lattice's anchor.
std::set<Key> cells_of(const OccupancyGrid& grid) {
  std::set<Key> cells;
  const GridFrame& frame = grid.frame();
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    if (grid.blocked(frame.cell_at(i))) cells.insert(key(frame.cell_at(i) + frame.first()));
  }
  return cells;
}

TEST(ObstacleMemory, KeepsAllThatTheWindowHasPassed) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 10; ++trial) {
    ObstacleMemory memory(kWindow, kRadius);
    std::set<Key> expected;
    Cell shift = Cell::Zero();
    for (int step = 0; step < 40; ++step) {
      const int far = step % 10 == 9 ? 40 : 4;
      for (int axis = 0; axis < 3; ++axis) {
        shift[axis] += static_cast<int>(random() % (2 * far + 1)) - far;
      }
      if (trial % 2 == 0) shift.z() = 0;
      OccupancyGrid seen = window(random, shift, 5);
      memory.add_to(seen);  // as a map that remembers, too
      memory.remember(seen);
      expected.merge(cells_of(seen));
    }
    EXPECT_EQ(cells_of(memory.blocked()), expected);
    EXPECT_FALSE(memory.has_forgotten());
    // A ring of free cells lies round all of it.
    const Cell first = memory.blocked().frame().first();
    const Cell upper(memory.blocked().frame().nx(), memory.blocked().frame().ny(),
                     memory.blocked().frame().nz());
    for (const Key& cell : expected) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(cell[axis], first[axis]);
        EXPECT_LT(cell[axis], first[axis] + upper[axis] - 1);
      }
    }
  }
}

TEST(ObstacleMemory, AddsToAWindowWhatTheWindowHasForgotten) {
  std::mt19937 random(6);
  ObstacleMemory memory(kWindow, kRadius);
  const OccupancyGrid seen = window(random, Cell(3, -2, 1), 60);
  memory.remember(seen);
  memory.remember(window(random, Cell(60, 40, -2), 60));
  OccupancyGrid again(seen.frame());
  memory.add_to(again);
  EXPECT_EQ(again, seen);
}

TEST(ObstacleMemory, FreesWhatTheWindowHasSeenGo) {
  ObstacleMemory memory(kWindow, kRadius);
  OccupancyGrid seen(kWindow);
  const Cell middle(10, 10, 3);
  const Cell border(1, 10, 3);
  seen.set(middle);
  seen.set(border);
  memory.remember(seen);
  const std::int64_t before = memory.version();
  memory.remember(OccupancyGrid(kWindow.shifted(Cell(0, 1, 0))));
  EXPECT_GT(memory.version(), before);
  // Near the border the window may only have left what blocks a cell.
  EXPECT_EQ(cells_of(memory.blocked()), std::set<Key>{key(border)});
}

TEST(ObstacleMemory, KeepsWhatAWindowNoLongerKnowsThatComesBack) {
  ObstacleMemory memory(kWindow, kRadius);
  OccupancyGrid seen(kWindow);
  seen.set(Cell(10, 10, 3));
  memory.remember(seen);
  for (const int x : {25, 0, 1}) memory.remember(OccupancyGrid(kWindow.shifted(Cell(x, 0, 0))));
  EXPECT_EQ(cells_of(memory.blocked()), std::set<Key>{(Key{10, 10, 3})});
}

/// The obvious answer: flood all that is remembered.
bool seals_by_brute_force(const OccupancyGrid& blocked, const Query& query) {
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
    ObstacleMemory memory(kWindow, kRadius);
    Cell shift = Cell::Zero();
    for (int step = 0; step < 40; ++step) {
      shift += Cell(static_cast<int>(random() % 5) - 1, static_cast<int>(random() % 5) - 2, 0);
      OccupancyGrid seen = window(random, shift, 100);
      memory.add_to(seen);
      memory.remember(seen);
      const auto anywhere = [&] {
        return seen.frame().centre(
            Cell(static_cast<int>(random() % 20), static_cast<int>(random() % 20), 3));
      };
      for (int i = 0; i < 3; ++i) {
        const Query query{anywhere(), anywhere(), {0.0, 0.0}};
        const bool expected = seals_by_brute_force(memory.blocked(), query);
        ASSERT_EQ(memory.seals(query), expected) << "trial " << trial << ", step " << step;
        ASSERT_EQ(memory.encloses({query.goal, query.start, query.band}), expected);
        ++(expected ? sealed : open);
      }
    }
  }
  EXPECT_GT(sealed, 20);
  EXPECT_GT(open, 20);
}

TEST(ObstacleMemory, ProvesNothingFromWhatItWasToldToForget) {
  ObstacleMemory memory(kWindow, kRadius);
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
  EXPECT_EQ(memory.blocked().count(), 0);
  EXPECT_FALSE(memory.seals(query));
  memory.remember(ring);
  EXPECT_TRUE(memory.seals(query));
}

TEST(ObstacleMemory, AllocatesNothingWhereThereIsRoom) {
  std::mt19937 random(5);
  ObstacleMemory memory(kWindow, kRadius);
  EXPECT_TRUE(memory.make_room({0, 0, 0}, {140, 120, 24}));
  for (int step = 0; step < 30; ++step) {
    OccupancyGrid seen = window(random, Cell(step, step, 0), 5);
    const std::int64_t before = test::allocations();
    memory.remember(seen);
    memory.add_to(seen);
    EXPECT_EQ(test::allocations() - before, 0) << "step " << step;
  }
}

TEST(ObstacleMemory, ForgetsWhatIsFarthestWhereItHasNoRoomForMore) {
  ObstacleMemory memory(kWindow, kRadius);
  OccupancyGrid seen(kWindow);
  seen.set(Cell(10, 10, 3));
  memory.remember(seen);
  EXPECT_FALSE(memory.make_room({0, 0, 0}, {1e6, 0, 0}));
  EXPECT_FALSE(memory.has_forgotten());
  const double edge = 2.0 * ObstacleMemory::kMostCells;
  EXPECT_TRUE(memory.make_room({300, 0, 0}, {edge + 200, 0, 8}));
  EXPECT_TRUE(memory.has_forgotten());
  EXPECT_EQ(memory.blocked().count(), 0);
  EXPECT_LE(memory.blocked().frame().nx(), ObstacleMemory::kMostCells);
  OccupancyGrid far(kWindow.shifted(Cell(100000, 0, 0)));
  far.set(Cell(4, 4, 4));
  memory.remember(far);  // it has leapt
  EXPECT_EQ(cells_of(memory.blocked()), std::set<Key>{(Key{100004, 4, 4})});
}

}  // namespace
}  // namespace ltp
