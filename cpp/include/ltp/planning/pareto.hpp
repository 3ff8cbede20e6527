// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ParetoPlanner`: the exact optimum of Eq. (5) over the graph's simple paths, and the whole front
// of (length, priority).
#pragma once

#include <vector>

#include "ltp/planning/cell_graph.hpp"
#include "ltp/planning/corridor.hpp"
#include "ltp/planning/exact_search.hpp"
#include "ltp/planning/front_search.hpp"
#include "ltp/planning/linearised.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/planning/step_costs.hpp"

namespace ltp {

/// The paths of which none is both shorter and over better ground, by rising length L and falling
/// loss R = p_max L - P (p_max: the largest priority in the window).
struct Front {
  PlanStatus status = PlanStatus::NoneFound;
  std::vector<PathTally> tallies;  ///< of each path; empty unless Found
  std::vector<Path> paths;         ///< start ... goal, world [m]; each checked like a plan's
  SearchStats stats;
};

/// Exact over the simple paths of the planners' graph: cell centres, 26 steps, start and goal in
/// place of the centres of their cells. A sweep gives a good path, `ExactSearch` goes on from
/// there.
///
/// `Plan::bound` is the optimum within 1e-9, where the priority raster's cells are the grid's
/// columns; elsewhere priority is that of the columns' centres, and there is no bound. With
/// `ParetoOptions::eps`, Eq. (5) + W_P p_max is at most (1 + eps) times its optimum. A search that
/// needs more than `ParetoOptions::memory`, or more than 64 cells at which circling would pay,
/// answers `OutOfBudget`, without a path.
class ParetoPlanner final : public Planner {
 public:
  explicit ParetoPlanner(const PlannerOptions& options);

  std::string_view name() const override { return "pareto"; }
  bool complete() const override { return true; }
  Plan plan(const Scene& scene, const Query& query) override;

  /// The front of (L, R), both as small as can be; equal ones once. Rings never pay in it, so all
  /// paths are simple. A path with the least Eq. (5) is on it wherever the optimum has W_L L /
  /// L_direct >= W_P (p_max - its mean priority), which is where circling over the best ground
  /// would not pay either.
  /// @param eps  for each path there is one in the front with at most (1 + eps) times its length
  ///             and its loss, >= 0
  /// `OutOfBudget` if the memory of the options or their `max_expansions` do not suffice. Throws
  /// `std::invalid_argument` for a query that is not finite or a wrong `eps`.
  Front front(const Scene& scene, const Query& query, double eps = 0.0);

 private:
  Path path_of(const GridFrame& frame, const Query& query,
               const std::vector<std::uint32_t>& chain) const;

  PlannerOptions options_;
  LinearisedPlanner sweep_;
  ExactSearch exact_;
  // For the front.
  StepCosts costs_;
  Corridor corridor_;
  std::vector<Cell> cells_;
  CellGraph graph_;
  std::vector<double> length_to_goal_;
  OpenList open_;
  FrontSearch fronts_;
};

}  // namespace ltp
