// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/octile_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "ltp/geometry/norm.hpp"

namespace ltp::planning {

double octile_distance(const Point& edges, const Cell& by) {
  std::array<int, 3> steps = {std::abs(by.x()), std::abs(by.y()), std::abs(by.z())};
  const int all = std::min({steps[0], steps[1], steps[2]});
  for (int& left : steps) left -= all;
  double length = all * norm(edges);
  for (int axis = 0; axis < 3; ++axis) {  // one of them is used up
    const int next = (axis + 1) % 3;
    const int both = std::min(steps[axis], steps[next]);
    length += both * std::hypot(edges[axis], edges[next]);
    steps[axis] -= both;
    steps[next] -= both;
  }
  for (int axis = 0; axis < 3; ++axis) length += steps[axis] * edges[axis];
  return length;
}

void OctileDistance::aim(const Cell& target, const std::array<Units, kSteps>& lengths,
                         const std::array<Units, 27>& last) {
  target_ = target;
  last_ = last;
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    const int axes = (step.dx != 0 ? 1 : 0) | (step.dy != 0 ? 2 : 0) | (step.dz != 0 ? 4 : 0);
    by_axes_[axes] = lengths[i];
  }
  changes_.fill(kUnknown);
}

OctileDistance::Units OctileDistance::change_of(int kind) const {
  const Cell by(kind / kStride[0] - kReach, kind / kStride[1] % kEdge - kReach,
                kind % kEdge - kReach);
  Units least = kUnknown;
  for (const Step& step : steps()) {
    const Cell neighbour(step.dx, step.dy, step.dz);
    least = std::min(least, length(ways_of(by - neighbour)) + last_[neighbour_bit(step.offset())]);
  }
  return least - length(ways_of(by));
}

}  // namespace ltp::planning
