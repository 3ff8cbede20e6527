// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `AdditiveSearch`: one exact A* for an edge cost that is a sum, the linearised penalty.
#pragma once

#include <cstdint>
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
  std::vector<Cell> chain;  ///< start ... goal; through several gates a cell may come twice
};

/// A* from start to goal, or through the gates of a problem: a state is a cell and how many gates
/// have been passed. The graph is the planners' own: the vertices, with start and goal
/// themselves in place of the centres of their cells. It begins at the start, since that is where
/// the obstacles are that a UAV has seen, and its heuristic knows none: the exact cost over the
/// columns to the goal, and the least that a change of height adds. A goal that is walled in is
/// proved so from the goal's side: closely by a glance, widely by a flood once the search has grown
/// long (from the start, where the goal is a region).
///
/// Passing a gate leads into its layer of states: a cell of it is entered as one of the next layer,
/// since whoever has passed it can do all that one who has not can. The heuristic of a layer is the
/// cost over the columns to its gate and on through all later ones.
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
    std::uint8_t passes = 0;      ///< gates that this step passes
  };
  /// The cheapest way to the end of all that is found.
  struct End {
    double cost = std::numeric_limits<double>::infinity();
    Cell cell = Cell::Zero();
    Node by;                 ///< its last step
    bool by_vertex = false;  ///< in its cell it goes by the vertex to the waypoint's point
  };

  bool begin(const Problem& problem, const AdditiveCost& cost, double longest);
  void enter(const Problem& problem, const AdditiveCost& cost, const Node& by, const Point& from,
             const Cell& cell, std::size_t layer);
  void enter_in_place(const Problem& problem, const AdditiveCost& cost, SearchStats& stats);
  void aim(const Problem& problem, const AdditiveCost& cost, double longest);
  void set_climbs(const Problem& problem, double metre);
  void set_gate_climbs(const Problem& problem, double metre);
  PlanStatus search(const Problem& problem, const AdditiveCost& cost, BudgetWatch& budget,
                    SearchStats& stats);
  void trace_back(const Problem& problem, std::vector<Cell>& chain) const;

  std::uint32_t state(std::size_t layer, const Cell& cell) const {
    return static_cast<std::uint32_t>(layer) * layer_size_ + space_.index(cell);
  }
  double& climb(std::size_t layer, int level) { return climbs_[layer * levels_ + level]; }

  LevelLengths lengths_;
  std::vector<double> climbs_;  ///< the least that a change of height adds, by layer and level
  std::size_t levels_ = 0;      ///< so many in a layer
  SearchSpace<Node> space_;
  BucketQueue open_;
  std::uint32_t layer_size_ = 0;     ///< states in a layer
  std::vector<ColumnCosts> fields_;  ///< to what is still to be passed, by layer
  End end_;
  UnreachableProof proof_;
};

}  // namespace ltp::planning
