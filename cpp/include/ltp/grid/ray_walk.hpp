// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells that a segment crosses, in order, in two or three dimensions.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace ltp {

/// Two boundaries that a segment meets within this distance [cells] count as met at once: the
/// segment passes through their common edge or corner.
inline constexpr double kWalkTie = 1e-9;

/// Walks the segment a-b, given in lattice units (metres from the lattice's anchor over the cell's
/// edge). Calls `visit(cell, t_in, t_out)` for each cell crossed, with the part [t_in, t_out] of
/// [0, 1] that lies in it. Where the segment passes exactly through an edge or a corner, the cells
/// that it only touches are visited too, with t_in == t_out: nothing squeezes between two cells
/// unseen. A point on a face belongs to the upper cell. `visit` returns whether to go on; the walk
/// returns whether it reached the end.
template <int kDim, typename Visitor>
bool walk_segment(const Eigen::Matrix<double, kDim, 1>& a, const Eigen::Matrix<double, kDim, 1>& b,
                  Visitor&& visit) {
  Eigen::Matrix<int, kDim, 1> cell;
  std::array<int, kDim> step{};
  std::array<double, kDim> inverse{};
  for (int axis = 0; axis < kDim; ++axis) {
    cell[axis] = static_cast<int>(std::floor(a[axis]));
    const double delta = b[axis] - a[axis];
    step[axis] = delta > 0.0 ? 1 : delta < 0.0 ? -1 : 0;
    inverse[axis] = step[axis] == 0 ? 0.0 : 1.0 / delta;
  }
  double t_in = 0.0;
  while (true) {
    // The next boundary of each axis that the segment still crosses; recomputed, so errors do not
    // add up.
    double t_out = 2.0;
    std::array<double, kDim> t_next{};
    for (int axis = 0; axis < kDim; ++axis) {
      t_next[axis] = 2.0;
      if (step[axis] > 0 && cell[axis] + 1 <= b[axis]) {
        t_next[axis] = (cell[axis] + 1 - a[axis]) * inverse[axis];
      } else if (step[axis] < 0 && cell[axis] > b[axis]) {
        t_next[axis] = (cell[axis] - a[axis]) * inverse[axis];
      }
      t_out = std::min(t_out, t_next[axis]);
    }
    if (t_out > 1.5) return visit(cell, t_in, 1.0);
    t_out = std::min(std::max(t_out, t_in), 1.0);
    if (!visit(cell, t_in, t_out)) return false;

    std::array<int, kDim> tied{};
    int count = 0;
    for (int axis = 0; axis < kDim; ++axis) {
      if (t_next[axis] > 1.5) continue;
      if ((t_next[axis] - t_out) * std::abs(b[axis] - a[axis]) <= kWalkTie) tied[count++] = axis;
    }
    for (int subset = 1; subset + 1 < (1 << count); ++subset) {
      Eigen::Matrix<int, kDim, 1> touched = cell;
      for (int bit = 0; bit < count; ++bit) {
        if (subset >> bit & 1) touched[tied[bit]] += step[tied[bit]];
      }
      if (!visit(touched, t_out, t_out)) return false;
    }
    for (int bit = 0; bit < count; ++bit) cell[tied[bit]] += step[tied[bit]];
    t_in = t_out;
  }
}

}  // namespace ltp
