// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's cubic Bezier planner: exhaustive search of the two middle control points.
#pragma once

#include <vector>

#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// Eqs. (6)-(7): P0 = start, P3 = goal; P1 and P2 begin at the thirds of the direct line and move
/// sideways, in the plane and square to it, over M x M offsets; optionally both move in height. The
/// curve that is flown, tallied and tested is the polyline through `segments` + 1 of its points,
/// tested exactly along its segments. Not complete: failing, it answers `NoneFound`.
class BezierPlanner final : public Planner {
 public:
  explicit BezierPlanner(const PlannerOptions& options);

  std::string_view name() const override { return "bezier"; }
  bool complete() const override { return false; }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  /// Fills `curve_` with the curve whose control points lie `first`, `second` to the side and
  /// `height` up.
  void draw(const Query& query, double first, double second, double height);

  PlannerOptions options_;
  Path basis_;  ///< per sample the Bernstein weights of P1 and P2, and the third of P3; P0 has the
                ///< rest
  Path curve_;
};

}  // namespace ltp
