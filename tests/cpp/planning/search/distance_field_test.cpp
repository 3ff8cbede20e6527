// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The distance field in every cell against a textbook's Dijkstra.
#include "planning/search/distance_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>

#include "allocations.hpp"
#include "budgets.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
LevelRange all_levels(const GridFrame& frame) { return {0, frame.nz() - 1}; }

LevelRange random_levels(std::mt19937_64& random, const GridFrame& frame, const Cell& within) {
  if (random() % 2 == 0) return all_levels(frame);
  const int below = static_cast<int>(random() % (within.z() + 1));
  const int above = static_cast<int>(random() % (frame.nz() - within.z()));
  return {within.z() - below, within.z() + above};
}

TEST(DistanceField, IsTheTextbooksInEveryCell) {
  std::mt19937_64 random(2);
  DistanceField field;
  int reached = 0;
  for (int k = 0; k < 1500; ++k) {
    const OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const Cell source = test::random_cell(random, frame);  // it may be blocked
    const LevelRange levels = random_levels(random, frame, source);
    SearchStats stats;
    ASSERT_EQ(field.run(grid, source, levels, *test::Limit(), stats), PlanStatus::Found);
    const std::vector<double> expected = test::slow_distances(grid, source, levels);
    std::vector<double> all(expected.size());
    field.copy_to(all.data());
    int count = 0;
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      ASSERT_EQ(all[i], field(frame.cell_at(i)));
      if (expected[i] == kInfinity) {
        ASSERT_EQ(all[i], kInfinity) << k;
        continue;
      }
      ASSERT_NEAR(all[i], expected[i], 1e-9) << k;
      ++count;
    }
    if (frame.cell() != test::kNeedle) {  // each cell once
      EXPECT_EQ(stats.expanded, count);
    }
    EXPECT_GE(stats.pushed, stats.expanded);
    reached += count;
  }
  EXPECT_GT(reached, 200000);
}

TEST(DistanceField, StopsWhereItShallAndKnowsTheWay) {
  std::mt19937_64 random(3);
  DistanceField field;
  int found = 0;
  for (int k = 0; k < 500; ++k) {
    const OccupancyGrid grid = test::random_grid(random);
    const GridFrame& frame = grid.frame();
    const Cell source = test::random_cell(random, frame);
    const Cell target = test::random_cell(random, frame);
    const LevelRange levels = all_levels(frame);
    const double expected =
        test::slow_distances(grid, source, levels)[static_cast<std::size_t>(frame.index(target))];
    SearchStats stats;
    const PlanStatus status = field.run(grid, source, levels, *test::Limit(), stats, target);
    ASSERT_EQ(status == PlanStatus::Found, expected < kInfinity) << k;
    if (status != PlanStatus::Found) {
      ASSERT_EQ(status, PlanStatus::Unreachable);
      continue;
    }
    ++found;
    ASSERT_NEAR(field(target), expected, 1e-9);
    const std::vector<Cell> chain = field.chain_from(target);
    ASSERT_EQ(chain.front(), target);
    ASSERT_EQ(chain.back(), source);
    double length = 0.0;
    for (std::size_t i = 1; i < chain.size(); ++i) {
      ASSERT_EQ((chain[i] - chain[i - 1]).cwiseAbs().maxCoeff(), 1);
      ASSERT_TRUE(chain[i] == source || !grid.blocked(chain[i]));
      length += (frame.centre(chain[i]) - frame.centre(chain[i - 1])).norm();
    }
    ASSERT_NEAR(length, expected, 1e-9);
  }
  EXPECT_GT(found, 200);
}

TEST(DistanceField, HoldsTheLengthsOfAMaze) {
  const OccupancyGrid grid = test::serpentine(251);
  DistanceField field;
  SearchStats stats;
  ASSERT_EQ(field.run(grid, Cell(0, 0, 0), {0, 0}, *test::Limit(), stats), PlanStatus::Found);
  // 126 rows of 250 steps, and two steps from row to row.
  EXPECT_EQ(field(Cell(250, 0, 0)), 2.0 * (126 * 250 + 125 * 2));
}

TEST(DistanceField, GivesUpWhenItIsTold) {
  const OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {30, 30, 10}));
  DistanceField field;
  SearchStats stats;
  EXPECT_EQ(field.run(grid, Cell(1, 1, 1), {0, 9}, *test::Limit(100), stats),
            PlanStatus::OutOfBudget);
  EXPECT_EQ(stats.expanded, 100);
  const std::function<bool()> now = [] { return true; };
  EXPECT_EQ(field.run(grid, Cell(1, 1, 1), {0, 9}, *test::Limit(0, now), stats),
            PlanStatus::OutOfBudget);
}

TEST(DistanceField, NamesACellThatIsNotInside) {
  const OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {4, 4, 4}));
  DistanceField field;
  SearchStats stats;
  for (const Cell& outside : {Cell(-1, 0, 1), Cell(0, 4, 1), Cell(0, 0, 0), Cell(0, 0, 3)}) {
    EXPECT_THROW(field.run(grid, outside, {1, 2}, *test::Limit(), stats), std::invalid_argument);
    EXPECT_THROW(field.run(grid, Cell(0, 0, 1), {1, 2}, *test::Limit(), stats, outside),
                 std::invalid_argument);
  }
  for (const LevelRange& wrong : {LevelRange{-1, 2}, LevelRange{0, 4}, LevelRange{2, 1}}) {
    EXPECT_THROW(field.run(grid, Cell(0, 0, 1), wrong, *test::Limit(), stats),
                 std::invalid_argument);
  }
}

TEST(DistanceField, AllocatesNothingTheSecondTime) {
  std::mt19937_64 random(4);
  const OccupancyGrid grid = test::random_grid(random);
  DistanceField field;
  SearchStats stats;
  std::int64_t before = 0;
  for (int round = 0; round < 3; ++round) {
    before = test::allocations();
    field.run(grid, Cell(0, 0, 0), {0, 0}, *test::Limit(), stats);
  }
  EXPECT_EQ(test::allocations(), before);
}

}  // namespace
}  // namespace ltp::planning
