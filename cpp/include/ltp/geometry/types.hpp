// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The few geometric types that every floor shares. World frame: ENU, metres, z up.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace ltp {

using Point = Eigen::Vector3d;

/// A polyline or a point set, one point a row, shape (N, 3), row-major [m].
using Path = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using PathRef = Eigen::Ref<const Path>;

/// Where a body is and how it is turned.
struct Pose {
  Point position = Point::Zero();                                       ///< in the world [m]
  Eigen::Quaterniond world_from_body = Eigen::Quaterniond::Identity();  ///< unit quaternion
};

}  // namespace ltp
