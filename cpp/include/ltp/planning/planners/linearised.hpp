// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The penalty linearised: `additive`, one exact search; `sweep`, searches until path and certified
// bound meet; `auto`, as many as a UAV can wait for. Three presets of one engine.
#pragma once

#include <cstdint>
#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct LinearisedOptions {
  double alpha = 0.0;       ///< of the first search; 0: from the weights
  double tolerance = 0.01;  ///< of Eq. (5): ends when path and bound are this close, >= 0
  int searches = 12;        ///< at most, >= 1
  std::int64_t effort = 0;  ///< expansions that may be spent, see `whole_first`; 0: no limit
  bool whole_first = true;  ///< `effort` counts from the first path on: that search is never cut
  bool remember = true;     ///< begins with the slope at the last path to the same goal
  /// Labels and cells that may be spent on closing the gap that is left, >= 0.
  std::int64_t closing = 200000;

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// Eq. (5) is a mean; linearised at a path of length L and mean priority m it is the sum of (alpha
/// - p) dl with alpha = m + (W_L / W_P) L / L_direct. While alpha is above the largest priority
/// every step costs something and A* is exact for it. A search with alpha whose least cost is C
/// proves P <= alpha L - C for every path through the vertices: a lower bound on Eq. (5),
/// `Plan::bound`. Where the bound lies, the slope of Eq. (5) is the next alpha (Aneja and Nair's
/// dichotomic search, steered by the penalty); the shortest path bounds it from the other side.
///
/// Ends when the best path is within the tolerance of the bound, when another search could bring
/// nothing new - then the path is the best supported one, and the true optimum lies between the
/// bound and it - or when its effort is spent. A gap that is still open then is closed by the exact
/// search, as far as `closing` goes. For W_P = 0 the path is a shortest one. Where alpha would have
/// to be below the largest priority (long detours over the best ground pay), it is held just above:
/// the bound stays valid and gets wider. The bound is given wherever
/// the priority raster is on the grid's columns or can be resampled to them (`onto_columns`).
///
/// It begins with a guess from the weights, or with the slope at its last path if that led to the
/// same goal and is steeper (`remember`): a larger alpha is a faster search for a shorter path.
std::unique_ptr<Planner> make_linearised(const PlannerInfo& info, const PenaltyWeights& weights,
                                         const LinearisedOptions& options);

}  // namespace ltp
