// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// An optimised cubic Hermite curve: the tangents at both ends are what is searched for.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct HermiteOptions {
  int segments = 64;    ///< straight pieces that the curve is flown in, 2 to 100000
  int starts = 5;       ///< sideways tangents tried at each end to begin with, odd and >= 1
  double reach = 3.0;   ///< the largest of them, in direct lengths, over 0, at most 1000
  int refined = 4;      ///< the best so many of those curves are optimised, >= 1
  int iterations = 24;  ///< rounds of the optimisation of each, >= 0

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// The paper's introduction names planners that optimise Hermite polynomials as the more aggressive
/// kind; ours minimises Eq. (5) over
///     c(s) = h00 start + h10 m0 + h01 goal + h11 m1,   0 <= s <= 1,
/// whose tangents m0, m1 may point anywhere (the Bezier planner's control points only move
/// sideways). A lattice of `starts` x `starts` sideways tangents is tried, the best `refined` of
/// those curves are improved by a pattern search (Hooke and Jeeves 1961): each round tries steps up
/// and down every coordinate of the tangents and keeps what is better; where nothing is, the steps
/// are halved. A curve that is blocked is better the fewer of its pieces are; so the search finds
/// its way out of obstacles. Flown, tallied and tested exactly is the polyline through `segments` +
/// 1 points. The straight line is the first curve, so the answer is never worse than it. Not
/// complete: failing, it answers `NoneFound`.
std::unique_ptr<Planner> make_hermite(const PlannerInfo& info, const PenaltyWeights& weights,
                                      const HermiteOptions& options);

}  // namespace ltp
