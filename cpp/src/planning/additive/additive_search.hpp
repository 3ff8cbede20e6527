// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `AdditiveSearch`: one exact A* for an edge cost that is a sum, the linearised penalty.
#pragma once

#include <limits>
#include <utility>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/additive/column_costs.hpp"
#include "planning/search/bucket_queue.hpp"
#include "planning/search/level_lengths.hpp"
#include "planning/search/search_space.hpp"
#include "planning/search/unreachable_proof.hpp"

namespace ltp::planning {

/// What a search found.
struct AdditiveResult {
  PlanStatus status = PlanStatus::NoneFound;
  double cost =
      0.0;  ///< Found: of the best path. Out of budget: no path through centres costs less
  std::vector<Cell> chain;  ///< start ... goal
};

/// A* from start to goal. The graph is the planners' own: the vertices, with start and goal
/// themselves in place of the centres of their cells. It begins at the start, since that is where
/// the obstacles are that a UAV has seen, and its heuristic knows none: the exact cost over the
/// columns to the goal, and the least that a change of height adds. A goal that is walled in is
/// proved so from the goal's side: closely by a glance, widely by a flood once the search has grown
/// long.
class AdditiveSearch {
 public:
  AdditiveSearch();

  /// Adds what it did to `stats`. A search that has been told to stop answers `OutOfBudget`.
  /// @param longest  of all paths from start to goal, those of this length [m] are to be among the
  ///     candidates; only on the ground that they can visit must every step cost something
  AdditiveResult run(const Problem& problem, const AdditiveCost& cost, BudgetWatch& budget,
                     SearchStats& stats, double longest = std::numeric_limits<double>::infinity());

 private:
  struct Node {
    double cost = 0.0;  ///< from the start to here
    std::uint32_t stamp = 0;
    std::int8_t from_start = -1;  ///< number of the step that led here; -1: not labelled
  };

  bool begin(const Problem& problem, const AdditiveCost& cost, double longest);
  void set_climbs(const Problem& problem, double metre);
  std::pair<PlanStatus, double> search(const Problem& problem, const AdditiveCost& cost,
                                       BudgetWatch& budget, SearchStats& stats);

  LevelLengths lengths_;
  std::vector<double> climbs_;  ///< the least that a change of height adds, by level
  SearchSpace<Node> space_;
  BucketQueue open_;
  ColumnCosts field_;
  UnreachableProof proof_;
};

}  // namespace ltp::planning
