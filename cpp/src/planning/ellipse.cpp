// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/ellipse.hpp"

#include <algorithm>

namespace ltp {

double most_priority(const GridFrame& frame, const Raster& priority, const Ellipse& ellipse) {
  double most = std::max({0.0, priority.at(ellipse.start.x(), ellipse.start.y()),
                          priority.at(ellipse.goal.x(), ellipse.goal.y())});
  for (int ix = 0; ix < frame.nx(); ++ix) {
    const int i = priority.index_of(0, frame.centre(Cell(ix, 0, 0)).x());
    for (int iy = 0; iy < frame.ny(); ++iy) {
      const Point centre = frame.centre(Cell(ix, iy, 0));
      const double value = priority(i, priority.index_of(1, centre.y()));
      if (value > most && ellipse.contains(centre.head<2>())) most = value;
    }
  }
  return most;
}

}  // namespace ltp
