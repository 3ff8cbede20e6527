// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The band is in metres: paths keep to it, and what planners prove holds on the vertices that do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "ltp/planning/planners.hpp"
#include "small_grids.hpp"

namespace ltp {
namespace {

using test::kInfinity;
using test::SmallGrid;

constexpr double kBands[] = {0.0, 0.3, 1.7, 4.0, 5.5, kInfinity};

/// Ends within cells, one of them at times on a face; bands that end within levels.
SmallGrid instance(std::mt19937_64& random, int number) {
  SmallGrid small = test::random_small_grid(random, {3, 3, 3}, 0.3);
  small.query.band = {kBands[random() % 6], kBands[random() % 6]};
  if (number % 4 == 0) {
    Point& end = number % 8 == 0 ? small.query.start : small.query.goal;
    end.z() = 4.0 * std::floor(end.z() / 4.0);
  }
  return small;
}

TEST(Band, LimitsLevelsThatHoldMoreOfItThanAFace) {
  const GridFrame frame({0, 0, 0}, {2, 2, 4}, {3, 3, 10});
  const auto levels = [&](double start, double goal, double below, double above) {
    const LevelRange range = levels_of(frame, {{1, 1, start}, {3, 3, goal}, {below, above}});
    return std::make_pair(range.lowest, range.highest);
  };
  EXPECT_EQ(levels(10, 10, 0, 0), std::make_pair(2, 2));
  EXPECT_EQ(levels(10, 10, 2, 2), std::make_pair(2, 2)) << "both touch";
  EXPECT_EQ(levels(10, 10, 2.1, 2.1), std::make_pair(1, 3));
  EXPECT_EQ(levels(8, 8, 0, 0), std::make_pair(2, 2)) << "an end on a face is in the upper cell";
  EXPECT_EQ(levels(8, 8, 0, 4), std::make_pair(2, 2));
  EXPECT_EQ(levels(8, 12, 0, 0), std::make_pair(2, 3));
  EXPECT_EQ(levels(9.7, 9.7, 0, 2.3), std::make_pair(2, 2)) << "however the sum is rounded";
  EXPECT_EQ(levels(10.3, 10.3, 2.3, 0), std::make_pair(2, 2));
  EXPECT_EQ(levels(10, 10, kInfinity, kInfinity), std::make_pair(0, 9));
  EXPECT_EQ(levels(10, 10, 1e300, 1e300), std::make_pair(0, 9));
}

TEST(Band, IsKeptByEveryPlannerAndWhatTheyProveHoldsInIt) {
  std::mt19937_64 random(11);
  PlannerOptions options;
  options.weights = {0.5, 1.0};
  options.bezier = {5, 3.0, 3, 3.0, 12};
  options.hermite = {12, 3, 2.0, 2, 8};
  int found = 0;
  int within = 0;  // vertices that no centre is
  for (int i = 0; i < 150; ++i) {
    const SmallGrid small = instance(random, i);
    const Query& query = small.query;
    const double low = std::min(query.start.z(), query.goal.z()) - query.band.below;
    const double high = std::max(query.start.z(), query.goal.z()) + query.band.above;
    const double optimum = test::exact_optimum(small, options.weights);
    for (const PlannerInfo& info : planners()) {
      SCOPED_TRACE(std::string(info.name) + ", grid " + std::to_string(i));
      options.refine = i % 3 == 0;
      const Plan plan = make_planner(info.name, options)->plan(small.scene(), query);
      if (info.has(Trait::Complete)) {
        ASSERT_EQ(to_string(plan.status), optimum < kInfinity ? "found" : "unreachable");
      }
      if (plan.status != PlanStatus::Found) continue;
      ++found;
      EXPECT_GE(plan.path.col(2).minCoeff(), low - 1e-9);
      EXPECT_LE(plan.path.col(2).maxCoeff(), high + 1e-9);
      EXPECT_FALSE(test::meets_blocked(small.grid, plan.path, -1e-9)) << plan.path;
      if (plan.bound) {
        EXPECT_LE(*plan.bound, optimum + 1e-12);
      }
      if (options.refine || !info.has(Trait::OnGrid)) continue;
      EXPECT_GE(plan.penalty, optimum - 1e-9);
      if (info.name == "exact") {
        EXPECT_NEAR(plan.penalty, optimum, 1e-9);
      }
      for (Eigen::Index k = 1; k + 1 < plan.path.rows(); ++k) {
        const Point point = plan.path.row(k).transpose();
        const Cell cell = small.grid.frame().cell_of(point);
        EXPECT_EQ(point, test::slow_vertex(small.grid.frame(), query, cell));
        within += point != small.grid.frame().centre(cell);
      }
    }
  }
  EXPECT_GT(found, 800);
  EXPECT_GT(within, 200);
}

TEST(Band, TheShortestPathIsTheShortestOfAllEndsIncluded) {
  std::mt19937_64 random(12);
  PlannerOptions options;
  options.weights = {0.5, 0.0};
  int found = 0;
  for (int i = 0; i < 150; ++i) {
    SmallGrid small = instance(random, i);
    if (i % 3 == 0) small.query.band = {};
    const double direct = (small.query.goal - small.query.start).norm();
    if (direct == 0.0) continue;
    const double optimum = test::exact_optimum(small, options.weights);
    for (const char* name : {"lp-dijkstra", "lp-a-star", "additive", "sweep", "auto", "exact"}) {
      const Plan plan = make_planner(name, options)->plan(small.scene(), small.query);
      ASSERT_EQ(plan.status, optimum < kInfinity ? PlanStatus::Found : PlanStatus::Unreachable);
      if (plan.status != PlanStatus::Found) continue;
      EXPECT_NEAR(plan.penalty, optimum, 1e-12) << name << ", grid " << i;
      ++found;
    }
  }
  EXPECT_GT(found, 300);
}

}  // namespace
}  // namespace ltp
