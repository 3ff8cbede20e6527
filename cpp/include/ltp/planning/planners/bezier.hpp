// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's cubic Bezier planner: exhaustive search of the two middle control points.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct BezierOptions {
  int offsets = 41;      ///< M, offsets tried for each of the two control points, odd and >= 1
  double reach = 60.0;   ///< largest sideways offset [m], > 0
  int z_offsets = 1;     ///< offsets tried in height for both control points together, odd and >= 1
  double z_reach = 0.0;  ///< largest offset in height [m], >= 0
  int segments = 64;     ///< straight pieces that the curve is flown in, 2 to 100000

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// Eqs. (6)-(7): P0 = start, P3 = goal; P1 and P2 begin at the thirds of the direct line and move
/// sideways, in the plane and square to it, over M x M offsets; optionally both move in height. The
/// curve that is flown, tallied and tested is the polyline through `segments` + 1 of its points,
/// tested exactly along its segments. Not complete: failing, it answers `NoneFound`.
std::unique_ptr<Planner> make_bezier(const PlannerInfo& info, const PenaltyWeights& weights,
                                     const BezierOptions& options);

}  // namespace ltp
