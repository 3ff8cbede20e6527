// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The penalty linearised: `additive`, one exact search, and `sweep`, searches until path and
// certified bound meet.
#pragma once

#include <limits>
#include <string>

#include "ltp/planning/additive_search.hpp"
#include "ltp/planning/exact_search.hpp"
#include "ltp/planning/penalty_bound.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/planning/shortest_path.hpp"

namespace ltp {

/// Eq. (5) is a mean; linearised at a path of length L and mean priority m it is the sum of (alpha
/// - p) dl with alpha = m + (W_L / W_P) L / L_direct. While alpha is above the largest priority
/// every step costs something and A* is exact for it. A search with alpha whose least cost is C
/// proves P <= alpha L - C for every path through cell centres: a lower bound on Eq. (5),
/// `Plan::bound`. Where the bound lies, the slope of Eq. (5) is the next alpha (Aneja and Nair's
/// dichotomic search, steered by the penalty); the shortest path bounds it from the other side.
///
/// Ends when the best path is within the tolerance of the bound, when another search could bring
/// nothing new - then the path is the best supported one, and the true optimum lies between the
/// bound and it - or when its effort is spent. A gap that is still open then is closed by
/// `ExactSearch`, as far as `LinearisedOptions::closing` goes. For W_P = 0 it is `ShortestPath`.
/// Where alpha would have to be below the largest priority (long detours over the best ground pay),
/// it is held just above: the bound stays valid and gets wider. The bound is given where the
/// priority raster's cells are the grid's columns.
///
/// It begins with a guess from the weights, or with the slope at its last path if that led to the
/// same goal and is steeper: a larger alpha is a faster search for a shorter path.
class LinearisedPlanner final : public Planner {
 public:
  /// @param max_searches  1: `additive`; more: `sweep`
  LinearisedPlanner(std::string name, int max_searches, const PlannerOptions& options);

  std::string_view name() const override { return name_; }
  bool complete() const override { return true; }
  Plan plan(const Scene& scene, const Query& query) override;

  /// Begins with a guess the next time.
  void forget() { last_goal_.setConstant(std::numeric_limits<double>::quiet_NaN()); }

 private:
  void shortest(const Scene& scene, const Query& query, const GridQuery& cells, Plan& plan);
  void search(const Scene& scene, const Query& query, const GridQuery& cells, Plan& best);
  double narrow(const Scene& scene, const Query& query, double penalty, PenaltyBound& bound);
  double begin_with(const PenaltyBound& bound, const GridQuery& cells, const Query& query,
                    double most_priority) const;

  std::string name_;
  int max_searches_;
  PlannerOptions options_;
  ShortestPath shortest_;
  AdditiveSearch search_;
  ColumnPriority priority_;
  ExactSearch exact_;
  Point last_goal_ = Point::Constant(std::numeric_limits<double>::quiet_NaN());
  double last_alpha_ = 0.0;
};

}  // namespace ltp
