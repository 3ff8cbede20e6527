// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Panorama`: what can be seen from a point over a height raster, roughly but never too far away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "ltp/grid/raster.hpp"

namespace ltp::sensing {

/// A picture of the surroundings on the four sides of an upright box round the point of view, like
/// the sides of a cube map. A side looks along one axis of the raster, its columns are headings,
/// its rows slopes. A pixel holds the first slab of cells (counted along the side's axis, from the
/// point of view) in which any ray through it can be below a top; rays need not be looked for
/// before. Made by one sweep of the horizon for each column, over the highest of all cells that
/// its wedge meets: a column's blocked slopes only grow.
class Panorama {
 public:
  static constexpr std::uint16_t kNothing = 0xffff;

  /// Whether a point has its cell in the raster, walls excepted.
  static bool can_look_from(const Raster& heights, const Point& origin);

  /// @param columns  of each side, even
  /// Needs `can_look_from`; memory is reused.
  void look(const Raster& heights, const Point& origin, double max_range, int columns);

  /// Where a ray can first hit.
  struct Glance {
    bool along_x;  ///< the side's axis
    int slab;      ///< cells from the point of view's
  };
  /// False if nowhere within the maximum range.
  bool glance(const Point& direction, Glance& out) const {
    const double ahead_x = std::abs(direction.x());
    const double ahead_y = std::abs(direction.y());
    out.along_x = ahead_x >= ahead_y;
    const double ahead = out.along_x ? direction.x() : direction.y();
    const double aside = out.along_x ? direction.y() : direction.x();
    const double stretch = 1.0 / std::max(std::abs(ahead), kSteep);
    const double column = std::min((aside * stretch + 1.0) * columns_per_heading_, last_column_);
    const double row =
        std::min(std::max((direction.z() * stretch + kSteepest) * kRowsPerSlope, 0.0), kRows - 1.0);
    const int side = (out.along_x ? 0 : 2) + (ahead < 0.0 ? 1 : 0);
    const std::size_t pixel =
        (static_cast<std::size_t>(side) * columns_ + static_cast<int>(column)) * kRows +
        static_cast<int>(row);
    const std::uint16_t slab = slabs_[pixel];
    out.slab = slab;
    return slab != kNothing && near_[side][slab] * stretch < max_range_;
  }

 private:
  static constexpr double kSteep = 1e-9;  // a ray that goes less ahead goes up or down
  static constexpr double kSteepest = 2.0;  // slope of the outer rows, which hold all beyond, too
  static constexpr int kRows = 128;
  static constexpr double kRowsPerSlope = kRows / (2.0 * kSteepest);

  /// One side: its axis, and which way it looks along it.
  void look_along(const Raster& heights, const Point& origin, int side, int slabs);

  int columns_ = 0;
  double columns_per_heading_ = 0.0;
  double last_column_ = 0.0;
  double max_range_ = 0.0;
  std::vector<std::uint16_t> slabs_;          ///< by side, column, row
  std::array<std::vector<double>, 4> near_;   ///< by side: where each slab begins [m]
  std::vector<double> far_;                   ///< where each slab ends [m]
};

}  // namespace ltp::sensing
