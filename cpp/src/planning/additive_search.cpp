// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/additive_search.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace ltp {
namespace {

/// After so many expansions the goal's side is asked whether there is a way at all: a flood costs
/// about as much as they did.
constexpr std::int64_t kExpandedBeforeFlood = 4096;

/// Visits to columns before the first expansion: some 20 us, enough for most buildings.
constexpr std::size_t kVisitsAtFirst = 1024;

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

/// By how much a step that changes the level is longer than the same one that does not, at least.
double least_climb(const std::array<double, kSteps>& lengths) {
  double least = std::numeric_limits<double>::infinity();
  for (const ColumnSteps& column : column_steps()) {
    const double level = column.number[1] < 0 ? 0.0 : lengths[column.number[1]];
    least = std::min(least, lengths[column.number[2]] - level);
  }
  return least;
}

std::vector<Cell> reversed(std::vector<Cell> chain) {
  std::reverse(chain.begin(), chain.end());
  return chain;
}

}  // namespace

AdditiveResult AdditiveSearch::run(const Scene& scene, const Query& query, const GridQuery& cells,
                                   const AdditiveCost& cost, const Budget& budget,
                                   SearchStats& stats, double longest) {
  AdditiveResult result;
  if (cells.start == cells.goal) {
    result.status = PlanStatus::Found;
    result.cost =
        cost((query.goal - query.start).norm(), scene.priority.integral(query.start, query.goal));
    result.chain = {cells.start};
    return result;
  }
  if (flood_.parts(scene.occupancy, cells.goal, cells.start, cells.levels, kVisitsAtFirst)) {
    result.status = PlanStatus::Unreachable;
    return result;
  }
  const GridFrame& frame = scene.occupancy.frame();
  const std::array<double, kSteps> lengths = step_lengths(frame.cell());
  space_.begin(frame, cells.levels);
  field_.aim(scene, cost, query, cells, longest);

  // The last step into the goal may climb a level for next to nothing: the goal is no centre.
  const double climb =
      least_climb(lengths) *
      std::max(0.0, cost.length - cost.priority * std::max(scene.priority.maximum(), 0.0));
  const auto height = [&](int level) {
    return climb * std::max(0, std::abs(level - cells.goal.z()) - 1);
  };
  // The ends are points, not centres; such a step is tallied exactly.
  const auto end_step = [&](const Cell& from, const Cell& to) {
    const Point a = from == cells.start ? query.start : frame.centre(from);
    const Point b = to == cells.goal ? query.goal : frame.centre(to);
    return cost((b - a).norm(), scene.priority.integral(a, b));
  };

  const std::uint32_t start = space_.index(cells.start);
  const std::uint32_t goal = space_.index(cells.goal);
  space_.visit(start).from_start = kSteps;
  Node& goal_node = space_.visit(goal);
  goal_node.cost = std::numeric_limits<double>::infinity();
  const double estimate = field_(cells.start.x(), cells.start.y());
  if (estimate == std::numeric_limits<double>::infinity()) {  // walled in over all levels
    result.status = PlanStatus::Unreachable;
    return result;
  }
  // The field begins at the centre of the start's column: from the start itself the first step may
  // be shorter, and over better ground. No step raises an estimate by more than twice its own cost.
  const double dearest = cost.length * frame.cell().norm();
  const double first = std::max(0.0, estimate - 3.0 * dearest);
  open_.begin(first, 6.0 * dearest / (BucketQueue::kBuckets - 4));
  open_.push({first, 0.0, start});
  ++stats.pushed;
  std::int64_t expanded = 0;
  while (!open_.empty()) {
    const BucketQueue::Entry entry = open_.pop();
    if (entry.value >= goal_node.cost) break;
    const std::uint32_t index = entry.cell;
    if (entry.cost != space_[index].cost) continue;  // stale
    ++stats.expanded;
    if (budget.spent(stats.expanded)) {
      result.status = PlanStatus::OutOfBudget;
      result.cost = entry.value;
      return result;
    }
    if (++expanded == kExpandedBeforeFlood) {
      flood_.fill(scene.occupancy, cells.goal, cells.levels);
      if (!flood_.reached(cells.start)) break;
    }
    const Cell cell = space_.cell(index);
    const double here = field_.half_metre(cell.x(), cell.y());
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
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
        const bool end = index == start || next_index == goal;
        const double total = entry.cost + (end ? end_step(cell, next) : lengths[number] * metre);
        Node& other = space_.visit(next_index);
        if (other.from_start >= 0 && total >= other.cost) continue;
        const double value = total + (next_index == goal ? 0.0 : ground + height(next.z()));
        if (value >= goal_node.cost) continue;
        other.cost = total;
        other.from_start = number;
        if (next_index == goal) continue;
        open_.push({value, total, next_index});
        ++stats.pushed;
      }
    }
  }
  if (goal_node.from_start < 0) {
    result.status = PlanStatus::Unreachable;
    return result;
  }
  result.status = PlanStatus::Found;
  result.cost = goal_node.cost;
  result.chain.push_back(cells.goal);
  while (result.chain.back() != cells.start) {
    const Step& step = steps()[space_[space_.index(result.chain.back())].from_start];
    result.chain.push_back(result.chain.back() - Cell(step.dx, step.dy, step.dz));
  }
  result.chain = reversed(std::move(result.chain));
  return result;
}

}  // namespace ltp
