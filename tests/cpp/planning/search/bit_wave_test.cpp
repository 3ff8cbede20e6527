// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The wave by itself: what it reaches, counts and forgets. Its generations are held against a slow
// wave in ggwp_test.cpp.
#include "planning/search/bit_wave.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <random>
#include <vector>

#include "budgets.hpp"
#include "scenes.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

/// A wave's answer.
struct Answer {
  PlanStatus status;
  std::int64_t reached;
};

Answer run(BitWave& wave, const OccupancyGrid& grid, const LevelRange& levels, const Cell& from,
           const Cell& to, BudgetWatch& budget = *test::Limit()) {
  SearchStats stats;
  const PlanStatus status = wave.run(grid, levels, from, to, budget, stats);
  EXPECT_EQ(stats.pushed, stats.expanded);
  return {status, stats.expanded};
}

/// 20 % blocked.
OccupancyGrid clutter(std::mt19937_64& random, const std::array<int, 3>& dims) {
  OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, dims));
  for (std::int64_t i = 0; i < grid.frame().size(); ++i) {
    grid.set(grid.frame().cell_at(i), random() % 5 == 0);
  }
  return grid;
}

TEST(BitWave, ReachesWhatAFloodReachesUpToTheEdgesOfItsWords) {
  std::mt19937_64 random(1);
  BitWave wave;
  int found = 0;
  int sealed = 0;
  for (const int rows : {1, 2, 63, 64, 65, 127, 128, 129}) {
    for (const int depth : {1, 2, 63, 64, 65}) {
      for (const int along : {1, 3}) {
        const OccupancyGrid grid = clutter(random, {along, rows, depth});
        const GridFrame& frame = grid.frame();
        for (const LevelRange levels : {LevelRange{0, depth - 1}, LevelRange{depth / 2, depth / 2},
                                        LevelRange{depth / 2, depth - 1}}) {
          const auto any = [&] {
            Cell cell = test::random_cell(random, frame);
            cell.z() =
                levels.lowest + static_cast<int>(random() % (levels.highest - levels.lowest + 1));
            return cell;
          };
          const Cell from = any();
          const Cell to = any();
          if (grid.blocked(from) || grid.blocked(to)) continue;
          const std::vector<char> seen = test::reachable(grid, from, levels);
          const Answer answer = run(wave, grid, levels, from, to);
          const std::int64_t all = std::accumulate(seen.begin(), seen.end(), std::int64_t{0});
          if (seen[static_cast<std::size_t>(frame.index(to))]) {
            ASSERT_EQ(answer.status, PlanStatus::Found);
            ASSERT_LE(answer.reached, all);
            ++found;
          } else {
            ASSERT_EQ(answer.status, PlanStatus::Unreachable);
            ASSERT_EQ(answer.reached, all);
            ++sealed;
          }
        }
      }
    }
  }
  EXPECT_GT(found, 50);
  EXPECT_GT(sealed, 20);
}

TEST(BitWave, ForgetsTheRunBefore) {
  // Windows of one size and of others, the same place blocked here and free there.
  std::mt19937_64 random(2);
  BitWave used;
  int told = 0;
  for (int k = 0; k < 60; ++k) {
    const std::array<int, 3> dims[] = {{9, 70, 5}, {9, 70, 5}, {9, 70, 1}, {5, 9, 70}, {20, 6, 5}};
    OccupancyGrid grid = clutter(random, dims[random() % 5]);
    const GridFrame& frame = grid.frame();
    const Cell from = test::random_cell(random, frame);
    const Cell to = test::random_cell(random, frame);
    grid.set(from, false);
    grid.set(to, false);
    const LevelRange levels{std::min(from.z(), to.z()), std::max(from.z(), to.z())};
    BitWave fresh;
    const Answer expected = run(fresh, grid, levels, from, to);
    const Answer answer = run(used, grid, levels, from, to);
    ASSERT_EQ(answer.status, expected.status);
    ASSERT_EQ(answer.reached, expected.reached);
    ASSERT_EQ(used.generation(), fresh.generation());
    ASSERT_EQ(used.pace(), fresh.pace());
    if (answer.status != PlanStatus::Found) continue;
    const std::uint32_t blocked = blocked_surroundings(grid, to, levels);
    for (const Step& step : steps()) {
      if (blocked & step.box) continue;
      const Cell next = to + step.offset();
      ASSERT_EQ(used.earlier(next, used.generation()), fresh.earlier(next, fresh.generation()));
      ++told;
    }
  }
  EXPECT_GT(told, 100);
}

