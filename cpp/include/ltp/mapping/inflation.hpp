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
  void add(const Cell& occupied, OccupancyGrid& blocked);

  /// Makes `blocked` the inflation of `occupied`, whatever it was before. The two must share a
  /// frame.
  void apply(const OccupancyGrid& occupied, OccupancyGrid& blocked);

  /// The same for the cells of `blocked` in [low, high) only, as far as these are inside.
  void repair(const OccupancyGrid& occupied, const Cell& low, const Cell& high,
              OccupancyGrid& blocked);

  /// Makes `blocked` the inflation of `occupied` again, if it was before that was rolled by
  /// `shift`. Only what lies near the window's faces is looked at.
  void roll(const OccupancyGrid& occupied, const Cell& shift, OccupancyGrid& blocked);

  /// How far the inflation of a cell reaches along each axis [cells].
  const Cell& reach() const { return reach_; }

 private:
  /// The surrounding columns in which the same levels are within reach: dz in [-reach, reach].
  struct Ring {
    struct Column {
      int dx;
      int dy;
      int words;  ///< from column to column
    };
    int reach;
    std::vector<Column> columns;
  };

  /// Dilates the levels in `dilated_` into the columns round (ix, iy), within [low, high) and the
  /// levels of `inside_`.
  void spread(int ix, int iy, const Cell& low, const Cell& high, OccupancyGrid& blocked);

  double radius_;
  Cell reach_ = Cell::Zero();
  std::vector<Ring> rings_;  ///< ascending by reach
  // Scratch, one column of bits each.
  std::vector<std::uint64_t> dilated_;
  std::vector<std::uint64_t> inside_;
};

/// The inflation of a whole grid.
OccupancyGrid inflate(const OccupancyGrid& occupied, double radius);

}  // namespace ltp
