// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Where Eq. (5) is first linearised.
#pragma once

#include "planning/additive/penalty_bound.hpp"

namespace ltp::planning {

/// The factor alpha of a first additive search, which knows no path yet: `fixed` if that is
/// positive, else the slope of Eq. (5) at a likely path.
/// @param direct_length  L_direct [m]
/// @param max_priority  the largest priority anywhere, >= 0
double first_alpha(const PenaltyBound& bound, double direct_length, double max_priority,
                   double fixed);

}  // namespace ltp::planning
