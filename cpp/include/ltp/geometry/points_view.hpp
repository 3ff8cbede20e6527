// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `PointsView`: points in somebody else's memory, as sensors deliver them.
#pragma once

#include <type_traits>

#include "ltp/geometry/types.hpp"

namespace ltp {

/// Points of float or double coordinates, rows of a C-ordered array of shape (N, 3) or wider: the
/// first three columns are x, y, z [m]. Nothing is copied: the memory must outlive the view.
class PointsView {
 public:
  enum class Scalar { Float, Double };

  PointsView() = default;
  /// @param stride  scalars from row to row, >= 3
  PointsView(const float* data, Eigen::Index rows, Eigen::Index stride = 3)
      : data_(data), rows_(rows), stride_(stride), scalar_(Scalar::Float) {}
  PointsView(const double* data, Eigen::Index rows, Eigen::Index stride = 3)
      : data_(data), rows_(rows), stride_(stride), scalar_(Scalar::Double) {}

  /// Of a `Path`, a `PathRef`, an `Eigen::Map` or a block of rows: row-major, three columns.
  template <typename Rows,
            typename = std::enable_if_t<Rows::ColsAtCompileTime == 3 && Rows::IsRowMajor>>
  PointsView(const Eigen::MatrixBase<Rows>& points)  // NOLINT: implicit, as `PathRef` is
      : PointsView(points.derived().data(), points.rows(), points.derived().outerStride()) {}

  Eigen::Index rows() const { return rows_; }
  Eigen::Index stride() const { return stride_; }  ///< scalars from row to row
  Scalar scalar() const { return scalar_; }

  /// The first coordinate of the first point, if they are of that type.
  template <typename Number>
  const Number* data() const {
    return static_cast<const Number*>(data_);
  }

  Point operator[](Eigen::Index row) const {
    return scalar_ == Scalar::Float ? at(data<float>() + row * stride_)
                                    : at(data<double>() + row * stride_);
  }

 private:
  template <typename Number>
  static Point at(const Number* xyz) {
    return Point(xyz[0], xyz[1], xyz[2]);
  }

  const void* data_ = nullptr;
  Eigen::Index rows_ = 0;
  Eigen::Index stride_ = 3;
  Scalar scalar_ = Scalar::Double;
};

}  // namespace ltp
