// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The packed graph against the grid's own steps, and its least costs against a slow search.
#include "planning/exact/cell_graph.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <vector>

#include "budgets.hpp"
#include "small_graphs.hpp"

namespace ltp::planning {
namespace {

using test::SmallGraph;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Some of the free cells, start and goal among them, in any order.
std::vector<Cell> some_cells(const SmallGraph& made, std::mt19937_64& random) {
  std::vector<Cell> cells;
  for (const Cell& cell : made.free) {
    const bool is_end = cell == made.problem.start || cell == made.problem.goal;
    if (is_end || random() % 4 != 0) cells.push_back(cell);
  }
  std::shuffle(cells.begin(), cells.end(), random);
  return cells;
}

TEST(CellGraph, HasTheLegalStepsBetweenItsCellsAndTheirCosts) {
  std::mt19937_64 random(1);
  CellGraph used;  // by graphs of all sizes, one after the other
  int edges = 0;
  for (int k = 0; k < 200; ++k) {
    const SmallGraph made(test::random_two_ends(random, k));
    const OccupancyGrid& grid = made.small.grid;
    const std::vector<Cell> cells = some_cells(made, random);
    CellGraph fresh;
    CellGraph& graph = k % 5 == 0 ? fresh : used;
    graph.build(made.problem, made.costs, cells);
    ASSERT_EQ(graph.size(), cells.size());
    ASSERT_EQ(graph.cell(graph.start()), made.problem.start);
    ASSERT_EQ(graph.cell(graph.goal()), made.problem.goal);
    for (std::uint32_t node = 0; node < graph.size(); ++node) {
      const Cell& from = graph.cell(node);
      ASSERT_EQ(from, cells[node]);
      ASSERT_EQ(graph.node(from), node);
      std::set<std::uint32_t> expected;
      const std::uint32_t blocked = blocked_surroundings(grid, from, made.problem.levels);
      for (std::uint32_t other = 0; other < cells.size(); ++other) {
        const Cell by = cells[other] - from;
        if (other == node || by.cwiseAbs().maxCoeff() > 1) continue;
        if ((blocked & steps()[step_between(from, cells[other])].box) == 0) expected.insert(other);
      }
      std::set<std::uint32_t> there;
      for (const CellGraph::Edge* edge = graph.begin(node); edge != graph.end(node); ++edge) {
        ASSERT_TRUE(there.insert(edge->to).second);
        const StepCost cost = graph.cost(node, *edge);
        const StepCost told = made.costs(from, step_between(from, graph.cell(edge->to)));
        ASSERT_EQ(cost.length, told.length);
        ASSERT_EQ(cost.loss, told.loss);
        ++edges;
      }
      ASSERT_EQ(there, expected);
    }
    ASSERT_GT(graph.bytes(), 0u);
  }
  EXPECT_GT(edges, 5000);
}

TEST(CellGraph, AddsUpPathsAndKnowsThatNoneIsLonger) {
  std::mt19937_64 random(2);
  int paths = 0;
  for (int k = 0; k < 60; ++k) {
    const SmallGraph made(test::random_two_ends(random, k));
    made.all_paths(
        [&](const std::vector<std::uint32_t>& nodes, const StepCost& sum, const PathTally& tally) {
          ASSERT_NEAR(sum.length, tally.length, 1e-9);
          ASSERT_NEAR(sum.loss, made.costs.max_priority() * tally.length - tally.priority, 1e-9);
          ASSERT_LE(sum.length, made.graph.longest());
          ASSERT_EQ(nodes.front(), made.graph.start());
          ASSERT_EQ(nodes.back(), made.graph.goal());
          ++paths;
        });
  }
  EXPECT_GT(paths, 5000);
}

TEST(CellGraph, CutsTheWaysRoundOutOfAPath) {
  using Chain = std::vector<std::uint32_t>;
  EXPECT_EQ(CellGraph::without_rings({}), Chain{});
  EXPECT_EQ(CellGraph::without_rings({1, 2, 3}), (Chain{1, 2, 3}));
  EXPECT_EQ(CellGraph::without_rings({1, 2, 3, 2, 4}), (Chain{1, 2, 4}));
  EXPECT_EQ(CellGraph::without_rings({1, 2, 3, 4, 2, 5, 3, 6}), (Chain{1, 2, 5, 3, 6}));
  EXPECT_EQ(CellGraph::without_rings({1, 2, 1, 3, 1}), Chain{1});
}

TEST(LeastCosts, AreThoseOfTheSlowSearchFromBothEnds) {
  std::mt19937_64 random(3);
  OpenList open;
  std::vector<double> costs;
  int reached = 0;
  int sealed = 0;
  for (int k = 0; k < 200; ++k) {
    const SmallGraph made(test::random_two_ends(random, k, 0.4));
    for (const CostFactors factors :
         {CostFactors{1.0, 0.0}, CostFactors{0.0, 1.0}, CostFactors{0.3, 1.0}}) {
      SearchStats stats;
      ASSERT_TRUE(
          least_costs(made.graph, made.graph.goal(), factors, *test::Limit(), stats, open, costs));
      const std::vector<double> expected = test::slow_costs_to_goal(made.graph, factors);
      for (std::uint32_t node = 0; node < made.graph.size(); ++node) {
        ASSERT_EQ(costs[node] == kInfinity, expected[node] == kInfinity);
        (costs[node] == kInfinity ? sealed : reached) += 1;
        if (costs[node] == kInfinity) continue;
        ASSERT_NEAR(costs[node], expected[node], 1e-9);
      }
      // The way there is the way back.
      const double whole = costs[made.graph.start()];
      ASSERT_TRUE(
          least_costs(made.graph, made.graph.start(), factors, *test::Limit(), stats, open, costs));
      ASSERT_EQ(costs[made.graph.start()], 0.0);
      ASSERT_TRUE(whole == kInfinity || std::abs(costs[made.graph.goal()] - whole) < 1e-9);
    }
  }
  EXPECT_GT(reached, 3000);
  EXPECT_GT(sealed, 300);
}

TEST(LeastCosts, LeadThroughNoOtherEnd) {
  // A corridor of three cells: goal, start, and a cell that lies behind the start.
  test::SmallGrid small{OccupancyGrid(GridFrame({0, 0, 0}, {2, 2, 4}, {3, 1, 1})),
                        Raster(Raster::Values::Zero(3, 1), {0, 0}, 2.0), Query{}};
  small.query.goal = {1, 1, 2};
  small.query.start = {3, 1, 2};
  const SmallGraph made(small);
  OpenList open;
  SearchStats stats;
  std::vector<double> costs;
  ASSERT_TRUE(
      least_costs(made.graph, made.graph.goal(), {1.0, 0.0}, *test::Limit(), stats, open, costs));
  EXPECT_EQ(costs[made.graph.start()], 2.0);
  EXPECT_EQ(costs[made.graph.node(Cell(2, 0, 0))], kInfinity);
  EXPECT_EQ(stats.expanded, 2);
  EXPECT_FALSE(
      least_costs(made.graph, made.graph.goal(), {1.0, 0.0}, *test::Limit(1), stats, open, costs));
}

}  // namespace
}  // namespace ltp::planning
