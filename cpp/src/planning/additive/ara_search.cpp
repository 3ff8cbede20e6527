// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/ara_search.hpp"

#include <algorithm>

#include "planning/search/trace.hpp"

namespace ltp::planning {
namespace {

constexpr std::int64_t kPatience = 4096;  // expansions before the flood

}  // namespace

AraSearch::AraSearch() : proof_(UnreachableProof::From::Goal, kPatience) {}

void AraSearch::begin(const Problem& problem, const AdditiveCost& cost, SearchStats& stats) {
  const GridFrame& frame = problem.frame();
  problem_ = &problem;
  cost_ = cost;
  lengths_.reset(problem);
  round_ = 0;
  weight_ = 1.0;
  least_ = 0.0;
  space_.begin(frame, problem.levels);
  open_.clear();
  incons_.clear();
  field_.aim(problem, cost);
  proof_.begin();

  goal_ = space_.index(problem.goal);
  space_.visit(goal_);
  const std::uint32_t start = space_.index(problem.start);
  Node& first = space_.visit(start);
  first.cost = 0.0;
  first.waiting = true;
  incons_.push_back(start);  // the first round takes it from there
  ++stats.pushed;
}

/// As in `AdditiveSearch`, but for the height. The field begins at the centre of the start's
/// column, not at the start, where it would promise too much.
double AraSearch::heuristic(const Cell& cell) {
  return cell == problem_->goal || cell == problem_->start ? 0.0 : field_(cell.x(), cell.y());
}

/// As in `AdditiveSearch`: a step at an end is tallied exactly.
double AraSearch::step_cost(const Cell& from, const Cell& to, double length) {
  if (from != problem_->start && to != problem_->goal) {
    return length * (field_.half_metre(from.x(), from.y()) + field_.half_metre(to.x(), to.y()));
  }
  return cost_.along(problem_->scene.priority, problem_->point_of(from), problem_->point_of(to));
}

/// OPEN takes in INCONS, all keys change with the weight. On any path, the first cell from the
/// start that waits has its least cost, so the smallest unweighted key bounds every path from
/// below.
void AraSearch::reweigh(double weight) {
  const auto take = [&](std::uint32_t index) {
    Node& node = space_.visit(index);
    if (node.waiting) waiting_.push_back(index);
    node.waiting = false;  // it may have several entries
  };
  for (const std::uint32_t index : incons_) take(index);
  for (const OpenEntry& entry : open_.entries()) take(entry.cell);
  incons_.clear();
  open_.clear();
  weight_ = weight;
  double least = cost();
  for (const std::uint32_t index : waiting_) {
    Node& node = space_.visit(index);
    node.waiting = true;
    const double cost = node.cost;
    const double h = heuristic(space_.cell(index));
    least = std::min(least, cost + h);
    open_.push({cost + weight_ * h, h, index});
  }
  least_ = std::max(least_, least);
  waiting_.clear();
}

PlanStatus AraSearch::improve(double weight, BudgetWatch& budget, SearchStats& stats) {
  reweigh(weight);
  ++round_;
  while (!open_.empty()) {
    const OpenEntry top = open_.top();
    if (top.f >= cost()) break;
    open_.pop();
    const Node& node = space_[top.cell];
    if (!node.waiting || node.closed == round_) continue;  // stale
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
    if (round_ == 1 && proof_.after_expansion(*problem_)) return PlanStatus::Unreachable;
    expand(top.cell, stats);
  }
  if (cost() == std::numeric_limits<double>::infinity()) return PlanStatus::Unreachable;
  reweigh(weight);
  return PlanStatus::Found;
}

void AraSearch::expand(std::uint32_t index, SearchStats& stats) {
  Node& node = space_.visit(index);
  node.waiting = false;
  node.closed = round_;
  const Cell cell = space_.cell(index);
  const std::uint32_t blocked = blocked_surroundings(problem_->grid(), cell, problem_->levels);
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    if (blocked & step.box) continue;
    const Cell next = cell + step.offset();
    const std::uint32_t next_index = space_.index(next);
    Node& other = space_.visit(next_index);
    const double total = node.cost + step_cost(cell, next, lengths_.from(cell.z())[i]);
    if (total >= other.cost) continue;
    const double h = heuristic(next);
    if (h == std::numeric_limits<double>::infinity()) continue;  // walled in over all levels
    other.cost = total;
    other.from_start = static_cast<std::int8_t>(i);
    ++stats.pushed;
    // The field is not quite consistent where a path goes over or under the goal.
    if (weight_ == 1.0) other.closed = 0;
    if (other.closed == round_) {
      if (!other.waiting) incons_.push_back(next_index);
    } else {
      open_.push({total + weight_ * h, h, next_index});
    }
    other.waiting = true;
  }
}

std::vector<Cell> AraSearch::chain() const {
  const auto back = [&](const Cell& cell) -> Cell {
    return -steps()[space_[space_.index(cell)].from_start].offset();
  };
  std::vector<Cell> cells;
  trace(problem_->goal, problem_->start, back, cells);
  std::reverse(cells.begin(), cells.end());
  return cells;
}

}  // namespace ltp::planning
