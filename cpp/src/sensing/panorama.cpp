// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "panorama.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground_track.hpp"

namespace ltp::sensing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Rays are computed with rounding, and so is the picture. These margins are far above both, and far
// below what would make many a ray look for its hit in vain.
constexpr double kAside = 1e-6;     // by which a wedge is wider [cells]
constexpr double kAbove = 1e-6;     // by which all tops are higher [m]
constexpr double kRelative = 1e-9;  // and by which they are for their size; also of ranges

/// The smallest magnitude in [low, high].
double least(double low, double high) { return std::max({low, -high, 0.0}); }

}  // namespace

bool Panorama::can_look_from(const Raster& heights, const Point& origin) {
  const double x = start_over(heights, origin, 0);
  const double y = start_over(heights, origin, 1);
  return x > 0.0 && x < heights.nx() && y > 0.0 && y < heights.ny();
}

void Panorama::look(const Raster& heights, const Point& origin, double max_range, int columns) {
  columns_ = columns;
  pixels_.resize(std::size_t{4} * columns * kRows);
  for (int side = 0; side < 4; ++side) look_along(heights, origin, max_range, side);
}

void Panorama::look_along(const Raster& heights, const Point& origin, double max_range, int side) {
  const bool along_x = side < 2;
  const int step = side % 2 == 0 ? 1 : -1;
  const double cell = heights.cell();
  const double ahead = start_over(heights, origin, along_x ? 0 : 1);
  const double aside = start_over(heights, origin, along_x ? 1 : 0);
  const int ahead_cells = along_x ? heights.nx() : heights.ny();
  const int aside_cells = along_x ? heights.ny() : heights.nx();
  const std::ptrdiff_t ahead_stride = along_x ? heights.ny() : 1;
  const std::ptrdiff_t aside_stride = along_x ? 1 : heights.ny();

  // The slabs as far as the raster or the maximum range reaches.
  const int first =
      step > 0 ? static_cast<int>(std::floor(ahead)) : static_cast<int>(std::ceil(ahead)) - 1;
  const int to_edge = step > 0 ? ahead_cells - first : first + 1;
  const double in_range = std::min(std::ceil(max_range / cell) + 1.0, kNothing - 1.0);
  const double entered = step > 0 ? first - ahead : ahead - (first + 1);  // not positive
  slabs_.clear();
  for (int slab = 0; slab < std::min<double>(to_edge, in_range); ++slab) {
    const double begin = std::max(entered + slab, 0.0);
    const double end = entered + slab + 1;
    slabs_.push_back({begin, end, 1.0 / (begin * cell), 1.0 / (end * cell)});
  }

  const double* values = heights.values().data() + first * ahead_stride;
  const double square_range = std::pow(max_range / cell, 2) * (1.0 + kRelative);
  for (int column = 0; column < columns_; ++column) {
    const double low = 2.0 * column / columns_ - 1.0;
    const double high = 2.0 * (column + 1) / columns_ - 1.0;
    std::uint16_t* pixels = pixels_.data() + (std::size_t{1} * side * columns_ + column) * kRows;
    const double least_square = 1.0 + std::pow(least(low, high), 2);
    int row = 0;
    double slope = -kInfinity;  // of the steepest ray down in this row
    for (std::size_t n = 0; n < slabs_.size() && row < kRows; ++n) {
      const Slab& slab = slabs_[n];
      const double from = aside - kAside + low * (low < 0.0 ? slab.end : slab.begin);
      const double to = aside + kAside + high * (high > 0.0 ? slab.end : slab.begin);
      const double* line = values + static_cast<std::ptrdiff_t>(n) * step * ahead_stride;
      const int last = to < aside_cells ? static_cast<int>(to) : aside_cells - 1;
      double top = -kInfinity;
      for (int cell_aside = from > 0.0 ? static_cast<int>(from) : 0; cell_aside <= last;
           ++cell_aside) {
        top = std::max(top, line[cell_aside * aside_stride]);
      }
      if (to < 0.0 || top == -kInfinity) break;  // beyond the raster
      const double rise =
          top - origin.z() + kAbove + kRelative * (std::abs(top) + std::abs(origin.z()));
      const double blocked = rise * (rise > 0.0 ? slab.per_begin : slab.per_end);
      while (slope < blocked) {
        const double next_slope = (row + 1) / kRowsPerSlope - kSteepest;
        const double square = least_square + std::pow(least(slope, row + 1 < kRows ? next_slope : kInfinity), 2);
        pixels[row] = slab.begin * slab.begin * square < square_range ? static_cast<std::uint16_t>(n) : kNothing;
        if (++row == kRows) break;
        slope = next_slope;
      }
    }
    std::fill(pixels + row, pixels + kRows, kNothing);
  }
}

}  // namespace ltp::sensing
