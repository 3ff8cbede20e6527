// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// An optimised cubic Hermite curve: the tangents at both ends are what is searched for.
#pragma once

#include <array>
#include <vector>

#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

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
class HermitePlanner final : public Planner {
 public:
  explicit HermitePlanner(const PlannerOptions& options);

  std::string_view name() const override { return "hermite"; }
  bool complete() const override { return false; }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  /// The tangents in direct lengths: ahead, to the left and up, at the start and at the goal.
  using Tangents = std::array<double, 6>;
  struct Curve {
    Tangents tangents{};
    int blocked = 0;  ///< pieces that touch an obstacle or leave the window
    double penalty = 0.0;
    /// By more than rounding, so that equals stay what they are.
    bool better_than(const Curve& other) const;
  };
  class Search;

  void draw(const Query& query, const Tangents& tangents);

  PlannerOptions options_;
  Path basis_;  ///< per sample h10, h11, h01; h00 is what is missing from 1
  Path curve_;
};

}  // namespace ltp
