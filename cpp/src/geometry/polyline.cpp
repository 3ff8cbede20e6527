// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"

namespace ltp {
namespace {

constexpr double kMostPoints = 1e8;

Point row(const PathRef& path, Eigen::Index i) { return path.row(i).transpose(); }

void require_points(const PathRef& path) {
  if (path.rows() == 0) check::fail("path", "(0, 3) array", "at least one point");
}

void require_number(const char* name, double value) {
  if (std::isnan(value)) check::fail(name, value, "a number");
}

/// Of the segment that ends at a point. Throws where it overflows.
double step_length(const PathRef& path, Eigen::Index i) {
  const double step = norm(path.row(i) - path.row(i - 1));
  if (!std::isfinite(step)) {
    check::fail("path[" + std::to_string(i) + "]", path.row(i),
                "a point at a finite distance from the one before it");
  }
  return step;
}

/// Where on a segment its point closest to `a + offset` is, in segments from its beginning `a`.
double share_along(const Point& offset, const Point& step, double size) {
  // Within these the square of the size is as good as any number.
  constexpr double kShort = 1e-100;
  constexpr double kLong = 1e100;
  const double share = offset.dot(step) / (size * size);
  if (size > kShort && size < kLong && std::isfinite(share)) return share;
  return offset.dot(step / size) / size;
}

}  // namespace

double length(const PathRef& path) {
  double sum = 0.0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) sum += step_length(path, i);
  if (!std::isfinite(sum)) check::fail("length of the path", sum, "a finite number");
  return sum;
}

Point point_at(const PathRef& path, double arc_length) {
  require_points(path);
  require_number("arc_length", arc_length);
  double left = arc_length;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    const double step = step_length(path, i);
    if (left <= step && step > 0.0) {
      const double t = std::max(left, 0.0) / step;
      return row(path, i - 1) + t * (row(path, i) - row(path, i - 1));
    }
    left -= step;
  }
  return row(path, path.rows() - 1);
}

Path resample(const PathRef& path, double spacing) {
  require_points(path);
  check::positive("spacing", spacing);
  const double total = length(path);
  if (!(total / spacing < kMostPoints)) check::fail("spacing", spacing, "at most 10^8 points");
  // The last step may be shorter, never longer, than the spacing (but for rounding).
  const auto steps = static_cast<Eigen::Index>(std::ceil(total / spacing - 1e-9));
  Path out(std::max<Eigen::Index>(steps, total > 0.0 ? 1 : 0) + 1, 3);
  for (Eigen::Index i = 0; i < out.rows(); ++i) {
    out.row(i) = point_at(path, static_cast<double>(i) * spacing).transpose();
  }
  if (out.rows() > 1) out.row(out.rows() - 1) = path.row(path.rows() - 1);
  return out;
}

ClosestPoint closest_point(const PathRef& path, const Point& point, double from_arc_length,
                           double to_arc_length) {
  require_points(path);
  require_number("from_arc_length", from_arc_length);
  require_number("to_arc_length", to_arc_length);
  const Eigen::Index last = path.rows() - 1;
  const double end = std::max(from_arc_length, to_arc_length);
  ClosestPoint best{row(path, last), length(path), 0.0};
  if (end < best.arc_length) best = {point_at(path, end), std::max(end, 0.0), 0.0};
  best.distance = norm(best.point - point);
  double arc = 0.0;
  for (Eigen::Index i = 1; i <= last && arc <= end; ++i) {
    const Point a = row(path, i - 1);
    const Point step = row(path, i) - a;
    const double size = step_length(path, i);
    if (arc + size >= from_arc_length && size > 0.0) {
      const double t_min = std::clamp((from_arc_length - arc) / size, 0.0, 1.0);
      const double t_max = std::clamp((end - arc) / size, t_min, 1.0);
      const double t = std::clamp(share_along(point - a, step, size), t_min, t_max);
      const Point candidate = a + t * step;
      const double distance = norm(candidate - point);
      // Of equally close points the first, so that a loop's common end is its beginning.
      if (distance < best.distance ||
          (distance == best.distance && arc + t * size < best.arc_length))
        best = {candidate, arc + t * size, distance};
    }
    arc += size;
  }
  if (!std::isfinite(best.distance)) {
    check::fail("point", point.transpose(), "a point at a finite distance from the path");
  }
  return best;
}

}  // namespace ltp
