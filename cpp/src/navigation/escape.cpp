// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "navigation/escape.hpp"

#include "ltp/planning/altitudes.hpp"

namespace ltp {

bool hit_on_escape(const OccupancyGrid& occupied, const PathRef& path, double from,
                   const Point& position) {
  return occupied.first_blocked(path, from, occupied.frame().cell_of(position)).has_value();
}

std::optional<Point> escape_point(const OccupancyGrid& occupied, const OccupancyGrid& blocked,
                                  const Query& query, double most) {
  const GridFrame& frame = blocked.frame();
  const Point& position = query.start;
  const Cell own = frame.cell_of(position);
  const LevelRange levels = levels_of(frame, query);
  const Cell reach =
      (Point::Constant(most).cwiseQuotient(frame.cell())).array().ceil().matrix().cast<int>();
  std::optional<Point> nearest;
  double distance = most;
  Path way(2, 3);
  way.row(0) = position.transpose();
  for (int dx = -reach.x(); dx <= reach.x(); ++dx) {
    for (int dy = -reach.y(); dy <= reach.y(); ++dy) {
      for (int level = levels.lowest; level <= levels.highest; ++level) {
        const Cell cell(own.x() + dx, own.y() + dy, level);
        if (!frame.contains(cell) || blocked.blocked(cell)) continue;
        const Point centre = vertex_of(frame, altitudes_of(query), cell);
        if ((centre - position).norm() >= distance) continue;
        way.row(1) = centre.transpose();
        if (hit_on_escape(occupied, way, 0.0, position)) continue;
        distance = (centre - position).norm();
        nearest = centre;
      }
    }
  }
  return nearest;
}

}  // namespace ltp
