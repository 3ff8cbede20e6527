// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What a query leaves open: its altitudes, its levels, and the vertices of the cells in them.
#pragma once

#include "ltp/grid/frame.hpp"
#include "ltp/grid/neighbourhood.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// Throws `std::invalid_argument` for a point that is not finite, or a band, a radius or a height
/// below zero.
void check_query(const Query& query);

/// The altitudes that a path may have [m].
struct AltitudeRange {
  double lowest;
  double highest;

  /// Whether an altitude is one of them, to within 1e-9 m.
  bool contains(double z) const;
};

/// From the lowest of a query's points (its ends and waypoints) less what its band allows below, to
/// the highest one and what it allows above.
AltitudeRange altitudes_of(const Query& query);

/// The levels that a query's band leaves open, clipped to the frame: those of its points, and those
/// that hold more of its altitudes than a touched face.
LevelRange levels_of(const GridFrame& frame, const Query& query);

/// Where a path passes a cell of a query's levels: the cell's centre, or the altitude nearest to it
/// that the query allows. It lies in the cell.
Point vertex_of(const GridFrame& frame, const AltitudeRange& altitudes, const Cell& cell);

}  // namespace ltp
