// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/corridor.hpp"

#include <algorithm>
#include <limits>

namespace ltp::planning {
namespace {

constexpr double kAny = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
constexpr double kLeast = 1e-100;  // the field's metre must cost something
constexpr int kAllLevels = std::numeric_limits<int>::max();

}  // namespace

bool Corridor::find(const Problem& problem, const StepCosts& costs, double beta, double most,
                    BudgetWatch& budget, SearchStats& stats, std::vector<Cell>& cells) {
  const GridFrame& frame = problem.frame();
  const Query& query = problem.query;
  const Problem back(problem.scene, {query.goal, query.start, query.band}, problem.weights);
  // beta L + R = (beta + p_max) L - P; p_max is the largest of this window alone.
  to_start_.aim(back, {std::max(kLeast, beta + costs.max_priority()), 1.0}, kAny, kAllLevels);
  // Its sums are not rounded as the graph's costs are.
  const double columns = static_cast<double>(frame.nx()) * frame.ny();
  const double limit = most + columns * ((beta + 2.0) * costs.unit() + kEpsilon * most);
  const auto heuristic = [&](const Cell& cell) {
    if (cell == problem.start) return 0.0;
    // The last step to the goal's own point may be shorter than the one to its column's centre.
    if (cell == problem.goal) return 0.0;
    return to_start_(cell.x(), cell.y());
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
      if (total + h > limit) continue;
      other.labelled = true;
      other.cost = total;
      open_.push({total + h, h, next_index});
      ++stats.pushed;
    }
  }
  return true;
}

}  // namespace ltp::planning
