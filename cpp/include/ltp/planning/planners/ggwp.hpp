// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// GGWP, the paper's greedy grid-based wavefront propagation: short paths, no priority.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

/// A wave goes out from the goal until it reaches the start; then the path descends: of all cells
/// that a legal step leads to and that the wave reached earlier, the one by which the way seems
/// shortest. What is left from there is as far as the wave has come in its generations, but no
/// shorter than it would be without obstacles. That is the greed: O(N), no priority queue. In the
/// open plane the path is a shortest one. Bound: a wave needs at most 2 generations for a diagonal
/// step of the plane and a path no more steps than the wave had generations, so a path is at most
/// twice too long in planar flight (3 times on cubes, 4 times on 2 x 2 x 4 m).
std::unique_ptr<Planner> make_ggwp(const PlannerInfo& info, const PenaltyWeights& weights);

}  // namespace ltp
