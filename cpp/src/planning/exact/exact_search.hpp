// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ExactSearch`: from a good path to the best one, or to the proof that it is good enough.
#pragma once

#include <optional>
#include <vector>

#include "ltp/planning/planner.hpp"
#include "planning/additive/penalty_bound.hpp"
#include "planning/exact/cell_graph.hpp"
#include "planning/exact/corridor.hpp"
#include "planning/exact/label_search.hpp"
#include "planning/exact/step_costs.hpp"

namespace ltp::planning {

/// Over the simple paths of the planners' graph. A good path leaves over few cells (`Corridor`,
/// then both ways over a `CellGraph`); on these, `LabelSearch` finds the optimum.
class ExactSearch {
 public:
  struct Limits {
    double eps = 0.0;        ///< what may be left of Eq. (5) + W_P p_max, as a part of it, >= 0
    double tolerance = 0.0;  ///< what may be left of Eq. (5), >= 0; the larger of both counts
    double memory = 0.0;     ///< for labels and graph [bytes]
  };

  /// Improves an answer that has a path through the vertices; W_P > 0, start and goal in two cells.
  /// Found: it is within the limits of the optimum. OutOfBudget: it may be better than before.
  /// `proved()` holds in either case.
  PlanStatus improve(const Problem& problem, const Limits& limits, Answer& answer);

  /// No path has a smaller penalty; empty where the raster's cells are not the grid's columns, or
  /// nothing was proved.
  std::optional<double> proved() const { return proved_; }

 private:
  bool narrow(const Problem& problem, const ShiftedPenalty& penalty, Answer& answer,
              Incumbent& best);
  bool guide(double beta, const ShiftedPenalty& penalty, Answer& answer, Incumbent& best);
  void keep_alive(const Problem& problem, Incumbent& best);

  std::optional<double> proved_;
  double memory_ = 0.0;
  std::optional<PenaltyBound> bound_;
  StepCosts costs_;
  Corridor corridor_;
  std::vector<Cell> cells_;
  CellGraph graph_;
  std::vector<Guide> guides_;
  std::vector<double> length_to_goal_;
  std::vector<double> from_start_;
  std::vector<char> alive_;
  OpenList open_;
  LabelSearch labels_;
};

}  // namespace ltp::planning
