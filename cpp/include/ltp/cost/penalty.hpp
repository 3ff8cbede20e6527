// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's equations 2 to 5 on polylines, and nothing else.
#pragma once

#include "ltp/geometry/types.hpp"
#include "ltp/grid/raster.hpp"

namespace ltp {

/// W_L and W_P of Eq. (5).
struct PenaltyWeights {
  double length = 0.5;    ///< W_L, of the length over the direct length; >= 0
  double priority = 1.0;  ///< W_P, of the mean priority along the path; >= 0

  /// Throws `std::invalid_argument` unless both are finite, none is negative and one is positive.
  void check() const;
};

/// The two integrals along a path that Eq. (5) is made of.
struct PathTally {
  double length = 0.0;    ///< L, Eq. (2) [m]
  double priority = 0.0;  ///< the integral of p_l dl, numerator of Eq. (4) [m]

  /// Eq. (4) without its sign: the mean priority, in [0, 1]; 0 for an empty path.
  double mean_priority() const { return length > 0.0 ? priority / length : 0.0; }
};

/// Eq. (2) and the integral of Eq. (4), exact for a priority that is constant on each cell of its
/// raster.
PathTally tally(const PathRef& path, const Raster& priority);

/// Eq. (5) for paths between two fixed points. Eq. (1), the obstacles, is `OccupancyGrid::blocked`.
class Penalty {
 public:
  /// @param direct_length  L_direct, the distance from start to goal [m], >= 0
  Penalty(const PenaltyWeights& weights, double direct_length);

  /// Eq. (5). Where the paper is silent: for start == goal the length ratio is 1, and over an empty
  /// path (length 0) the mean priority is `point_priority`, that of the point itself.
  double operator()(double length, double priority_integral, double point_priority = 0.0) const;
  double operator()(const PathTally& tally, double point_priority = 0.0) const {
    return (*this)(tally.length, tally.priority, point_priority);
  }

  /// Eq. (5) of a path by its length and mean priority.
  double at(double length, double mean_priority) const {
    return per_metre_ * length - weights_.priority * mean_priority;
  }

  double per_metre() const { return per_metre_; }  ///< W_L / L_direct [1/m]; 0 for L_direct = 0
  const PenaltyWeights& weights() const { return weights_; }

 private:
  PenaltyWeights weights_;
  double direct_length_;
  double per_metre_;
};

}  // namespace ltp
