// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The search over labels against all simple paths of small graphs, and what it proves when it must
// stop.
#include "planning/exact/label_search.hpp"

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
constexpr double kMemory = 1e8;

/// A graph with guides, its optimum, and its worst path as the one that is known.
struct Instance {
  SmallGraph made;
  ShiftedPenalty penalty;
  std::vector<Guide> guides;
  std::vector<double> length_to_goal;
  double optimum = kInfinity;
  Incumbent worst;

  Instance(const test::SmallGrid& small, double length_weight, double priority_weight,
           const std::vector<double>& betas)
      : made(small), penalty{length_weight / made.problem.direct_length, priority_weight} {
    for (const double beta : betas) {
      guides.push_back({beta, test::slow_costs_to_goal(made.graph, {beta, 1.0})});
    }
    length_to_goal = test::slow_costs_to_goal(made.graph, {1.0, 0.0});
    made.all_paths(
        [&](const std::vector<std::uint32_t>& nodes, const StepCost& sum, const PathTally&) {
          const double value = penalty(sum);
          optimum = std::min(optimum, value);
          if (value > worst.value || worst.chain.empty()) worst = {value, nodes};
        });
  }
  LabelTask task(double factor = 1.0, double memory = kMemory) const {
    return {made.graph, penalty, guides, length_to_goal, factor, memory};
  }
  void expect_path(const Incumbent& best) const {
    EXPECT_EQ(best.chain.front(), made.graph.start());
    EXPECT_EQ(best.chain.back(), made.graph.goal());
    EXPECT_EQ(std::set<std::uint32_t>(best.chain.begin(), best.chain.end()).size(),
              best.chain.size());
    EXPECT_NEAR(penalty(made.graph.along(best.chain)), best.value, 1e-12 * (1.0 + best.value));
  }
};

const std::vector<double> kBetas[] = {{0.5}, {0.0}, {0.1, 0.6}, {1.5, 0.3, 0.05}};

TEST(LabelSearch, FindsTheOptimumOfAllSimplePathsWhateverGuidesIt) {
  std::mt19937_64 random(1);
  LabelSearch search;
  int improved = 0;
  for (int k = 0; k < 120; ++k) {
    SCOPED_TRACE(k);
    // Where priority weighs most it would pay to go in circles.
    const double ratio = std::array<double, 3>{1.0, 4.0, 20.0}[k % 3];
    const Instance given(test::random_two_ends(random, k), 0.5, 0.5 * ratio, kBetas[k / 3 % 4]);
    if (given.worst.chain.empty()) continue;
    Incumbent best = given.worst;
    SearchStats stats;
    ASSERT_EQ(search.run(given.task(), *test::Limit(), stats, best), PlanStatus::Found);
    given.expect_path(best);
    ASSERT_NEAR(best.value, given.optimum, 1e-9 * (1.0 + given.optimum));
    ASSERT_LE(search.proved(), given.optimum);
    ASSERT_GE(search.proved(), given.optimum - 1e-9 * (1.0 + given.optimum));
    improved += best.value < given.worst.value - 1e-3;
  }
  EXPECT_GT(improved, 80);
}

TEST(LabelSearch, FindsItWithoutALengthTermToo) {
  std::mt19937_64 random(2);
  LabelSearch search;
  int found = 0;
  for (int k = 0; k < 40; ++k) {
    const Instance given(test::random_two_ends(random, k, 0.3), 0.0, 1.0, {0.0, 0.2});
    if (given.worst.chain.empty()) continue;
    Incumbent best = given.worst;
    SearchStats stats;
    ASSERT_EQ(search.run(given.task(), *test::Limit(), stats, best), PlanStatus::Found);
    ASSERT_NEAR(best.value, given.optimum, 1e-9) << k;
    ++found;
  }
  EXPECT_GT(found, 25);
}

TEST(LabelSearch, KeepsWithinItsFactorAndProvesIt) {
  std::mt19937_64 random(3);
  LabelSearch search;
  int content = 0;
  for (int k = 0; k < 40; ++k) {
    const Instance given(test::random_two_ends(random, k), 0.5, 1.0, {0.4});
    if (given.worst.chain.empty()) continue;
    for (const double factor : {1.05, 1.5}) {
      Incumbent best = given.worst;
      SearchStats stats;
      ASSERT_EQ(search.run(given.task(factor), *test::Limit(), stats, best), PlanStatus::Found);
      given.expect_path(best);
      ASSERT_LE(best.value, factor * given.optimum * (1.0 + 1e-9));
      ASSERT_LE(search.proved(), given.optimum);
      ASSERT_GE(search.proved() * factor, best.value * (1.0 - 1e-9));
      content += best.value > given.optimum + 1e-6;
    }
  }
  EXPECT_GT(content, 3);
}

TEST(LabelSearch, ProvesWhatItCanWhereItMustStop) {
  std::mt19937_64 random(4);
  LabelSearch search;
  int stopped = 0;
  int proved = 0;
  for (int k = 0; k < 60; ++k) {
    const Instance given(test::random_two_ends(random, k), 0.5, 5.0, {0.3});
    if (given.worst.chain.empty()) continue;
    for (int n = 0; n < 6; ++n) {
      Incumbent best = given.worst;
      SearchStats stats;
      const bool by_memory = n % 2 == 0;
      const PlanStatus status = search.run(given.task(1.0, by_memory ? 500.0 * (n + 1) : kMemory),
                                           *test::Limit(by_memory ? 0 : 1 + n * 3), stats, best);
      ASSERT_LE(best.value, given.worst.value);
      ASSERT_GE(best.value, given.optimum * (1.0 - 1e-9));
      ASSERT_LE(search.proved(), given.optimum);
      given.expect_path(best);
      if (status == PlanStatus::Found) continue;
      ASSERT_EQ(status, PlanStatus::OutOfBudget);
      ASSERT_TRUE(by_memory || stats.expanded == 1 + n * 3);
      ++stopped;
      proved += search.proved() > 0.0;
    }
  }
  EXPECT_GT(stopped, 40);
  EXPECT_GT(proved, 20);
}

}  // namespace
}  // namespace ltp::planning
