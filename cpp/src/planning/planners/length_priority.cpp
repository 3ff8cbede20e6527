// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/length_priority.hpp"

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/additive/additive_search.hpp"
#include "planning/search/column_priority.hpp"
#include "planning/search/lazy_open_list.hpp"
#include "planning/search/level_lengths.hpp"
#include "planning/search/search_space.hpp"
#include "planning/search/shortest_path.hpp"

namespace ltp {
namespace planning {
namespace {

class LengthPriorityPlanner final : public GridPlanner {
 public:
  LengthPriorityPlanner(const PlannerInfo& info, const PenaltyWeights& weights,
                        const LengthPriorityOptions& options)
      : GridPlanner(info, weights), options_(options) {}

 private:
  struct Node {
    double length = 0.0;    ///< L of the path from here to the goal [m]
    double priority = 0.0;  ///< integral of the priority along it [m]
    double g = 0.0;         ///< Eq. (8)
    std::uint32_t stamp = 0;
    std::int8_t to_goal =
        -1;  ///< number of the step towards the goal; -1 without a label, or there
    bool closed = false;
  };

  void search(const Problem& problem, Answer& answer) override {
    if (options_.heuristic_weight <= 1.0 && weights().priority == 0.0) {
      if (problem.within_a_cell()) {
        answer.offer(std::vector<Cell>{problem.start});
        return;
      }
      if (problem.has_gates()) return to_region(problem, answer);
      const PlanStatus status = shortest_.run(problem, answer.budget, answer.stats);
      if (status != PlanStatus::Found) return answer.end(status);
      answer.offer(shortest_.chain());
    } else {
      const PlanStatus status = best_first(problem, answer.budget, answer.stats);
      if (status != PlanStatus::Found) return answer.end(status);
      chain_.assign(1, problem.start);
      while (true) {
        const std::int8_t step = space_[space_.index(chain_.back())].to_goal;
        if (step < 0) break;
        chain_.push_back(chain_.back() + steps()[step].offset());
      }
      answer.offer(chain_);
    }
  }

  /// The shortest path to a region.
  void to_region(const Problem& problem, Answer& answer) {
    const AdditiveResult found = additive_.run(problem, {1.0, 0.0}, answer.budget, answer.stats);
    if (found.status != PlanStatus::Found) return answer.end(found.status);
    answer.offer(found.chain);
  }

  /// The paper's search.
  PlanStatus best_first(const Problem& problem, BudgetWatch& budget, SearchStats& stats) {
    const GridFrame& frame = problem.frame();
    lengths_.reset(problem);
    const Penalty penalty(weights(), problem.direct_length);
    priority_.reset(frame, problem.scene.priority);
    space_.begin(frame, problem.levels);
    open_.begin(-weights().priority, 2.0 * (weights().length + weights().priority));

    // Eq. (9), times W_A* of Eq. (10). As printed it lacks the factor W_L of the length that it
    // estimates.
    const double scale = options_.scaled ? weights().length : 1.0;
    const double per_metre = problem.direct_length > 0.0
                                 ? options_.heuristic_weight * scale / problem.direct_length
                                 : 0.0;
    const auto heuristic = [&](const Cell& cell) {
      return per_metre > 0.0 ? per_metre * (problem.vertex(cell) - problem.query.start).norm()
                             : 0.0;
    };
    // Eq. (8): the penalty of the path from a cell to the goal; there its priority.
    const auto g = [&](double length, double integral) { return penalty(length, integral); };

    const std::uint32_t start = space_.index(problem.start);
    const GateRegion* const region = problem.has_gates() ? &problem.gates.front() : nullptr;
    const auto begin_at = [&](const Cell& goal) {
      if (problem.grid().blocked(goal)) return;
      const std::uint32_t index = space_.index(goal);
      Node& root = space_.visit(index);
      root.g = penalty(0.0, 0.0, priority_(goal.x(), goal.y()));
      open_.push({root.g + heuristic(goal), heuristic(goal), index});
      ++stats.pushed;
    };
    if (region != nullptr) {
      region->for_each(begin_at);  // a path ends where it enters
    } else {
      begin_at(problem.goal);
    }

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
      if (index == start) return PlanStatus::Found;
      if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;

      const Cell cell = space_.cell(index);
      const double here = priority_(cell.x(), cell.y());
      const LevelLengths::Lengths& lengths = lengths_.from(cell.z());
      const std::uint32_t blocked = blocked_surroundings(problem.grid(), cell, problem.levels);
      for (int i = 0; i < kSteps; ++i) {
        const Step& step = steps()[i];
        if (blocked & step.box) continue;  // Eq. (1), and no squeezing between blocked cells
        const Cell next = cell + step.offset();
        const std::uint32_t next_index = space_.index(next);
        Node& other = space_.visit(next_index);
        if (other.closed || (region != nullptr && region->contains(next))) continue;
        const double length = node.length + lengths[i];
        const double priority =
            node.priority + step_integral(lengths[i], here, priority_(next.x(), next.y()));
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

  LengthPriorityOptions options_;
  ShortestPath shortest_;
  AdditiveSearch additive_;
  LevelLengths lengths_;
  SearchSpace<Node> space_;
  LazyOpenList open_;
  ColumnPriority priority_;
  std::vector<Cell> chain_;  ///< of the last path found, start ... goal
};

}  // namespace
}  // namespace planning

void LengthPriorityOptions::check() const {
  check::not_negative("heuristic_weight", heuristic_weight);
}

std::unique_ptr<Planner> make_length_priority(const PlannerInfo& info,
                                              const PenaltyWeights& weights,
                                              const LengthPriorityOptions& options) {
  options.check();
  return std::make_unique<planning::LengthPriorityPlanner>(info, weights, options);
}

}  // namespace ltp
