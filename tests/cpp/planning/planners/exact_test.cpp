// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The exact search against all simple paths of small grids, and what it promises about memory, eps
// and the front.
#include "ltp/planning/planners/exact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>
#include <tuple>

#include "ltp/planning/planners.hpp"
#include "ltp/planning/planners/linearised.hpp"
#include "small_grids.hpp"

namespace ltp {
namespace {

using test::SmallGrid;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::array<int, 3> kPlane{5, 5, 1};
constexpr std::array<int, 3> kSpace{3, 3, 3};
constexpr double kRatios[] = {0.0, 1.0, 2.0, 5.0, 20.0};  // W_P / W_L

SmallGrid instance(std::mt19937_64& random, int number) {
  return test::random_small_grid(random, number % 2 ? kPlane : kSpace, number % 2 ? 0.3 : 0.4,
                                 number % 4 > 1);
}

PlannerOptions options_of(double ratio) {
  PlannerOptions options;
  options.weights = {0.5, 0.5 * ratio};
  return options;
}

bool is_simple(const Plan& plan, const GridFrame& frame) {
  std::set<std::int64_t> cells;
  for (Eigen::Index i = 0; i < plan.path.rows(); ++i) {
    cells.insert(frame.index(frame.cell_of(plan.path.row(i).transpose())));
  }
  const bool within_one = plan.path.rows() == 2 && cells.size() == 1;
  return within_one || static_cast<Eigen::Index>(cells.size()) == plan.path.rows();
}

TEST(Exact, IsTheOptimumOverAllSimplePathsOf500Grids) {
  std::mt19937_64 random(1);
  int found = 0;
  int better_than_sweep = 0;
  for (int i = 0; i < 500; ++i) {
    const SmallGrid small = instance(random, i);
    for (const double ratio : kRatios) {
      SCOPED_TRACE("grid " + std::to_string(i) + ", ratio " + std::to_string(ratio));
      const PlannerOptions options = options_of(ratio);
      const double optimum = test::exact_optimum(small, options.weights);
      const Plan plan = make_planner("exact", options)->plan(small.scene(), small.query);
      ASSERT_EQ(plan.status, optimum < kInfinity ? PlanStatus::Found : PlanStatus::Unreachable);
      if (plan.status != PlanStatus::Found) continue;
      ++found;
      EXPECT_NEAR(plan.penalty, optimum, 1e-9);
      EXPECT_TRUE(is_simple(plan, small.grid.frame()));
      ASSERT_TRUE(plan.bound.has_value());
      EXPECT_LE(*plan.bound, optimum + 1e-12);
      EXPECT_GE(*plan.bound, optimum - 1e-8 * (1 + std::abs(optimum)));
      PlannerOptions supported = options;
      supported.linearised.closing = 0;
      const Plan sweep = make_planner("sweep", supported)->plan(small.scene(), small.query);
      better_than_sweep += plan.penalty < sweep.penalty - 1e-6;
    }
  }
  EXPECT_GT(found, 1500);
  EXPECT_GT(better_than_sweep, 100);  // optima inside the hull, and those that wind
}

TEST(Exact, IsTheOptimumWithoutALengthTermToo) {
  std::mt19937_64 random(2);
  int found = 0;
  for (int i = 0; i < 100; ++i) {
    const SmallGrid small = test::random_small_grid(
        random, i % 2 ? std::array<int, 3>{4, 4, 1} : std::array<int, 3>{2, 2, 3}, 0.25);
    PlannerOptions options;
    options.weights = {0.0, 1.0};
    const Plan plan = make_planner("exact", options)->plan(small.scene(), small.query);
    double optimum = kInfinity;
    test::all_simple_paths(small, [&](const std::vector<Cell>&, const PathTally& sums) {
      optimum = std::min(optimum, -sums.mean_priority());
    });
    if (plan.status != PlanStatus::Found) {
      EXPECT_EQ(optimum, kInfinity);
      continue;
    }
    ++found;
    EXPECT_NEAR(plan.penalty, optimum, 1e-9) << i;
  }
  EXPECT_GT(found, 60);
}

TEST(Exact, KeepsWithinItsFactor) {
  std::mt19937_64 random(3);
  int cheaper = 0;
  for (int i = 0; i < 200; ++i) {
    const SmallGrid small = instance(random, i);
    PlannerOptions options = options_of(kRatios[i % 5]);
    const Plan exact = make_planner("exact", options)->plan(small.scene(), small.query);
    options.exact.eps = 0.1;
    const Plan near = make_planner("exact", options)->plan(small.scene(), small.query);
    ASSERT_EQ(near.status, exact.status);
    if (exact.status != PlanStatus::Found) continue;
    const double shift = options.weights.priority * small.priority.maximum();
    EXPECT_LE(near.penalty + shift, 1.1 * (exact.penalty + shift) + 1e-9);
    EXPECT_GE(near.penalty, exact.penalty - 1e-9);
    EXPECT_LE(*near.bound, exact.penalty + 1e-12);
    cheaper += near.stats.expanded < exact.stats.expanded;
  }
  EXPECT_GT(cheaper, 10);
}

/// A window of 40 x 40 cells with houses.
SmallGrid town(int seed, bool smooth) {
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  SmallGrid made = test::random_small_grid(random, {40, 40, 3}, 0.0, true);
  std::uniform_int_distribution<int> any(0, 39);
  Raster::Values values = Raster::Values::Constant(40, 40, 0.2);
  for (int i = 0; i < 12; ++i) {
    const int x = any(random);
    const int y = any(random);
    for (int dx = 0; dx < 5; ++dx) {
      for (int dy = 0; dy < 5; ++dy) {
        if (x + dx > 39 || y + dy > 39) continue;
        values(x + dx, y + dy) = i % 2 ? 1.0 : 0.0;
        if (i % 3 == 0) made.grid.set(Cell(x + dx, y + dy, any(random) % 3));
      }
    }
  }
  if (smooth) {
    for (int i = 1; i < 39; ++i) {
      for (int j = 1; j < 39; ++j) values(i, j) = values.block<3, 3>(i - 1, j - 1).mean();
    }
  }
  made.priority = Raster(values, {0, 0}, 2.0);
  made.grid.set(made.grid.frame().cell_of(made.query.start), false);
  made.grid.set(made.grid.frame().cell_of(made.query.goal), false);
  return made;
}

TEST(Exact, LiesBetweenTheSweepsBoundAndItsPath) {
  int judged = 0;
  for (int i = 0; i < 40; ++i) {
    const SmallGrid small = town(i, i % 2 == 0);
    for (const double ratio : {0.5, 1.0, 2.0}) {
      PlannerOptions options = options_of(ratio);
      options.exact.memory = 64.0;
      const Plan sweep = make_planner("sweep", options)->plan(small.scene(), small.query);
      const Plan exact = make_planner("exact", options)->plan(small.scene(), small.query);
      if (exact.status != PlanStatus::Found) {
        EXPECT_NE(exact.status, PlanStatus::OutOfBudget) << i;
        continue;
      }
      ++judged;
      EXPECT_LE(exact.penalty, sweep.penalty + 1e-9);
      EXPECT_GE(exact.penalty, *sweep.bound - 1e-9);
    }
  }
  EXPECT_GT(judged, 90);
}

TEST(Exact, GivesUpWhereItsMemoryEnds) {
  // Over even ground nothing is known better than anything else: where circling pays, all of it is.
  SmallGrid small = town(1, false);
  small.priority = Raster(Raster::Values::Random(40, 40).abs(), {0, 0}, 2.0);
  PlannerOptions options;
  options.weights = {0.01, 1.0};
  options.exact.memory = 4.0;
  const Plan plan = make_planner("exact", options)->plan(small.scene(), small.query);
  EXPECT_EQ(to_string(plan.status), "out_of_budget");
  EXPECT_EQ(plan.path.rows(), 0);
  EXPECT_EQ(plan.penalty, kInfinity);
  EXPECT_FALSE(plan.bound.has_value());
  options.exact.memory = 1e-3;
  const Front front = pareto_front(small.scene(), small.query, options.exact);
  EXPECT_EQ(to_string(front.status), "out_of_budget");
  EXPECT_TRUE(front.paths.empty());
}

struct Corner {
  double length;
  double loss;
};

/// The least loss for each length, of all simple paths.
std::vector<Corner> slow_front(const SmallGrid& small) {
  std::vector<Corner> all;
  test::all_simple_paths(small, [&](const std::vector<Cell>&, const PathTally& sums) {
    all.push_back({sums.length, small.priority.maximum() * sums.length - sums.priority});
  });
  std::sort(all.begin(), all.end(), [](const Corner& a, const Corner& b) {
    return std::tie(a.length, a.loss) < std::tie(b.length, b.loss);
  });
  std::vector<Corner> front;
  for (const Corner& corner : all) {
    if (front.empty() || corner.loss < front.back().loss - 1e-9) front.push_back(corner);
  }
  return front;
}

TEST(ParetoFront, IsThatOfAllSimplePaths) {
  std::mt19937_64 random(4);
  int found = 0;
  std::size_t points = 0;
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const SmallGrid small = test::random_small_grid(
        random, i % 2 ? std::array<int, 3>{4, 4, 1} : std::array<int, 3>{2, 3, 2}, 0.25, i % 4 > 1);
    const std::vector<Corner> expected = slow_front(small);
    const Front front = pareto_front(small.scene(), small.query);
    ASSERT_EQ(front.status, expected.empty() ? PlanStatus::Unreachable : PlanStatus::Found);
    ASSERT_EQ(front.paths.size(), expected.size());
    ASSERT_EQ(front.tallies.size(), expected.size());
    const double most = small.priority.maximum();
    for (std::size_t k = 0; k < expected.size(); ++k) {
      const PathTally& sums = front.tallies[k];
      EXPECT_NEAR(sums.length, expected[k].length, 1e-6);
      EXPECT_NEAR(most * sums.length - sums.priority, expected[k].loss, 1e-6);
      const PathTally again = tally(front.paths[k], small.priority);
      EXPECT_EQ(sums.length, again.length);
      EXPECT_EQ(sums.priority, again.priority);
    }
    found += !expected.empty();
    points += expected.size();

    for (const double eps : {0.02, 0.3}) {
      const Front coarse = pareto_front(small.scene(), small.query, {512.0, eps});
      ASSERT_EQ(coarse.status, front.status);
      EXPECT_LE(coarse.paths.size(), front.paths.size());
      for (const Corner& corner : expected) {
        EXPECT_TRUE(
            std::any_of(coarse.tallies.begin(), coarse.tallies.end(), [&](const PathTally& sums) {
              return sums.length <= (1 + eps) * corner.length + 1e-9 &&
                     most * sums.length - sums.priority <= (1 + eps) * corner.loss + 1e-9;
            }));
      }
    }
  }
  EXPECT_GT(found, 120);
  EXPECT_GT(points, 250u);
}

TEST(ParetoFront, HoldsTheOptimumWhereCirclingDoesNotPay) {
  int judged = 0;
  std::size_t exact_points = 0;
  std::size_t coarse_points = 0;
  for (int i = 0; i < 30; ++i) {
    const SmallGrid small = town(i, i % 2 == 0);
    const PlannerOptions options = options_of(1.0);
    const auto planner = make_planner("exact", options);
    const Plan plan = planner->plan(small.scene(), small.query);
    const Front front = pareto_front(small.scene(), small.query);
    ASSERT_EQ(front.status, plan.status);
    if (plan.status != PlanStatus::Found) continue;
    exact_points += front.paths.size();
    coarse_points += pareto_front(small.scene(), small.query, {512.0, 0.05}).paths.size();
    const double direct = (small.query.goal - small.query.start).norm();
    const double mean = plan.tally.mean_priority();
    if (plan.tally.length / direct < small.priority.maximum() - mean) continue;
    ++judged;
    double least = kInfinity;
    for (const PathTally& sums : front.tallies) {
      least = std::min(least, Penalty(options.weights, direct)(sums));
    }
    EXPECT_NEAR(least, plan.penalty, 1e-9);
  }
  EXPECT_GT(judged, 20);
  EXPECT_LT(coarse_points, exact_points / 2);
}

TEST(ParetoFront, AnswersLikeAPlan) {
  SmallGrid small = town(3, false);
  EXPECT_THROW(pareto_front(small.scene(), small.query, {512.0, -0.1}), std::invalid_argument);
  EXPECT_THROW(pareto_front(small.scene(), small.query, {512.0, kInfinity}), std::invalid_argument);
  Query far = small.query;
  far.goal.x() = 1e6;
  EXPECT_EQ(to_string(pareto_front(small.scene(), far).status), "outside_map");
  far.goal.x() = kInfinity;
  EXPECT_THROW(pareto_front(small.scene(), far), std::invalid_argument);
  const auto limited = [&](const Budget& budget) {
    return pareto_front(small.scene(), small.query, {}, budget);
  };
  EXPECT_EQ(to_string(limited({50}).status), "out_of_budget");
  EXPECT_THROW(limited({-1}), std::invalid_argument);
  const Front front = limited({0, 0.0, [] { return true; }});
  EXPECT_TRUE(front.status == PlanStatus::OutOfBudget || front.stats.expanded < 8192);
}

}  // namespace
}  // namespace ltp
