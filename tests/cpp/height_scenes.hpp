// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Random height rasters, and slow and obvious answers: every column is a box, try them all.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "ltp/sensing/height_surface.hpp"

namespace ltp::test {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kPi = 3.141592653589793;

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return low + (high - low) * (random() >> 11) * 0x1p-53;
}

inline Point random_direction(Random& random) {
  while (true) {
    const Point v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    if (v.norm() > 0.1 && v.norm() < 1.0) return v.normalized();
  }
}

/// Ground, blocks and single poles; a third of the heights are exact multiples of 4 m.
inline Raster random_city(Random& random, int nx, int ny, const Eigen::Vector2d& origin,
                          double cell) {
  Raster::Values values = Raster::Values::Zero(nx, ny);
  const auto height = [&] {
    const double h = uniform(random, -8, 30);
    return random() % 3 == 0 ? 4.0 * std::round(h / 4.0) : h;
  };
  for (int block = 0; block < nx * ny / 24; ++block) {
    const int i = static_cast<int>(random() % nx);
    const int j = static_cast<int>(random() % ny);
    const int di = std::min<int>(1 + random() % 5, nx - i);
    const int dj = std::min<int>(1 + random() % 5, ny - j);
    values.block(i, j, di, dj) = height();
  }
  for (int pole = 0; pole < nx; ++pole) values(random() % nx, random() % ny) = height();
  return Raster(values, origin, cell);
}

/// When a + t * d lies in the half-open [low, high).
inline std::pair<double, double> slab(double a, double d, double low, double high) {
  if (d == 0.0) {
    return a >= low && a < high ? std::pair(-kInfinity, kInfinity) : std::pair(1.0, -1.0);
  }
  return std::minmax((low - a) / d, (high - a) / d);
}

/// How far a point lies inside the column that holds it: from its top and its walls [m].
inline double depth_in_column(const Raster& heights, const Point& point) {
  const int i = heights.index_of(0, point.x());
  const int j = heights.index_of(1, point.y());
  const double x = point.x() - (heights.origin().x() + i * heights.cell());
  const double y = point.y() - (heights.origin().y() + j * heights.cell());
  return std::min({x, y, heights.cell() - x, heights.cell() - y, heights(i, j) - point.z()});
}

/// The slow answer: the nearest of all columns whose interior the ray enters.
inline double slow_range(const Raster& heights, const Point& origin, const Point& direction,
                         double max_range) {
  double nearest = kInfinity;
  for (int i = 0; i < heights.nx(); ++i) {
    for (int j = 0; j < heights.ny(); ++j) {
      const double x = heights.origin().x() + i * heights.cell();
      const double y = heights.origin().y() + j * heights.cell();
      const auto [x_in, x_out] = slab(origin.x(), direction.x(), x, x + heights.cell());
      const auto [y_in, y_out] = slab(origin.y(), direction.y(), y, y + heights.cell());
      const auto [z_in, z_out] = slab(origin.z(), direction.z(), -1e9, heights(i, j));
      const double t_in = std::max({0.0, x_in, y_in, z_in});
      if (t_in < std::min({x_out, y_out, z_out})) nearest = std::min(nearest, t_in);
    }
  }
  return nearest < max_range ? nearest : kInfinity;
}

/// The slow answer for a closed solid: the smallest t in [0, 1] of a + t * (b - a) in any box.
inline double slow_touch(const Raster& heights, const Point& a, const Point& b) {
  const Point d = b - a;
  const auto closed = [&](int axis, double low, double high) {
    if (d[axis] != 0.0) return slab(a[axis], d[axis], low, high);
    return a[axis] >= low && a[axis] <= high ? std::pair(-kInfinity, kInfinity)
                                             : std::pair(1.0, -1.0);
  };
  double first = kInfinity;
  for (int i = 0; i < heights.nx(); ++i) {
    for (int j = 0; j < heights.ny(); ++j) {
      const double x = heights.origin().x() + i * heights.cell();
      const double y = heights.origin().y() + j * heights.cell();
      const auto [x_in, x_out] = closed(0, x, x + heights.cell());
      const auto [y_in, y_out] = closed(1, y, y + heights.cell());
      const auto [z_in, z_out] = closed(2, -1e9, heights(i, j));
      const double t_in = std::max({0.0, x_in, y_in, z_in});
      if (t_in <= std::min({1.0, x_out, y_out, z_out})) first = std::min(first, t_in);
    }
  }
  return first;
}

inline double slow_clearance(const Raster& heights, const Point& point, double max_distance) {
  double nearest = max_distance;
  for (int i = 0; i < heights.nx(); ++i) {
    for (int j = 0; j < heights.ny(); ++j) {
      const Point low(heights.origin().x() + i * heights.cell(),
                      heights.origin().y() + j * heights.cell(), -1e9);
      const Point high(low.x() + heights.cell(), low.y() + heights.cell(), heights(i, j));
      nearest = std::min(nearest, (point - point.cwiseMax(low).cwiseMin(high)).norm());
    }
  }
  return nearest;
}

inline Path path(const std::vector<Point>& points) {
  Path rows(points.size(), 3);
  for (std::size_t n = 0; n < points.size(); ++n) rows.row(n) = points[n].transpose();
  return rows;
}

/// A point in, above, below or beside a raster.
inline Point random_point(Random& random, const Raster& heights) {
  const double width = heights.nx() * heights.cell();
  const double depth = heights.ny() * heights.cell();
  return {heights.origin().x() + uniform(random, -0.3, 1.3) * width,
          heights.origin().y() + uniform(random, -0.3, 1.3) * depth, uniform(random, -12, 40)};
}

/// 4 x 4 cells of 1 m; cell (2, 1) is 5 m high, the rest lies at 0.
inline HeightSurface tower() {
  Raster::Values values = Raster::Values::Zero(4, 4);
  values(2, 1) = 5.0;
  return HeightSurface(Raster(values, {0, 0}, 1.0));
}

}  // namespace ltp::test
