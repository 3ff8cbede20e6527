// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/gates.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

GateRegion first_region(const GridFrame& frame, const Query& query) {
  return {frame,
          altitudes_of(query),
          levels_of(frame, query),
          {query.goal, query.gate_radius, query.gate_height}};
}

}  // namespace

void check_gates(const GateSizesRef& sizes, Eigen::Index waypoints) {
  if (sizes.rows() != 0 && sizes.rows() != waypoints) {
    check::fail("gates.rows()", sizes.rows(),
                ("as many as waypoints, " + std::to_string(waypoints)).c_str());
  }
  for (Eigen::Index i = 0; i < sizes.rows(); ++i) {
    const std::string name = "gates[" + std::to_string(i) + "]";
    check::not_negative(name + ".radius", sizes(i, 0));
    check::not_negative(name + ".height", sizes(i, 1));
  }
}

Gates::Gates(const GridFrame& window, double radius, double height, double reach)
    : cell_(window.cell()), radius_(radius), height_(height), reach_(reach) {}

void Gates::set(const PathRef& waypoints, const GateSizesRef& sizes) {
  check_gates(sizes, waypoints.rows());
  gates_.clear();
  for (Eigen::Index i = 0; i < waypoints.rows(); ++i) {
    const bool given = sizes.rows() > 0;
    const bool last = i + 1 == waypoints.rows();
    const double radius = given ? sizes(i, 0) : last ? 0.0 : radius_;
    const double height = given ? sizes(i, 1) : last ? 0.0 : height_;
    gates_.push_back({waypoints.row(i).transpose(), std::max(radius, reach_),
                      height > 0.0 ? height : cell_.z()});
  }
}

bool Gates::served(int waypoint, const Point& position) const {
  const Gate& gate = gates_[waypoint];
  const Point offset = gate.point - position;
  return offset.head<2>().norm() <= gate.radius && std::abs(offset.z()) <= gate.height;
}

/// Half a cell smaller.
Gate Gates::planned(int waypoint) const {
  Gate gate = gates_[waypoint];
  const bool wide = gate.radius > reach_;
  gate.radius = wide ? std::max(0.0, gate.radius - 0.5 * cell_.head<2>().norm()) : 0.0;
  gate.height = wide ? std::max(0.0, gate.height - 0.5 * cell_.z()) : 0.0;
  return gate;
}

Query Gates::query(const Point& position, int waypoint, int horizon,
                   const AltitudeBand& band) const {
  const Gate first = planned(waypoint);
  Query query{position, first.point, band, first.radius, first.height, {}};
  const int end = std::min(waypoint + horizon, static_cast<int>(gates_.size()));
  for (int i = waypoint + 1; i < end; ++i) query.then.push_back(planned(i));
  return query;
}

bool Gates::blocked(const OccupancyGrid& grid, const Query& query) {
  const GridFrame& frame = grid.frame();
  if (query.gate_radius == 0.0) {
    return grid.blocked_at(query.goal) && frame.cell_of(query.goal) != frame.cell_of(query.start);
  }
  const GateRegion region = first_region(frame, query);
  return region.inside() && !region.any_free(grid);
}

std::vector<Point> Gates::free_points(const OccupancyGrid& grid, const Query& query) {
  if (query.gate_radius == 0.0) return {query.goal};
  const GridFrame& frame = grid.frame();
  std::vector<Point> points;
  first_region(frame, query).for_each([&](const Cell& cell) {
    if (!grid.blocked(cell)) points.push_back(vertex_of(frame, altitudes_of(query), cell));
  });
  std::sort(points.begin(), points.end(), [&](const Point& a, const Point& b) {
    return (a - query.goal).squaredNorm() < (b - query.goal).squaredNorm();
  });
  return points;
}

}  // namespace ltp
