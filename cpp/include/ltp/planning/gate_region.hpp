// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GateRegion`: the cells of a window in which a waypoint is served.
#pragma once

#include <algorithm>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/planning/altitudes.hpp"

namespace ltp {

/// The cells whose vertices lie in a gate, and always the cell of its point, whatever its radius.
class GateRegion {
 public:
  GateRegion(const GridFrame& frame, const AltitudeRange& altitudes, const LevelRange& open,
             const Gate& gate);

  const Gate& gate() const { return gate_; }
  /// The cell of its point; may lie outside of the window.
  const Cell& own() const { return own_; }
  /// The levels whose vertices lie in the gate's height; none if the lowest is above the highest.
  const LevelRange& levels() const { return levels_; }
  /// The columns that hold all of it, clipped to the window: from the first one to the last; none
  /// if one coordinate of the first is the larger one. Their z says nothing.
  const Cell& first() const { return first_; }
  const Cell& last() const { return last_; }
  /// No cell's vertex in it (that of its own aside) is farther from its point [m].
  double reach() const { return reach_; }

  /// Whether a column's centre lies within its radius.
  bool covers(int ix, int iy) const {
    const double dx = ix * edge_.x() - centre_.x();
    const double dy = iy * edge_.y() - centre_.y();
    return dx * dx + dy * dy <= gate_.radius * gate_.radius;
  }
  /// Whether a cell of the window is one of its cells.
  bool contains(const Cell& cell) const { return holds_vertex(cell) || cell == own_; }
  /// Whether a cell's vertex lies in the gate.
  bool holds_vertex(const Cell& cell) const {
    return levels_.contains(cell) && covers(cell.x(), cell.y());
  }
  /// Whether a point lies in the gate, to 1e-9 m.
  bool contains(const Point& point) const;

  /// Calls `visit(cell)` for its cells in the window, whether free or not.
  template <typename Visitor>
  void for_each(Visitor&& visit) const {
    bool own = own_inside_;
    for (int ix = first_.x(); ix <= last_.x(); ++ix) {
      for (int iy = first_.y(); iy <= last_.y(); ++iy) {
        if (!covers(ix, iy)) continue;
        for (int iz = levels_.lowest; iz <= levels_.highest; ++iz) {
          const Cell cell(ix, iy, iz);
          own = own && cell != own_;
          visit(cell);
        }
      }
    }
    if (own) visit(own_);
  }
  bool any_free(const OccupancyGrid& grid) const;
  /// Whether all of it lies beyond the window.
  bool outside() const;
  /// Whether all of it lies within the window.
  bool inside() const { return whole_; }

 private:
  Gate gate_;
  Point edge_;              ///< of a cell [m]
  Eigen::Vector2d centre_;  ///< of the gate, from the centre of column (0, 0) [m]
  Cell own_;
  bool own_inside_;
  bool whole_;
  LevelRange levels_;
  Cell first_, last_;
  double reach_;
};

}  // namespace ltp
