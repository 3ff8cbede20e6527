// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// An additive search that has been used answers with the least cost, whatever it was asked before.
#include "planning/additive/additive_search.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "budgets.hpp"
#include "scenes.hpp"
#include "slow_distances.hpp"

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The cost of the best path from start to goal as textbooks have it; infinite if there is none.
double slow_cost(const Problem& problem, const AdditiveCost& cost) {
  const GridFrame& frame = problem.frame();
  const Raster& priority = problem.scene.priority;
  const auto vertex = [&](const Cell& cell) {
    return test::slow_vertex(frame, problem.query, cell);
  };
  const auto step_cost = [&](const Cell& from, const Cell& to) {
    const Point a = from == problem.start ? problem.query.start : vertex(from);
    const Point b = to == problem.goal ? problem.query.goal : vertex(to);
    if (from == problem.start || to == problem.goal) {
      return cost((b - a).norm(), priority.integral(a, b));
    }
    const double sum = priority.at(a.x(), a.y()) + priority.at(b.x(), b.y());
    return cost((b - a).norm(), (b - a).norm() * 0.5 * sum);
  };
  std::vector<double> costs(static_cast<std::size_t>(frame.size()), kInfinity);
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  costs[static_cast<std::size_t>(frame.index(problem.start))] = 0.0;
  open.push({0.0, frame.index(problem.start)});
  while (!open.empty()) {
    const auto [here, index] = open.top();
    open.pop();
    if (here > costs[static_cast<std::size_t>(index)]) continue;
    const Cell cell = frame.cell_at(index);
    const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
    for (const Step& step : steps()) {
      if ((blocked & step.box) != 0) continue;
      const Cell next = cell + step.offset();
      const double total = here + step_cost(cell, next);
      double& other = costs[static_cast<std::size_t>(frame.index(next))];
      if (total >= other) continue;
      other = total;
      open.push({total, frame.index(next)});
    }
  }
  return costs[static_cast<std::size_t>(frame.index(problem.goal))];
}

TEST(AdditiveSearch, FindsTheLeastCostAlsoWhenItHasBeenUsed) {
  // The same goal is asked for again: from elsewhere, from a little beside it, over other levels,
  // after a search that was bounded by an ellipse.
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int found = 0;
  int bounded = 0;
  for (const std::array<int, 3>& dims :
       {std::array<int, 3>{9, 8, 12}, std::array<int, 3>{10, 9, 3}}) {
    const GridFrame frame({0, 0, 0}, {2, 2, 4}, dims);
    OccupancyGrid grid(frame);
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      grid.set(frame.cell_at(i), unit(random) < 0.2);
    }
    Raster::Values values(dims[0], dims[1]);
    for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
    const Raster priority(values, {0, 0}, 2.0);
    const Scene scene{grid, priority};
    AdditiveSearch search;
    Query query;
    Cell goal = Cell::Zero();
    for (int k = 0; k < 200; ++k) {
      const auto within = [&](const Cell& cell) -> Point {
        const Point share(unit(random), unit(random), unit(random));
        return frame.centre(cell) +
               (0.98 * share.array() - 0.49).matrix().cwiseProduct(frame.cell());
      };
      const auto free_cell = [&] {
        Cell cell = test::random_cell(random, frame);
        while (grid.blocked(cell)) cell = test::random_cell(random, frame);
        return cell;
      };
      if (k % 20 == 0) {
        goal = free_cell();
        query.goal = within(goal);
      }
      if (random() % 3 == 0) query.goal = within(goal);
      if (random() % 3 == 0) query.band = random() % 2 ? AltitudeBand{} : AltitudeBand{5.0, 9.0};
      query.start = within(free_cell());
      const AdditiveCost cost{k % 7 == 0 ? 1.5 : 1.1, 1.0};
      const Problem problem(scene, query, {});
      if (problem.start == problem.goal) continue;
      const bool is_bounded = random() % 3 == 0;
      SearchStats stats;
      const AdditiveResult result =
          search.run(problem, cost, *test::Limit(), stats,
                     is_bounded ? 1.2 * problem.direct_length : kInfinity);
      const double least = slow_cost(problem, cost);
      if (is_bounded) {  // it may have left out the best path
        ASSERT_TRUE(result.status != PlanStatus::Found || result.cost >= least - 1e-9);
        ++bounded;
        continue;
      }
      ASSERT_EQ(result.status, least < kInfinity ? PlanStatus::Found : PlanStatus::Unreachable);
      if (result.status != PlanStatus::Found) continue;
      ASSERT_NEAR(result.cost, least, 1e-9) << "query " << k;
      const PathTally sums = tally(path_through(problem, result.chain), priority);
      ASSERT_NEAR(cost(sums.length, sums.priority), least, 1e-9);
      ++found;
    }
  }
  EXPECT_GT(found, 200);
  EXPECT_GT(bounded, 80);
}

}  // namespace
}  // namespace ltp::planning
