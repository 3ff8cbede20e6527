// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/geometry/polyline.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ltp/geometry/check.hpp"

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

}  // namespace

double length(const PathRef& path) {
  double sum = 0.0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) sum += (path.row(i) - path.row(i - 1)).norm();
  return sum;
}

Point point_at(const PathRef& path, double arc_length) {
  require_points(path);
  require_number("arc_length", arc_length);
  double left = arc_length;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    const double step = (path.row(i) - path.row(i - 1)).norm();
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
  best.distance = (best.point - point).norm();
  double arc = 0.0;
  for (Eigen::Index i = 1; i <= last && arc <= end; ++i) {
    const Point a = row(path, i - 1);
    const Point step = row(path, i) - a;
    const double size = step.norm();
    if (arc + size >= from_arc_length && size > 0.0) {
      const double t_min = std::clamp((from_arc_length - arc) / size, 0.0, 1.0);
      const double t_max = std::clamp((end - arc) / size, t_min, 1.0);
      const double t = std::clamp((point - a).dot(step) / (size * size), t_min, t_max);
      const Point candidate = a + t * step;
      const double distance = (candidate - point).norm();
      // Of equally close points the first, so that a loop's common end is its beginning.
      if (distance < best.distance ||
          (distance == best.distance && arc + t * size < best.arc_length))
        best = {candidate, arc + t * size, distance};
    }
    arc += size;
  }
  return best;
}

}  // namespace ltp
