// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Where Eq. (5) is first linearised, and over which rasters a bound drawn from that holds.
#pragma once

#include "ltp/grid/frame.hpp"
#include "ltp/grid/raster.hpp"
#include "planning/additive/penalty_bound.hpp"

namespace ltp::planning {

/// The factor alpha of a first additive search, which knows no path yet: `fixed` if that is
/// positive, else the slope of Eq. (5) at a likely path.
/// @param direct_length  L_direct [m]
/// @param max_priority  the largest priority anywhere, >= 0
double first_alpha(const PenaltyBound& bound, double direct_length, double max_priority,
                   double fixed);

/// Whether the raster's cells are the grid's columns; only then does a search see each path's true
/// priority.
bool aligned(const GridFrame& frame, const Raster& raster);

}  // namespace ltp::planning
