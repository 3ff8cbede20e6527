// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The 26 steps by their definition, and the mask of a cell's surroundings against asking each cell.
#include "ltp/grid/neighbourhood.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <random>
#include <set>
#include <utility>

namespace ltp {
namespace {

TEST(Neighbourhood, HasEveryStepOnceInTheOrderOfTies) {
  std::set<std::array<int, 3>> seen;
  std::array<int, 4> last = {0, -2, -2, -2};
  for (const Step& step : steps()) {
    const std::array<int, 3> offset = {step.dx, step.dy, step.dz};
    EXPECT_TRUE(seen.insert(offset).second);
    int kind = 0;
    for (const int d : offset) {
      EXPECT_LE(std::abs(d), 1);
      kind += std::abs(d);
    }
    EXPECT_GE(kind, 1);
    // Faces first, then edges, then corners; within each by (dx, dy, dz).
    const std::array<int, 4> place = {kind, offset[0], offset[1], offset[2]};
    EXPECT_LT(last, place);
    last = place;
  }
  EXPECT_EQ(seen.size(), 26u);
}

TEST(Neighbourhood, KnowsTheStepBack) {
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    const Step& back = steps()[step.opposite];
    EXPECT_EQ(back.dx, -step.dx);
    EXPECT_EQ(back.dy, -step.dy);
    EXPECT_EQ(back.dz, -step.dz);
    EXPECT_EQ(back.opposite, i);
  }
}

TEST(Neighbourhood, AsksAboutTheBoundingBoxOfAStep) {
  for (const Step& step : steps()) {
    int cells = 0;
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          const auto between = [](int d, int end) {
            return std::min(0, end) <= d && d <= std::max(0, end);
          };
          const bool own = x == 0 && y == 0 && z == 0;
          const bool expected =
              !own && between(x, step.dx) && between(y, step.dy) && between(z, step.dz);
          EXPECT_EQ(step.box >> neighbour_bit(x, y, z) & 1u, expected);
          cells += expected;
        }
      }
    }
    const int kind = std::abs(step.dx) + std::abs(step.dy) + std::abs(step.dz);
    EXPECT_EQ(cells, (1 << kind) - 1);
    EXPECT_EQ(step.box >> 27, 0u);
  }
}

TEST(Neighbourhood, MeasuresStepsInMetres) {
  const std::array<double, kSteps> lengths = step_lengths(Point(2, 3, 6));
  const std::array<double, kSteps> ones = step_lengths(Point(1, 1, 1));
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    double squares = 0.0;
    if (step.dx != 0) squares += 4;
    if (step.dy != 0) squares += 9;
    if (step.dz != 0) squares += 36;
    EXPECT_DOUBLE_EQ(lengths[i], std::sqrt(squares));
    EXPECT_EQ(lengths[i], lengths[step.opposite]);
    EXPECT_DOUBLE_EQ(ones[i], std::sqrt(std::abs(step.dx) + std::abs(step.dy) + std::abs(step.dz)));
  }
  EXPECT_DOUBLE_EQ(lengths[25], 7.0) << "the last one is a corner";
}

TEST(Neighbourhood, SeesTheBlockedCellsRoundACell) {
  std::mt19937_64 random(1);
  int compared = 0;
  for (const int nz : {1, 2, 3, 62, 63, 64, 65, 66, 127, 128, 129, 130}) {
    for (const auto& [nx, ny] : {std::pair{3, 4}, {1, 1}, {1, 5}}) {
      OccupancyGrid grid(GridFrame(Point(0, 0, 0), Point(2, 2, 4), {nx, ny, nz}));
      const GridFrame& frame = grid.frame();
      for (std::int64_t i = 0; i < frame.size(); ++i) {
        if (random() % 2 == 0) grid.set(frame.cell_at(i));
      }
      LevelRange ranges[] = {{0, nz - 1}, {nz / 3, nz / 2}, {nz - 1, nz - 1}, {0, 0}, {0, 0}};
      ranges[4].lowest = static_cast<int>(random() % nz);
      ranges[4].highest = ranges[4].lowest + static_cast<int>(random() % (nz - ranges[4].lowest));
      for (const LevelRange& levels : ranges) {
        for (std::int64_t i = 0; i < frame.size(); ++i) {
          const Cell cell = frame.cell_at(i);
          if (cell.z() < levels.lowest || cell.z() > levels.highest) continue;
          std::uint32_t expected = 0;
          for (int x = -1; x <= 1; ++x) {
            for (int y = -1; y <= 1; ++y) {
              for (int z = -1; z <= 1; ++z) {
                const Cell other = cell + Cell(x, y, z);
                const bool open = frame.contains(other) && other.z() >= levels.lowest &&
                                  other.z() <= levels.highest;
                if (!open || grid.blocked(other)) {
                  expected |= std::uint32_t{1} << neighbour_bit(x, y, z);
                }
              }
            }
          }
          ASSERT_EQ(blocked_surroundings(grid, cell, levels), expected)
              << "nz " << nz << ", cell " << cell.transpose() << ", levels " << levels.lowest
              << " to " << levels.highest;
          ++compared;
        }
      }
    }
  }
  EXPECT_GT(compared, 20000);
}

}  // namespace
}  // namespace ltp
