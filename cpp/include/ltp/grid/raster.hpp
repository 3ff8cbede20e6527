// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Raster`: a scalar field over the ground - heights or priority - constant on each square cell.
#pragma once

#include <cstdint>
#include <vector>

#include "ltp/geometry/types.hpp"

namespace ltp {

/// Values on a regular grid of squares; cell (i, j) covers [origin + (i, j) * cell, + cell). Axis 0
/// is x (east), axis 1 is y (north). Outside the raster the field has the value `outside`.
class Raster {
 public:
  using Values = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

  /// @param values   shape (nx, ny), finite
  /// @param origin   lowest corner of cell (0, 0), world [m]
  /// @param cell     edge length [m], positive
  /// @param outside  the value beyond the edges
  Raster(Values values, const Eigen::Vector2d& origin, double cell, double outside = 0.0);

  int nx() const { return static_cast<int>(values_.rows()); }
  int ny() const { return static_cast<int>(values_.cols()); }
  const Eigen::Vector2d& origin() const { return origin_; }
  double cell() const { return cell_; }
  double outside() const { return outside_; }
  const Values& values() const { return values_; }
  double minimum() const { return minimum_; }  ///< over the raster and `outside`
  double maximum() const { return maximum_; }  ///< over the raster and `outside`

  /// Unlike that of any other raster but copies: what was computed from it can be kept.
  std::uint64_t id() const { return id_; }

  /// Whether cell (i, j) is inside, and its value (`outside` if it is not).
  bool contains(int i, int j) const {
    return static_cast<unsigned>(i) < static_cast<unsigned>(nx()) &&
           static_cast<unsigned>(j) < static_cast<unsigned>(ny());
  }
  double operator()(int i, int j) const { return contains(i, j) ? values_(i, j) : outside_; }

  /// The index along one axis (0: x, 1: y) of the cell that holds a coordinate [m]; saturates far
  /// away.
  int index_of(int axis, double coordinate) const;

  /// The value of the cell that holds (x, y).
  double at(double x, double y) const { return (*this)(index_of(0, x), index_of(1, y)); }
  /// Bilinear interpolation between cell centres; constant beyond the outermost centres, `outside`
  /// beyond the edges.
  double bilinear(double x, double y) const;

  /// The integral of the field along the segment a-b, per metre of its 3-D length: exact, cell by
  /// cell.
  double integral(const Point& a, const Point& b) const;

 private:
  Values values_;
  Eigen::Vector2d origin_;
  double cell_;
  double outside_;
  double minimum_;
  double maximum_;
  std::uint64_t id_;
};

}  // namespace ltp
