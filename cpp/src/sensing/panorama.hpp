// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Panorama`: what can be seen from a point over a height raster, roughly but never too far away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "horizon.hpp"

namespace ltp::sensing {

/// A picture of the surroundings: each column of a `Horizon`, its rows being slopes. A pixel holds
/// the first slab in which any ray through it can be below a top, so that no ray need be walked
/// before. The slopes that a column blocks only grow from slab to slab: one sweep draws it.
class Panorama {
 public:
  static constexpr std::uint16_t kNothing = 0xffff;
  static constexpr double kMostSlabs = 65000.0;  ///< that a pixel can tell apart

  /// One for each thread, so that memory is taken once.
  static Panorama& of_this_thread();

  /// What it is drawn from; also to be used without a picture.
  Horizon& horizon() { return horizon_; }

  /// As `Horizon::look`.
  void look(const Raster& heights, const Point& origin, double max_range, int columns);

  /// Rays by component, as many as a cache likes, and what was found for them.
  struct Rays {
    static constexpr int kMost = 256;
    std::array<double, kMost> x;  ///< of the direction, a unit vector
    std::array<double, kMost> y;
    std::array<double, kMost> z;
    std::array<int, kMost> pixel;           ///< that each goes through
    std::array<int, kMost> near;            ///< those that may hit within the maximum range,
    std::array<std::uint16_t, kMost> slab;  ///< and where the first of them may, the second, ...
  };
  /// Looks where the first `count` rays can hit; how many of them can. Inlined, to be compiled for
  /// what the caller is compiled for.
  __attribute__((always_inline)) int glance(Rays& rays, int count) const;

 private:
  static constexpr double kSteep = 1e-9;  // a ray that goes less ahead goes straight up or down
  static constexpr double kSteepest =
      2.0;  // slope of the outer rows, which hold all beyond as well
  static constexpr int kRows = 256;
  static constexpr double kRowsPerSlope = kRows / (2.0 * kSteepest);

  /// Draws a column.
  void draw(int side, int column, double square_range, std::uint16_t* pixels) const;

  Horizon horizon_;
  /// By side, column, row.
  std::vector<std::uint16_t> pixels_ =
      std::vector<std::uint16_t>(std::size_t{4} * Horizon::kMostColumns * kRows);
};

inline int Panorama::glance(Rays& rays, int count) const {
  const double columns_per_slope = 0.5 * horizon_.columns();
  const double last_column = horizon_.columns() - 1.0;
  const int up = horizon_.columns() * kRows;
  for (int n = 0; n < count; ++n) {
    const double x = std::abs(rays.x[n]);
    const double y = std::abs(rays.y[n]);
    const bool along_x = x >= y;
    const double ahead = along_x ? rays.x[n] : rays.y[n];
    const double aside = along_x ? rays.y[n] : rays.x[n];
    const double stretch = 1.0 / std::max(std::max(x, y), kSteep);
    const double column = std::min((aside * stretch + 1.0) * columns_per_slope, last_column);
    const double row = (rays.z[n] * stretch + kSteepest) * kRowsPerSlope;
    rays.pixel[n] = static_cast<int>(column) * kRows +
                    static_cast<int>(std::min(std::max(row, 0.0), kRows - 1.0)) +
                    (along_x ? 0 : 2 * up) + (ahead < 0.0 ? up : 0);
  }
  int found = 0;
  for (int n = 0; n < count; ++n) {
    const std::uint16_t slab = pixels_[rays.pixel[n]];
    rays.near[found] = n;
    rays.slab[found] = slab;
    found += slab != kNothing;
  }
  return found;
}

}  // namespace ltp::sensing
