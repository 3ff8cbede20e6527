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

constexpr double kWithin =
    1e-9;  // what an altitude may be off, and a band may touch of a level [m]

[[noreturn]] void broken(const std::string& what) {
  throw std::logic_error("ltp: a planner returned a path that " + what + " (please report this)");
}

void verify(const Problem& problem, const PathRef& path) {
  const GridFrame& frame = problem.frame();
  if (path.rows() < 2 || path.row(0) != problem.query.start.transpose() ||
      path.row(path.rows() - 1) != problem.query.goal.transpose()) {
    broken("does not lead from start to goal");
  }
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    const Cell cell = frame.cell_of(path.row(i).transpose());
    if (!frame.contains(cell)) broken("leaves the window");
    if (!problem.levels.contains(cell)) broken("leaves its levels");
    if (!problem.altitudes.contains(path(i, 2))) broken("leaves its altitudes");
  }
  if (problem.grid().first_blocked(path)) broken("touches a blocked cell");
}

}  // namespace

void check_query(const Query& query) {
  check::finite("start", query.start);
  check::finite("goal", query.goal);
  // An infinite band is open to the whole window.
  if (!(query.band.below >= 0.0)) check::fail("band.below", query.band.below, "a number >= 0");
  if (!(query.band.above >= 0.0)) check::fail("band.above", query.band.above, "a number >= 0");
}

bool AltitudeRange::contains(double z) const {
  const double rounding = kWithin + 1e-15 * std::abs(z);
  return z >= lowest - rounding && z <= highest + rounding;
}

AltitudeRange altitudes_of(const Query& query) {
  return {std::min(query.start.z(), query.goal.z()) - query.band.below,
          std::max(query.start.z(), query.goal.z()) + query.band.above};
}

LevelRange levels_of(const GridFrame& frame, const Query& query) {
  const auto level = [&](double z) {
    if (z <= frame.origin().z()) return 0;  // an open band has no cell of its own
    if (z >= frame.upper().z()) return frame.nz() - 1;
    return std::clamp(frame.cell_of(Point(query.start.x(), query.start.y(), z)).z(), 0,
                      frame.nz() - 1);
  };
  const AltitudeRange open = altitudes_of(query);
  const double face = kWithin * std::min(1.0, frame.cell().z());
  const std::pair<int, int> ends = std::minmax({level(query.start.z()), level(query.goal.z())});
  return {std::min(ends.first, level(open.lowest + face)),
          std::max(ends.second, level(open.highest - face))};
}

Point vertex_of(const GridFrame& frame, const AltitudeRange& altitudes, const Cell& cell) {
  Point point = frame.centre(cell);
  point.z() = std::clamp(point.z(), altitudes.lowest, altitudes.highest);
  return point;
}

Problem::Problem(const Scene& the_scene, const Query& the_query, const PenaltyWeights& the_weights)
    : scene(the_scene), query(the_query), weights(the_weights) {
  check_query(query);
  start = frame().cell_of(query.start);
  goal = frame().cell_of(query.goal);
  altitudes = altitudes_of(query);
  levels = levels_of(frame(), query);
  direct_length = norm(query.goal - query.start);
  column_priority = is_constant_on_columns(scene.priority, frame());
}

std::optional<PlanStatus> Problem::refused() const {
  if (!frame().contains(start) || !frame().contains(goal)) return PlanStatus::OutsideMap;
  if (grid().blocked(goal)) return PlanStatus::GoalBlocked;
  if (grid().blocked(start)) return PlanStatus::StartBlocked;
  return std::nullopt;
}

Path path_through(const Problem& problem, const std::vector<Cell>& chain) {
  const auto size = static_cast<Eigen::Index>(chain.size());
  Path path(std::max<Eigen::Index>(size, 2), 3);
  for (Eigen::Index i = 1; i + 1 < size; ++i) {
    path.row(i) = problem.vertex(chain[i]).transpose();
  }
  path.row(0) = problem.query.start.transpose();
  path.row(path.rows() - 1) = problem.query.goal.transpose();
  return path;
}

Plan accepted(const Problem& problem, Path path, const Plan& plan) {
  if (problem.query.start == problem.query.goal) path = path_through(problem, {});  // no loops
  verify(problem, path);
  Plan better;
  better.bound = plan.bound;
  better.priority_resampled = plan.priority_resampled;
  better.stats = plan.stats;
  better.status = PlanStatus::Found;
  better.path = std::move(path);
  better.tally = tally(better.path, problem.scene.priority);
  const Point& goal = problem.query.goal;
  better.penalty = Penalty(problem.weights, problem.direct_length)(
      better.tally, problem.scene.priority.at(goal.x(), goal.y()));
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

Plan GridPlanner::plan(const Scene& scene, const Query& query, const Budget& budget) {
  BudgetWatch watch(budget);
  const Stopwatch stopwatch;
  check_query(query);
  const Problem problem(seen_.of(scene), query, weights_);
  Answer answer(problem, watch);
  if (const std::optional<PlanStatus> refused = problem.refused()) {
    answer.end(*refused);
  } else {
    search(problem, answer);
  }
  Plan plan = answer.take();
  plan.priority_resampled = seen_.resampled();
  plan.stats = answer.stats;
  plan.stats.seconds = stopwatch.seconds();
  return plan;
}

}  // namespace ltp
