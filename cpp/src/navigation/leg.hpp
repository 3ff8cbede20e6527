// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What is asked on the way to a waypoint, and what a plan or a path says about it.
#pragma once

#include <cstddef>

#include "ltp/grid/frame.hpp"
#include "ltp/planning/altitudes.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp::leg {

/// No path that leaves the window and comes back is shorter [m].
double out_and_back(const GridFrame& window, const Query& query);

/// A query with the band that gives it these altitudes.
Query over(const AltitudeRange& altitudes, Query query);

/// The altitude of the highest of a query's waypoints [m].
double highest_waypoint(const Query& query);

/// Where a plan passes its first gate [m]; a planner that knows no gates leads there.
double to_first_gate(const Plan& plan);

/// How many waypoints a plan passes; a planner that knows no gates leads to one.
std::size_t passes(const Plan& plan);

/// A path from an arc length [m] on, for who is at a position near there.
Path rest_of(const Path& path, double from, const Point& position);

}  // namespace ltp::leg
