// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's search, literally: LP-Dijkstra, LP-A*, WLP-A*.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct LengthPriorityOptions {
  /// W_A* of Eq. (10): 0 LP-Dijkstra, 1 LP-A*, sqrt(3) WLP-A*; >= 0.
  double heuristic_weight = 0.0;
  /// Eq. (9) as printed lacks the factor W_L, so that its heuristic weighs 1 / W_L too much. True
  /// scales it.
  bool scaled = false;

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// Backward weighted A* from goal to start over the 26-neighbour graph, ordered by Eqs. (8)-(10). A
/// cell carries one label (L, P) and is closed for good when it is expanded: reopening would turn
/// parent chains into rings, since Eq. (8) is a mean that can fall along a path. So for W_P > 0
/// this is the paper's heuristic, not an optimum of Eq. (5). For W_P = 0 and a heuristic weight of
/// at most 1 the answer is the shortest path on the graph, and `ShortestPath` finds it.
std::unique_ptr<Planner> make_length_priority(const PlannerInfo& info,
                                              const PenaltyWeights& weights,
                                              const LengthPriorityOptions& options);

}  // namespace ltp
