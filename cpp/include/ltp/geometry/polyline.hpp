// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What one asks of a polyline: its length, a point along it, the point of it that is closest.
#pragma once

#include <limits>

#include "ltp/geometry/types.hpp"

namespace ltp {

// Whatever the magnitude: lengths from 1e-300 to 1e300 m neither vanish nor overflow. Where the
// distance between two points is no finite number all of these throw `std::invalid_argument`.

/// Length of a polyline [m]; 0 for fewer than two points.
double length(const PathRef& path);

/// The point at `arc_length` [m] from the first one; clamped to the ends. Throws
/// `std::invalid_argument` on an empty path or NaN.
Point point_at(const PathRef& path, double arc_length);

/// Points every `spacing` [m] along the path; the first and the last point are always kept, shape
/// (N, 3). Throws `std::invalid_argument` on an empty path, or unless the spacing is positive and
/// wide enough for at most 10^8 points.
Path resample(const PathRef& path, double spacing);

/// The point of a polyline that is closest to a given point.
struct ClosestPoint {
  Point point = Point::Zero();
  double arc_length = 0.0;  ///< from the first point of the path [m]
  double distance = 0.0;    ///< to the point asked about [m]
};

/// The first of equally close points. Considers only the part of the path from `from_arc_length` to
/// `to_arc_length` [m], or the path's end where it begins beyond that. Throws
/// `std::invalid_argument` on an empty path or NaN.
ClosestPoint closest_point(const PathRef& path, const Point& point, double from_arc_length = 0.0,
                           double to_arc_length = std::numeric_limits<double>::infinity());

}  // namespace ltp
