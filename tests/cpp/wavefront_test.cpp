// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// GGWP against a slow wave that is told layer by layer, and within its bound.
#include "ltp/planning/wavefront.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "scenes.hpp"

namespace ltp {
namespace {

using test::Situation;

/// The cells of the descent: hops from the goal by flooding layers, the shortest offer from the
/// layer before, and from the start always the best offer; in the order of the steps.
std::vector<Cell> slow_descent(const Situation& situation) {
  const OccupancyGrid& grid = situation.grid;
  const GridFrame& frame = grid.frame();
  const LevelRange levels = test::slow_levels(frame, situation.query);
  const Cell start = frame.cell_of(situation.query.start);
  const Cell goal = frame.cell_of(situation.query.goal);
  const auto legal = [&](const Cell& cell, const Step& step) {
    return (blocked_surroundings(grid, cell, levels) & step.box) == 0;
  };
  const auto to = [](const Cell& cell, const Step& step) {
    return Cell(cell + Cell(step.dx, step.dy, step.dz));
  };
  const std::array<double, kSteps> lengths = step_lengths(frame.cell());
  std::vector<int> hops(frame.size(), -1);
  std::vector<double> value(frame.size(), test::kInfinity);
  hops[frame.index(goal)] = 0;
  value[frame.index(goal)] = 0.0;
  for (int layer = 1; hops[frame.index(start)] < 0; ++layer) {
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      const Cell cell = frame.cell_at(i);
      if (hops[i] >= 0 || cell.z() < levels.lowest || cell.z() > levels.highest ||
          grid.blocked(cell)) {
        continue;
      }
      for (int s = 0; s < kSteps; ++s) {
        if (!legal(cell, steps()[s])) continue;
        const std::int64_t other = frame.index(to(cell, steps()[s]));
        if (hops[other] != layer - 1) continue;
        hops[i] = layer;
        value[i] = std::min(value[i], value[other] + lengths[s]);
      }
    }
  }
  std::vector<Cell> chain = {start};
  while (chain.back() != goal) {
    double best = test::kInfinity;
    Cell next = chain.back();
    for (int s = 0; s < kSteps; ++s) {
      if (!legal(chain.back(), steps()[s])) continue;
      const Cell other = to(chain.back(), steps()[s]);
      if (hops[frame.index(other)] < 0) continue;
      const double offer = value[frame.index(other)] + lengths[s];
      if (offer < best) {
        best = offer;
        next = other;
      }
    }
    chain.push_back(next);
  }
  return chain;
}

TEST(Wavefront, DescendsTheSlowWave) {
  WavefrontPlanner planner({});
  int compared = 0;
  for (const Situation& situation : test::situations()) {
    if (test::slow_status(situation) != PlanStatus::Found) continue;
    const Plan plan = planner.plan(situation.scene(), situation.query);
    const std::vector<Cell> chain = slow_descent(situation);
    const GridFrame& frame = situation.grid.frame();
    ASSERT_EQ(plan.path.rows(), std::max<Eigen::Index>(static_cast<Eigen::Index>(chain.size()), 2))
        << situation.name;
    for (Eigen::Index i = 1; i + 1 < plan.path.rows(); ++i) {
      ASSERT_EQ(plan.path.row(i).transpose(), frame.centre(chain[i])) << situation.name;
    }
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

TEST(Wavefront, IsAtMostTheLongestOverTheShortestStepTooLong) {
  PlannerOptions shortest;
  shortest.weights = {1.0, 0.0};
  const std::unique_ptr<Planner> dijkstra = make_planner("lp-dijkstra", shortest);
  WavefrontPlanner planner({});
  int compared = 0;
  int longer = 0;
  std::vector<Situation> all = test::situations();
  std::mt19937_64 random(1);
  for (int k = 0; k < 200; ++k) {
    const GridFrame frame(Point(0, 0, 0), Point(2, 2, k % 2 == 0 ? 2 : 4), {12, 12, 6});
    Situation clutter{"more clutter", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (random() % 10 < 3) clutter.grid.set(frame.cell_at(i));
    }
    clutter.query.start = frame.centre(Cell(1, 2, 3));
    clutter.query.goal = frame.centre(Cell(10, 9, 2));
    clutter.grid.set(Cell(1, 2, 3), false);
    clutter.grid.set(Cell(10, 9, 2), false);
    all.push_back(clutter);
  }
  for (const Situation& situation : all) {
    if (!situation.centred) continue;
    const Plan plan = planner.plan(situation.scene(), situation.query);
    if (plan.status != PlanStatus::Found) continue;
    const Plan best = dijkstra->plan(situation.scene(), situation.query);
    const LevelRange levels = test::slow_levels(situation.grid.frame(), situation.query);
    const Point cell = situation.grid.frame().cell();
    const bool flat = levels.lowest == levels.highest;
    const double longest = flat ? cell.head<2>().norm() : cell.norm();
    const double least = flat ? cell.head<2>().minCoeff() : cell.minCoeff();
    EXPECT_GE(plan.tally.length, best.tally.length * (1 - 1e-12)) << situation.name;
    EXPECT_LE(plan.tally.length, longest / least * best.tally.length * (1 + 1e-12))
        << situation.name;
    longer += plan.tally.length > best.tally.length * (1 + 1e-9);
    ++compared;
  }
  EXPECT_GT(compared, 50);
  EXPECT_GT(longer, 0) << "it is greedy";
}

TEST(Wavefront, IsShortestInTheOpenPlane) {
  const GridFrame frame(Point(0, 0, 0), Point(2, 2, 4), {20, 15, 3});
  Situation field{"", OccupancyGrid(frame), test::random_priority(frame, 1), {}};
  field.query.band = test::kPlanar;
  WavefrontPlanner planner({});
  for (int x = 0; x < 20; x += 3) {
    for (int y = 0; y < 15; y += 2) {
      field.query.start = frame.centre(Cell(x, y, 1));
      field.query.goal = frame.centre(Cell(11, 6, 1));
      const int dx = std::abs(x - 11);
      const int dy = std::abs(y - 6);
      const double expected =
          2.0 * (std::max(dx, dy) - std::min(dx, dy)) + 2.0 * std::sqrt(2.0) * std::min(dx, dy);
      const Plan plan = planner.plan(field.scene(), field.query);
      EXPECT_NEAR(plan.tally.length, expected, 1e-9);
    }
  }
}

TEST(Wavefront, KnowsNothingOfPriority) {
  PlannerOptions heavy;
  heavy.weights = {0.1, 50.0};
  WavefrontPlanner plain({});
  WavefrontPlanner weighted(heavy);
  for (Situation& situation : test::built_situations()) {
    const Plan plan = plain.plan(situation.scene(), situation.query);
    EXPECT_EQ(plan.path, weighted.plan(situation.scene(), situation.query).path);
    const Raster none(Raster::Values::Zero(1, 1), {0, 0}, 1.0);
    EXPECT_EQ(plan.path, plain.plan({situation.grid, none}, situation.query).path);
  }
}

}  // namespace
}  // namespace ltp
