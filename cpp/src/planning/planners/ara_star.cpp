// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/ara_star.hpp"

#include <algorithm>
#include <cmath>

#include "ltp/geometry/check.hpp"
#include "planning/additive/ara_search.hpp"
#include "planning/additive/linearisation.hpp"

namespace ltp {
namespace planning {
namespace {

constexpr double kProved = 1.0 + 1e-12;  // a path this close to the least cost is the cheapest

class AraStarPlanner final : public GridPlanner {
 public:
  AraStarPlanner(const PlannerInfo& info, const PenaltyWeights& weights, const AraOptions& options,
                 double alpha)
      : GridPlanner(info, weights), options_(options), alpha_(alpha) {}

 private:
  void search(const Problem& problem, Answer& answer) override {
    const bool only_length = weights().priority == 0.0 || problem.within_a_cell();
    AdditiveCost cost;
    double most = 0.0;
    if (!only_length) {
      most = std::max(problem.scene.priority.maximum(), 0.0);
      const PenaltyBound none(weights(), problem.direct_length, most);
      cost = {first_alpha(none, problem.direct_length, most, alpha_), 1.0};
    }
    search_.begin(problem, cost, answer.stats);
    for (double weight = options_.first_weight;;) {
      const PlanStatus status = search_.improve(weight, answer.budget, answer.stats);
      if (status != PlanStatus::Found) return answer.end(status);
      answer.offer(search_.chain());
      if (problem.within_a_cell()) {
        answer.prove(answer.plan().penalty);
      } else if (only_length) {  // the least cost is a length
        answer.prove(Penalty(weights(), problem.direct_length)(search_.least(), 0.0));
      } else if (problem.column_priority) {
        PenaltyBound bound(weights(), problem.direct_length, most);
        bound.add(cost.length, search_.least());
        answer.prove(bound.lowest().value);
      }
      if (weight <= 1.0 || search_.cost() <= kProved * search_.least()) return;
      // What is proved already may be better than the weight that was searched with.
      weight = std::min(weight, search_.cost() / search_.least());
      weight = std::max(1.0, weight - options_.step);
    }
  }

  AraOptions options_;
  double alpha_;
  AraSearch search_;
};

}  // namespace
}  // namespace planning

void AraOptions::check() const {
  check::between("ara.first_weight", first_weight, 1, 100);
  if (!(step >= 0.01) || !std::isfinite(step)) {
    check::fail("ara.step", step, "a finite number >= 0.01");
  }
}

std::unique_ptr<Planner> make_ara_star(const PlannerInfo& info, const PenaltyWeights& weights,
                                       const AraOptions& options, double alpha) {
  options.check();
  return std::make_unique<planning::AraStarPlanner>(info, weights, options, alpha);
}

}  // namespace ltp
