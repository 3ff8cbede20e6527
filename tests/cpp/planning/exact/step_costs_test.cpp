// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The costs of steps against the tally of the polylines that they make.
#include "planning/exact/step_costs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "small_graphs.hpp"

namespace ltp::planning {
namespace {

using test::SmallGraph;
using test::SmallGrid;

Cell by(const Step& step) { return step.offset(); }

/// Calls `visit(from, number, to)` for every step between two cells of a frame.
template <typename Visitor>
void all_steps(const GridFrame& frame, Visitor&& visit) {
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    for (int k = 0; k < kSteps; ++k) {
      const Cell to = frame.cell_at(i) + by(steps()[k]);
      if (frame.contains(to)) visit(frame.cell_at(i), k, to);
    }
  }
}

TEST(StepCosts, AddUpToTheTallyOfEverySimplePath) {
  std::mt19937_64 random(1);
  int paths = 0;
  for (int k = 0; k < 50; ++k) {
    const SmallGraph made(test::random_two_ends(random, k));
    const double most = made.costs.max_priority();
    ASSERT_LE(most, made.small.priority.maximum() + 1e-12);
    test::all_simple_paths(made.small, [&](const std::vector<Cell>& chain, const PathTally& sums) {
      const StepCost cost = made.costs.along(chain);
      ASSERT_NEAR(cost.length, sums.length, 1e-9);
      ASSERT_NEAR(cost.loss, most * sums.length - sums.priority, 1e-9);
      ++paths;
    });
  }
  EXPECT_GT(paths, 5000);
}

TEST(StepCosts, AddUpAlikeInAnyOrder) {
  std::mt19937_64 random(2);
  int different = 0;  // of the same sums, not rounded
  for (int k = 0; k < 30; ++k) {
    const SmallGraph made(test::random_two_ends(random, k));
    std::vector<StepCost> all;
    all_steps(made.small.grid.frame(), [&](const Cell& from, int step, const Cell&) {
      all.push_back(made.costs(from, step));
    });
    std::shuffle(all.begin(), all.end(), random);
    all.resize(std::min<std::size_t>(all.size(), 12));  // no more steps than a path has
    const auto sum = [](const std::vector<StepCost>& costs, double factor) {
      StepCost total;
      for (const StepCost& cost : costs)
        total = total + StepCost{factor * cost.length, factor * cost.loss};
      return std::make_pair(total.length, total.loss);
    };
    const auto exact = sum(all, 1.0);
    const auto thirds = sum(all, 1.0 / 3.0);
    for (int n = 0; n < 20; ++n) {
      std::shuffle(all.begin(), all.end(), random);
      ASSERT_EQ(sum(all, 1.0), exact);
      different += sum(all, 1.0 / 3.0) != thirds;
    }
  }
  EXPECT_GT(different, 100);
}

TEST(StepCosts, AreMultiplesOfOneUnit) {
  std::mt19937_64 random(4);
  for (int k = 0; k < 30; ++k) {
    const SmallGraph made(test::random_two_ends(random, k));
    const double unit = made.costs.unit();
    ASSERT_LT(unit, 1e-10);
    all_steps(made.small.grid.frame(), [&](const Cell& from, int step, const Cell&) {
      const StepCost cost = made.costs(from, step);
      ASSERT_EQ(std::remainder(cost.length, unit), 0.0);
      ASSERT_EQ(std::remainder(cost.loss, unit), 0.0);
    });
  }
}

TEST(StepCosts, AreNeverNegativeAndTheSameThereAndBack) {
  std::mt19937_64 random(3);
  int lossless = 0;
  for (int k = 0; k < 60; ++k) {
    SmallGrid small = test::random_two_ends(random, k);
    if (k % 3 == 0) small.priority = test::random_fine_raster(random);
    const SmallGraph made(small);
    all_steps(small.grid.frame(), [&](const Cell& from, int step, const Cell& to) {
      const StepCost cost = made.costs(from, step);
      const StepCost back = made.costs(to, steps()[step].opposite);
      ASSERT_GT(cost.length, 0.0);
      ASSERT_GE(cost.loss, 0.0);
      ASSERT_EQ(cost.length, back.length);
      ASSERT_EQ(cost.loss, back.loss);
      ASSERT_EQ(step_between(from, to), step);
      lossless += cost.loss == 0.0;
    });
  }
  EXPECT_GT(lossless, 100);  // p_max is no larger than it must be
}

TEST(StepCosts, TallyTheStepsAtTheEndsExactlyOverAnyRaster) {
  std::mt19937_64 random(4);
  int ends = 0;
  int between = 0;
  for (int k = 0; k < 60; ++k) {
    SmallGrid small = test::random_two_ends(random, k);
    small.priority = test::random_fine_raster(random);
    const SmallGraph made(small);
    const GridFrame& frame = small.grid.frame();
    const double most = made.costs.max_priority();
    const auto place = [&](const Cell& cell) -> Point {
      if (cell == made.problem.start) return small.query.start;
      return cell == made.problem.goal ? small.query.goal : frame.centre(cell);
    };
    all_steps(frame, [&](const Cell& from, int step, const Cell& to) {
      const StepCost cost = made.costs(from, step);
      const double length = (place(to) - place(from)).norm();
      ASSERT_NEAR(cost.length, length, 1e-9);
      const bool at_end = place(from) != frame.centre(from) || place(to) != frame.centre(to);
      double priority = 0.0;
      if (at_end) {
        priority = small.priority.integral(place(from), place(to));
        ++ends;
      } else if (from != made.problem.start && from != made.problem.goal &&
                 to != made.problem.start && to != made.problem.goal) {
        const auto at = [&](const Cell& cell) {
          return small.priority.at(place(cell).x(), place(cell).y());
        };
        priority = length * 0.5 * (at(from) + at(to));
        ++between;
      } else {
        return;  // an end at a centre: exact, too
      }
      ASSERT_NEAR(cost.loss, most * length - priority, 1e-9);
    });
  }
  EXPECT_GT(ends, 500);
  EXPECT_GT(between, 1000);
}

TEST(StepCosts, KnowTheNumberOfEveryStep) {
  for (int k = 0; k < kSteps; ++k) {
    EXPECT_EQ(step_between(Cell(3, -4, 5), Cell(3, -4, 5) + by(steps()[k])), k);
  }
}

}  // namespace
}  // namespace ltp::planning
