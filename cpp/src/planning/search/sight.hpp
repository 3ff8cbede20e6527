// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Sight`: whether a straight line keeps clear of blocked cells, and the priority along it;
// quickly.
#pragma once

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/planning/grid_planner.hpp"

namespace ltp::planning {

/// Looks along straight lines for the thousands of questions of a refinement. It walks one layer of
/// cells after the other along the longer horizontal axis, a third of the price of the exact walks
/// (`OccupancyGrid::first_blocked`, `Raster::integral`) and, unlike them, subject to rounding: a
/// path that leaves the house is checked and tallied by those.
class Sight {
 public:
  /// Reads grid and raster as long as it is used.
  Sight(const OccupancyGrid& grid, const LevelRange& levels, const Raster& priority,
        const AltitudeRange& altitudes = {-kOpen, kOpen});

  /// Whether the box [-margin, margin]^3 [cells, < 0.5], moved from `a` to `b` [world, m] while its
  /// margin changes evenly from `margin_a` to `margin_b`, meets no blocked cell. Cells outside the
  /// window count as free. May say no where a line only climbs past an obstacle; never yes wrongly.
  bool clear(const Point& a, const Point& b, double margin_a, double margin_b) const;
  /// Whether the box round a point meets no blocked cell.
  bool clear(const Point& point, double margin) const {
    return clear(point, point, margin, margin);
  }

  /// Whether a point lies in the window, its levels and its altitudes, the former safely by more
  /// than rounding.
  bool inside(const Point& point) const;

  /// The integral of the priority along a-b, as `Raster::integral` [m].
  double priority(const Point& a, const Point& b) const;

 private:
  Point cells(const Point& point) const { return (point - origin_).cwiseProduct(per_metre_); }
  bool free(int ix, int iy, int low, int high) const;
  bool box_free(const Point& low, const Point& high) const;

  const OccupancyGrid& grid_;
  const Raster& priority_;
  Point origin_;     ///< of the window [m]
  Point per_metre_;  ///< cells per metre along each axis
  Point lowest_;     ///< corners of what is open: the window between the altitudes [cells]
  Point highest_;
};

}  // namespace ltp::planning
