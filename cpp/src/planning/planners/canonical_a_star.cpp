// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/canonical_a_star.hpp"

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/shortest_path.hpp"

namespace ltp {
namespace planning {
namespace {

class CanonicalAStarPlanner final : public GridPlanner {
 public:
  CanonicalAStarPlanner(const PlannerInfo& info, const PenaltyWeights& weights)
      : GridPlanner(info, weights) {}

 private:
  void search(const Problem& problem, Answer& answer) override {
    if (problem.within_a_cell()) {
      answer.offer(std::vector<Cell>{problem.start});
      return;
    }
    const PlanStatus status = search_.run(problem, answer.budget, answer.stats);
    if (status != PlanStatus::Found) return answer.end(status);
    answer.offer(search_.chain());
  }

  ShortestPath search_;
};

}  // namespace
}  // namespace planning

std::unique_ptr<Planner> make_canonical_a_star(const PlannerInfo& info,
                                               const PenaltyWeights& weights) {
  return std::make_unique<planning::CanonicalAStarPlanner>(info, weights);
}

}  // namespace ltp
