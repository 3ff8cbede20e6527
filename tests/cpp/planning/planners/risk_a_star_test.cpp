// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// riskA* against the least risk by repeated relaxation of all edges.
#include "ltp/planning/planners/risk_a_star.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "ltp/planning/planners.hpp"
#include "scenes.hpp"
#include "small_grids.hpp"

namespace ltp {
namespace {

/// The least integral of (no_risk - p + factor) dl over the graph of cell centres: Bellman-Ford.
double least_risk(const test::SmallGrid& small, double factor) {
  const GridFrame& frame = small.grid.frame();
  const Cell start = frame.cell_of(small.query.start);
  const Cell goal = frame.cell_of(small.query.goal);
  const auto place = [&](const Cell& cell) -> Point {
    if (cell == start) return small.query.start;
    return cell == goal ? small.query.goal : frame.centre(cell);
  };
  std::vector<double> risk(frame.size(), test::kInfinity);
  risk[frame.index(start)] = 0.0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (risk[i] == test::kInfinity) continue;
      const Cell cell = frame.cell_at(i);
      const std::uint32_t blocked = blocked_surroundings(small.grid, cell, {0, frame.nz() - 1});
      for (const Step& step : steps()) {
        if (blocked & step.box) continue;
        const Cell next = cell + step.offset();
        const Point a = place(cell);
        const Point b = place(next);
        const double edge = (1.0 + factor) * (b - a).norm() - small.priority.integral(a, b);
        double& other = risk[frame.index(next)];
        changed |= risk[i] + edge < other - 1e-12;
        other = std::min(other, risk[i] + edge);
      }
    }
  }
  return risk[frame.index(goal)];
}

TEST(RiskAStar, FindsThePathOfLeastRisk) {
  std::mt19937_64 random(1);
  int found = 0;
  int none = 0;
  for (int i = 0; i < 200; ++i) {
    const test::SmallGrid small = test::random_small_grid(
        random, i % 2 == 0 ? std::array<int, 3>{9, 8, 1} : std::array<int, 3>{5, 6, 3}, 0.3);
    PlannerOptions options;
    options.risk.length_factor = i % 3 == 0 ? 0.01 : 0.5;
    options.weights = {0.5, i % 5 == 0 ? 0.0 : 1.0};  // of no matter
    const Plan plan = make_planner("risk-a-star", options)->plan(small.scene(), small.query);
    const double least = least_risk(small, options.risk.length_factor);
    ASSERT_EQ(plan.status == PlanStatus::Found, least < test::kInfinity) << i;
    none += plan.status != PlanStatus::Found;
    if (plan.status != PlanStatus::Found || plan.path.rows() == 2) continue;
    ++found;
    const double risk =
        (1.0 + options.risk.length_factor) * plan.tally.length - plan.tally.priority;
    EXPECT_NEAR(risk, least, 1e-9) << i;
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 10);
}

TEST(RiskAStar, GoesFartherForSafetyTheLessAMetreCosts) {
  // Safe ground lies 10 m beside the straight way, risky ground under it.
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {40, 20, 1});
  Raster::Values values = Raster::Values::Zero(40, 20);
  values.col(15) = 1.0;
  const Raster priority(values, Eigen::Vector2d(0, 0), 2.0);
  const OccupancyGrid grid(frame);
  Query query;
  query.start = frame.centre(Cell(2, 10, 0));
  query.goal = frame.centre(Cell(37, 10, 0));
  double last = test::kInfinity;
  for (const double factor : {0.01, 0.1, 1.0, 20.0}) {
    PlannerOptions options;
    options.risk.length_factor = factor;
    const Plan plan = make_planner("risk-a-star", options)->plan({grid, priority}, query);
    ASSERT_EQ(plan.status, PlanStatus::Found);
    EXPECT_LE(plan.tally.length, last);
    last = plan.tally.length;
    EXPECT_EQ(plan.tally.mean_priority() > 0.5, factor < 5.0) << factor;
  }
  EXPECT_DOUBLE_EQ(last, 70.0);
}

TEST(RiskAStar, TakesPrioritiesOverOne) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 50; ++i) {
    test::SmallGrid small = test::random_small_grid(random, {8, 8, 1}, 0.2);
    const double scale = 1.0 + i;
    const Raster steep(small.priority.values() * scale, {0, 0}, 2.0);
    PlannerOptions options;
    options.risk.length_factor = 0.1;
    const Plan plan = make_planner("risk-a-star", options)->plan({small.grid, steep}, small.query);
    EXPECT_EQ(
        to_string(plan.status),
        to_string(make_planner("risk-a-star", options)->plan(small.scene(), small.query).status));
  }
}

}  // namespace
}  // namespace ltp
