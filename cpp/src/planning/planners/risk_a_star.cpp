// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/risk_a_star.hpp"

#include <algorithm>

#include "ltp/geometry/check.hpp"
#include "planning/additive/additive_search.hpp"

namespace ltp {
namespace planning {
namespace {

class RiskAStarPlanner final : public GridPlanner {
 public:
  RiskAStarPlanner(const PlannerInfo& info, const PenaltyWeights& weights,
                   const RiskOptions& options)
      : GridPlanner(info, weights), options_(options) {}

 private:
  void search(const Problem& problem, Answer& answer) override {
    const double no_risk = std::max(problem.scene.priority.maximum(), 1.0);
    const AdditiveCost cost{no_risk + options_.length_factor, 1.0};
    const AdditiveResult found = search_.run(problem, cost, answer.budget, answer.stats);
    if (found.status != PlanStatus::Found) return answer.end(found.status);
    answer.offer(found.chain);
  }

  RiskOptions options_;
  AdditiveSearch search_;
};

}  // namespace
}  // namespace planning

void RiskOptions::check() const { check::positive("risk.length_factor", length_factor); }

std::unique_ptr<Planner> make_risk_a_star(const PlannerInfo& info, const PenaltyWeights& weights,
                                          const RiskOptions& options) {
  options.check();
  return std::make_unique<planning::RiskAStarPlanner>(info, weights, options);
}

}  // namespace ltp
