// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/gated.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp {
namespace planning {
namespace {

class GatedPlanner final : public Planner {
 public:
  GatedPlanner(std::unique_ptr<Planner> planner, const PenaltyWeights& weights)
      : planner_(std::move(planner)), weights_(weights) {}

  const PlannerInfo& info() const override { return planner_->info(); }
  const PenaltyWeights& weights() const override { return weights_; }

  Plan plan(const Scene& scene, const Query& query, const Budget& budget) override {
    const bool knows = !query.has_gates() || (query.then.empty() && info().has(Trait::Regions));
    if (knows) return planner_->plan(scene, query, budget);
    BudgetWatch watch(budget);
    const Stopwatch stopwatch;
    check_query(query);
    const Scene seen = seen_.of(scene);
    const bool resampled = seen_.resampled();
    Plan plan = leg_by_leg(seen, query, budget, watch);
    plan.bound.reset();
    plan.priority_resampled = resampled;
    plan.stats.seconds = stopwatch.seconds();
    return plan;
  }

 private:
  Plan leg_by_leg(const Scene& scene, const Query& query, const Budget& budget,
                  BudgetWatch& watch) {
    const Problem problem(scene, query, weights_);
    Plan sum;
    if (const std::optional<PlanStatus> refused = problem.refused()) {
      sum.status = *refused;
      return sum;
    }
    std::vector<Path> legs(1, path_through(problem, {problem.start}).topRows(1));
    std::size_t passed = problem.passed_at_start;
    while (passed < problem.gates.size()) {
      const Point from = legs.back().row(legs.back().rows() - 1).transpose();
      Plan leg = plan_leg(problem, from, passed, budget, watch, sum.stats);
      sum.status = leg.status;
      if (leg.status != PlanStatus::Found) break;
      for (Eigen::Index i = 1; i < leg.path.rows() && passed < problem.gates.size(); ++i) {
        passed = problem.passed_at(leg.path.row(i).transpose(), passed);
      }
      legs.push_back(std::move(leg.path));
    }
    if (passed == 0) return sum;
    if (passed < problem.gates.size()) return first_ones(scene, problem.query, passed, watch, sum);
    return accepted(problem, until_served(problem, joined(legs)), sum);
  }

  /// Without the gates to which no way was found: the last one that is left is passed otherwise.
  Plan first_ones(const Scene& scene, Query query, std::size_t count, BudgetWatch& watch,
                  const Plan& before) {
    query.then.resize(count - 1);
    Budget budget = watch.rest();
    if (budget.max_expansions > 0) {
      budget.max_expansions =
          std::max<std::int64_t>(1, budget.max_expansions - before.stats.expanded);
    }
    Plan fewer = plan(scene, query, budget);
    fewer.stats.expanded += before.stats.expanded;
    fewer.stats.pushed += before.stats.pushed;
    return fewer;
  }

  /// A leg to the next gate. Adds what it did to `stats`.
  Plan plan_leg(const Problem& problem, const Point& from, std::size_t passed, const Budget& budget,
                BudgetWatch& watch, SearchStats& stats) {
    const GateRegion& gate = problem.gates[passed];
    Query query{from, gate.gate().point, {}};
    if (info().has(Trait::Regions) && gate.gate().radius > 0.0) {
      query.gate_radius = gate.gate().radius;
      query.gate_height = gate.gate().height;
    } else {
      const std::optional<Point> end = nearest_end(problem, from, passed);
      if (!end) return none(PlanStatus::Unreachable);
      query.goal = *end;
    }
    // The altitudes of the whole route.
    const std::pair<double, double> ends = std::minmax({from.z(), query.goal.z()});
    query.band.below = std::max(0.0, ends.first - problem.altitudes.lowest);
    query.band.above = std::max(0.0, problem.altitudes.highest - ends.second);
    Budget rest = watch.rest();
    if (budget.max_expansions > 0) {
      rest.max_expansions -= stats.expanded;
      if (rest.max_expansions <= 0) return none(PlanStatus::OutOfBudget);
    }
    Plan leg = planner_->plan(problem.scene, query, rest);
    stats.expanded += leg.stats.expanded;
    stats.pushed += leg.stats.pushed;
    return leg;
  }

  /// Of the vertices in a gate that can be reached the nearest one; the waypoint's point counts as
  /// that of its cell for the last gate.
  std::optional<Point> nearest_end(const Problem& problem, const Point& from, std::size_t passed) {
    const GateRegion& gate = problem.gates[passed];
    const bool last = passed + 1 == problem.gates.size();
    flood_.fill(problem.grid(), problem.frame().cell_of(from), problem.levels);
    std::optional<Point> nearest;
    double least = std::numeric_limits<double>::infinity();
    gate.for_each([&](const Cell& cell) {
      if (!flood_.reached(cell)) return;
      const Point end = last && cell == gate.own() ? gate.gate().point : problem.vertex(cell);
      const double distance = (end - from).norm();
      if (distance >= least) return;
      least = distance;
      nearest = end;
    });
    return nearest;
  }

  static Plan none(PlanStatus status) {
    Plan plan;
    plan.status = status;
    return plan;
  }

  /// Each begins where the one before ends.
  static Path joined(const std::vector<Path>& legs) {
    Eigen::Index rows = 1;
    for (const Path& leg : legs) rows += leg.rows() - 1;
    Path path(std::max<Eigen::Index>(rows, 2), 3);
    path.bottomRows(1) = legs.front().topRows(1);
    Eigen::Index row = 0;
    for (const Path& leg : legs) {
      path.middleRows(row, leg.rows()) = leg;
      row += leg.rows() - 1;
    }
    return path;
  }

  std::unique_ptr<Planner> planner_;
  PenaltyWeights weights_;
  ColumnScene seen_;
  Flood flood_;
};

}  // namespace
}  // namespace planning

std::unique_ptr<Planner> make_gated(std::unique_ptr<Planner> planner,
                                    const PenaltyWeights& weights) {
  if (!planner) check::fail("planner", "null", "a planner");
  if (planner->info().has(Trait::Regions | Trait::Horizon)) return planner;
  return std::make_unique<planning::GatedPlanner>(std::move(planner), weights);
}

}  // namespace ltp
