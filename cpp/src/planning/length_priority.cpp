// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/length_priority.hpp"

#include "ltp/geometry/check.hpp"

namespace ltp {

LengthPriorityPlanner::LengthPriorityPlanner(std::string name, double heuristic_weight,
                                             const PlannerOptions& options)
    : name_(std::move(name)), heuristic_weight_(heuristic_weight), options_(options) {
  options.check();
  check::not_negative("heuristic_weight", heuristic_weight);
}

Plan LengthPriorityPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    const bool only_length = heuristic_weight_ == 0.0 && options_.weights.priority == 0.0;
    plan.status = only_length ? dijkstra(scene, query, cells, plan.stats)
                              : search(scene, query, cells, plan.stats);
    if (plan.status == PlanStatus::Found) {
      accept(scene, query, cells, options_.weights, chain_, plan);
    }
  });
}

PlanStatus LengthPriorityPlanner::dijkstra(const Scene& scene, const Query& query,
                                           const GridQuery& cells, SearchStats& stats) {
  const Budget budget(options_.max_expansions, query.interrupted);
  const PlanStatus status =
      field_.run(scene.occupancy, cells.goal, cells.levels, budget, stats, cells.start);
  if (status == PlanStatus::Found) chain_ = field_.chain_from(cells.start);
  return status;
}

PlanStatus LengthPriorityPlanner::search(const Scene& scene, const Query& query,
                                         const GridQuery& cells, SearchStats& stats) {
  const GridFrame& frame = scene.occupancy.frame();
  const std::array<double, kSteps> lengths = step_lengths(frame.cell());
  const Penalty penalty(options_.weights, cells.direct_length);
  const Budget budget(options_.max_expansions, query.interrupted);
  priority_.reset(frame, scene.priority);
  space_.begin(frame, cells.levels);
  open_.begin(-options_.weights.priority,
              2.0 * (options_.weights.length + options_.weights.priority));

  // Eq. (9), times W_A* of Eq. (10). As printed it lacks the factor W_L of the length that it
  // estimates.
  const double scale = options_.scaled_heuristic ? options_.weights.length : 1.0;
  const double per_metre =
      cells.direct_length > 0.0 ? heuristic_weight_ * scale / cells.direct_length : 0.0;
  const auto heuristic = [&](const Cell& cell) {
    return per_metre > 0.0 ? per_metre * (frame.centre(cell) - query.start).norm() : 0.0;
  };
  // Eq. (8): the penalty of the path from a cell to the goal.
  const double goal_priority = priority_(cells.goal.x(), cells.goal.y());
  const auto g = [&](double length, double integral) {
    return penalty(length, integral, goal_priority);
  };

  const std::uint32_t start = space_.index(cells.start);
  const std::uint32_t goal = space_.index(cells.goal);
  Node& root = space_.visit(goal);
  root.g = g(0.0, 0.0);
  open_.push({root.g + heuristic(cells.goal), heuristic(cells.goal), goal});
  ++stats.pushed;

  // The cell was labelled better since, or expanded.
  const auto is_stale = [&](const OpenEntry& entry) {
    const Node& node = space_[entry.cell];
    return node.closed || node.g + entry.h != entry.f;
  };
  for (OpenEntry entry; open_.pop(entry, is_stale);) {
    const std::uint32_t index = entry.cell;
    Node& node = space_.visit(index);
    if (node.closed) continue;
    node.closed = true;
    ++stats.expanded;
    if (index == start) {
      trace(cells);
      return PlanStatus::Found;
    }
    if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;

    const Cell cell = space_.cell(index);
    const double here = priority_(cell.x(), cell.y());
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;  // Eq. (1), and no squeezing between blocked cells
      const Cell next = cell + Cell(step.dx, step.dy, step.dz);
      const std::uint32_t next_index = space_.index(next);
      Node& other = space_.visit(next_index);
      if (other.closed) continue;
      const double length = node.length + lengths[i];
      const double priority =
          node.priority + 0.5 * lengths[i] * (here + priority_(next.x(), next.y()));
      const double cost = g(length, priority);
      if (other.to_goal >= 0 && cost >= other.g) continue;
      other.length = length;
      other.priority = priority;
      other.g = cost;
      other.to_goal = step.opposite;
      const double h = heuristic(next);
      open_.push({cost + h, h, next_index});  // Eq. (10)
      ++stats.pushed;
    }
  }
  return PlanStatus::Unreachable;
}

void LengthPriorityPlanner::trace(const GridQuery& cells) {
  chain_.assign(1, cells.start);
  while (chain_.back() != cells.goal) {
    const Step& step = steps()[space_[space_.index(chain_.back())].to_goal];
    chain_.push_back(chain_.back() + Cell(step.dx, step.dy, step.dz));
  }
}

}  // namespace ltp
