// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/corridor.hpp"

#include <limits>

namespace ltp::planning {

/// From the start's neighbours on, whose steps are exact; no step in space costs less than its
/// shadow.
void Corridor::spread_over_columns(const GridFrame& frame, const StepCosts& costs, double beta,
                                   double most) {
  const auto column = [&](int ix, int iy) {
    return static_cast<std::uint32_t>(ix * frame.ny() + iy);
  };
  over_columns_.assign(static_cast<std::size_t>(frame.nx()) * frame.ny(),
                       std::numeric_limits<double>::infinity());
  open_.clear();
  const auto offer = [&](int ix, int iy, double cost) {
    double& mine = over_columns_[column(ix, iy)];
    if (cost >= mine || cost > most) return;
    mine = cost;
    open_.push({cost, 0.0, column(ix, iy)});
  };
  for (int i = 0; i < kSteps; ++i) {
    const Cell next = costs.start() + steps()[i].offset();
    if (!frame.contains(next)) continue;
    const StepCost cost = costs(costs.start(), i);
    offer(next.x(), next.y(), beta * cost.length + cost.loss);
  }
  while (!open_.empty()) {
    const OpenEntry entry = open_.pop();
    if (entry.f > over_columns_[entry.cell]) continue;
    const int ix = static_cast<int>(entry.cell) / frame.ny();
    const int iy = static_cast<int>(entry.cell) % frame.ny();
    const double here = costs.priority(ix, iy);
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      const int jx = ix + step.dx;
      const int jy = iy + step.dy;
      if (step.dz != 0 || !frame.contains(Cell(jx, jy, 0))) continue;
      const StepCost cost = costs.between(costs.lengths()[i], here, costs.priority(jx, jy));
      offer(jx, jy, entry.f + beta * cost.length + cost.loss);
    }
  }
}

bool Corridor::find(const Problem& problem, const StepCosts& costs, double beta, double most,
                    BudgetWatch& budget, SearchStats& stats, std::vector<Cell>& cells) {
  const GridFrame& frame = problem.frame();
  spread_over_columns(frame, costs, beta, most);
  const auto heuristic = [&](const Cell& cell) {
    if (cell == problem.start) return 0.0;
    // The last step to the goal's own point may be shorter than the one to its column's centre.
    if (cell == problem.goal) return 0.0;
    return over_columns_[static_cast<std::size_t>(cell.x()) * frame.ny() + cell.y()];
  };
  cells.clear();
  space_.begin(frame, problem.levels);
  open_.clear();
  const std::uint32_t goal = space_.index(problem.goal);
  space_.visit(goal).labelled = true;
  open_.push({0.0, 0.0, goal});
  ++stats.pushed;
  while (!open_.empty()) {
    const std::uint32_t index = open_.pop().cell;
    Node& node = space_.visit(index);
    if (node.closed) continue;
    node.closed = true;
    const Cell cell = space_.cell(index);
    cells.push_back(cell);
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return false;
    if (cell == problem.start) continue;  // no path leads through its own start
    const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
    for (int i = 0; i < kSteps; ++i) {
      if (blocked & steps()[i].box) continue;
      const Cell next = cell + steps()[i].offset();
      const std::uint32_t next_index = space_.index(next);
      Node& other = space_.visit(next_index);
      if (other.closed) continue;
      const StepCost cost = costs(cell, i);
      const double total = node.cost + beta * cost.length + cost.loss;
      if (other.labelled && total >= other.cost) continue;
      const double h = heuristic(next);
      if (total + h > most) continue;
      other.labelled = true;
      other.cost = total;
      open_.push({total + h, h, next_index});
      ++stats.pushed;
    }
  }
  return true;
}

}  // namespace ltp::planning
