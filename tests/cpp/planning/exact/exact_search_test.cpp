// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// From any path to the best one: against all simple paths, and what holds where it must stop.
#include "planning/exact/exact_search.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

#include "budgets.hpp"
#include "small_graphs.hpp"

namespace ltp::planning {
namespace {

using test::SmallGrid;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
const ExactSearch::Limits kExact{0.0, 0.0, 1e8};

/// A grid, its optimum, and its worst and best simple paths as plans to begin with.
struct Instance {
  SmallGrid small;
  PenaltyWeights weights;
  Problem problem;
  double optimum = kInfinity;
  Plan worst;
  Plan best;

  Instance(const SmallGrid& made, const PenaltyWeights& w)
      : small(made), weights(w), problem(small.scene(), small.query, w) {
    const Penalty penalty(weights, problem.direct_length);
    double value = -kInfinity;
    std::vector<Cell> worst_chain;
    std::vector<Cell> best_chain;
    test::all_simple_paths(small, [&](const std::vector<Cell>& path, const PathTally& sums) {
      const double here = penalty(sums);
      if (here > value) worst_chain = path;
      if (here < optimum) best_chain = path;
      value = std::max(value, here);
      optimum = std::min(optimum, here);
    });
    if (best_chain.empty()) return;
    worst = accepted(problem, path_through(problem, worst_chain));
    best = accepted(problem, path_through(problem, best_chain));
  }
  bool has_path() const { return worst.status == PlanStatus::Found; }
  PlanStatus improve(ExactSearch& search, const ExactSearch::Limits& limits, BudgetWatch& budget,
                     Plan& plan) const {
    Answer answer(problem, budget);
    answer.offer(plan.path);
    const PlanStatus status = search.improve(problem, limits, answer);
    plan = answer.take();
    plan.stats = answer.stats;
    return status;
  }
};

Instance random_instance(std::mt19937_64& random, int number) {
  const double ratio = std::array<double, 4>{0.5, 1.0, 4.0, 20.0}[number / 2 % 4];
  return Instance(test::random_two_ends(random, number),
                  number % 20 == 19 ? PenaltyWeights{0.0, 1.0} : PenaltyWeights{0.5, 0.5 * ratio});
}

TEST(ExactSearch, LeadsFromTheWorstPathToTheBestOne) {
  std::mt19937_64 random(1);
  ExactSearch search;
  int improved = 0;
  for (int k = 0; k < 100; ++k) {
    SCOPED_TRACE(k);
    const Instance given = random_instance(random, k);
    if (!given.has_path()) continue;
    Plan plan = given.worst;
    ASSERT_EQ(given.improve(search, kExact, *test::Limit(), plan), PlanStatus::Found);
    ASSERT_EQ(plan.status, PlanStatus::Found);
    ASSERT_NEAR(plan.penalty, given.optimum, 1e-9);
    ASSERT_TRUE(search.proved().has_value());
    ASSERT_LE(*search.proved(), given.optimum + 1e-12);
    ASSERT_GE(*search.proved(), given.optimum - 1e-7);
    improved += plan.penalty < given.worst.penalty - 1e-3;
    // Nothing is left to improve.
    Plan again = plan;
    ASSERT_EQ(given.improve(search, kExact, *test::Limit(), again), PlanStatus::Found);
    ASSERT_EQ(again.path, plan.path);
  }
  EXPECT_GT(improved, 60);
}

TEST(ExactSearch, KeepsWithinItsLimits) {
  std::mt19937_64 random(2);
  ExactSearch search;
  int content = 0;
  for (int k = 0; k < 60; ++k) {
    const Instance given = random_instance(random, k);
    if (!given.has_path()) continue;
    const double shift = given.weights.priority * given.small.priority.maximum();
    for (const ExactSearch::Limits limits :
         {ExactSearch::Limits{0.1, 0.0, 1e8}, ExactSearch::Limits{0.0, 0.05, 1e8}}) {
      Plan plan = given.worst;
      ASSERT_EQ(given.improve(search, limits, *test::Limit(), plan), PlanStatus::Found);
      const double left =
          limits.eps > 0.0 ? limits.eps * (given.optimum + shift) : limits.tolerance;
      ASSERT_LE(plan.penalty, given.optimum + left + 1e-9) << k;
      ASSERT_LE(*search.proved(), given.optimum + 1e-12);
      ASSERT_TRUE(limits.eps > 0.0 || plan.penalty - *search.proved() <= limits.tolerance);
      content += plan.penalty > given.optimum + 1e-6;
    }
  }
  EXPECT_GT(content, 3);
}

TEST(ExactSearch, NeverWorsensAPlanAndProvesOnlyWhatIsSo) {
  std::mt19937_64 random(3);
  ExactSearch search;
  int stopped = 0;
  int better = 0;
  for (int k = 0; k < 60; ++k) {
    SCOPED_TRACE(k);
    const Instance given = random_instance(random, k);
    if (!given.has_path()) continue;
    for (const std::int64_t limit : {1, 10, 30, 60, 120, 250}) {
      Plan plan = given.worst;
      plan.stats.expanded = 0;
      const PlanStatus status = given.improve(search, kExact, *test::Limit(limit), plan);
      ASSERT_EQ(plan.status, PlanStatus::Found);
      ASSERT_LE(plan.penalty, given.worst.penalty);
      ASSERT_GE(plan.penalty, given.optimum - 1e-9);
      ASSERT_LE(plan.stats.expanded, limit);
      ASSERT_TRUE(!search.proved() || *search.proved() <= given.optimum + 1e-12);
      if (status == PlanStatus::Found) {
        ASSERT_NEAR(plan.penalty, given.optimum, 1e-9);
        continue;
      }
      ASSERT_EQ(status, PlanStatus::OutOfBudget);
      ++stopped;
      better += plan.penalty < given.worst.penalty;
    }
  }
  EXPECT_GT(stopped, 100);
  EXPECT_GT(better, 3);
}

TEST(ExactSearch, StopsWhereItsMemoryEnds) {
  std::mt19937_64 random(4);
  ExactSearch search;
  int stopped = 0;
  for (int k = 0; k < 30; ++k) {
    const Instance given = random_instance(random, k);
    if (!given.has_path()) continue;
    for (const double memory : {100.0, 3000.0, 6000.0}) {
      Plan plan = given.worst;
      const PlanStatus status = given.improve(search, {0.0, 0.0, memory}, *test::Limit(), plan);
      ASSERT_LE(plan.penalty, given.worst.penalty);
      ASSERT_TRUE(!search.proved() || *search.proved() <= given.optimum + 1e-12);
      if (status == PlanStatus::Found) continue;
      ASSERT_EQ(status, PlanStatus::OutOfBudget);
      ++stopped;
    }
  }
  EXPECT_GT(stopped, 20);
}

TEST(ExactSearch, ProvesNothingOverARasterThatIsNotTheGridsColumns) {
  // There a path's tally is not the sum of its steps as the search sees them.
  std::mt19937_64 random(5);
  ExactSearch search;
  int judged = 0;
  int above = 0;  // proofs that would have been wrong
  for (int k = 0; k < 60; ++k) {
    SmallGrid small = test::random_two_ends(random, k);
    small.priority = test::random_fine_raster(random);
    const Instance given(small, {0.5, 1.0});
    if (!given.has_path()) continue;
    Plan plan = given.worst;
    ASSERT_EQ(given.improve(search, kExact, *test::Limit(), plan), PlanStatus::Found);
    ASSERT_FALSE(search.proved().has_value());
    ASSERT_LE(plan.penalty, given.worst.penalty);
    above += plan.penalty > given.optimum + 1e-6;
    // What the search takes for better may be worse.
    plan = given.best;
    ASSERT_EQ(given.improve(search, kExact, *test::Limit(), plan), PlanStatus::Found);
    ASSERT_EQ(plan.penalty, given.best.penalty);
    ASSERT_EQ(plan.path, given.best.path);
    ++judged;
  }
  EXPECT_GT(judged, 30);
  EXPECT_GT(above, 0);
}

}  // namespace
}  // namespace ltp::planning
