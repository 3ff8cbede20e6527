// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `AdditiveSearch`: one exact A* for an edge cost that is a sum, the linearised penalty.
#pragma once

#include <vector>

#include "ltp/planning/column_field.hpp"
#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/open_list.hpp"
#include "ltp/planning/search_space.hpp"

namespace ltp {

/// The cost of a path of length L and priority integral P: `length` L - `priority` P, both factors
/// >= 0. While `length` > `priority` * (largest priority) every step costs something and the search
/// is exact.
struct AdditiveCost {
  double length = 1.0;
  double priority = 0.0;

  double operator()(double metres, double integral) const {
    return length * metres - priority * integral;
  }
};

/// What a search found.
struct AdditiveResult {
  PlanStatus status = PlanStatus::NoneFound;
  double cost = 0.0;        ///< of the best path; no path through cell centres costs less
  std::vector<Cell> chain;  ///< start ... goal
};

/// Backward A* from goal to start. The graph is the planners' own: cell centres, with start and
/// goal themselves in place of the centres of their cells. Its heuristic is the exact cost over the
/// columns from the start, obstacles ignored: priority depends on x and y alone, so no path in
/// space is cheaper than the best one over the ground.
class AdditiveSearch {
 public:
  /// Adds what it did to `stats`. A search that has been told to stop answers `OutOfBudget`.
  AdditiveResult run(const Scene& scene, const Query& query, const GridQuery& cells,
                     const AdditiveCost& cost, const Budget& budget, SearchStats& stats);

 private:
  struct Node {
    double cost = 0.0;  ///< from here to the goal
    std::uint32_t stamp = 0;
    std::int8_t to_goal = -1;
    bool labelled = false;
    bool closed = false;
  };

  SearchSpace<Node> space_;
  OpenList open_;
  ColumnPriority priority_;
  ColumnField field_;
};

}  // namespace ltp
