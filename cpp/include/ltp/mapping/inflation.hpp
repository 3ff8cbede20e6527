// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Inflation: the cells that come within a radius of something occupied.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/grid/occupancy_grid.hpp"

namespace ltp {

/// Blocks every cell whose closed box is within `radius` [m] of the closed box of a source: an
/// occupied cell, or an occupied part of one. Conservative: no point of a cell left free is that
/// near to any point of a source. So any radius > 0 blocks at least the cells that touch a source;
/// radius 0 blocks those that hold one. Works on whole columns of bits; allocates only when it is
/// made.
class Inflation {
 public:
  /// For all grids with this frame's cells and dims.
  /// @param parts  sources along each edge of a cell, >= 1: their grid has so many times the dims,
  ///               and the same corner. {1, 1, 1}: the sources are cells.
  /// Throws unless `radius` is finite and >= 0. A radius of more than two windows counts as two.
  Inflation(const GridFrame& frame, double radius, const std::array<int, 3>& parts = {1, 1, 1});

  double radius() const { return radius_; }

  /// Blocks in `blocked` the surroundings of one source. Whether that blocked any cell anew.
  bool add(const Cell& source, OccupancyGrid& blocked);
  /// The same for the cells of [low, high) only, which must be inside; the source need not be.
  bool add(const Cell& source, const Cell& low, const Cell& high, OccupancyGrid& blocked);

  /// Makes `blocked` the inflation of `sources`, whatever it was before.
  void apply(const OccupancyGrid& sources, OccupancyGrid& blocked);

  /// The same for the cells of `blocked` in [low, high) only, as far as these are inside.
  void repair(const OccupancyGrid& sources, const Cell& low, const Cell& high,
              OccupancyGrid& blocked);

  /// Makes `blocked` the inflation of `sources` again, if it was before that was rolled by `shift`
  /// cells. Only what lies near the window's faces is looked at.
  void roll(const OccupancyGrid& sources, const Cell& shift, OccupancyGrid& blocked);

  /// How far the inflation of a source reaches along each axis [cells], [sources].
  const Cell& reach() const { return reach_; }
  const Cell& source_reach() const { return source_reach_; }

 private:
  /// The surrounding columns in which the same levels are within reach: sources that are at most
  /// `reach` levels of sources from one of the cell's own.
  struct Ring {
    struct Column {
      int dx;
      int dy;
      int words;  ///< from column to column
    };
    int reach;
    std::vector<Column> columns;
  };

  const std::vector<Ring>& rings_of(int part_x, int part_y) const {
    return rings_[part_x * parts_[1] + part_y];
  }
  std::vector<Ring> rings(int part_x, int part_y, const GridFrame& frame, double within) const;
  /// Puts the levels of a column of sources that lie in [low, high) into `planes_`. Whether any do.
  bool take(const std::uint64_t* column, int low, int high);
  void dilate();
  /// Dilates the levels in `planes_` into the columns round a source column, within [low, high) and
  /// the levels of `inside_`.
  void spread(int source_x, int source_y, const Cell& low, const Cell& high,
              OccupancyGrid& blocked);

  double radius_;
  std::array<int, 3> parts_;
  int words_;  ///< of a column of cells
  Cell reach_ = Cell::Zero();
  Cell source_reach_ = Cell::Zero();
  std::vector<std::vector<Ring>> rings_;  ///< by the source's part of its cell; ascending by reach
  // Scratch, columns of bits.
  std::vector<std::uint64_t> planes_;  ///< word by word, in each the parts of a level, lowest first
  std::vector<std::uint64_t> inside_;
};

/// The inflation of a whole grid of cells.
OccupancyGrid inflate(const OccupancyGrid& occupied, double radius);
/// That of a whole grid of parts of cells: the grid of the cells, `parts` along each edge. Throws
/// `std::invalid_argument` unless its dims, and where its window begins, are multiples of them.
OccupancyGrid inflate(const OccupancyGrid& sources, double radius, const std::array<int, 3>& parts);

}  // namespace ltp
