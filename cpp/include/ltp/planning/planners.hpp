// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The registry: every planner by its name, and what each can be told.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "ltp/planning/planner.hpp"
#include "ltp/planning/planners/ara_star.hpp"
#include "ltp/planning/planners/bezier.hpp"
#include "ltp/planning/planners/exact.hpp"
#include "ltp/planning/planners/hermite.hpp"
#include "ltp/planning/planners/linearised.hpp"
#include "ltp/planning/planners/risk_a_star.hpp"
#include "ltp/planning/planners/tangent_bug.hpp"

namespace ltp {

/// What every planner can be told. A planner ignores what does not concern it.
struct PlannerOptions {
  PenaltyWeights weights;
  /// Of LP-A* and WLP-A*: Eq. (9) as printed lacks the factor W_L; true scales by it.
  bool scaled_heuristic = false;
  /// Frees the path from the grid's directions, see `Refiner`: never a larger penalty.
  bool refine = false;
  BezierOptions bezier;
  LinearisedOptions linearised;
  ExactOptions exact;
  AraOptions ara;
  RiskOptions risk;
  TangentBugOptions tangent_bug;
  HermiteOptions hermite;

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// All planners, in the order of the paper's tables.
const std::vector<PlannerInfo>& planners();

/// The planner of that name, or of an older one that stays for a release (`pareto`, `bug`). Throws
/// `std::invalid_argument` for an unknown one, listing those known.
const PlannerInfo& planner_info(std::string_view name);

/// Makes a planner by its name; `auto` is what a UAV should fly. Throws as `planner_info` and
/// `PlannerOptions::check` do.
std::unique_ptr<Planner> make_planner(std::string_view name = "auto",
                                      const PlannerOptions& options = {});

}  // namespace ltp
