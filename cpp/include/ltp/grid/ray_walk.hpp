// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The cells that a segment crosses, in order, in two or three dimensions.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>

namespace ltp {

/// Two boundaries that a segment meets within this much of its way [cells] count as met at once:
/// the segment passes through their common edge or corner.
inline constexpr double kWalkTie = 1e-9;

/// The part of a segment that is worth walking.
template <int kDim>
struct ClippedSegment {
  Eigen::Matrix<double, kDim, 1> a, b;
  double t_in = 0.0;  ///< where the part begins and ends on the whole segment, in [0, 1]
  double t_out = 1.0;
  bool empty = false;
  /// A place on the part as a place on the whole segment.
  double whole(double t) const { return t_in + t * (t_out - t_in); }
};

/// The part of the segment a-b that lies within a margin of one or two cells round the box [low,
/// high]: beyond it there is nothing to see, and there may be 10^300 cells of it. A segment that
/// stays inside is returned as it is. Empty for numbers that are not finite.
template <int kDim>
ClippedSegment<kDim> clip_segment(const Eigen::Matrix<double, kDim, 1>& a,
                                  const Eigen::Matrix<double, kDim, 1>& b,
                                  const Eigen::Matrix<double, kDim, 1>& low,
                                  const Eigen::Matrix<double, kDim, 1>& high) {
  ClippedSegment<kDim> part{a, b};
  const auto inside = [&](const Eigen::Matrix<double, kDim, 1>& p) {
    return (p.array() >= low.array() - 2.0).all() && (p.array() <= high.array() + 2.0).all();
  };
  if (inside(a) && inside(b)) return part;
  // When each axis enters and leaves the margin; axes that stand still do neither.
  Eigen::Matrix<double, kDim, 1> enter = Eigen::Matrix<double, kDim, 1>::Constant(-1.0);
  Eigen::Matrix<double, kDim, 1> leave = Eigen::Matrix<double, kDim, 1>::Constant(2.0);
  for (int axis = 0; axis < kDim; ++axis) {
    // Halved, so that the difference of the largest numbers is finite.
    const double delta = 0.5 * b[axis] - 0.5 * a[axis];
    const double to_low = 0.5 * (low[axis] - 1.0) - 0.5 * a[axis];
    const double to_high = 0.5 * (high[axis] + 1.0) - 0.5 * a[axis];
    if (delta == 0.0) {
      part.empty |= to_low > 0.0 || to_high < 0.0;
    } else {
      enter[axis] = (delta > 0.0 ? to_low : to_high) / delta;
      leave[axis] = (delta > 0.0 ? to_high : to_low) / delta;
      part.t_in = std::max(part.t_in, enter[axis]);
      part.t_out = std::min(part.t_out, leave[axis]);
    }
  }
  part.empty |= !(part.t_in <= part.t_out) || !a.allFinite() || !b.allFinite();
  if (part.empty) return part;
  // On a segment so long that rounding swallows cells, the faces met are known better than the
  // times.
  constexpr double kThin = 1e-9;
  const bool thin = part.t_out - part.t_in < kThin;
  const auto at = [&](double t, const Eigen::Matrix<double, kDim, 1>& met, bool entering) {
    Eigen::Matrix<double, kDim, 1> point = (a + 2.0 * (t * (0.5 * b - 0.5 * a)))
                                               .array()
                                               .max(low.array() - 2.0)
                                               .min(high.array() + 2.0);
    for (int axis = 0; thin && axis < kDim; ++axis) {
      if (met[axis] != t) continue;
      point[axis] = (a[axis] < b[axis]) == entering ? low[axis] - 1.0 : high[axis] + 1.0;
    }
    return point;
  };
  if (inside(a)) part.t_in = 0.0;
  if (inside(b)) part.t_out = 1.0;
  if (part.t_in > 0.0) part.a = at(part.t_in, enter, true);
  if (part.t_out < 1.0) part.b = at(part.t_out, leave, false);
  return part;
}

/// Walks the segment a-b, given in lattice units (metres from the lattice's anchor over the cell's
/// edge). Calls `visit(cell, t_in, t_out)` for each cell crossed, with the part [t_in, t_out] of
/// [0, 1] that lies in it. The coordinates must fit into `int`: see `clip_segment`. Where the
/// segment passes exactly through an edge or a corner, the cells that it only touches are visited
/// too, with t_in == t_out: nothing squeezes between two cells unseen. A point on a face belongs to
/// the upper cell. `visit` returns whether to go on; the walk returns whether it reached the end.
template <int kDim, typename Visitor>
bool walk_segment(const Eigen::Matrix<double, kDim, 1>& a, const Eigen::Matrix<double, kDim, 1>& b,
                  Visitor&& visit) {
  Eigen::Matrix<int, kDim, 1> cell;
  std::array<int, kDim> step{};
  const Eigen::Matrix<double, kDim, 1> delta = b - a;
  const double way = delta.cwiseAbs().maxCoeff();
  for (int axis = 0; axis < kDim; ++axis) {
    cell[axis] = static_cast<int>(std::floor(a[axis]));
    step[axis] = delta[axis] > 0.0 ? 1 : delta[axis] < 0.0 ? -1 : 0;
  }
  double t_in = 0.0;
  while (true) {
    // The next boundary of each axis that the segment still crosses; recomputed, so errors do not
    // add up. Divided, since the inverse of the smallest numbers is infinite.
    double t_out = 2.0;
    std::array<double, kDim> t_next{};
    for (int axis = 0; axis < kDim; ++axis) {
      t_next[axis] = 2.0;
      if (step[axis] > 0 && cell[axis] + 1.0 <= b[axis]) {
        t_next[axis] = (cell[axis] + 1.0 - a[axis]) / delta[axis];
      } else if (step[axis] < 0 && cell[axis] > b[axis]) {
        t_next[axis] = (cell[axis] - a[axis]) / delta[axis];
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
      if ((t_next[axis] - t_out) * way <= kWalkTie) tied[count++] = axis;
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
