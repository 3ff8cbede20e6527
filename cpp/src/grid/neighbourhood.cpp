// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/neighbourhood.hpp"

namespace ltp {
std::array<double, kSteps> step_lengths(const Point& cell) {
  std::array<double, kSteps> lengths{};
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    lengths[i] = Point(step.dx, step.dy, step.dz).cwiseProduct(cell).norm();
  }
  return lengths;
}

}  // namespace ltp
