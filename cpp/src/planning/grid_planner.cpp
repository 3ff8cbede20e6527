// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/grid_planner.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"
#include "ltp/grid/columns.hpp"

namespace ltp {
namespace {

constexpr double kShortest = 1e-6;  // no path into a region that has no length [m]

[[noreturn]] void broken(const std::string& what) {
  throw std::logic_error("ltp: a planner returned a path that " + what + " (please report this)");
}

void verify_ends(const Problem& problem, const PathRef& path) {
  const Point last = path.row(path.rows() - 1).transpose();
  if (path.row(0) != problem.query.start.transpose() ||
      (!problem.has_gates() && last != problem.query.goal)) {
    broken("does not lead from start to goal");
  }
}

/// Where it passes the gates, arc lengths [m].
std::vector<double> passed_by(const Problem& problem, const PathRef& path) {
  std::vector<double> passed;
  double so_far = 0.0;
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    if (i > 0) so_far += norm(Point((path.row(i) - path.row(i - 1)).transpose()));
    if (!problem.has_gates()) continue;
    const bool moved = i > 0 && path.row(i) != path.row(i - 1);
    if (passed.size() == problem.gates.size() && moved) broken("goes on where it is served");
    passed.resize(problem.passed_at(path.row(i).transpose(), passed.size()), so_far);
  }
  if (!problem.has_gates()) return {so_far};
  if (passed.size() < problem.gates.size()) broken("does not pass all gates");
  return passed;
}

void verify(const Problem& problem, const PathRef& path) {
  const GridFrame& frame = problem.frame();
  if (path.rows() < 2) broken("does not lead from start to goal");
  verify_ends(problem, path);
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    const Cell cell = frame.cell_of(path.row(i).transpose());
    if (!frame.contains(cell)) broken("leaves the window");
    if (!problem.levels.contains(cell)) broken("leaves its levels");
    if (!problem.altitudes.contains(path(i, 2))) broken("leaves its altitudes");
  }
  if (problem.grid().first_blocked(path)) broken("touches a blocked cell");
}

}  // namespace

Problem::Problem(const Scene& the_scene, const Query& the_query, const PenaltyWeights& the_weights)
    : scene(the_scene), query(the_query), weights(the_weights) {
  check_query(query);
  start = frame().cell_of(query.start);
  goal = frame().cell_of(query.goal);
  resolve();
  while (!gates.empty()) {
    const std::size_t usable = usable_gates();
    if (usable == gates.size()) break;
    query.then.resize(usable - 1);
    resolve();
  }
  passed_at_start = passed_at(query.start, 0);
  column_priority = is_constant_on_columns(scene.priority, frame());
}

/// What follows from the waypoints.
void Problem::resolve() {
  altitudes = altitudes_of(query);
  levels = levels_of(frame(), query);
  direct_length = ltp::direct_length(query);
  least_length = direct_length;
  gates.clear();
  if (!query.has_gates()) return;
  least_length = norm(query.goal - query.start);
  for (std::size_t i = 0; i < query.then.size(); ++i) {
    least_length += norm(query.then[i].point - (i == 0 ? query.goal : query.then[i - 1].point));
  }
  gates.emplace_back(frame(), altitudes, levels,
                     Gate{query.goal, query.gate_radius, query.gate_height});
  for (const Gate& gate : query.then) gates.emplace_back(frame(), altitudes, levels, gate);
  double farthest = kShortest;
  for (std::size_t i = 0; i < gates.size(); ++i) {
    const GateRegion& gate = gates[i];
    const bool last = i + 1 == gates.size();
    // The last is passed at its very point, and any other in its cell with it.
    const bool with_last = gate.own() == gates.back().own();
    const double own = last ? 0.0
                            : std::max(norm(vertex(gate.own()) - gate.gate().point),
                                       with_last ? norm(last_point() - gate.gate().point) : 0.0);
    const double reach = std::max(own, gate.reach());
    farthest = std::max(farthest, norm(gate.gate().point - query.start) - reach);
    least_length -= last ? reach : 2.0 * reach;
  }
  least_length = std::max(least_length, farthest);
}

/// The gates before the first one of the later ones that is blocked or beyond the window.
std::size_t Problem::usable_gates() const {
  for (std::size_t i = 1; i < gates.size(); ++i) {
    if (!gates[i].any_free(grid())) return i;
  }
  return gates.size();
}

std::size_t Problem::passed_at(const Point& point, std::size_t passed) const {
  for (; passed < gates.size(); ++passed) {
    const GateRegion& gate = gates[passed];
    const bool at_its_point = passed + 1 == gates.size() ? point == gate.gate().point
                                                         : frame().cell_of(point) == gate.own();
    if (!at_its_point && !gate.contains(point)) break;
  }
  return passed;
}

std::optional<PlanStatus> Problem::refused() const {
  const bool outside = has_gates() ? gates.front().outside() : !frame().contains(goal);
  if (!frame().contains(start) || outside) return PlanStatus::OutsideMap;
  if (has_gates() ? !gates.front().any_free(grid()) : grid().blocked(goal)) {
    return PlanStatus::GoalBlocked;
  }
  if (grid().blocked(start)) return PlanStatus::StartBlocked;
  return std::nullopt;
}

