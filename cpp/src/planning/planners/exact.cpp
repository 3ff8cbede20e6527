// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/exact.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "planning/exact/cell_graph.hpp"
#include "planning/exact/corridor.hpp"
#include "planning/exact/exact_search.hpp"
#include "planning/exact/front_search.hpp"

namespace ltp {
namespace planning {
namespace {

constexpr double kMegabyte = 1e6;

/// The sweep that gives a path to begin with, the same one for the same question.
LinearisedOptions seed(LinearisedOptions options) {
  options.closing = 0;
  options.remember = false;
  return options;
}

constexpr PlannerInfo kSweep{"sweep", "Sweep", PlannerFamily::Ours,
                             Trait::Regions | Trait::Horizon | Trait::Bounds};

/// What is exact for one priority a column would not be so for the given raster.
void check_priority(const Problem& problem) {
  if (problem.column_priority || problem.weights.priority == 0.0) return;
  check::fail("priority", "a raster off the grid's columns",
              "for an exact plan: one on them, or columns whose x and y edges are at most 16 times "
              "one common edge, so that it can be resampled");
}

class ExactPlanner final : public GridPlanner {
 public:
  ExactPlanner(const PlannerInfo& info, const PenaltyWeights& weights, const ExactOptions& options,
               const LinearisedOptions& sweep)
      : GridPlanner(info, weights),
        options_(options),
        sweep_(make_linearised(kSweep, weights, seed(sweep))) {}

 private:
  void search(const Problem& problem, Answer& answer) override {
    check_priority(problem);
    answer.take_over(sweep_->plan(problem.scene, problem.query, answer.budget.rest()));
    const Plan& plan = answer.plan();
    if (!answer.found() || (plan.bound && *plan.bound == plan.penalty)) return;
    if (problem.has_gates()) return;  // the exact search knows one goal: the sweep's best, bounded
    if (answer.budget.is_spent(answer.stats.expanded)) {
      return answer.withdraw(PlanStatus::OutOfBudget);
    }
    const PlanStatus status =
        exact_.improve(problem, {options_.eps, 0.0, options_.memory * kMegabyte}, answer);
    if (status != PlanStatus::Found) return answer.withdraw(status);
    answer.prove(exact_.proved());
  }

  ExactOptions options_;
  std::unique_ptr<Planner> sweep_;
  ExactSearch exact_;
};

/// The front's solutions as chains of cells.
PlanStatus search_front(const Problem& problem, const ExactOptions& options, BudgetWatch& budget,
                        SearchStats& stats, std::vector<std::vector<Cell>>& chains) {
  const GridFrame& frame = problem.frame();
  constexpr double kAny = std::numeric_limits<double>::infinity();
  StepCosts costs;
  costs.reset(problem, static_cast<double>(frame.size()) * frame.cell().norm());
  std::vector<Cell> cells;
  if (!Corridor().find(problem, costs, 1.0, kAny, budget, stats, cells)) {
    return PlanStatus::OutOfBudget;
  }
  if (std::find(cells.begin(), cells.end(), problem.start) == cells.end()) {
    return PlanStatus::Unreachable;
  }
  CellGraph graph;
  graph.build(problem, costs, cells);
  OpenList open;
  std::vector<double> length_to_goal;
  std::vector<double> loss_to_goal;
  if (!least_costs(graph, graph.goal(), {1.0, 0.0}, budget, stats, open, length_to_goal) ||
      !least_costs(graph, graph.goal(), {0.0, 1.0}, budget, stats, open, loss_to_goal)) {
    return PlanStatus::OutOfBudget;
  }
  std::vector<FrontSearch::Solution> found;
  const double memory = options.memory * kMegabyte - static_cast<double>(graph.bytes());
  const PlanStatus status = FrontSearch().run(
      {graph, length_to_goal, loss_to_goal, 1.0 + options.eps, memory}, budget, stats, found);
  if (status != PlanStatus::Found) return status;
  for (const FrontSearch::Solution& solution : found) {
    std::vector<Cell>& chain = chains.emplace_back();
    for (const std::uint32_t node : solution.chain) chain.push_back(graph.cell(node));
  }
  return status;
}

}  // namespace
}  // namespace planning

void ExactOptions::check() const {
  check::positive("exact.memory", memory);
  check::not_negative("exact.eps", eps);
}

std::unique_ptr<Planner> make_exact(const PlannerInfo& info, const PenaltyWeights& weights,
                                    const ExactOptions& options, const LinearisedOptions& sweep) {
  options.check();
  sweep.check();
  return std::make_unique<planning::ExactPlanner>(info, weights, options, sweep);
}

Front pareto_front(const Scene& scene, const Query& query, const ExactOptions& options,
                   const Budget& budget) {
  options.check();
  BudgetWatch watch(budget);
  const Stopwatch stopwatch;
  check_query(query);
  ColumnScene seen;
  const Problem problem(seen.of(scene), query, {});
  planning::check_priority(problem);
  Front front;
  front.priority_resampled = seen.resampled();
  std::vector<std::vector<Cell>> chains;
  const std::optional<PlanStatus> refused = problem.refused();
  front.status =
      refused ? *refused : planning::search_front(problem, options, watch, front.stats, chains);
  for (const std::vector<Cell>& chain : chains) {
    Answer answer(problem, watch);
    answer.offer(chain);
    Plan plan = answer.take();
    front.tallies.push_back(plan.tally);
    front.paths.push_back(std::move(plan.path));
  }
  front.stats.seconds = stopwatch.seconds();
  return front;
}

}  // namespace ltp
