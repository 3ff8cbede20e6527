// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/risk_a_star.hpp"

#include <algorithm>

namespace ltp {

RiskAStarPlanner::RiskAStarPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
}

Plan RiskAStarPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    const double no_risk = std::max(scene.priority.maximum(), 1.0);
    const AdditiveCost cost{no_risk + options_.risk.length_factor, 1.0};
    const Budget budget(options_.max_expansions, query.interrupted);
    const AdditiveResult found = search_.run(scene, query, cells, cost, budget, plan.stats);
    plan.status = found.status;
    if (found.status == PlanStatus::Found) {
      accept(scene, query, cells, options_.weights, found.chain, plan);
    }
  });
}

}  // namespace ltp
