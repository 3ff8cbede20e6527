// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `NavigationOptions`: when a waypoint is reached, a path left, a height allowed; and
// `NavigationStatus`: what is being done.
#pragma once

#include <cstdint>
#include <string_view>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct NavigationOptions {
  AltitudeBand band{0.0,
                    0.0};  ///< about the altitudes of UAV and waypoint [m]; {0, 0}: planar flight
  /// How far above the highest waypoint of a leg the UAV may rise, however high it is by now [m];
  /// 0: `band.above`, which counts from the UAV too, so that who has climbed may climb again. What
  /// lies below where a leg begins stays open to it.
  double climb = 0.0;
  double reach_distance =
      0.0;  ///< a waypoint is reached within it, horizontally [m]; 0: one horizontal cell diagonal
  double leave_distance =
      0.0;  ///< farther from its path the UAV has left it [m]; 0: one horizontal cell diagonal
  double escape_distance =
      20.0;  ///< how far to look for a free cell when standing in a blocked one [m]

  /// A waypoint is served within it, horizontally [m]: its gate, to the whole of which is planned;
  /// the last one stays a point. 0: all are points, reached within `reach_distance`.
  double gate_radius = 0.0;
  double gate_height = 0.0;  ///< the same, up and down [m]; 0: one cell
  int horizon = 1;           ///< waypoints that are planned jointly, >= 1

  std::int64_t max_expansions = 0;  ///< of a plan, see `Budget`; 0: no limit
  double time_limit = 0.0;          ///< of a plan, see `Budget` [s]; 0: no limit

  /// A waypoint that would cost more metres than the shortest way to it that was known at first, by
  /// so many, is skipped as too far [m]; 0: none is.
  double max_detour = 0.0;
  /// Where the planner finds no path and a way is known, to fly the shortest one instead of
  /// holding: for planners that are not complete, or have a tight budget.
  bool fly_route = false;

  /// The band of a leg that begins at an altitude and whose highest waypoint lies at another [m].
  AltitudeBand band_from(double start, double highest) const;
  void check() const;
};

enum class NavigationStatus {
  Finished,   ///< no waypoint is left (or none was given)
  Following,  ///< there is a path to the next waypoint, or towards it where the way there leaves
              ///< the window
  Escaping,   ///< the UAV stands in a blocked cell: the path leads to the nearest free one
  Holding,    ///< no path and no proof: stay, and try again when the map has changed
};

std::string_view to_string(NavigationStatus status);

}  // namespace ltp
