// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/pareto.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/stopwatch.hpp"

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMegabyte = 1e6;

PlannerOptions without_closing(PlannerOptions options) {
  options.linearised.closing = 0;
  return options;
}

}  // namespace

ParetoPlanner::ParetoPlanner(const PlannerOptions& options)
    : options_(options), sweep_("sweep", options.linearised.searches, without_closing(options)) {
  options.check();
}

Plan ParetoPlanner::plan(const Scene& scene, const Query& query) {
  const Stopwatch watch;
  // Asked no more once it has said so.
  Query watched = query;
  bool stopped = false;
  if (query.interrupted) {
    watched.interrupted = [&] { return stopped || (stopped = query.interrupted()); };
  }
  sweep_.forget();
  Plan plan = sweep_.plan(scene, watched);
  const auto out_of_budget = [&] {
    const std::int64_t limit = options_.max_expansions;
    return stopped || (limit > 0 && plan.stats.expanded >= limit);
  };
  if (plan.status == PlanStatus::Found && !(plan.bound && *plan.bound == plan.penalty)) {
    PlanStatus status = PlanStatus::OutOfBudget;
    if (!out_of_budget()) {
      const Budget budget(options_.max_expansions, watched.interrupted);
      const ExactSearch::Limits limits{options_.pareto.eps, 0.0,
                                       options_.pareto.memory * kMegabyte};
      status = exact_.improve(scene, query, resolve(scene, query).cells, options_.weights, limits,
                              budget, plan);
      plan.bound = exact_.proved();
    }
    if (status != PlanStatus::Found) {
      const SearchStats stats = plan.stats;
      plan = Plan{};
      plan.stats = stats;
      plan.status = status;
    }
  }
  plan.stats.seconds = watch.seconds();
  return plan;
}

Path ParetoPlanner::path_of(const GridFrame& frame, const Query& query,
                            const std::vector<std::uint32_t>& chain) const {
  std::vector<Cell> cells;
  for (const std::uint32_t node : chain) cells.push_back(graph_.cell(node));
  return path_through(frame, query, cells);
}

Front ParetoPlanner::front(const Scene& scene, const Query& query, double eps) {
  check::not_negative("eps", eps);
  const Stopwatch watch;
  Front front;
  const auto [refused, cells] = resolve(scene, query);
  const Budget budget(options_.max_expansions, query.interrupted);
  const auto search = [&, &cells = cells] {
    const GridFrame& frame = scene.occupancy.frame();
    const double memory = options_.pareto.memory * kMegabyte;
    costs_.reset(scene, query, cells, static_cast<double>(frame.size()) * frame.cell().norm());
    if (!corridor_.find(scene, cells, costs_, 1.0, kInfinity, budget, front.stats, cells_)) {
      return PlanStatus::OutOfBudget;
    }
    if (std::find(cells_.begin(), cells_.end(), cells.start) == cells_.end()) {
      return PlanStatus::Unreachable;
    }
    graph_.build(scene, cells, costs_, cells_);
    Guide loss;
    if (!least_costs(graph_, graph_.goal(), {1.0, 0.0}, budget, front.stats, open_,
                     length_to_goal_) ||
        !least_costs(graph_, graph_.goal(), {0.0, 1.0}, budget, front.stats, open_, loss.to_goal)) {
      return PlanStatus::OutOfBudget;
    }
    std::vector<FrontSearch::Solution> found;
    const PlanStatus status = fronts_.run({graph_, length_to_goal_, loss.to_goal, 1.0 + eps,
                                           memory - static_cast<double>(graph_.bytes())},
                                          budget, front.stats, found);
    if (status != PlanStatus::Found) return status;
    for (const FrontSearch::Solution& solution : found) {
      Plan plan;
      accept(scene, query, cells, options_.weights, path_of(frame, query, solution.chain), plan);
      front.tallies.push_back(plan.tally);
      front.paths.push_back(std::move(plan.path));
    }
    return status;
  };
  front.status = refused ? *refused : search();
  front.stats.seconds = watch.seconds();
  return front;
}

}  // namespace ltp
