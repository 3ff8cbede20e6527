// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/ellipse.hpp"

#include <algorithm>

namespace ltp::planning {

double max_priority(const GridFrame& frame, const ColumnPriority& priority, const Ellipse& ellipse,
                    double enough) {
  Cell low = Cell::Zero();
  Cell high(frame.nx() - 1, frame.ny() - 1, 0);
  if (!ellipse.unbounded()) {  // the box round it
    const Eigen::Vector2d centre = 0.5 * (ellipse.start + ellipse.goal);
    const Eigen::Vector2d half = Eigen::Vector2d::Constant(0.5 * ellipse.longest);
    const auto cell_of = [&](const Eigen::Vector2d& corner) {
      return frame.cell_of(Point(corner.x(), corner.y(), frame.origin().z()));
    };
    low = cell_of(centre - half).cwiseMax(low);
    high = cell_of(centre + half).cwiseMin(high);
  }
  double most = 0.0;
  for (int ix = low.x(); ix <= high.x(); ++ix) {
    for (int iy = low.y(); iy <= high.y(); ++iy) {
      const double value = priority(ix, iy);
      if (value <= most) continue;
      if (!ellipse.contains(frame.centre(Cell(ix, iy, 0)).head<2>())) continue;
      most = value;
      if (most >= enough) return most;
    }
  }
  return most;
}

}  // namespace ltp::planning