TEST(BitWave, ComesAsFarAlongEachAxisAsItsPaceAllows) {
  BitWave wave;
  for (const Point& edges : {Point(2, 2, 4), Point(1, 2, 3), Point(4, 3, 1), Point(5, 1, 2)}) {
    for (const int depth : {1, 12}) {
      const GridFrame frame({0, 0, 0}, edges, {12, 12, depth});
      const OccupancyGrid grid(frame);
      const double pace = depth == 1 ? edges.head<2>().minCoeff() : edges.minCoeff();
      for (int axis = 0; axis < (depth == 1 ? 2 : 3); ++axis) {
        for (int n = 0; n < 12; ++n) {
          Cell to = Cell::Zero();
          to[axis] = n;
          const Answer answer = run(wave, grid, {0, depth - 1}, Cell::Zero(), to);
          ASSERT_EQ(answer.status, PlanStatus::Found);
          ASSERT_EQ(wave.pace(), pace);
          ASSERT_EQ(wave.generation(), std::ceil(n * edges[axis] / pace - 1e-9));
          ASSERT_TRUE(n > 0 || answer.reached == 1);
        }
      }
    }
  }
}

TEST(BitWave, TellsOfNoEarlinessWhereItHasNotBeen) {
  const GridFrame frame({0, 0, 0}, {2, 2, 4}, {5, 5, 3});
  OccupancyGrid grid(frame);
  for (int y = 0; y < 5; ++y) {
    for (int z = 0; z < 3; ++z) grid.set(Cell(3, y, z));
  }
  BitWave wave;
  ASSERT_EQ(run(wave, grid, {0, 2}, Cell(0, 2, 1), Cell(2, 2, 1)).status, PlanStatus::Found);
  ASSERT_EQ(wave.generation(), 2);
  EXPECT_EQ(wave.earlier(Cell(1, 2, 1), 2), 1);
  EXPECT_EQ(wave.earlier(Cell(2, 2, 1), 2), 0);  // itself
  EXPECT_EQ(wave.earlier(Cell(3, 2, 1), 2), 0);  // blocked
  EXPECT_EQ(wave.earlier(Cell(2, 4, 1), 2), 0);  // not come to yet
}

TEST(BitWave, StopsWhenItsBudgetIsSpentAndSaysNoMore) {
  const OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {60, 60, 10}));
  BitWave wave;
  const Cell from(1, 1, 1);
  const Cell to(58, 58, 8);
  const Answer whole = run(wave, grid, {0, 9}, from, to);
  ASSERT_EQ(whole.status, PlanStatus::Found);
  for (const std::int64_t limit : {std::int64_t{1}, std::int64_t{5000}, whole.reached - 1}) {
    const Answer stopped = run(wave, grid, {0, 9}, from, to, *test::Limit(limit));
    EXPECT_EQ(stopped.status, PlanStatus::OutOfBudget);
    EXPECT_EQ(stopped.reached, limit);
  }
  EXPECT_EQ(run(wave, grid, {0, 9}, from, to, *test::Limit(whole.reached + 1)).status,
            PlanStatus::Found);
  const std::function<bool()> now = [] { return true; };
  const Answer interrupted = run(wave, grid, {0, 9}, from, to, *test::Limit(0, now));
  EXPECT_EQ(interrupted.status, PlanStatus::OutOfBudget);
  EXPECT_LT(interrupted.reached, whole.reached);
}

}  // namespace
}  // namespace ltp::planning
