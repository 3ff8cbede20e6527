// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `AraSearch`: ARA*, one additive search whose path gets better from round to round.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/additive/column_costs.hpp"
#include "planning/search/level_lengths.hpp"
#include "planning/search/open_list.hpp"
#include "planning/search/search_space.hpp"
#include "planning/search/unreachable_proof.hpp"

namespace ltp::planning {

/// Likhachev, Gordon, Thrun, "ARA*: Anytime A* with provable bounds on sub-optimality", NIPS 2003,
/// on the graph and cost of `AdditiveSearch`. Each round is an A* whose heuristic is weighted; it
/// costs at most that weight times the least. The next, with a smaller weight, goes on from what
/// the last one left: cells that became cheaper after they were closed wait in a list of their own
/// (INCONS) until then. In the last round, with weight 1, they are opened again at once.
class AraSearch {
 public:
  AraSearch();

  /// Begins. The problem is borrowed until the last `improve`.
  void begin(const Problem& problem, const AdditiveCost& cost, SearchStats& stats);

  /// One round. `Found`: `chain` costs at most `weight` times the least; `Unreachable`: proved;
  /// `OutOfBudget`: stopped on the way.
  PlanStatus improve(double weight, BudgetWatch& budget, SearchStats& stats);

  double cost() const { return space_[goal_].cost; }  ///< of the best path so far
  double least() const { return least_; }             ///< no path costs less
  std::vector<Cell> chain() const;                    ///< the best path so far, start ... goal

 private:
  struct Node {
    double cost = std::numeric_limits<double>::infinity();  ///< from the start to here
    std::uint32_t stamp = 0;
    std::int32_t closed = 0;      ///< the last round that closed it
    std::int8_t from_start = -1;  ///< number of the step that led here
    bool waiting = false;         ///< its present cost has not been passed on: OPEN or INCONS
  };

  double heuristic(const Cell& cell);
  double step_cost(const Cell& from, const Cell& to, double length);
  void expand(std::uint32_t index, SearchStats& stats);
  void reweigh(double weight);

  const Problem* problem_ = nullptr;
  AdditiveCost cost_;
  LevelLengths lengths_;
  double weight_ = 1.0;
  double least_ = 0.0;
  std::int32_t round_ = 0;
  std::uint32_t goal_ = 0;

  SearchSpace<Node> space_;
  OpenList open_;
  std::vector<std::uint32_t> waiting_;  ///< cells of OPEN and INCONS, between two rounds
  std::vector<std::uint32_t> incons_;
  ColumnCosts field_;
  UnreachableProof proof_;
};

}  // namespace ltp::planning
