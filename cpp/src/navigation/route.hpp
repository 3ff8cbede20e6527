// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Route`: the shortest way to a waypoint over all that is remembered.
#pragma once

#include <functional>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"
#include "planning/search/shortest_path.hpp"

namespace ltp {

/// An exact search on whole numbers; it knows no priorities, so no tie between these can turn it
/// about. What nobody has seen is free.
class Route {
 public:
  Route();

  /// `Found`, `Unreachable`, or what keeps it from searching: an end that is blocked or outside;
  /// `OutOfBudget` if it was interrupted.
  PlanStatus find(const OccupancyGrid& known, const Query& query,
                  const std::function<bool()>& interrupted);

  /// Of the way found, a polyline from the query's start to its goal [m].
  const Path& path() const { return path_; }
  double length() const { return length_; }
  bool stays_in(const GridFrame& window) const;

  /// Where to fly to in a window that the way leaves: a point of it before it does so, or of the
  /// straight line to a point farther on, where nothing known lies on that line.
  Point stopover(const OccupancyGrid& known, const GridFrame& window) const;
  /// The part of the way up to where it leaves the window, or all of it.
  Path beginning(const GridFrame& window) const;

 private:
  Eigen::Index first_outside(const GridFrame& window) const;

  planning::ShortestPath search_;
  planning::Flood flood_;
  Path path_ = Path(0, 3);
  double length_ = 0.0;  ///< [m]
};

}  // namespace ltp
