// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The linearised searches against all simple paths of small grids: the cost is the least one, the
// bound a bound.
#include "ltp/planning/planners/linearised.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "budgets.hpp"
#include "ltp/grid/columns.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "ltp/planning/planners/exact.hpp"
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

TEST(Linearised, EndsSoonWhereItLooksAtSomeOfTheGroundOnly) {
  // Steps over ground that was narrowed away wrongly would cost less than nothing, without end.
  std::mt19937_64 random(6);
  int found = 0;
  for (int i = 0; i < 600; ++i) {
    const Instance instance = test::random_small_grid(random, {9, 9, 1 + i % 2}, 0.1);
    PlannerOptions options;
    options.weights = {0.5, i % 3 == 0 ? 0.5 : i % 3 == 1 ? 1.5 : 5.0};
    options.linearised.tolerance = 0.0;
    options.linearised.closing = 0;
    const std::int64_t most = 4 * options.linearised.searches * instance.grid.frame().size();
    const Scene scene{instance.grid, instance.priority};
    const Plan plan = make_planner("sweep", options)->plan(scene, instance.query, {most});
    EXPECT_LT(plan.stats.expanded, most) << "instance " << i;
    found += plan.status == PlanStatus::Found;
  }
  EXPECT_GT(found, 400);
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

TEST(Linearised, BoundsWhatItReportsOverARasterThatIsNotTheGridsColumns) {
  std::mt19937_64 random(5);
  int found = 0;
  for (int i = 0; i < 40; ++i) {
    Instance instance = test::random_small_grid(random, i % 2 ? kPlanar : kSpace);
    const Raster& columns = instance.priority;
    const double shift = i % 3 == 0 ? 1.0 : 0.0;
    const double cell = i % 3 == 1 ? 1.0 : i % 3 == 2 ? 4.0 : 2.0;
    const Raster given(columns.values(), {shift, 0.0}, cell);
    const bool alike = given.minimum() == given.maximum();
    instance.priority = onto_columns(given, instance.grid.frame());
    PlannerOptions options;
    options.weights = {0.5, 1.0};
    const double optimum = test::exact_optimum(instance, options.weights);
    for (const char* name : {"additive", "sweep", "auto", "ara-star", "exact"}) {
      SCOPED_TRACE(std::string(name) + ", grid " + std::to_string(i));
      const Plan plan = make_planner(name, options)->plan({instance.grid, given}, instance.query);
      EXPECT_EQ(plan.priority_resampled, i % 3 != 2 && !alike) << "blocks of columns are as good";
      if (plan.status != PlanStatus::Found) continue;
      ++found;
      ASSERT_TRUE(plan.bound.has_value());
      EXPECT_LE(*plan.bound, optimum + 1e-12);
      EXPECT_GE(plan.penalty, optimum - 1e-9);
      if (name == std::string("exact")) {
        EXPECT_NEAR(plan.penalty, optimum, 1e-9);
      }
    }
  }
  EXPECT_GT(found, 100);
}

TEST(Linearised, ClaimsNoBoundWhereNoSquaresFillAColumn) {
  const GridFrame frame({0, 0, 0}, {1.0, 1.37, 2.0}, {6, 6, 2});
  const OccupancyGrid grid(frame);
  const Raster priority(Raster::Values::Random(9, 9).abs(), {0, 0}, 1.0);
  const Query query{frame.centre(Cell(0, 0, 0)), frame.centre(Cell(5, 3, 0)), {}};
  for (const char* name : {"additive", "sweep", "auto", "ara-star"}) {
    const Plan plan = make_planner(name)->plan({grid, priority}, query);
    EXPECT_EQ(plan.status, PlanStatus::Found);
    EXPECT_FALSE(plan.bound.has_value()) << name;
    EXPECT_FALSE(plan.priority_resampled);
  }
  EXPECT_THROW(make_planner("exact")->plan({grid, priority}, query), std::invalid_argument);
  EXPECT_THROW(pareto_front({grid, priority}, query), std::invalid_argument);
  PlannerOptions shortest;
  shortest.weights = {1.0, 0.0};
  EXPECT_TRUE(make_planner("exact", shortest)->plan({grid, priority}, query).bound.has_value());
}

}  // namespace
}  // namespace ltp
