// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/additive_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "planning/search/trace.hpp"

namespace ltp::planning {
namespace {

constexpr std::int64_t kPatience = 4096;  // expansions before the flood
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The steps to one of the 3 x 3 columns round a cell: their numbers by dz + 1; -1: no step.
struct ColumnSteps {
  int dx, dy;
  std::array<std::int8_t, 3> number;
};

std::array<ColumnSteps, 9> make_column_steps() {
  std::array<ColumnSteps, 9> all{};
  for (int k = 0; k < 9; ++k) all[k] = {k / 3 - 1, k % 3 - 1, {-1, -1, -1}};
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    all[(step.dx + 1) * 3 + step.dy + 1].number[step.dz + 1] = static_cast<std::int8_t>(i);
  }
  return all;
}

const std::array<ColumnSteps, 9>& column_steps() {
  static const std::array<ColumnSteps, 9> all = make_column_steps();
  return all;
}

/// By how much a step up from a level is longer than the same one that stays there, at least.
double min_climb(const LevelLengths::Lengths& lengths) {
  double least = kInfinity;
  for (const ColumnSteps& column : column_steps()) {
    const double level = column.number[1] < 0 ? 0.0 : lengths[column.number[1]];
    least = std::min(least, lengths[column.number[2]] - level);
  }
  return least;
}

}  // namespace

AdditiveSearch::AdditiveSearch() : proof_(UnreachableProof::From::Goal, kPatience) {}

AdditiveResult AdditiveSearch::run(const Problem& problem, const AdditiveCost& cost,
                                   BudgetWatch& budget, SearchStats& stats, double longest) {
  const Query& query = problem.query;
  if (problem.within_a_cell()) {
    const double straight = cost.along(problem.scene.priority, query.start, query.goal);
    return {PlanStatus::Found, straight, {problem.start}};
  }
  if (proof_.at_once(problem) || !begin(problem, cost, longest)) {
    return {PlanStatus::Unreachable, 0.0, {}};
  }
  ++stats.pushed;
  const auto [status, least] = search(problem, cost, budget, stats);
  if (status != PlanStatus::Found) return {status, least, {}};
  AdditiveResult result{status, least, {}};
  const auto back = [&](const Cell& cell) -> Cell {
    return -steps()[space_[space_.index(cell)].from_start].offset();
  };
  trace(problem.goal, problem.start, back, result.chain);
  std::reverse(result.chain.begin(), result.chain.end());
  return result;
}

/// Lists the start; false if it is walled in over all levels.
bool AdditiveSearch::begin(const Problem& problem, const AdditiveCost& cost, double longest) {
  proof_.begin();
  space_.begin(problem.frame(), problem.levels);
  field_.aim(problem, cost, longest);
  const std::uint32_t start = space_.index(problem.start);
  space_.visit(start).from_start = kSteps;
  space_.visit(space_.index(problem.goal)).cost = kInfinity;
  const double estimate = field_(problem.start.x(), problem.start.y());
  if (estimate == kInfinity) return false;
  // The field begins at the centre of the start's column: from the start itself the first step may
  // be shorter, and over better ground. No step raises an estimate by more than twice its own cost.
  const double dearest = cost.length * problem.frame().cell().norm();
  const double first = std::max(0.0, estimate - 3.0 * dearest);
  open_.begin(first, 6.0 * dearest / (BucketQueue::kBuckets - 4));
  open_.push({first, 0.0, start});
  return true;
}

/// The last step into the goal may climb a level for next to nothing: the goal is no vertex.
void AdditiveSearch::set_climbs(const Problem& problem, double metre) {
  const LevelRange& levels = problem.levels;
  const int goal = problem.goal.z();
  lengths_.reset(problem);
  climbs_.assign(levels.count(), 0.0);
  const auto climb = [&](int level) -> double& { return climbs_[level - levels.lowest]; };
  if (problem.even()) {
    const double one = min_climb(lengths_.from(levels.lowest)) * metre;
    for (int level = levels.lowest; level <= levels.highest; ++level) {
      climb(level) = one * std::max(0, std::abs(level - goal) - 1);
    }
    return;
  }
  for (int level = goal + 2; level <= levels.highest; ++level) {
    climb(level) = climb(level - 1) + min_climb(lengths_.from(level - 1)) * metre;
  }
  for (int level = goal - 2; level >= levels.lowest; --level) {
    climb(level) = climb(level + 1) + min_climb(lengths_.from(level)) * metre;
  }
}

/// The status, and with it the least cost: of the path found, or of all paths if out of budget.
std::pair<PlanStatus, double> AdditiveSearch::search(const Problem& problem,
                                                     const AdditiveCost& cost, BudgetWatch& budget,
                                                     SearchStats& stats) {
  const double most = std::max(problem.scene.priority.maximum(), 0.0);
  set_climbs(problem, std::max(0.0, cost.length - cost.priority * most));
  const int lowest = problem.levels.lowest;
  const std::uint32_t start = space_.index(problem.start);
  const std::uint32_t goal = space_.index(problem.goal);
  Node& goal_node = space_.visit(goal);
  while (!open_.empty()) {
    const BucketQueue::Entry entry = open_.pop();
    if (entry.value >= goal_node.cost) break;
    const std::uint32_t index = entry.cell;
    if (entry.cost != space_[index].cost) continue;  // stale
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return {PlanStatus::OutOfBudget, entry.value};
    if (proof_.after_expansion(problem)) break;
    const Cell cell = space_.cell(index);
    const double here = field_.half_metre(cell.x(), cell.y());
    const LevelLengths::Lengths& lengths = lengths_.from(cell.z());
    const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
    for (const ColumnSteps& column : column_steps()) {
      const int jx = cell.x() + column.dx;
      const int jy = cell.y() + column.dy;
      double metre = -1.0;  // cost of a metre on the way to this column, once it is needed
      double ground = 0.0;  // the field's value there
      const std::uint32_t level = space_.index(Cell(jx, jy, cell.z()));
      for (const std::int8_t number : column.number) {
        if (number < 0 || (blocked & steps()[number].box)) continue;
        if (metre < 0.0) {
          metre = here + field_.half_metre(jx, jy);
          ground = field_(jx, jy);
        }
        const Cell next(jx, jy, cell.z() + steps()[number].dz);
        const std::uint32_t next_index = level + static_cast<std::uint32_t>(next.z() - cell.z());
        const bool end = index == start || next_index == goal;  // such a step is tallied exactly
        const double total =
            entry.cost + (end ? cost.along(problem.scene.priority, problem.point_of(cell),
                                           problem.point_of(next))
                              : lengths[number] * metre);
        Node& other = space_.visit(next_index);
        if (other.from_start >= 0 && total >= other.cost) continue;
        const double value =
            total + (next_index == goal ? 0.0 : ground + climbs_[next.z() - lowest]);
        if (value >= goal_node.cost) continue;
        other.cost = total;
        other.from_start = number;
        if (next_index == goal) continue;
        open_.push({value, total, next_index});
        ++stats.pushed;
      }
    }
  }
  if (goal_node.from_start < 0) return {PlanStatus::Unreachable, 0.0};
  return {PlanStatus::Found, goal_node.cost};
}

}  // namespace ltp::planning
