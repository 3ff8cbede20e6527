// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Surface`: something that a ray can hit.
#pragma once

#include <limits>
#include <vector>

#include "ltp/geometry/types.hpp"

namespace ltp {

/// Where a ray first meets a surface.
struct RayHit {
  double range =
      std::numeric_limits<double>::infinity();  ///< from the ray's origin [m]; inf: no hit
  /// The point hit, moved into the solid by `kHitDepth` along the inward normal of the face hit, so
  /// that rounding it to a cell finds the solid's cell and never the free one before it.
  Point inside = Point::Constant(std::numeric_limits<double>::quiet_NaN());

  bool hit() const { return range < std::numeric_limits<double>::infinity(); }
};

inline constexpr double kHitDepth = 1e-3;  ///< [m]

class Surface {
 public:
  virtual ~Surface() = default;

  /// The first hit of the ray from `origin` [m] along the unit vector `direction`, nearer than
  /// `max_range` [m]. A ray that starts inside the solid hits at range 0.
  virtual RayHit cast(const Point& origin, const Point& direction, double max_range) const = 0;

  /// All beams of one azimuth at once: directions (cos(e) * heading, sin(e)) for ascending
  /// elevations e.
  /// @param heading  unit vector in the plane (x, y)
  /// @param elevations  ascending [rad], each in (-pi/2, pi/2)
  /// @param hits  one per elevation, resized
  /// The default casts one by one; a height surface sweeps the horizon once.
  virtual void cast_fan(const Point& origin, const Eigen::Vector2d& heading,
                        const std::vector<double>& elevations, double max_range,
                        std::vector<RayHit>& hits) const;
};

}  // namespace ltp
