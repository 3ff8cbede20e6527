// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The linearised searches against all simple paths of small grids: the cost is the least one, the
// bound a bound.
#include "ltp/planning/planners/linearised.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "budgets.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "planning/additive/additive_search.hpp"
#include "small_grids.hpp"

namespace ltp {
namespace {

using namespace planning;  // NOLINT: the searches behind the planner

using Instance = test::SmallGrid;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Exact {
  double penalty = kInfinity;  ///< Eq. (5)
  double cost = kInfinity;     ///< alpha L - P
};

Exact exact(const Instance& instance, const PenaltyWeights& weights, double alpha) {
  const Penalty penalty(weights, (instance.query.goal - instance.query.start).norm());
  Exact best;
  test::all_simple_paths(instance, [&](const std::vector<Cell>&, const PathTally& sums) {
    best.penalty = std::min(best.penalty, penalty(sums));
    best.cost = std::min(best.cost, alpha * sums.length - sums.priority);
  });
  return best;
}

constexpr std::array<int, 3> kPlanar{4, 4, 1};
constexpr std::array<int, 3> kSpace{2, 2, 2};

TEST(Linearised, TheAdditiveSearchFindsTheLeastCost) {
  std::mt19937_64 random(1);
  AdditiveSearch search;
  int found = 0;
  for (int i = 0; i < 300; ++i) {
    const Instance instance = test::random_small_grid(random, i % 2 ? kPlanar : kSpace);
    const double alpha = 1.001 + 0.01 * i;
    const Scene scene{instance.grid, instance.priority};
    const Problem problem(scene, instance.query, {});
    SearchStats stats;
    const AdditiveResult result = search.run(problem, {alpha, 1.0}, *test::Limit(), stats);
    const Exact best = exact(instance, {0.5, 1.0}, alpha);
    ASSERT_EQ(result.status == PlanStatus::Found, best.cost < kInfinity);
    EXPECT_LE(stats.expanded, instance.grid.frame().size());
    if (result.status != PlanStatus::Found || result.chain.size() == 1) continue;
    ++found;
    EXPECT_NEAR(result.cost, best.cost, 1e-9);
    const Path path = path_through(problem, result.chain);
    const PathTally sums = tally(path, instance.priority);
    EXPECT_NEAR(alpha * sums.length - sums.priority, best.cost, 1e-9);
  }
  EXPECT_GT(found, 150);
}

TEST(Linearised, TheBoundIsNeverAboveTheExactOptimum) {
  std::mt19937_64 random(2);
  const PenaltyWeights weights[] = {{1, 0}, {1, 1}, {0.5, 1}, {0.2, 1}, {0.05, 1}, {0, 1}};
  int found = 0;

  double additive_gap = 0.0;
  double sweep_gap = 0.0;
  for (int i = 0; i < 1000; ++i) {
    const Instance instance = test::random_small_grid(random, i % 3 ? kPlanar : kSpace);
    PlannerOptions options;
    options.weights = weights[i % 6];
    options.linearised.tolerance = 0.0;
    const double optimum = exact(instance, options.weights, 1.5).penalty;
    const Scene scene{instance.grid, instance.priority};
    const Plan additive = make_planner("additive", options)->plan(scene, instance.query);
    const Plan sweep = make_planner("sweep", options)->plan(scene, instance.query);
    ASSERT_EQ(additive.status == PlanStatus::Found, optimum < kInfinity);
    ASSERT_EQ(sweep.status, additive.status);
    if (sweep.status != PlanStatus::Found) continue;
    ++found;
    for (const Plan* plan : {&additive, &sweep}) {
      ASSERT_TRUE(plan->bound.has_value());
      EXPECT_LE(*plan->bound, optimum + 1e-12) << "instance " << i;
      EXPECT_GE(plan->penalty, optimum - 1e-9) << "instance " << i;
    }
    EXPECT_LE(sweep.penalty, additive.penalty);
    EXPECT_GE(*sweep.bound, *additive.bound - 1e-9);
    if (options.weights.length >= 0.5) {
      additive_gap += additive.penalty - optimum;
      sweep_gap += sweep.penalty - optimum;
    }
  }
  EXPECT_GT(found, 600);
  EXPECT_LT(sweep_gap, additive_gap);
}

TEST(Linearised, ASweepThatEndsContentIsWithinItsTolerance) {
  std::mt19937_64 random(4);
  int closed = 0;
  for (int i = 0; i < 1000; ++i) {
    const Instance instance = test::random_small_grid(random, {4, 4, 1}, 0.1);
    PlannerOptions options;
    options.weights = {0.5, 1.0};
    const Scene scene{instance.grid, instance.priority};
    options.linearised.closing = 0;
    const Plan open = make_planner("sweep", options)->plan(scene, instance.query);
    options.linearised.closing = 200000;
    const Plan sweep = make_planner("sweep", options)->plan(scene, instance.query);
    if (sweep.status != PlanStatus::Found) continue;
    // To the last bit: a certificate of 0.01 that is an ulp wider is none.
    EXPECT_LE(sweep.penalty - *sweep.bound, options.linearised.tolerance) << "instance " << i;
    closed += open.penalty - *open.bound > options.linearised.tolerance;
  }
  EXPECT_GT(closed, 50);
}

TEST(Linearised, ClaimsNoBoundOverARasterThatIsNotTheGridsColumns) {
  std::mt19937_64 random(5);
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    Instance instance = test::random_small_grid(random, i % 2 ? kPlanar : kSpace);
    const GridFrame& frame = instance.grid.frame();
    const Cell start = frame.cell_of(instance.query.start);
    if (start == frame.cell_of(instance.query.goal)) continue;  // one path, and it is known
    const Raster& columns = instance.priority;
    const double shift = i % 3 == 0 ? 1.0 : 0.0;
    const double cell = i % 3 == 1 ? 1.0 : i % 3 == 2 ? 4.0 : 2.0;
    instance.priority = Raster(columns.values(), {shift, 0.0}, cell);
    PlannerOptions options;
    options.weights = {0.5, 1.0};
    for (const char* name : {"additive", "sweep"}) {
      const Plan plan =
          make_planner(name, options)->plan({instance.grid, instance.priority}, instance.query);
      EXPECT_FALSE(plan.bound.has_value()) << name << ", grid " << i;
      found += plan.status == PlanStatus::Found;
    }
  }
  EXPECT_GT(found, 40);
}

}  // namespace
}  // namespace ltp
