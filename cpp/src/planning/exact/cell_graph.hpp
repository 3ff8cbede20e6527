// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CellGraph`: some cells of a grid and the steps between them, numbered and packed; and the least
// costs on it.
#pragma once

#include <cstdint>
#include <vector>

#include "planning/exact/step_costs.hpp"
#include "planning/search/open_list.hpp"

namespace ltp::planning {

/// Every step is there in both directions, at the same cost.
class CellGraph {
 public:
  struct Edge {
    std::uint32_t to;
    std::uint32_t step;  ///< its number, of 26; from `kSteps` on: one whose cost is its own
  };

  /// @param cells   start and goal among them, none twice
  /// @param costs   kept: must live as long as the graph is used
  void build(const Problem& problem, const StepCosts& costs, const std::vector<Cell>& cells);

  std::uint32_t size() const { return static_cast<std::uint32_t>(cells_.size()); }
  std::uint32_t start() const { return start_; }
  std::uint32_t goal() const { return goal_; }
  const Cell& cell(std::uint32_t node) const { return cells_[node]; }
  /// The number of a cell that is in the graph.
  std::uint32_t node(const Cell& cell) const {
    return number_[static_cast<std::size_t>(frame_index(cell))];
  }
  const Edge* begin(std::uint32_t node) const { return edges_.data() + first_[node]; }
  const Edge* end(std::uint32_t node) const { return edges_.data() + first_[node + 1]; }
  StepCost cost(std::uint32_t from, const Edge& edge) const {
    if (edge.step >= kSteps) return ends_[edge.step - kSteps];
    return costs_->between(costs_->lengths()[edge.step], priority_[from], priority_[edge.to]);
  }
  /// Of a chain of neighbouring nodes.
  StepCost along(const std::vector<std::uint32_t>& chain) const;
  /// No simple path is longer [m].
  double longest() const { return longest_; }
  std::size_t bytes() const;

  /// A path through one node more than once, without the ways round.
  static std::vector<std::uint32_t> without_rings(const std::vector<std::uint32_t>& chain);

 private:
  std::int64_t frame_index(const Cell& cell) const {
    return (std::int64_t{cell.x()} * ny_ + cell.y()) * nz_ + cell.z();
  }

  const StepCosts* costs_ = nullptr;
  int ny_ = 0;
  int nz_ = 0;
  std::uint32_t start_ = 0;
  std::uint32_t goal_ = 0;
  double longest_ = 0.0;
  std::vector<Cell> cells_;
  std::vector<double> priority_;
  std::vector<std::uint32_t> first_;
  std::vector<Edge> edges_;
  std::vector<StepCost> ends_;
  std::vector<std::uint32_t> number_;  // of each cell of the window; kNone where it has none
};

/// A cost that is a sum: `length` L + `loss` R, both factors >= 0.
struct CostFactors {
  double length = 1.0;
  double loss = 0.0;
  double operator()(const StepCost& cost) const { return length * cost.length + loss * cost.loss; }
};

/// Dijkstra: the least cost between one node (start or goal) and every other, infinite where none.
/// Paths do not lead through the other end. False: out of budget.
bool least_costs(const CellGraph& graph, std::uint32_t from, const CostFactors& factors,
                 BudgetWatch& budget, SearchStats& stats, OpenList& open,
                 std::vector<double>& costs);

}  // namespace ltp::planning
