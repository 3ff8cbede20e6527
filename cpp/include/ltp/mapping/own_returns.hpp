// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OwnReturns`: which returns of a scan are no obstacles, but the aircraft itself or nothing.
#pragma once

#include "ltp/geometry/types.hpp"
#include "ltp/mapping/obstacle_map_options.hpp"

namespace ltp {

/// A sensor sees arms, legs and propellers of its own aircraft, and many write the sensor's own
/// place where there was no return. Mapped, they wall the UAV in.
class OwnReturns {
 public:
  enum class Verdict { Obstacle, TooNear, InBody };

  /// @param sensor  where the rays began, and how the axes of the body box are turned
  OwnReturns(const ObstacleMapOptions& options, const Pose& sensor);

  /// No own return is this far from where the rays began, or farther [m].
  double reach() const { return reach_; }

  /// @param offset  of a return from where the rays began, world frame [m]
  Verdict operator()(const Point& offset) const;

 private:
  double blind_distance_;
  bool has_body_;
  Point low_;
  Point high_;
  Eigen::Quaterniond body_from_world_;
  double reach_;
};

}  // namespace ltp
