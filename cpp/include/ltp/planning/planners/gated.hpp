// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Gates for planners that know points only: leg by leg, and to one cell of each region.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

/// The planner itself if it plans regions and several of them jointly (`Trait::Regions`,
/// `Trait::Horizon`). Any other is asked leg by leg, from where the last leg ended, and, if it does
/// not know regions, for a path to the nearest of a region's cells that a flood reaches. Statuses
/// are that planner's, but `Unreachable` is also what the flood says; no bound is proved. What
/// `make_planner` makes has been through this. Throws `std::invalid_argument` for null.
/// @param weights  of Eq. (5), by which the whole path is judged
std::unique_ptr<Planner> make_gated(std::unique_ptr<Planner> planner,
                                    const PenaltyWeights& weights);

}  // namespace ltp
