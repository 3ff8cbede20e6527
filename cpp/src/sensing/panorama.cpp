// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "panorama.hpp"

#include <limits>

namespace ltp::sensing {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRelative = 1e-9;  // by which the maximum range is longer, for rounding's sake

/// The least square in [low, high].
double least_square(double low, double high) {
  const double least = std::max({low, -high, 0.0});
  return least * least;
}

}  // namespace

Panorama& Panorama::of_this_thread() {
  static thread_local Panorama panorama;
  return panorama;
}

void Panorama::look(const Raster& heights, const Point& origin, double max_range, int columns) {
  horizon_.look(heights, origin, max_range, columns);
  const double range = max_range / heights.cell();
  std::uint16_t* pixels = pixels_.data();
  for (int side = 0; side < 4; ++side) {
    for (int column = 0; column < columns; ++column, pixels += kRows) {
      draw(side, column, range * range * (1.0 + kRelative), pixels);
    }
  }
}

void Panorama::draw(int side, int column, double square_range, std::uint16_t* pixels) const {
  const std::vector<Horizon::Slab>& slabs = horizon_.slabs(side);
  const double* blocked = horizon_.blocked(side, column);
  const double aside = least_square(2.0 * column / horizon_.columns() - 1.0,
                                    2.0 * (column + 1) / horizon_.columns() - 1.0);
  int row = 0;
  double slope = -kInfinity;  // the lowest of the row: the outer rows hold all beyond as well
  for (std::size_t slab = 0; slab < slabs.size() && row < kRows; ++slab) {
    while (slope < blocked[slab] && row < kRows) {
      const double next = ++row < kRows ? row / kRowsPerSlope - kSteepest : kInfinity;
      const double begin = slabs[slab].begin;
      const bool near = begin * begin * (1.0 + aside + least_square(slope, next)) < square_range;
      *pixels++ = near ? static_cast<std::uint16_t>(slab) : kNothing;
      slope = next;
    }
  }
  std::fill_n(pixels, kRows - row, kNothing);
}

}  // namespace ltp::sensing
