// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/sight.hpp"

#include <algorithm>
#include <cmath>

namespace ltp::planning {
namespace {

// Lines that far from the raster, or with so many of its cells under them, are left to the exact
// walk, which clips them [cells].
constexpr double kFar = 1e6;
constexpr double kEdge = 1e-6;  // [cells]

int floor_of(double value) {
  const int cut = static_cast<int>(value);
  return cut - (value < cut);
}

/// The cell below a coordinate, clipped to [-1, count].
int index_of(double coordinate, int count) {
  return floor_of(std::clamp(coordinate, -1.0, static_cast<double>(count)));
}

}  // namespace

Sight::Sight(const OccupancyGrid& grid, const LevelRange& levels, const Raster& priority,
             const AltitudeRange& altitudes)
    : grid_(grid),
      priority_(priority),
      origin_(grid.frame().origin()),
      per_metre_(grid.frame().cell().cwiseInverse()),
      lowest_(0.0, 0.0, levels.lowest),
      highest_(grid.frame().nx(), grid.frame().ny(), levels.highest + 1.0) {
  const double low = cells(Point(0.0, 0.0, altitudes.lowest)).z();
  const double high = cells(Point(0.0, 0.0, altitudes.highest)).z();
  // An end may lie on its level's floor, and the whole path with it.
  const bool from_its_floor = low >= lowest_.z();
  lowest_.array() += kEdge;
  highest_.array() -= kEdge;
  lowest_.z() = from_its_floor ? low : lowest_.z();
  highest_.z() = std::min(high, highest_.z());
}

/// Whether the levels `low` to `high` of a column in the window are free.
bool Sight::free(int ix, int iy, int low, int high) const {
  const std::uint64_t* column = grid_.column(ix, iy);
  for (int word = low >> 6; word <= high >> 6; ++word) {
    std::uint64_t bits = column[word];
    if (word == low >> 6) bits &= ~std::uint64_t{0} << (low & 63);
    if (word == high >> 6) bits &= ~std::uint64_t{0} >> (63 - (high & 63));
    if (bits != 0) return false;
  }
  return true;
}

/// Whether the cells that a box meets [cells] are free.
bool Sight::box_free(const Point& low, const Point& high) const {
  const GridFrame& frame = grid_.frame();
  const int iz0 = std::max(0, index_of(low.z(), frame.nz()));
  const int iz1 = std::min(frame.nz() - 1, index_of(high.z(), frame.nz()));
  if (iz0 > iz1) return true;
  const int ix1 = std::min(frame.nx() - 1, index_of(high.x(), frame.nx()));
  const int iy1 = std::min(frame.ny() - 1, index_of(high.y(), frame.ny()));
  for (int ix = std::max(0, index_of(low.x(), frame.nx())); ix <= ix1; ++ix) {
    for (int iy = std::max(0, index_of(low.y(), frame.ny())); iy <= iy1; ++iy) {
      if (!free(ix, iy, iz0, iz1)) return false;
    }
  }
  return true;
}

bool Sight::inside(const Point& point) const {
  const Point at = cells(point);
  return (at.array() >= lowest_.array()).all() && (at.array() <= highest_.array()).all();
}

bool Sight::clear(const Point& a, const Point& b, double margin_a, double margin_b) const {
  // The box's two corners, from where it begins, and how they move.
  const Point from = cells(a);
  const Point to = cells(b);
  Point low = from.array() - margin_a;
  Point high = from.array() + margin_a;
  Point low_way = (to.array() - margin_b).matrix() - low;
  Point high_way = (to.array() + margin_b).matrix() - high;
  const Point way = to - from;
  const int major = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
  const int minor = 1 - major;
  if (way[major] < 0.0) {
    low += low_way;
    high += high_way;
    low_way = -low_way;
    high_way = -high_way;
  }
  if (!(low_way[major] > 1e-6 && high_way[major] > 1e-6)) {  // it hardly moves: one box about all
    return box_free(low.cwiseMin(low + low_way), high.cwiseMax(high + high_way));
  }
  const GridFrame& frame = grid_.frame();
  const int count = frame.dims()[major];
  const double per_low = 1.0 / low_way[major];
  const double per_high = 1.0 / high_way[major];
  const int last = std::min(count - 1, index_of(high[major] + high_way[major], count));
  for (int layer = std::max(0, index_of(low[major], count)); layer <= last; ++layer) {
    // The part of the way on which the box meets the layer; then all that it meets there.
    const double in = std::clamp((layer - high[major]) * per_high, 0.0, 1.0);
    const double out = std::clamp((layer + 1 - low[major]) * per_low, 0.0, 1.0);
    const auto least = [&](int axis) {
      return low[axis] + std::min(in * low_way[axis], out * low_way[axis]);
    };
    const auto most = [&](int axis) {
      return high[axis] + std::max(in * high_way[axis], out * high_way[axis]);
    };
    const int iz0 = std::max(0, index_of(least(2), frame.nz()));
    const int iz1 = std::min(frame.nz() - 1, index_of(most(2), frame.nz()));
    if (iz0 > iz1) continue;
    const int side = frame.dims()[minor];
    const int last_side = std::min(side - 1, index_of(most(minor), side));
    for (int i = std::max(0, index_of(least(minor), side)); i <= last_side; ++i) {
      if (!(major == 0 ? free(layer, i, iz0, iz1) : free(i, layer, iz0, iz1))) return false;
    }
  }
  return true;
}

double Sight::priority(const Point& a, const Point& b) const {
  const double length = (b - a).norm();
  const double per_metre = 1.0 / priority_.cell();
  Eigen::Vector2d from = (a.head<2>() - priority_.origin()) * per_metre;
  Eigen::Vector2d way = (b.head<2>() - a.head<2>()) * per_metre;
  if (!(from.cwiseAbs().maxCoeff() + way.cwiseAbs().maxCoeff() < kFar)) {
    return priority_.integral(a, b);
  }
  const int major = std::abs(way.x()) >= std::abs(way.y()) ? 0 : 1;
  const int minor = 1 - major;
  if (way[major] < 0.0) {
    from += way;
    way = -way;
  }
  const auto value = [&](int layer, int side) {
    return major == 0 ? priority_(layer, side) : priority_(side, layer);
  };
  int layer = floor_of(from[major]);
  int side = floor_of(from[minor]);
  if (way[major] < 1e-9) return value(layer, side) * length;  // straight up
  const double inverse = 1.0 / way[major];
  const double slope = way[minor] * inverse;
  const double inverse_slope = slope != 0.0 ? 1.0 / slope : 0.0;
  const double end = from[major] + way[major];
  double sum = 0.0;
  for (double at = from[major]; at < end; ++layer) {
    const double next = std::min(end, layer + 1.0);
    const int next_side = floor_of(from[minor] + slope * (next - from[major]));
    while (side != next_side) {  // at a slope of at most 1, a layer has one such face, or two
      const int up = next_side > side ? 1 : 0;
      const double face = from[major] + (side + up - from[minor]) * inverse_slope;
      const double cross = std::clamp(face, at, next);
      sum += (cross - at) * value(layer, side);
      at = cross;
      side += 2 * up - 1;
    }
    sum += (next - at) * value(layer, side);
    at = next;
  }
  return sum * inverse * length;
}

}  // namespace ltp::planning
