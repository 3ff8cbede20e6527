// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The way out of a blocked cell: to the nearest free one, past nothing that was hit.
#pragma once

#include <optional>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// Whether a cell that was hit lies on an escape at or beyond an arc length [m]. The cell of the
/// UAV's position counts as free: it is there.
bool hit_on_escape(const OccupancyGrid& occupied, const PathRef& path, double from,
                   const Point& position);

/// The vertex of the free cell nearest to a query's start, within its altitudes and a distance [m],
/// to which the straight way touches nothing that was hit.
std::optional<Point> escape_point(const OccupancyGrid& occupied, const OccupancyGrid& blocked,
                                  const Query& query, double most);

}  // namespace ltp
