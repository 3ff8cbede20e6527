// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/additive_search.hpp"

#include <algorithm>

namespace ltp {

AdditiveResult AdditiveSearch::run(const Scene& scene, const Query& query, const GridQuery& cells,
                                   const AdditiveCost& cost, const Budget& budget,
                                   SearchStats& stats) {
  const GridFrame& frame = scene.occupancy.frame();
  const std::array<double, kSteps> lengths = step_lengths(frame.cell());
  priority_.reset(frame, scene.priority);
  space_.begin(frame, cells.levels);
  open_.clear();
  field_.begin(frame, priority_, cost.length, cost.priority, cells.start.x(), cells.start.y());

  // The field begins at the centre of the start's column, the path at the start itself: the last
  // step may be shorter, and pass over better ground, than the field's. What it can save at most is
  // taken off, so that the bound stays one.
  const double diagonal = frame.cell().head<2>().norm();
  const double slack = cost.length * (frame.centre(cells.start) - query.start).head<2>().norm() +
                       cost.priority * 2.0 * diagonal * std::max(scene.priority.maximum(), 0.0);
  const auto heuristic = [&](const Cell& cell) {
    return std::max(0.0, field_(cell.x(), cell.y()) - slack);
  };
  // The ends are points, not centres; such a step is tallied exactly.
  const auto place = [&](const Cell& cell) -> Point {
    if (cell == cells.start) return query.start;
    if (cell == cells.goal) return query.goal;
    return frame.centre(cell);
  };
  const auto step_cost = [&](const Cell& from, const Cell& to, double length) {
    if (from == cells.goal || to == cells.start) {
      const Point a = place(from);
      const Point b = place(to);
      return cost((b - a).norm(), scene.priority.integral(a, b));
    }
    return cost(length, 0.5 * length * (priority_(from.x(), from.y()) + priority_(to.x(), to.y())));
  };

  AdditiveResult result;
  const std::uint32_t start = space_.index(cells.start);
  const std::uint32_t goal = space_.index(cells.goal);
  space_.visit(goal).labelled = true;
  open_.push({heuristic(cells.goal), heuristic(cells.goal), goal});
  ++stats.pushed;
  while (!open_.empty()) {
    const std::uint32_t index = open_.pop().cell;
    Node& node = space_.visit(index);
    if (node.closed) continue;
    node.closed = true;
    ++stats.expanded;
    if (index == start) {
      result.status = PlanStatus::Found;
      result.cost = node.cost;
      break;
    }
    if (budget.spent(stats.expanded)) {
      result.status = PlanStatus::OutOfBudget;
      return result;
    }
    const Cell cell = space_.cell(index);
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;
      const Cell next = cell + Cell(step.dx, step.dy, step.dz);
      const std::uint32_t next_index = space_.index(next);
      Node& other = space_.visit(next_index);
      if (other.closed) continue;
      const double total = node.cost + step_cost(cell, next, lengths[i]);
      if (other.labelled && total >= other.cost) continue;
      other.labelled = true;
      other.cost = total;
      other.to_goal = step.opposite;
      const double h = heuristic(next);
      open_.push({total + h, h, next_index});
      ++stats.pushed;
    }
  }
  if (result.status != PlanStatus::Found) {
    result.status = PlanStatus::Unreachable;
    return result;
  }
  result.chain.push_back(cells.start);
  while (result.chain.back() != cells.goal) {
    const Step& step = steps()[space_[space_.index(result.chain.back())].to_goal];
    result.chain.push_back(result.chain.back() + Cell(step.dx, step.dy, step.dz));
  }
  return result;
}

}  // namespace ltp
