// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OctileDistance`: the length of the shortest grid path to a point where nothing is in the way.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <utility>

#include "ltp/grid/neighbourhood.hpp"

namespace ltp::planning {

/// From the centre of a cell to that of another one, `by` apart [m]: the longest steps first. For
/// cells of the given edges.
double octile_distance(const Point& edges, const Cell& by);

/// From the centres of cells to a point that need not be one: over 26 steps, then from a neighbour
/// of the point's cell straight to it. A consistent heuristic, and the best there is that knows no
/// obstacles.
///
/// On the lattice alone the shortest way takes as many diagonals as it can: along all three axes,
/// then along two, then along one (the length of a step is submodular in its axes). What the last
/// step changes depends on the cell's direction only, save near the planes where that is between
/// two; it is computed once for each kind of direction that is asked for.
class OctileDistance {
 public:
  using Units = std::uint64_t;
  static constexpr Units kNoStep = std::numeric_limits<Units>::max() / 4;

  /// @param lengths  of the steps
  /// @param last  lengths of the steps from the target's neighbours to the point itself, by
  ///     `neighbour_bit`; `kNoStep` where there is none
  void aim(const Cell& target, const std::array<Units, kSteps>& lengths,
           const std::array<Units, 27>& last);

  /// Of any cell but the target.
  Units operator()(const Cell& cell) {
    const Cell by = cell - target_;
    const Ways ways = ways_of(by);
    // The nearest cell in the same kind of direction.
    const auto near = [](int difference) { return difference < 2 ? difference : 2; };
    const int least = near(ways.count[2]);
    const int middle = least + near(ways.count[1] - ways.count[2]);
    const int most = middle + near(ways.count[0] - ways.count[1]);
    int kind = kKinds / 2;
    const auto add = [&](int axis, int count) {
      kind += kStride[axis] * (by[axis] < 0 ? -count : count);
    };
    add(ways.axis[0], most);
    add(ways.axis[1], middle);
    add(ways.axis[2], least);
    Units& change = changes_[kind];
    if (change == kUnknown) change = change_of(kind);
    return length(ways) + change;  // modulo 2^64: a change may be negative
  }

 private:
  static constexpr int kReach = 6;
  static constexpr int kEdge = 2 * kReach + 1;
  static constexpr int kKinds = kEdge * kEdge * kEdge;
  static constexpr int kStride[3] = {kEdge * kEdge, kEdge, 1};
  static constexpr Units kUnknown = std::numeric_limits<Units>::max();

  /// The axes by falling number of cells.
  struct Ways {
    std::array<int, 3> axis;
    std::array<int, 3> count;
  };
  static Ways ways_of(const Cell& by) {
    Ways ways{{0, 1, 2},
              {by.x() < 0 ? -by.x() : by.x(), by.y() < 0 ? -by.y() : by.y(),
               by.z() < 0 ? -by.z() : by.z()}};
    const auto order = [&](int i, int j) {
      if (ways.count[i] >= ways.count[j]) return;
      std::swap(ways.count[i], ways.count[j]);
      std::swap(ways.axis[i], ways.axis[j]);
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return ways;
  }
  Units length(const Ways& ways) const {
    const int first = 1 << ways.axis[0];
    const int both = first | 1 << ways.axis[1];
    return static_cast<Units>(ways.count[0] - ways.count[1]) * by_axes_[first] +
           static_cast<Units>(ways.count[1] - ways.count[2]) * by_axes_[both] +
           static_cast<Units>(ways.count[2]) * by_axes_[7];
  }
  Units change_of(int kind) const;

  Cell target_ = Cell::Zero();
  std::array<Units, 8> by_axes_{};  ///< lengths of steps, by the axes that they go along
  std::array<Units, 27> last_{};
  std::array<Units, kKinds> changes_{};
};

}  // namespace ltp::planning
