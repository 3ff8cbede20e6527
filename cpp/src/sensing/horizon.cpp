// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "horizon.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ground_track.hpp"

namespace ltp::sensing {
namespace {

// Rays are computed with rounding, and so is the horizon. These margins are far above both, and far
// below what would make many a ray look for its hit in vain.
constexpr double kAside = 1e-6;     // by which a wedge is wider [cells]
constexpr double kAbove = 1e-6;     // by which all tops are higher [m]
constexpr double kRelative = 1e-9;  // and by which they are for their size

double slabs_in_range(const Raster& heights, double max_range) {
  return std::ceil(max_range / heights.cell()) + 1.0;
}

}  // namespace

bool Horizon::can_look(const Raster& heights, const Point& origin, double max_range,
                       double most_slabs) {
  const double x = start_over(heights, origin, 0);
  const double y = start_over(heights, origin, 1);
  const double in_range =
      std::min<double>(max_range / heights.cell(), std::max(heights.nx(), heights.ny()));
  return in_range <= most_slabs && x > 0.0 && x < heights.nx() && y > 0.0 && y < heights.ny();
}

void Horizon::look(const Raster& heights, const Point& origin, double max_range, int columns) {
  columns_ = columns;
  const double most_slabs = std::min(slabs_in_range(heights, max_range),
                                     static_cast<double>(std::max(heights.nx(), heights.ny())));
  blocked_.clear();
  blocked_.reserve(std::size_t{4} * kMostColumns * static_cast<std::size_t>(most_slabs));
  for (std::vector<Slab>& slabs : slabs_) slabs.reserve(static_cast<std::size_t>(most_slabs));
  for (int side = 0; side < 4; ++side) look_along(heights, origin, max_range, side);
}

void Horizon::look_along(const Raster& heights, const Point& origin, double max_range, int side) {
  const bool along_x = side < 2;
  const int step = side % 2 == 0 ? 1 : -1;
  const double cell = heights.cell();
  const TrackStart ahead(heights, origin, along_x ? 0 : 1);
  const TrackStart aside(heights, origin, along_x ? 1 : 0);
  const std::ptrdiff_t ahead_stride = along_x ? heights.ny() : 1;
  const std::ptrdiff_t aside_stride = along_x ? 1 : heights.ny();

  const int first = ahead.first_cell(step);
  const double to_edge = step > 0 ? ahead.cells - first : first + 1;
  const double in_range = slabs_in_range(heights, max_range);
  const double entered = step > 0 ? first - ahead.start : ahead.start - (first + 1);  // <= 0
  std::vector<Slab>& slabs = slabs_[side];
  slabs.clear();
  for (int n = 0; n < std::min(to_edge, in_range); ++n) {
    const double begin = std::max(entered + n, 0.0);
    const double end = entered + n + 1;
    slabs.push_back({begin, end, 1.0 / (begin * cell), 1.0 / (end * cell)});
  }

  offsets_[side] = blocked_.size();
  blocked_.resize(blocked_.size() + columns_ * slabs.size());
  double* blocked = blocked_.data() + offsets_[side];
  for (int column = 0; column < columns_; ++column) {
    const double low = 2.0 * column / columns_ - 1.0;
    const double high = 2.0 * (column + 1) / columns_ - 1.0;
    const double* line = heights.values().data() + first * ahead_stride;
    for (const Slab& slab : slabs) {
      const double from = aside.start - kAside + low * (low < 0.0 ? slab.end : slab.begin);
      const double to = aside.start + kAside + high * (high > 0.0 ? slab.end : slab.begin);
      const int begin = from > 0.0 ? static_cast<int>(from) : 0;
      const int end = to < 0.0 ? 0 : to < aside.cells ? static_cast<int>(to) + 1 : aside.cells;
      double top = std::numeric_limits<double>::lowest();  // beyond the raster
      for (int n = begin; n < end; ++n) top = std::max(top, line[n * aside_stride]);
      const double rise =
          top - origin.z() + kAbove + kRelative * (std::abs(top) + std::abs(origin.z()));
      *blocked++ = rise * (rise > 0.0 ? slab.per_begin : slab.per_end);
      line += step * ahead_stride;
    }
  }
}

}  // namespace ltp::sensing
