// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The corridor holds every cell of every path that is cheap enough: against all simple paths.
#include "planning/exact/corridor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "budgets.hpp"
#include "small_graphs.hpp"

namespace ltp::planning {
namespace {

using test::SmallGraph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(Corridor, HoldsEveryCellOfEveryPathThatIsCheapEnough) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Corridor corridor;
  std::vector<Cell> found;
  int held = 0;
  std::size_t kept = 0;
  std::size_t free = 0;
  for (int k = 0; k < 150; ++k) {
    const SmallGraph made(test::random_two_ends(random, k));
    const GridFrame& frame = made.small.grid.frame();
    const CostFactors factors{k % 5 == 0 ? 0.0 : 2.0 * unit(random) * unit(random), 1.0};
    double least = kInfinity;
    std::vector<double> through(static_cast<std::size_t>(frame.size()), kInfinity);
    made.all_paths(
        [&](const std::vector<std::uint32_t>& nodes, const StepCost& sum, const PathTally&) {
          const double cost = factors(sum);
          least = std::min(least, cost);
          for (const std::uint32_t node : nodes) {
            double& mine = through[static_cast<std::size_t>(frame.index(made.graph.cell(node)))];
            mine = std::min(mine, cost);
          }
        });
    if (least == kInfinity) continue;
    const double most = (1.0 + 1e-9) * least + (k % 3 == 0 ? 0.0 : 3.0 * unit(random));
    SearchStats stats;
    ASSERT_TRUE(corridor.find(made.problem, made.costs, factors.length, most, *test::Limit(), stats,
                              found));
    std::set<std::int64_t> cells;
    for (const Cell& cell : found) {
      ASSERT_FALSE(made.small.grid.blocked(cell));
      ASSERT_TRUE(cells.insert(frame.index(cell)).second) << "twice";
    }
    ASSERT_EQ(stats.expanded, static_cast<std::int64_t>(found.size()));
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (through[static_cast<std::size_t>(i)] > most) continue;
      ASSERT_EQ(cells.count(i), 1u) << "cell " << i << " of grid " << k;
      ++held;
    }
    kept += found.size();
    free += made.free.size();
  }
  EXPECT_GT(held, 500);
  EXPECT_LT(kept, free * 3 / 4);
}

TEST(Corridor, ReachesTheStartOnlyIfAPathIsCheapEnough) {
  std::mt19937_64 random(2);
  Corridor corridor;
  std::vector<Cell> found;
  int judged = 0;
  for (int k = 0; k < 200; ++k) {
    const SmallGraph made(test::random_two_ends(random, k, 0.4));
    const double beta = 0.1 * (k % 7);
    const double least = test::slow_costs_to_goal(made.graph, {beta, 1.0})[made.graph.start()];
    const auto reaches = [&](double most) {
      SearchStats stats;
      EXPECT_TRUE(
          corridor.find(made.problem, made.costs, beta, most, *test::Limit(), stats, found));
      return std::find(found.begin(), found.end(), made.problem.start) != found.end();
    };
    ASSERT_EQ(reaches(kInfinity), least < kInfinity);
    if (least == kInfinity) continue;
    ASSERT_TRUE(reaches(least + 1e-9));
    ASSERT_FALSE(reaches(least - 1e-6));
    ++judged;
  }
  EXPECT_GT(judged, 80);
}

TEST(Corridor, WithoutALimitHoldsAllFromWhichTheGoalIsReached) {
  std::mt19937_64 random(3);
  Corridor corridor;
  std::vector<Cell> found;
  for (int k = 0; k < 100; ++k) {
    const SmallGraph made(test::random_two_ends(random, k, 0.4));
    SearchStats stats;
    ASSERT_TRUE(
        corridor.find(made.problem, made.costs, 1.0, kInfinity, *test::Limit(), stats, found));
    const std::vector<double> costs = test::slow_costs_to_goal(made.graph, {1.0, 1.0});
    const auto reached =
        std::count_if(costs.begin(), costs.end(), [](double cost) { return cost < kInfinity; });
    ASSERT_EQ(static_cast<std::ptrdiff_t>(found.size()), reached);
  }
}

TEST(Corridor, SaysWhenItsBudgetIsSpent) {
  std::mt19937_64 random(4);
  const SmallGraph made(test::random_two_ends(random, 1, 0.0));
  Corridor corridor;
  std::vector<Cell> found;
  SearchStats stats;
  EXPECT_FALSE(
      corridor.find(made.problem, made.costs, 1.0, kInfinity, *test::Limit(5), stats, found));
  EXPECT_EQ(stats.expanded, 5);
}

}  // namespace
}  // namespace ltp::planning
