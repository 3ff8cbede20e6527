// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/label_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr int kMostCritical = 64;
constexpr double kReserve = 1e-10;  // an improvement smaller than this part of F is none

std::uint64_t bit_of(int number) { return number < 0 ? 0 : std::uint64_t{1} << number; }

}  // namespace

PlanStatus LabelSearch::run(const LabelTask& task, BudgetWatch& budget, SearchStats& stats,
                            Incumbent& best) {
  task_ = &task;
  const std::size_t guides = task.guides.size();
  guidance_.resize(task.graph.size() * guides);
  for (std::size_t node = 0; node < task.graph.size(); ++node) {
    for (std::size_t i = 0; i < guides; ++i) {
      guidance_[node * guides + i] = task.guides[i].to_goal[node];
    }
  }
  critical_.assign(task.graph.size(), -1);
  criticals_ = 0;
  proved_ = 0.0;
  while (true) {
    if (!solve_relaxed(budget, stats, best)) return PlanStatus::OutOfBudget;
    if (walk_value_ == kInfinity) {
      proved_ = enough_;
      return PlanStatus::Found;
    }
    if (!add_critical()) return PlanStatus::OutOfBudget;
  }
}

/// Afterwards `walk_value_` is finite only if a walk that is not simple is better than `best`.
bool LabelSearch::solve_relaxed(BudgetWatch& budget, SearchStats& stats, Incumbent& best) {
  const CellGraph& graph = task_->graph;
  enough_ = best.value * (1.0 - kReserve) / task_->factor;
  walk_value_ = kInfinity;
  labels_.clear();
  open_.clear();
  heads_.assign(graph.size(), kNone);
  // Each label is queued once.
  const double most_labels =
      std::min(task_->memory / (sizeof(Label) + sizeof(OpenEntry)), double{kNone - 1});
  Range range{};
  if (!possible(graph.start(), {}, range)) return true;
  floor_ = range.bound;
  labels_.add({{}, 0, 0.0f, 0.0f, graph.start(), kNone, kNone, false});
  open_.push({range.bound, 0.0, 0});
  ++stats.pushed;
  while (!open_.empty()) {
    const OpenEntry entry = open_.pop();
    if (entry.f >= enough_) break;
    proved_ = std::max(proved_, entry.f);  // best first: whatever is left is no better
    const Label label = labels_[entry.cell];
    if (label.dominated) continue;
    ++stats.expanded;
    if (budget.spent(stats.expanded)) return false;
    const CellGraph::Edge* const end = graph.end(label.node);
    for (const CellGraph::Edge* edge = graph.begin(label.node); edge != end; ++edge) {
      if (edge->to == graph.start()) continue;
      const std::uint64_t bit = bit_of(critical_[edge->to]);
      if (label.passed & bit) continue;
      const StepCost sum = label.sum + graph.cost(label.node, *edge);
      if (edge->to == graph.goal()) {
        arrive(entry.cell, sum, best);
        continue;
      }
      if (!possible(edge->to, sum, range)) continue;
      // Rounded outwards.
      Label next{sum,
                 label.passed | bit,
                 std::nextafter(static_cast<float>(range.low), 0.0f),
                 std::nextafter(static_cast<float>(range.high), HUGE_VALF),
                 edge->to,
                 entry.cell,
                 kNone,
                 false};
      range.bound = std::max(range.bound, entry.f);
      if (is_dominated(next, range)) continue;
      next.next = heads_[edge->to];
      if (labels_.size() >= most_labels) return false;
      heads_[edge->to] = labels_.add(next);
      open_.push({range.bound, task_->length_to_goal[edge->to], heads_[edge->to]});
      ++stats.pushed;
    }
  }
  return true;
}

