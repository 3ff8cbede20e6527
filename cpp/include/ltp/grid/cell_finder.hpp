// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CellFinder`: the answers of `GridFrame::cell_of` at a third of its price, for thousands of
// points.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"

namespace ltp {

/// Multiplies by the inverse edge instead of dividing, and cuts instead of rounding down, in fixed
/// point: the upper bits are the cell, the lower ones say how near its faces are. Where rounding
/// could matter - next to a face, outside the window - it asks the frame, so the two never
/// disagree. The frame must outlive it.
class CellFinder {
 public:
  explicit CellFinder(const GridFrame& frame) : frame_(frame) {
    for (int axis = 0; axis < 3; ++axis) {
      const double origin = frame.origin()[axis];
      const double scale = kOne / frame.cell()[axis];
      // Inside the window, `cell_of` and we round to within 2^-53 (3 * 2^30 + 3 * 2^31 + 4 |origin|
      // / edge) cells of the truth: lattice coordinates are below 2^30, a window at most 2^31 cells
      // long. That is 1.1 units of the fixed point and what the origin's distance adds.
      const double doubt = 4.0 + 1e-15 * std::abs(origin) * scale;
      // Where the frame saturates inside its own window, and for edges that have no inverse, it
      // decides everything.
      const double farthest = std::abs<double>(frame.first()[axis]) + frame.dims()[axis];
      const bool usable = farthest < kFarthestCell && doubt < 0.5 * kOne;
      axes_[axis] = {origin, scale, frame.dims()[axis] * static_cast<double>(kOne),
                     usable ? static_cast<std::int64_t>(doubt) : kOne / 2};
    }
  }

  /// The cell that holds a point, exactly `frame.cell_of(point)` for any point.
  Cell operator()(const Point& point) const {
    bool certain = true;
    const auto along = [&](int i) {
      const Axis& axis = axes_[i];
      // Points outside end up on -1 or `end`, and NaN on -1: as good as on a face, hence uncertain.
      const double scaled =
          std::min(axis.end, std::max(-1.0, (point[i] - axis.origin) * axis.scale));
      const std::int64_t fixed = static_cast<std::int64_t>(scaled);
      const std::int64_t rest = (fixed & (kOne - 1)) - axis.doubt;
      certain &=
          static_cast<std::uint64_t>(rest) < static_cast<std::uint64_t>(kOne - 2 * axis.doubt);
      return static_cast<int>(fixed >> kBits);
    };
    const int ix = along(0);
    const int iy = along(1);
    const int iz = along(2);
    return certain ? Cell(ix, iy, iz) : frame_.cell_of(point);
  }

 private:
  static constexpr int kBits = 20;  ///< of the fixed point, behind the point
  static constexpr std::int64_t kOne = std::int64_t{1} << kBits;

  struct Axis {
    double origin;       ///< of the window [m]
    double scale;        ///< fixed point units a metre
    double end;          ///< of the window [units]
    std::int64_t doubt;  ///< this near to a face, the frame decides [units]
  };

  const GridFrame& frame_;
  std::array<Axis, 3> axes_;
};

}  // namespace ltp
