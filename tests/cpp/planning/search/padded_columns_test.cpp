// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The padded copy of a window, cell by cell: its numbers, what it knows of each, and its margin.
#include "planning/search/padded_columns.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

LevelRange random_levels(std::mt19937_64& random, const GridFrame& frame) {
  const int lowest = static_cast<int>(random() % frame.nz());
  const int highest = lowest + static_cast<int>(random() % (frame.nz() - lowest));
  return random() % 2 == 0 ? LevelRange{0, frame.nz() - 1} : LevelRange{lowest, highest};
}

TEST(PaddedColumns, KnowTheSurroundingsOfEveryCell) {
  std::mt19937_64 random(1);
  PaddedColumns columns;
  for (int k = 0; k < 200; ++k) {
    const OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const LevelRange levels = random_levels(random, frame);
    columns.reset(grid, levels);
    ASSERT_EQ(columns.depth(), static_cast<std::uint32_t>(levels.highest - levels.lowest + 1));
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      const bool inside = cell.z() >= levels.lowest && cell.z() <= levels.highest;
      ASSERT_EQ(columns.contains(cell), inside);
      if (!inside) continue;
      const std::uint32_t blocked = blocked_surroundings(grid, cell, levels);
      ASSERT_EQ(columns.surroundings(columns.index(cell)), blocked);
      ASSERT_EQ(columns.in_the_open(columns.index(cell)), blocked == 0);
    }
  }
}

TEST(PaddedColumns, NumberEachCellOnceAndItsNeighboursByTheirOffsets) {
  std::mt19937_64 random(2);
  PaddedColumns columns;
  for (int k = 0; k < 60; ++k) {
    const OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const LevelRange levels = random_levels(random, frame);
    columns.reset(grid, levels);
    std::vector<char> used(columns.size(), 0);
    for (int x = -1; x <= frame.nx(); ++x) {
      for (int y = -1; y <= frame.ny(); ++y) {
        for (int z = levels.lowest; z <= levels.highest; ++z) {
          const Cell cell(x, y, z);
          const std::uint32_t index = columns.index(cell);
          ASSERT_LT(index, columns.size());
          ASSERT_EQ(used[index]++, 0);
          if (!frame.contains(cell)) {  // the margin
            ASSERT_FALSE(columns.in_the_open(index));
            continue;
          }
          for (const Step& step : steps()) {
            const Cell next = cell + step.offset();
            if (!columns.contains(next)) continue;
            const std::int64_t by = std::int64_t{columns.index(next)} - index;
            ASSERT_EQ(columns.offset(step), by);
          }
        }
      }
    }
  }
}

TEST(PaddedColumns, ShowEveryCellOnceInItsWordsAndABlockedMargin) {
  std::mt19937_64 random(3);
  PaddedColumns columns;
  std::int64_t blocked = 0;
  for (int k = 0; k < 100; ++k) {
    const OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const LevelRange levels = random_levels(random, frame);
    columns.reset(grid, levels);
    std::vector<int> shown(columns.size(), -1);
    columns.each_word([&](std::uint32_t first, std::uint64_t bits, std::uint32_t count) {
      for (std::uint32_t i = 0; i < count; ++i) {
        ASSERT_EQ(shown[first + i], -1);
        shown[first + i] = static_cast<int>(bits >> i & 1u);
      }
    });
    for (int x = -1; x <= frame.nx(); ++x) {
      for (int y = -1; y <= frame.ny(); ++y) {
        for (int z = levels.lowest; z <= levels.highest; ++z) {
          const Cell cell(x, y, z);
          const int expected = !frame.contains(cell) || grid.blocked(cell) ? 1 : 0;
          ASSERT_EQ(shown[columns.index(cell)], expected);
          blocked += expected;
        }
      }
    }
  }
  EXPECT_GT(blocked, 10000);
}

}  // namespace
}  // namespace ltp::planning
