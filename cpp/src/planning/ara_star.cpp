// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/ara_star.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "ltp/planning/linearisation.hpp"
#include "ltp/planning/penalty_bound.hpp"

namespace ltp {
namespace {

/// After so many expansions the goal's side is asked whether there is a way at all: a flood costs
/// about as much as they did.
constexpr std::int64_t kExpandedBeforeFlood = 4096;
constexpr double kProved = 1.0 + 1e-12;  // a path this close to the least cost is the cheapest

}  // namespace

void AraSearch::begin(const Scene& scene, const Query& query, const GridQuery& cells,
                      const AdditiveCost& cost, SearchStats& stats) {
  const GridFrame& frame = scene.occupancy.frame();
  scene_ = &scene;
  query_ = &query;
  cells_ = cells;
  cost_ = cost;
  lengths_ = step_lengths(frame.cell());
  round_ = 0;
  weight_ = 1.0;
  least_ = 0.0;
  space_.begin(frame, cells.levels);
  open_.clear();
  incons_.clear();
  field_.aim(scene, cost, query, cells, std::numeric_limits<double>::infinity());

  goal_ = space_.index(cells.goal);
  space_.visit(goal_);
  const std::uint32_t start = space_.index(cells.start);
  Node& first = space_.visit(start);
  first.cost = 0.0;
  first.waiting = true;
  incons_.push_back(start);  // the first round takes it from there
  ++stats.pushed;
}

/// As in `AdditiveSearch`, but for the height. The field begins at the centre of the start's
/// column, not at the start, where it would promise too much.
double AraSearch::heuristic(const Cell& cell) {
  return cell == cells_.goal || cell == cells_.start ? 0.0 : field_(cell.x(), cell.y());
}

/// As in `AdditiveSearch`: the ends are points, not centres; such a step is tallied exactly.
double AraSearch::step_cost(const Cell& from, const Cell& to, double length) {
  if (from != cells_.start && to != cells_.goal) {
    return length * (field_.half_metre(from.x(), from.y()) + field_.half_metre(to.x(), to.y()));
  }
  const GridFrame& frame = scene_->occupancy.frame();
  const Point a = from == cells_.start ? query_->start : frame.centre(from);
  const Point b = to == cells_.goal ? query_->goal : frame.centre(to);
  return cost_((b - a).norm(), scene_->priority.integral(a, b));
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

PlanStatus AraSearch::improve(double weight, const Budget& budget, SearchStats& stats) {
  reweigh(weight);
  ++round_;
  std::int64_t expanded = 0;
  while (!open_.empty()) {
    const OpenEntry top = open_.top();
    if (top.f >= cost()) break;
    open_.pop();
    const Node& node = space_[top.cell];
    if (!node.waiting || node.closed == round_) continue;  // stale
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
    if (round_ == 1 && ++expanded == kExpandedBeforeFlood) {
      flood_.fill(scene_->occupancy, cells_.goal, cells_.levels);
      if (!flood_.reached(cells_.start)) return PlanStatus::Unreachable;
    }
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
  const std::uint32_t blocked = blocked_surroundings(scene_->occupancy, cell, cells_.levels);
  for (int i = 0; i < kSteps; ++i) {
    const Step& step = steps()[i];
    if (blocked & step.box) continue;
    const Cell next = cell + Cell(step.dx, step.dy, step.dz);
    const std::uint32_t next_index = space_.index(next);
    Node& other = space_.visit(next_index);
    const double total = node.cost + step_cost(cell, next, lengths_[i]);
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
  std::vector<Cell> cells = {cells_.goal};
  while (cells.back() != cells_.start) {
    const Step& step = steps()[space_[space_.index(cells.back())].from_start];
    cells.push_back(cells.back() - Cell(step.dx, step.dy, step.dz));
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

AraStarPlanner::AraStarPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
}

Plan AraStarPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query,
                [&](const GridQuery& cells, Plan& plan) { search(scene, query, cells, plan); });
}

void AraStarPlanner::search(const Scene& scene, const Query& query, const GridQuery& cells,
                            Plan& best) {
  const Budget budget(options_.max_expansions, query.interrupted);
  const bool alone = options_.weights.priority == 0.0 || cells.start == cells.goal;
  AdditiveCost cost;
  double most = 0.0;
  if (!alone) {
    most = std::max(scene.priority.maximum(), 0.0);
    const PenaltyBound none(options_.weights, cells.direct_length, most);
    cost = {first_alpha(none, cells.direct_length, most, options_.linearised.alpha), 1.0};
  }
  search_.begin(scene, query, cells, cost, best.stats);
  for (double weight = options_.ara.first_weight;;) {
    const PlanStatus status = search_.improve(weight, budget, best.stats);
    if (status != PlanStatus::Found) {
      if (best.status != PlanStatus::Found) best.status = status;
      return;
    }
    Plan candidate;
    accept(scene, query, cells, options_.weights, search_.chain(), candidate);
    if (best.status != PlanStatus::Found || candidate.penalty < best.penalty) {
      candidate.stats = best.stats;
      best = std::move(candidate);
    }
    if (cells.start == cells.goal) {
      best.bound = best.penalty;
    } else if (alone) {  // the least cost is a length
      best.bound = std::min(best.penalty,
                            Penalty(options_.weights, cells.direct_length)(search_.least(), 0.0));
    } else if (aligned(scene.occupancy.frame(), scene.priority)) {
      PenaltyBound bound(options_.weights, cells.direct_length, most);
      bound.add(cost.length, search_.least());
      best.bound = std::min(bound.lowest().value, best.penalty);
    }
    if (weight <= 1.0 || search_.cost() <= kProved * search_.least()) return;
    // What is proved already may be better than the weight that was searched with.
    weight = std::min(weight, search_.cost() / search_.least());
    weight = std::max(1.0, weight - options_.ara.step);
  }
}

}  // namespace ltp
