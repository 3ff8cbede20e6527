// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ColumnPriority`: the priority under the columns of a grid, and along a step between two.
#pragma once

#include <vector>

#include "ltp/grid/frame.hpp"
#include "ltp/grid/raster.hpp"

namespace ltp::planning {

/// The raster's value at each column's centre, which is exact where the raster's cells are the
/// grid's columns.
class ColumnPriority {
 public:
  /// Reads `raster` as long as it is used; keeps its memory from query to query.
  void reset(const GridFrame& frame, const Raster& raster);
  double operator()(int ix, int iy) const { return (*raster_)(rows_[ix], columns_[iy]); }

 private:
  const Raster* raster_ = nullptr;
  std::vector<int> rows_;
  std::vector<int> columns_;
};

/// The priority integral along a step of a length [m] between the centres of two columns: half of
/// it lies in each.
inline double step_integral(double length, double from, double to) {
  return 0.5 * length * (from + to);
}

}  // namespace ltp::planning
