// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// ARA*: each round within its weight of the least cost, the last one at it; the bounds are bounds.
#include "ltp/planning/planners/ara_star.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "budgets.hpp"
#include "ltp/planning/planners.hpp"
#include "planning/additive/additive_search.hpp"
#include "planning/additive/ara_search.hpp"
#include "scenes.hpp"
#include "small_grids.hpp"

namespace ltp {
namespace {

using namespace planning;  // NOLINT: the searches behind the planner

/// `AraSearch` round by round; what its chain really costs.
class Rounds {
 public:
  Rounds(const test::SmallGrid& small, const AdditiveCost& cost)
      : problem_(small.scene(), small.query, {}), cost_(cost) {
    search.begin(problem_, cost, stats);
  }
  PlanStatus improve(double weight) { return search.improve(weight, *test::Limit(), stats); }
  double chain_cost() const {
    const PathTally sums = tally(path_through(problem_, search.chain()), problem_.scene.priority);
    return cost_(sums.length, sums.priority);
  }

  AraSearch search;
  SearchStats stats;

 private:
  Problem problem_;
  AdditiveCost cost_;
};

TEST(AraStar, EachRoundKeepsItsPromise) {
  std::mt19937_64 random(1);
  const double weights[] = {5.0, 3.0, 2.0, 1.5, 1.2, 1.0};
  AdditiveSearch exact;
  int found = 0;
  int improved = 0;
  std::int64_t once = 0;
  std::int64_t later = 0;
  for (int i = 0; i < 120; ++i) {
    const bool planar = i % 2 == 0;
    const test::SmallGrid small = test::random_small_grid(
        random, planar ? std::array<int, 3>{30, 25, 1} : std::array<int, 3>{14, 12, 9}, 0.3);
    const AdditiveCost cost{i % 3 == 0 ? 1.05 : 1.4, 1.0};
    SearchStats stats;
    const AdditiveResult best =
        exact.run(Problem(small.scene(), small.query, {}), cost, *test::Limit(), stats);
    Rounds rounds(small, cost);
    const PlanStatus first = rounds.improve(weights[0]);
    ASSERT_EQ(first, best.status) << i;
    if (first != PlanStatus::Found || best.chain.size() < 2) continue;
    ++found;
    const double first_cost = rounds.search.cost();
    const std::int64_t first_expanded = rounds.stats.expanded;
    double last = first_cost;
    double least = 0.0;
    for (const double weight : weights) {
      ASSERT_EQ(rounds.improve(weight), PlanStatus::Found);
      const double now = rounds.search.cost();
      EXPECT_LE(rounds.chain_cost(), now + 1e-9) << i;
      EXPECT_LE(now, weight * best.cost + 1e-9) << i << " at " << weight;
      EXPECT_LE(now, last);
      EXPECT_LE(rounds.search.least(), best.cost + 1e-9) << i << " at " << weight;
      EXPECT_GE(rounds.search.least(), least);
      last = now;
      least = rounds.search.least();
    }
    EXPECT_NEAR(last, best.cost, 1e-9) << i;
    EXPECT_NEAR(least, best.cost, 1e-9) << i << ": at weight 1 it is proved";
    improved += first_cost > best.cost + 1e-9;
    // Six rounds from scratch would expand six times as much and more.
    Rounds alone(small, cost);
    alone.improve(1.0);
    once += alone.stats.expanded;
    later += rounds.stats.expanded - first_expanded;
  }
  EXPECT_GT(found, 80);
  EXPECT_GT(improved, 30);
  EXPECT_LT(later, 2 * once) << "rounds go on from what the last one left";
}

TEST(AraStar, TheBoundIsNeverAboveTheExactOptimum) {
  std::mt19937_64 random(2);
  const PenaltyWeights weights[] = {{1, 0}, {1, 1}, {0.5, 1}, {0.2, 1}, {0.05, 1}, {0, 1}};
  int found = 0;
  for (int i = 0; i < 400; ++i) {
    const test::SmallGrid small = test::random_small_grid(
        random, i % 3 == 0 ? std::array<int, 3>{2, 2, 2} : std::array<int, 3>{4, 4, 1});
    PlannerOptions options;
    options.weights = weights[i % 6];
    const Plan whole = make_planner("ara-star", options)->plan(small.scene(), small.query);
    double optimum = test::kInfinity;
    const double direct = (small.query.goal - small.query.start).norm();
    test::all_simple_paths(small, [&](const std::vector<Cell>&, const PathTally& sums) {
      optimum = std::min(optimum, Penalty(options.weights, direct)(sums));
    });
    ASSERT_EQ(whole.status == PlanStatus::Found, optimum < test::kInfinity) << i;
    if (whole.status != PlanStatus::Found) continue;
    ++found;
    for (std::int64_t limit = 0; limit < whole.stats.expanded; ++limit) {
      const Plan plan = make_planner("ara-star", options)
                            ->plan(small.scene(), small.query, {limit});  // 0: without one
      if (plan.status == PlanStatus::OutOfBudget) continue;
      ASSERT_TRUE(plan.bound.has_value());
      EXPECT_LE(*plan.bound, optimum + 1e-12) << i;
      EXPECT_GE(plan.penalty, optimum - 1e-9) << i;
    }
  }
  EXPECT_GT(found, 250);
}

TEST(AraStar, ABiggerBudgetIsNeverWorse) {
  std::mt19937_64 random(3);
  int better = 0;
  int tighter = 0;
  for (int i = 0; i < 10; ++i) {
    const test::SmallGrid small = test::random_small_grid(random, {12, 12, 9}, 0.4);
    PlannerOptions options;
    options.ara = {5.0, 0.5};
    const Plan whole = make_planner("ara-star", options)->plan(small.scene(), small.query);
    if (whole.status != PlanStatus::Found) continue;
    bool any = false;
    double penalty = test::kInfinity;
    double bound = -test::kInfinity;
    for (std::int64_t limit = 1; limit <= whole.stats.expanded + 1; ++limit) {
      const Plan plan =
          make_planner("ara-star", options)->plan(small.scene(), small.query, {limit});
      if (plan.status == PlanStatus::OutOfBudget) {
        EXPECT_FALSE(any) << "it once had a path";
        continue;
      }
      ASSERT_EQ(plan.status, PlanStatus::Found);
      EXPECT_LE(plan.penalty, penalty);
      EXPECT_GE(*plan.bound, bound - 1e-12);
      better += any && plan.penalty < penalty;
      tighter += any && *plan.bound > bound + 1e-12;
      any = true;
      penalty = plan.penalty;
      bound = *plan.bound;
    }
    EXPECT_EQ(penalty, whole.penalty);
    EXPECT_EQ(bound, *whole.bound);
  }
  EXPECT_GT(better, 0);
  EXPECT_GT(tighter, 10);
}

TEST(AraStar, WithoutAPriorityIsTheShortestPathAndProved) {
  std::mt19937_64 random(4);
  PlannerOptions options;
  options.weights = {1.0, 0.0};
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    const test::SmallGrid small = test::random_small_grid(random, {12, 12, 3}, 0.3);
    const Plan plan = make_planner("ara-star", options)->plan(small.scene(), small.query);
    const Plan exact = make_planner("additive", options)->plan(small.scene(), small.query);
    ASSERT_EQ(plan.status, exact.status);
    if (plan.status != PlanStatus::Found) continue;
    ++found;
    EXPECT_NEAR(plan.tally.length, exact.tally.length, 1e-9);
    EXPECT_NEAR(*plan.bound, plan.penalty, 1e-9);
  }
  EXPECT_GT(found, 25);
}

}  // namespace
}  // namespace ltp
