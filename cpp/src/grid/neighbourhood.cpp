// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/neighbourhood.hpp"

#include "ltp/geometry/norm.hpp"

namespace ltp {

int step_by(const Cell& offset) {
  static const std::array<int, 27> numbers = [] {
    std::array<int, 27> all{};
    all.fill(kNoStep);
    for (int i = 0; i < kSteps; ++i) all[neighbour_bit(steps()[i].offset())] = i;
    return all;
  }();
  if (offset.cwiseAbs().maxCoeff() > 1) return kNoStep;
  return numbers[neighbour_bit(offset)];
}

std::array<double, kSteps> step_lengths(const Point& cell) {
  std::array<double, kSteps> lengths{};
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    lengths[i] = norm(Point(step.dx, step.dy, step.dz).cwiseProduct(cell));
  }
  return lengths;
}

}  // namespace ltp
