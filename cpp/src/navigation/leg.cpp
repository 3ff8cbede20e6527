// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "navigation/leg.hpp"

#include <algorithm>
#include <cmath>

#include "ltp/geometry/norm.hpp"

namespace ltp::leg {

double out_and_back(const GridFrame& window, const Query& query) {
  const AltitudeRange altitudes = altitudes_of(query);
  const auto to_face = [&](const Point& point) {
    const Point low = point - window.origin();
    const Point high = window.upper() - point;
    double least = std::min(low.head<2>().minCoeff(), high.head<2>().minCoeff());
    if (altitudes.lowest < window.origin().z()) least = std::min(least, low.z());
    if (altitudes.highest > window.upper().z()) least = std::min(least, high.z());
    return least;
  };
  const double into_gate = std::hypot(query.gate_radius, query.gate_height);
  return to_face(query.start) + std::max(0.0, to_face(query.goal) - into_gate);
}

Query over(const AltitudeRange& altitudes, Query query) {
  query.band = {0.0, 0.0};
  const AltitudeRange ends = altitudes_of(query);
  query.band = {std::max(ends.lowest - altitudes.lowest, 0.0),
                std::max(altitudes.highest - ends.highest, 0.0)};
  return query;
}

double highest_waypoint(const Query& query) {
  double highest = query.goal.z();
  for (const Gate& gate : query.then) highest = std::max(highest, gate.point.z());
  return highest;
}

double to_first_gate(const Plan& plan) {
  return plan.passed.empty() ? plan.tally.length : plan.passed.front();
}

std::size_t passes(const Plan& plan) { return std::max<std::size_t>(plan.passed.size(), 1); }

Path rest_of(const Path& path, double from, const Point& position) {
  double so_far = 0.0;
  Eigen::Index first = 1;  // vertex after the position
  for (; first + 1 < path.rows(); ++first) {
    so_far += norm(Point((path.row(first) - path.row(first - 1)).transpose()));
    if (so_far > from) break;
  }
  Path rest(path.rows() - first + 1, 3);
  rest << position.transpose(), path.bottomRows(path.rows() - first);
  return rest;
}

}  // namespace ltp::leg
