// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/sensing/surface.hpp"

#include <cmath>

#include "ltp/geometry/check.hpp"

namespace ltp {

BeamFan::BeamFan(const std::vector<double>& elevations) {
  constexpr double kZenith = 1.5707963267948966;
  beams_.reserve(elevations.size());
  for (std::size_t row = 0; row < elevations.size(); ++row) {
    const double elevation = elevations[row];
    const std::string name = "elevations[" + std::to_string(row) + "]";
    if (!(std::abs(elevation) < kZenith)) check::fail(name, elevation, "within (-pi/2, pi/2)");
    if (row > 0 && elevation < elevations[row - 1]) {
      check::fail(name, elevation, "ascending elevations");
    }
    const double cosine = std::cos(elevation);
    const double sine = std::sin(elevation);
    beams_.push_back({sine / cosine, cosine / sine, cosine, sine, 1.0 / cosine});
  }
}

void RayHits::reset(std::int64_t rays) {
  size_ = 0;
  rays_.resize(rays);
  ranges_.resize(rays);
  inside_.resize(rays);
}

void RayHits::swap_inside(std::vector<Point>& points) {
  inside_.resize(size_);
  inside_.swap(points);
  size_ = 0;
}

void Surface::cast_fans(const Point& origin, const std::vector<Eigen::Vector2d>& headings,
                        const BeamFan& fan, double max_range, RayHits& hits) const {
  std::int64_t ray = 0;
  for (const Eigen::Vector2d& heading : headings) {
    for (int row = 0; row < fan.size(); ++row, ++ray) {
      const BeamFan::Beam& beam = fan[row];
      const Point direction(beam.cosine * heading.x(), beam.cosine * heading.y(), beam.sine);
      const RayHit hit = cast(origin, direction, max_range);
      if (hit.hit()) hits.add(ray, hit.range, hit.inside);
    }
  }
}

void Surface::cast_bundle(const Point& origin, const Eigen::Matrix3d& turn,
                          const PathRef& directions, double max_range, RayHits& hits) const {
  for (Eigen::Index ray = 0; ray < directions.rows(); ++ray) {
    const RayHit hit = cast(origin, turned(turn, directions.row(ray)), max_range);
    if (hit.hit()) hits.add(ray, hit.range, hit.inside);
  }
}

std::optional<double> Surface::first_collision(const PathRef& path) const {
  if (!path.allFinite()) check::fail("path", "not finite", "finite numbers only");
  if (path.rows() == 1) {
    const RayHit hit = cast(path.row(0).transpose(), Point::UnitZ(), kHitMargin);
    return hit.range == 0.0 ? std::optional<double>(0.0) : std::nullopt;
  }
  double arc = 0.0;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    const Point begin = path.row(i - 1).transpose();
    const Point move = path.row(i).transpose() - begin;
    const double size = move.norm();
    if (size > 0.0) {
      const RayHit hit = cast(begin, move / size, size);
      if (hit.hit()) return arc + hit.range;
    }
    arc += size;
  }
  return std::nullopt;
}

double Surface::clearance(const Point& point, double max_distance) const {
  check::finite("point", point);
  check::not_negative("max_distance", max_distance);
  return std::numeric_limits<double>::quiet_NaN();
}

void Surface::cast_rays(const PathRef& origins, const PathRef& directions, double max_range,
                        Eigen::Ref<Eigen::VectorXd> ranges) const {
  static thread_local RayHits hits;  // reused from call to call
  ranges.setConstant(std::numeric_limits<double>::infinity());
  for (Eigen::Index first = 0; first < origins.rows();) {
    Eigen::Index last = first + 1;
    while (last < origins.rows() && origins.row(last) == origins.row(first)) ++last;
    hits.reset(last - first);
    cast_bundle(origins.row(first).transpose(), Eigen::Matrix3d::Identity(),
                directions.middleRows(first, last - first), max_range, hits);
    for (std::int64_t n = 0; n < hits.size(); ++n) ranges[first + hits.ray(n)] = hits.range(n);
    first = last;
  }
}

}  // namespace ltp
