// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Horizon`: which slopes can be blocked at which distance, all round a point over a height raster.
#pragma once

#include <array>
#include <vector>

#include "ltp/grid/raster.hpp"

namespace ltp::sensing {

/// The surroundings on the four sides of an upright box round the point of view, like the sides of
/// a cube map: a side looks along one axis of the raster, its columns are headings. What a column's
/// wedge meets is cut into slabs of cells across the side's axis, counted from the point of view's.
/// For each slab the horizon knows the slope below which a ray can be below the highest of all
/// cells that the wedge meets there; a ray at or above it is certain to pass.
class Horizon {
 public:
  /// The cells between two lines across a side's axis.
  struct Slab {
    double begin;      ///< from the point of view [cells]
    double end;        ///< [cells]
    double per_begin;  ///< slope to the near line, for each metre of height [1/m]
    double per_end;    ///< slope to the far line, for each metre of height [1/m]
  };

  /// Whether a point lies over the raster, its edges excepted, and no more than so many slabs are
  /// in range: all cells within are read, which only pays for as many rays.
  static bool can_look(const Raster& heights, const Point& origin, double max_range,
                       double most_slabs);

  static constexpr int kMostColumns = 64;
  /// @param columns  of each side, even, at most `kMostColumns`
  /// Needs `can_look`. Memory is reused; for the same range it suffices whatever is looked at.
  void look(const Raster& heights, const Point& origin, double max_range, int columns);

  /// The side that a ray goes through: 0, 1: up, down the x axis, 2, 3: the y axis.
  static int side(bool along_x, bool down) { return (along_x ? 0 : 2) + (down ? 1 : 0); }

  int columns() const { return columns_; }
  /// As far as the raster or the maximum range reaches.
  const std::vector<Slab>& slabs(int side) const { return slabs_[side]; }
  /// One slope a slab, metres up per metre along the side's axis.
  const double* blocked(int side, int column) const {
    return blocked_.data() + offsets_[side] + column * slabs_[side].size();
  }

 private:
  void look_along(const Raster& heights, const Point& origin, double max_range, int side);

  int columns_ = 0;
  std::array<std::vector<Slab>, 4> slabs_;
  std::array<std::size_t, 4> offsets_;  ///< of the sides in `blocked_`
  std::vector<double> blocked_;         ///< by side, column, slab
};

}  // namespace ltp::sensing
