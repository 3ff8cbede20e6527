// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Canonical A*: a shortest path, whatever the ground below is.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

/// Sturtevant and Rabin, "Canonical orderings on grids", IJCAI 2016, on the planners' graph.
std::unique_ptr<Planner> make_canonical_a_star(const PlannerInfo& info,
                                               const PenaltyWeights& weights);

}  // namespace ltp
