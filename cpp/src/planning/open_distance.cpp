// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/open_distance.hpp"

#include <algorithm>

namespace ltp {

void OpenDistance::aim(const Cell& target, const std::array<Units, kSteps>& lengths,
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

void OpenDistance::aim(const Cell& target, const std::array<Units, kSteps>& lengths) {
  std::array<Units, 27> last{};
  for (int i = 0; i < kSteps; ++i) {
    last[neighbour_bit(steps()[i].dx, steps()[i].dy, steps()[i].dz)] = lengths[i];
  }
  aim(target, lengths, last);
}

OpenDistance::Units OpenDistance::change_of(int kind) const {
  const Cell by(kind / kStride[0] - kReach, kind / kStride[1] % kEdge - kReach,
                kind % kEdge - kReach);
  Units least = kUnknown;
  for (const Step& step : steps()) {
    const Cell neighbour(step.dx, step.dy, step.dz);
    least = std::min(
        least, length(ways_of(by - neighbour)) + last_[neighbour_bit(step.dx, step.dy, step.dz)]);
  }
  return least - length(ways_of(by));
}

}  // namespace ltp
