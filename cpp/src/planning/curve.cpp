// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/curve.hpp"

namespace ltp {

bool inside(const GridFrame& frame, const LevelRange& levels, const PathRef& curve) {
  for (Eigen::Index i = 0; i < curve.rows(); ++i) {
    const Cell cell = frame.cell_of(curve.row(i).transpose());
    if (!frame.contains(cell) || cell.z() < levels.lowest || cell.z() > levels.highest) {
      return false;
    }
  }
  return true;
}

Point sideways(const Point& direction) {
  const Eigen::Vector2d plane = direction.head<2>();
  if (!(plane.norm() > 0.0)) return Point::UnitX();
  const Eigen::Vector2d side = Eigen::Vector2d(-plane.y(), plane.x()).normalized();
  return Point(side.x(), side.y(), 0.0);
}

}  // namespace ltp