/// Whether a chain's end is the last waypoint's very point: where that passes all that is left.
static bool ends_at_point(const Problem& problem, const std::vector<Cell>& chain,
                          const PathRef& path) {
  if (chain.back() != problem.gates.back().own()) return false;
  std::size_t passed = problem.passed_at_start;
  for (Eigen::Index i = 1; i + 1 < path.rows(); ++i) {
    passed = problem.passed_at(path.row(i).transpose(), passed);
  }
  return problem.passed_at(problem.last_point(), passed) == problem.gates.size();
}

Path path_through(const Problem& problem, const std::vector<Cell>& chain) {
  const auto size = static_cast<Eigen::Index>(chain.size());
  Path path(std::max<Eigen::Index>(size, 2), 3);
  for (Eigen::Index i = 1; i + 1 < size; ++i) {
    path.row(i) = problem.vertex(chain[i]).transpose();
  }
  path.row(0) = problem.query.start.transpose();
  Point end = problem.last_point();
  if (problem.served()) {
    end = problem.query.start;
  } else if (problem.has_gates() && !ends_at_point(problem, chain, path)) {
    end = problem.vertex(chain.back());
  }
  path.row(path.rows() - 1) = end.transpose();
  return path;
}

Path until_served(const Problem& problem, const PathRef& path) {
  std::size_t passed = problem.passed_at_start;
  Eigen::Index last = 1;
  for (; last + 1 < path.rows(); ++last) {
    passed = problem.passed_at(path.row(last).transpose(), passed);
    if (passed == problem.gates.size()) break;
  }
  return path.topRows(last + 1);
}

Plan accepted(const Problem& problem, Path path, const Plan& plan) {
  if (problem.served()) path = path_through(problem, {});  // no loops
  verify(problem, path);
  Plan better;
  better.bound = plan.bound;
  better.priority_resampled = plan.priority_resampled;
  better.stats = plan.stats;
  better.status = PlanStatus::Found;
  better.path = std::move(path);
  better.passed = passed_by(problem, better.path);
  better.tally = tally(better.path, problem.scene.priority);
  const Point end = better.path.row(better.path.rows() - 1).transpose();
  better.penalty = Penalty(problem.weights, problem.direct_length)(
      better.tally, problem.scene.priority.at(end.x(), end.y()));
  return better;
}

bool Answer::offer(Path path) {
  Plan candidate = accepted(problem_, std::move(path), plan_);
  if (found() && !(candidate.penalty < plan_.penalty)) return false;
  plan_ = std::move(candidate);
  return true;
}

void Answer::take_over(Plan plan) {
  stats = plan.stats;
  plan_ = std::move(plan);
}

void Answer::end(PlanStatus status) {
  if (!found()) plan_.status = status;
}

void Answer::withdraw(PlanStatus status) {
  plan_ = Plan{};
  plan_.status = status;
}

void Answer::prove(std::optional<double> bound) {
  if (bound) bound = std::min(*bound, plan_.penalty);
  plan_.bound = bound;
}

GridPlanner::GridPlanner(const PlannerInfo& info, const PenaltyWeights& weights)
    : info_(info), weights_(weights) {
  weights.check();
}

/// A problem that its traits allow.
Plan GridPlanner::plan_for(const Problem& problem, BudgetWatch& watch, SearchStats& stats) {
  Answer answer(problem, watch);
  answer.stats = stats;
  if (const std::optional<PlanStatus> refused = problem.refused()) {
    answer.end(*refused);
  } else if (problem.has_gates() && problem.served()) {
    answer.offer(std::vector<Cell>{problem.start});
    if (info_.has(Trait::Bounds)) answer.prove(answer.plan().penalty);  // the only path
  } else {
    search(problem, answer);
  }
  stats = answer.stats;
  return answer.take();
}

void GridPlanner::check_traits(const Query& query) const {
  if (query.has_gates() && !info_.has(Trait::Regions)) {
    check::fail("gate_radius", query.gate_radius, "0: this planner needs `make_gated` for regions");
  }
  if (!query.then.empty() && !info_.has(Trait::Horizon)) {
    check::fail("then", query.then.size(), "no further gates: this planner needs `make_gated`");
  }
}

Plan GridPlanner::plan(const Scene& scene, const Query& query, const Budget& budget) {
  BudgetWatch watch(budget);
  const Stopwatch stopwatch;
  check_query(query);
  check_traits(query);
  const Scene seen = seen_.of(scene);
  SearchStats stats;
  Plan plan = plan_for(Problem(seen, query, weights_), watch, stats);
  // No way leads to one of them: which one, the search does not say.
  for (Query fewer = query; plan.status == PlanStatus::Unreachable && !fewer.then.empty();) {
    fewer.then.resize(Problem(seen, fewer, weights_).query.then.size());
    if (fewer.then.empty()) break;
    fewer.then.pop_back();
    plan = plan_for(Problem(seen, fewer, weights_), watch, stats);
  }
  plan.priority_resampled = seen_.resampled();
  plan.stats = stats;
  plan.stats.seconds = stopwatch.seconds();
  return plan;
}

}  // namespace ltp
