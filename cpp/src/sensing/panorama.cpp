// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "panorama.hpp"

#include <limits>

#include "ground_track.hpp"

namespace ltp::sensing {
namespace {

// Rays are computed with rounding, and so is the picture. These margins are far above both, and far
// below what would make a ray look for its hit in vain.
constexpr double kAside = 1e-6;     // by which a wedge is wider [cells]
constexpr double kAbove = 1e-6;     // by which all tops are higher [m]
constexpr double kRelative = 1e-9;  // by which they are higher for their size, and ranges longer

}  // namespace

bool Panorama::can_look_from(const Raster& heights, const Point& origin) {
  const double x = start_over(heights, origin, 0);
  const double y = start_over(heights, origin, 1);
  return x > 0.0 && x < heights.nx() && y > 0.0 && y < heights.ny();
}

void Panorama::look(const Raster& heights, const Point& origin, double max_range, int columns) {
  columns_ = columns;
  columns_per_heading_ = 0.5 * columns;
  last_column_ = columns - 1.0;
  max_range_ = max_range * (1.0 + kRelative);
  slabs_.resize(std::size_t{4} * columns * kRows);
  const double reach = std::ceil(max_range / heights.cell()) + 2.0;
  const int slabs = static_cast<int>(std::min(reach, kNothing - 1.0));
  for (int side = 0; side < 4; ++side) look_along(heights, origin, side, slabs);
}

void Panorama::look_along(const Raster& heights, const Point& origin, int side, int slabs) {
  const bool along_x = side < 2;
  const int step = side % 2 == 0 ? 1 : -1;
  const double cell = heights.cell();
  const double ahead = start_over(heights, origin, along_x ? 0 : 1);
  const double aside = start_over(heights, origin, along_x ? 1 : 0);
  const int ahead_cells = along_x ? heights.nx() : heights.ny();
  const int aside_cells = along_x ? heights.ny() : heights.nx();
  const std::ptrdiff_t ahead_stride = along_x ? heights.ny() : 1;
  const std::ptrdiff_t aside_stride = along_x ? 1 : heights.ny();

  // The slabs up to the raster's edge, and where each begins and ends.
  const int first = step > 0 ? static_cast<int>(std::floor(ahead))
                             : static_cast<int>(std::ceil(ahead)) - 1;
  const int count = std::min(slabs, step > 0 ? ahead_cells - first : first + 1);
  const double entered = step > 0 ? first - ahead : ahead - (first + 1);  // not positive
  std::vector<double>& near = near_[side];
  near.resize(count);
  far_.resize(count);
  for (int slab = 0; slab < count; ++slab) {
    near[slab] = std::max(entered + slab, 0.0) * cell;
    far_[slab] = (entered + slab + 1) * cell;
  }

  const double* values = heights.values().data() + first * ahead_stride;
  for (int column = 0; column < columns_; ++column) {
    const double low = column / columns_per_heading_ - 1.0;
    const double high = (column + 1) / columns_per_heading_ - 1.0;
    std::uint16_t* pixels =
        slabs_.data() + (static_cast<std::size_t>(side) * columns_ + column) * kRows;
    int row = 0;
    // The outer row holds all steeper rays as well.
    double slope = -std::numeric_limits<double>::infinity();
    for (int slab = 0; slab < count && row < kRows; ++slab) {
      const double* line = values + slab * step * ahead_stride;
      const double begin = near[slab] / cell;
      const double end = far_[slab] / cell;
      const double from = aside - kAside + low * (low < 0.0 ? end : begin);
      const double to = aside + kAside + high * (high > 0.0 ? end : begin);
      const int last = to < aside_cells ? static_cast<int>(to) : aside_cells - 1;
      double top = -std::numeric_limits<double>::infinity();
      for (int n = from > 0.0 ? static_cast<int>(from) : 0; n <= last; ++n) {
        top = std::max(top, line[n * aside_stride]);
      }
      // Steeper than this, and a ray is above all of them.
      const double rise =
          top - origin.z() + kAbove + kRelative * (std::abs(top) + std::abs(origin.z()));
      const double blocked = rise / (rise > 0.0 ? near[slab] : far_[slab]);
      while (slope < blocked) {
        pixels[row] = static_cast<std::uint16_t>(slab);
        if (++row == kRows) break;
        slope = row / kRowsPerSlope - kSteepest;
      }
    }
    std::fill(pixels + row, pixels + kRows, kNothing);
  }
}

}  // namespace ltp::sensing
