// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The exact optimum of Eq. (5) over the graph's simple paths; and the whole front of (length,
// priority).
#pragma once

#include <memory>
#include <vector>

#include "ltp/planning/planner.hpp"
#include "ltp/planning/planners/linearised.hpp"

namespace ltp {

struct ExactOptions {
  double memory = 512.0;  ///< for its labels; more is `OutOfBudget` [MB], > 0
  double eps = 0.0;       ///< Eq. (5) + W_P p_max may be this part above its optimum, >= 0

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

using ParetoOptions [[deprecated("now ExactOptions")]] = ExactOptions;

/// Exact over the simple paths of the planners' graph: cells' vertices, 26 steps, start and goal in
/// place of the vertices of their cells. A sweep gives a good path, the exact search goes on from
/// there.
///
/// `Plan::bound` is the optimum within 1e-9. Over a priority raster that is neither on the grid's
/// columns nor can be resampled to them it throws `std::invalid_argument`. With
/// `ExactOptions::eps`, Eq. (5) + W_P p_max is at most (1 + eps) times its optimum. A search that
/// needs more than `ExactOptions::memory`, or more than 64 cells at which circling would pay,
/// answers `OutOfBudget`, without a path.
/// @param sweep  of the sweep; its `closing` plays no part
std::unique_ptr<Planner> make_exact(const PlannerInfo& info, const PenaltyWeights& weights,
                                    const ExactOptions& options, const LinearisedOptions& sweep);

/// The paths of which none is both shorter and over better ground, by rising length L and falling
/// loss R = p_max L - P (p_max: the largest priority in the window).
struct Front {
  PlanStatus status = PlanStatus::NoneFound;
  std::vector<PathTally> tallies;   ///< of each path; empty unless Found
  std::vector<Path> paths;          ///< start ... goal, world [m]; each checked like a plan's
  bool priority_resampled = false;  ///< as `Plan::priority_resampled`
  SearchStats stats;
};

/// The front of (L, R), both as small as can be; equal ones once. Rings never pay in it, so all
/// paths are simple. A path with the least Eq. (5) is on it wherever the optimum has W_L L /
/// L_direct >= W_P (p_max - its mean priority), which is where circling over the best ground would
/// not pay either. `OutOfBudget` if memory or budget do not suffice. Throws
/// `std::invalid_argument` for a query that is not finite or a wrong option.
/// @param options  `eps`: for each path there is one in the front with at most (1 + eps) times its
///                 length and its loss
Front pareto_front(const Scene& scene, const Query& query, const ExactOptions& options = {},
                   const Budget& budget = {});

}  // namespace ltp
