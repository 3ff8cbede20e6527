// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Inflation: the cells that come within a radius of an occupied cell.
#pragma once

#include <vector>

#include "ltp/grid/occupancy_grid.hpp"

namespace ltp {

/// Blocks every cell whose closed box is within `radius` [m] of the closed box of an occupied cell:
/// conservative, no point of a cell left free is that near to any point of an occupied one. So any
/// radius > 0 blocks at least the 26 neighbours; radius 0 blocks the occupied cells only. Works on
/// whole columns of bits; allocates only when it is made.
class Inflation {
 public:
  /// For all grids with this frame's cells and dims. Throws unless `radius` is finite and >= 0.
  Inflation(const GridFrame& frame, double radius);

  double radius() const { return radius_; }

  /// Blocks in `blocked` the surroundings of one occupied cell, which must be inside.
  void add(const Cell& occupied, OccupancyGrid& blocked) const;

  /// Makes `blocked` the inflation of `occupied`, whatever it was before. The two must share a
  /// frame.
  void apply(const OccupancyGrid& occupied, OccupancyGrid& blocked);

 private:
  /// The levels within reach in one of the surrounding columns: dz in [-reach, reach].
  struct Column {
    int dx;
    int dy;
    int reach;
  };

  double radius_;
  std::vector<Column> columns_;         ///< ascending by reach
  std::vector<std::uint64_t> dilated_;  ///< scratch: one column of bits
};

/// The inflation of a whole grid.
OccupancyGrid inflate(const OccupancyGrid& occupied, double radius);

}  // namespace ltp