/// Whether a path that begins so can have F < `enough_`; and its length then.
bool LabelSearch::possible(std::uint32_t node, const StepCost& sum, Range& range) const {
  const double a = task_->penalty.per_metre;
  const double b = task_->penalty.priority_weight;
  const std::size_t guides = task_->guides.size();
  const double* const to_goal = guidance_.data() + node * guides;
  const double shortest = sum.length + task_->length_to_goal[node];
  range.low = shortest;
  // Without a length term only simple paths have a longest length.
  range.high = a > 0.0 ? kInfinity : task_->graph.longest();
  for (std::size_t i = 0; i < guides; ++i) {
    const double beta = task_->guides[i].beta;
    const double cost = b * (beta * sum.length + sum.loss + to_goal[i]);
    const double slope = enough_ + b * beta;
    // a L^2 - slope L + cost < 0 for the whole path's L.
    const double root = slope * slope - 4.0 * a * cost;
    if (!(root > 0.0)) return false;
    const double wide = slope + std::sqrt(root);
    range.low = std::max(range.low, 2.0 * cost / wide);
    if (a > 0.0) range.high = std::min(range.high, wide / (2.0 * a));
  }
  if (range.low >= range.high) return false;
  const double beta = task_->guides[0].beta;
  const double cost = b * (beta * sum.length + sum.loss + to_goal[0]);
  const double best_length = a > 0.0 ? std::sqrt(cost / a) : range.high;
  const double length = std::max(best_length, shortest);
  range.bound = std::max(0.0, a * length + cost / length - b * beta);
  return true;
}

/// Also marks those that the label dominates.
bool LabelSearch::is_dominated(const Label& label, const Range& range) {
  const double a = task_->penalty.per_metre;
  const double b = task_->penalty.priority_weight;
  // Whether `first` dominates `second`, whose path is `low` to `high` long and F of it `bound` or
  // more.
  const auto dominates = [&](const StepCost& first, const StepCost& second, double low, double high,
                             double bound) {
    const double longer = second.length - first.length;
    const double lost = b * (second.loss - first.loss);
    if (longer >= 0.0) return lost >= longer * (enough_ - 2.0 * a * low + a * longer);
    // Without a length term what is longer may end as too long.
    return a > 0.0 && lost >= longer * (bound - 2.0 * a * high + a * longer);
  };
  std::uint32_t* link = &heads_[label.node];
  while (*link != kNone) {
    Label& other = labels_[*link];
    if ((other.passed & ~label.passed) == 0 &&
        dominates(other.sum, label.sum, range.low, range.high, range.bound)) {
      // To the front: what has dominated one is likely to dominate the next.
      const std::uint32_t number = *link;
      *link = other.next;
      other.next = heads_[label.node];
      heads_[label.node] = number;
      return true;
    }
    if ((label.passed & ~other.passed) == 0 &&
        dominates(label.sum, other.sum, other.low, other.high, floor_)) {
      other.dominated = true;
      *link = other.next;
    } else {
      link = &other.next;
    }
  }
  return false;
}

void LabelSearch::arrive(std::uint32_t parent, const StepCost& sum, Incumbent& best) {
  const double value = task_->penalty(sum);
  if (value >= enough_) return;
  std::vector<std::uint32_t> chain{task_->graph.goal()};
  for (std::uint32_t i = parent; i != kNone; i = labels_[i].parent)
    chain.push_back(labels_[i].node);
  std::reverse(chain.begin(), chain.end());
  if (CellGraph::without_rings(chain).size() == chain.size()) {
    best = {value, std::move(chain)};
    enough_ = std::min(enough_, value * (1.0 - kReserve) / task_->factor);
    if (walk_value_ >= enough_) walk_value_ = kInfinity;
  } else {
    walk_value_ = value;
    walk_ = std::move(chain);
    enough_ = value;
  }
}

/// Those that the best walk passes more than once.
bool LabelSearch::add_critical() {
  std::sort(walk_.begin(), walk_.end());
  for (std::size_t i = 1; i < walk_.size(); ++i) {
    if (walk_[i] != walk_[i - 1] || critical_[walk_[i]] >= 0) continue;
    if (criticals_ == kMostCritical) return false;
    critical_[walk_[i]] = static_cast<std::int8_t>(criticals_++);
  }
  return true;
}

}  // namespace ltp::planning
