// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The front of a graph against all its simple paths.
#include "planning/exact/front_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <tuple>
#include <vector>

#include "budgets.hpp"
#include "small_graphs.hpp"

namespace ltp::planning {
namespace {

using test::SmallGraph;

constexpr double kMemory = 1e8;

/// A graph and the sums of all its simple paths.
struct Instance {
  SmallGraph made;
  std::vector<double> length_to_goal;
  std::vector<double> loss_to_goal;
  std::vector<StepCost> sums;

  explicit Instance(const test::SmallGrid& small)
      : made(small),
        length_to_goal(test::slow_costs_to_goal(made.graph, {1.0, 0.0})),
        loss_to_goal(test::slow_costs_to_goal(made.graph, {0.0, 1.0})) {
    made.all_paths([&](const std::vector<std::uint32_t>&, const StepCost& sum, const PathTally&) {
      sums.push_back(sum);
    });
  }
  FrontSearch::Task task(double factor, double memory = kMemory) const {
    return {made.graph, length_to_goal, loss_to_goal, factor, memory};
  }
  /// By rising length and falling loss. Sums of rounded costs are exact, so equal is equal.
  std::vector<StepCost> slow_front() const {
    std::vector<StepCost> all = sums;
    std::sort(all.begin(), all.end(), [](const StepCost& a, const StepCost& b) {
      return std::tie(a.length, a.loss) < std::tie(b.length, b.loss);
    });
    std::vector<StepCost> front;
    for (const StepCost& sum : all) {
      if (front.empty() || sum.loss < front.back().loss) front.push_back(sum);
    }
    return front;
  }
  void expect_simple_paths(const std::vector<FrontSearch::Solution>& front) const {
    for (std::size_t i = 0; i < front.size(); ++i) {
      const std::vector<std::uint32_t>& chain = front[i].chain;
      ASSERT_EQ(chain.front(), made.graph.start());
      ASSERT_EQ(chain.back(), made.graph.goal());
      ASSERT_EQ(std::set<std::uint32_t>(chain.begin(), chain.end()).size(), chain.size());
      ASSERT_EQ(made.graph.along(chain).length, front[i].sum.length);
      ASSERT_EQ(made.graph.along(chain).loss, front[i].sum.loss);
      if (i == 0) continue;
      ASSERT_GT(front[i].sum.length, front[i - 1].sum.length);
      ASSERT_LT(front[i].sum.loss, front[i - 1].sum.loss);
    }
  }
};

TEST(FrontSearch, FindsThoseThatNoSimplePathDominates) {
  std::mt19937_64 random(1);
  FrontSearch search;
  std::vector<FrontSearch::Solution> front;
  std::size_t points = 0;
  int sealed = 0;
  for (int k = 0; k < 120; ++k) {
    const Instance given(test::random_two_ends(random, k, 0.35));
    SearchStats stats;
    const PlanStatus status = search.run(given.task(1.0), *test::Limit(), stats, front);
    const std::vector<StepCost> expected = given.slow_front();
    ASSERT_EQ(status, expected.empty() ? PlanStatus::Unreachable : PlanStatus::Found);
    ASSERT_EQ(front.size(), expected.size());
    given.expect_simple_paths(front);
    for (std::size_t i = 0; i < front.size(); ++i) {
      ASSERT_EQ(front[i].sum.length, expected[i].length) << k;
      ASSERT_EQ(front[i].sum.loss, expected[i].loss) << k;
    }
    points += front.size();
    sealed += expected.empty();
  }
  EXPECT_GT(points, 150u);
  EXPECT_GT(sealed, 5);
}

TEST(FrontSearch, CoversEverySimplePathWithinItsFactor) {
  std::mt19937_64 random(2);
  FrontSearch search;
  std::vector<FrontSearch::Solution> front;
  std::size_t points = 0;
  std::size_t exact = 0;
  for (int k = 0; k < 60; ++k) {
    const Instance given(test::random_two_ends(random, k, 0.35));
    for (const double factor : {1.1, 1.3, 2.0}) {
      SearchStats stats;
      const PlanStatus status = search.run(given.task(factor), *test::Limit(), stats, front);
      ASSERT_EQ(status, given.sums.empty() ? PlanStatus::Unreachable : PlanStatus::Found);
      given.expect_simple_paths(front);
      for (const StepCost& sum : given.slow_front()) {  // hence every path
        ASSERT_TRUE(std::any_of(front.begin(), front.end(), [&](const auto& solution) {
          return solution.sum.length <= factor * sum.length + 1e-9 &&
                 solution.sum.loss <= factor * sum.loss + 1e-9;
        })) << k;
        ++exact;
      }
      points += front.size();
    }
  }
  EXPECT_LT(points, exact * 9 / 10);
}

TEST(FrontSearch, ExpandsEachNodeOnceOverEvenGround) {
  // Of paths that lose nothing the shortest to a node dominates all others, also where nothing is
  // known of what lies ahead.
  std::mt19937_64 random(4);
  FrontSearch search;
  std::vector<FrontSearch::Solution> front;
  int found = 0;
  for (int k = 0; k < 60; ++k) {
    test::SmallGrid small = test::random_two_ends(random, k, 0.35);
    small.priority = Raster(Raster::Values::Zero(1, 1), {0, 0}, 2.0);
    const Instance given(small);
    const std::vector<double> nothing(given.made.graph.size(), 0.0);
    SearchStats stats;
    const PlanStatus status = search.run({given.made.graph, nothing, nothing, 1.0, kMemory},
                                         *test::Limit(), stats, front);
    ASSERT_LE(stats.expanded, given.made.graph.size());
    if (status != PlanStatus::Found) continue;
    ASSERT_EQ(front.size(), 1u);
    ASSERT_EQ(front[0].sum.loss, 0.0);
    ++found;
  }
  EXPECT_GT(found, 20);
}

TEST(FrontSearch, StopsWhereItsMemoryOrItsBudgetEnds) {
  std::mt19937_64 random(3);
  FrontSearch search;
  std::vector<FrontSearch::Solution> front;
  int stopped = 0;
  for (int k = 0; k < 80; ++k) {
    const Instance given(test::random_two_ends(random, k, 0.35));
    SearchStats whole;
    if (search.run(given.task(1.0), *test::Limit(), whole, front) != PlanStatus::Found) continue;
    if (whole.expanded < 5 || whole.pushed < 12) continue;
    for (const std::int64_t limit : {std::int64_t{2}, whole.expanded - 1}) {
      SearchStats stats;
      ASSERT_EQ(search.run(given.task(1.0), *test::Limit(limit), stats, front),
                PlanStatus::OutOfBudget);
      ASSERT_EQ(stats.expanded, limit);
    }
    SearchStats stats;
    ASSERT_EQ(search.run(given.task(1.0, 400.0), *test::Limit(), stats, front),
              PlanStatus::OutOfBudget);
    ASSERT_LE(stats.pushed, 10);  // sums and numbers of 40 bytes at least
    ++stopped;
  }
  EXPECT_GT(stopped, 5);
}

}  // namespace
}  // namespace ltp::planning
