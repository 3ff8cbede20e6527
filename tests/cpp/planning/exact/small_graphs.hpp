// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Random graphs of few cells with all their simple paths, for the parts of the exact search.
#pragma once

#include <functional>
#include <random>
#include <vector>

#include "planning/exact/cell_graph.hpp"
#include "small_grids.hpp"

namespace ltp::test {

using planning::CellGraph;
using planning::CostFactors;
using planning::StepCosts;

/// All free cells of a small grid, start and goal in two of them. It does not move: the graph keeps
/// its costs.
struct SmallGraph {
  SmallGrid small;
  Problem problem;
  StepCosts costs;
  std::vector<Cell> free;
  CellGraph graph;

  explicit SmallGraph(const SmallGrid& made)
      : small(made), problem(small.scene(), small.query, {}) {
    const GridFrame& frame = small.grid.frame();
    costs.reset(problem, static_cast<double>(frame.size()) * frame.cell().norm());
    for (std::int64_t i = 0; i < frame.size(); ++i) {
      if (!small.grid.blocked(frame.cell_at(i))) free.push_back(frame.cell_at(i));
    }
    graph.build(problem, costs, free);
  }
  SmallGraph(const SmallGraph&) = delete;
  SmallGraph& operator=(const SmallGraph&) = delete;

  /// Calls `visit(nodes, sums, tally of the polyline)` for every simple path from start to goal.
  template <typename Visitor>
  void all_paths(Visitor&& visit) const {
    std::vector<std::uint32_t> nodes;
    all_simple_paths(small, [&](const std::vector<Cell>& chain, const PathTally& tally) {
      nodes.clear();
      for (const Cell& cell : chain) nodes.push_back(graph.node(cell));
      visit(nodes, graph.along(nodes), tally);
    });
  }
};

/// A small grid with start and goal in two cells; planar and in space by turns.
inline SmallGrid random_two_ends(std::mt19937_64& random, int number, double density = 0.25) {
  while (true) {
    const std::array<int, 3> dims =
        number % 2 != 0 ? std::array<int, 3>{4, 4, 1} : std::array<int, 3>{2, 3, 2};
    SmallGrid made = random_small_grid(random, dims, density, number % 4 > 1);
    const GridFrame& frame = made.grid.frame();
    if (frame.cell_of(made.query.start) != frame.cell_of(made.query.goal)) return made;
  }
}

/// A raster whose cells are not the grid's columns.
inline Raster random_fine_raster(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Raster::Values values(20, 20);
  for (Eigen::Index i = 0; i < values.size(); ++i) values.data()[i] = unit(random);
  return Raster(values, {-0.3, -0.2}, 0.7);
}

/// The least `factors` of a path from each node to the goal, by going over all edges again and
/// again. No path leads through the start.
inline std::vector<double> slow_costs_to_goal(const CellGraph& graph, const CostFactors& factors) {
  std::vector<double> costs(graph.size(), std::numeric_limits<double>::infinity());
  costs[graph.goal()] = 0.0;
  for (std::uint32_t round = 0; round < graph.size(); ++round) {
    for (std::uint32_t from = 0; from < graph.size(); ++from) {
      for (const CellGraph::Edge* edge = graph.begin(from); edge != graph.end(from); ++edge) {
        if (edge->to == graph.start()) continue;
        costs[from] = std::min(costs[from], costs[edge->to] + factors(graph.cost(from, *edge)));
      }
    }
  }
  return costs;
}

}  // namespace ltp::test
