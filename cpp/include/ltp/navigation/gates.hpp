// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Gates`: where each waypoint is served, and what is asked of a planner to get there.
#pragma once

#include <vector>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/planning/gate_region.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// One row a waypoint: radius and height of its gate [m]; 0: the radius in which a point is
/// reached, one cell's height.
using GateSizes = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
using GateSizesRef = Eigen::Ref<const GateSizes>;

/// Throws `std::invalid_argument` unless there is a row for each of the waypoints, finite and not
/// negative; or none at all.
void check_gates(const GateSizesRef& sizes, Eigen::Index waypoints);

/// The waypoints with their gates. A UAV is served anywhere in a gate. What it plans to is half a
/// cell smaller all round, so that one that flies to the very edge of that is in the gate; a gate
/// that is no wider than where a point is reached is planned to as a point.
class Gates {
 public:
  /// @param window  of the map, for its cells
  /// @param radius  of the gates that are not given one, but for the last [m]; 0: points
  /// @param height  the same [m]; 0: one cell
  /// @param reach   horizontally, within which a point is reached [m]
  Gates(const GridFrame& window, double radius, double height, double reach);

  /// As `check_gates` throws. Without sizes all but the last waypoint have the constructor's.
  void set(const PathRef& waypoints, const GateSizesRef& sizes);

  /// Whether a waypoint is served at a position [m].
  bool served(int waypoint, const Point& position) const;
  /// From a position to a waypoint and, up to the horizon, on to those after it.
  Query query(const Point& position, int waypoint, int horizon, const AltitudeBand& band) const;
  /// Whether the map proves that no cell of a query's first gate is free; of a point in the UAV's
  /// own cell it proves nothing.
  static bool blocked(const OccupancyGrid& grid, const Query& query);
  /// The points of a query's first gate to which a path might lead: vertices of free cells.
  static std::vector<Point> free_points(const OccupancyGrid& grid, const Query& query);

 private:
  Gate planned(int waypoint) const;

  Point cell_;
  double radius_, height_, reach_;
  std::vector<Gate> gates_;
};

}  // namespace ltp
