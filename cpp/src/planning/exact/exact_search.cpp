// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/exact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "planning/additive/linearisation.hpp"

namespace ltp::planning {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMargin = 1.0 + 1e-9;  // of costs that were summed in different orders
constexpr int kRounds = 8;              // linearisations tried on the narrowed graph
constexpr double kSame = 1e-6;          // slopes nearer than this tell the same
constexpr double kReserve = 1e-9;       // kept from what is proved, for rounding

bool is_known(double beta, const std::vector<Guide>& guides) {
  return std::any_of(guides.begin(), guides.end(),
                     [&](const Guide& guide) { return std::abs(guide.beta - beta) < kSame; });
}

/// The largest beta L + R of a path with F < `value`; a L^2 + b R < F L.
double dearest(const ShiftedPenalty& penalty, double beta, double value, double longest) {
  const double a = penalty.per_metre;
  const double slope = value + penalty.priority_weight * beta;
  const double length = a > 0.0 ? std::min(longest, slope / (2.0 * a)) : longest;
  return kMargin * (slope - a * length) * length / penalty.priority_weight;
}

/// The slope of F where a path is `length` long: the `beta` that linearises it there.
double slope_at(const ShiftedPenalty& penalty, double value, double length) {
  return std::max(0.0, (2.0 * penalty.per_metre * length - value) / penalty.priority_weight);
}

/// From start to goal, each step the one on which a guide's cost is the least. Costs are positive.
std::vector<std::uint32_t> guided(const CellGraph& graph, const Guide& guide) {
  std::vector<std::uint32_t> chain{graph.start()};
  while (chain.back() != graph.goal()) {
    const std::uint32_t node = chain.back();
    const CellGraph::Edge* next = nullptr;
    double least = kInfinity;
    const CellGraph::Edge* const end = graph.end(node);
    for (const CellGraph::Edge* edge = graph.begin(node); edge != end; ++edge) {
      const double cost =
          CostFactors{guide.beta, 1.0}(graph.cost(node, *edge)) + guide.to_goal[edge->to];
      if (edge->to != graph.start() && cost < least) {
        least = cost;
        next = edge;
      }
    }
    chain.push_back(next->to);
  }
  return chain;
}

}  // namespace

PlanStatus ExactSearch::improve(const Problem& problem, const Limits& limits, Answer& answer) {
  const GridFrame& frame = problem.frame();
  const PenaltyWeights& weights = problem.weights;
  const ShiftedPenalty penalty{weights.length / problem.direct_length, weights.priority};
  const Path& path = answer.plan().path;
  memory_ = limits.memory;
  proved_.reset();
  cells_.clear();
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    cells_.push_back(frame.cell_of(path.row(i).transpose()));
  }
  const double all = static_cast<double>(frame.size()) * frame.cell().norm();
  costs_.reset(problem, all);
  Incumbent incumbent{penalty(costs_.along(cells_)), {}};
  if (penalty.per_metre > 0.0) {
    costs_.reset(problem, std::min(all, 2.0 * incumbent.value / penalty.per_metre));
    incumbent.value = penalty(costs_.along(cells_));
  }
  bound_.emplace(weights, problem.direct_length, costs_.max_priority());
  if (!narrow(problem, penalty, answer, incumbent)) return PlanStatus::OutOfBudget;
  const double used = static_cast<double>(graph_.bytes()) +
                      static_cast<double>(sizeof(double)) * graph_.size() * (guides_.size() + 1);
  // The reserve is part of what may be left.
  const double largest = incumbent.value + weights.priority * costs_.max_priority();
  const double tolerance = std::max(0.0, limits.tolerance - 4.0 * kReserve * (1.0 + largest));
  const double close =
      tolerance < incumbent.value ? incumbent.value / (incumbent.value - tolerance) : kInfinity;
  const LabelTask task{
      graph_, penalty, guides_, length_to_goal_, std::max(1.0 + limits.eps, close), memory_ - used};
  const PlanStatus status = labels_.run(task, answer.budget, answer.stats, incumbent);

  std::vector<Cell> chain;
  for (const std::uint32_t node : incumbent.chain) chain.push_back(graph_.cell(node));
  // Where the raster's cells are not the grid's columns, the first path may by chance be better.
  answer.offer(chain);
  if (problem.column_priority) {
    const double value = labels_.proved() - weights.priority * costs_.max_priority();
    proved_ = std::min(answer.plan().penalty, value - kReserve * (1.0 + std::abs(value)));
  }
  return status;
}

/// Leaves in `graph_` the cells that a better path than `best` may use, with their guides.
bool ExactSearch::narrow(const Problem& problem, const ShiftedPenalty& penalty, Answer& answer,
                         Incumbent& best) {
  const std::vector<Cell> chain = cells_;
  double beta = slope_at(penalty, best.value, costs_.along(chain).length);
  if (!corridor_.find(problem, costs_, beta, dearest(penalty, beta, best.value, kInfinity),
                      answer.budget, answer.stats, cells_)) {
    return false;
  }
  graph_.build(problem, costs_, cells_);
  if (static_cast<double>(graph_.bytes()) > memory_) return false;
  best.chain.clear();
  for (const Cell& cell : chain) best.chain.push_back(graph_.node(cell));
  alive_.assign(graph_.size(), 1);
  guides_.clear();

  double highest = -kInfinity;  // bound so far, and the guide that gives most of it
  std::size_t first = 0;
  for (int round = 0; round < kRounds; ++round) {
    if (!guide(beta, penalty, answer, best)) return false;
    const PenaltyBound::Point lowest = bound_->lowest();
    if (lowest.value > highest + 1e-9) {
      highest = lowest.value;
      first = guides_.size() - 1;
    }
    const double most = costs_.max_priority();
    if (lowest.value + penalty.priority_weight * most >= best.value) break;
    const double slopes[] = {std::max(0.0, lowest.alpha - most),
                             slope_at(penalty, best.value, lowest.length)};
    beta = -1.0;
    for (const double slope : slopes) {
      if (beta < 0.0 && !is_known(slope, guides_)) beta = slope;
    }
    if (beta < 0.0) break;
  }
  std::swap(guides_[0], guides_[first]);

  // Two more, at the slopes of the shortest and the longest path that may be better.
  keep_alive(problem, best);
  double low = 0.0;
  double high = graph_.longest();
  for (const Guide& guide : guides_) {
    const double a = penalty.per_metre;
    const double cost = penalty.priority_weight * guide.to_goal[graph_.start()];
    const double slope = best.value + penalty.priority_weight * guide.beta;
    const double wide = slope + std::sqrt(std::max(0.0, slope * slope - 4.0 * a * cost));
    low = std::max(low, 2.0 * cost / wide);
    if (a > 0.0) high = std::min(high, wide / (2.0 * a));
  }
  for (const double length : {low, high}) {
    const double slope = slope_at(penalty, best.value, length);
    if (is_known(slope, guides_)) continue;
    if (!guide(slope, penalty, answer, best)) return false;
  }
  for (const bool from_start : {true, false}) {
    if (!least_costs(graph_, from_start ? graph_.start() : graph_.goal(), {1.0, 0.0}, answer.budget,
                     answer.stats, open_, from_start ? from_start_ : length_to_goal_)) {
      return false;
    }
  }
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    if (from_start_[i] + length_to_goal_[i] > high * kMargin) alive_[i] = 0;
  }
  guides_.push_back({0.0, std::move(length_to_goal_)});  // goes with the guides through the sieve
  keep_alive(problem, best);
  length_to_goal_ = std::move(guides_.back().to_goal);
  guides_.pop_back();
  return true;
}

/// Adds a guide, improves `best` by its path, and marks the cells that are too dear.
bool ExactSearch::guide(double beta, const ShiftedPenalty& penalty, Answer& answer,
                        Incumbent& best) {
  BudgetWatch& budget = answer.budget;
  SearchStats& stats = answer.stats;
  Guide made{beta, {}};
  const CostFactors factors{beta, 1.0};
  if (!least_costs(graph_, graph_.goal(), factors, budget, stats, open_, made.to_goal) ||
      !least_costs(graph_, graph_.start(), factors, budget, stats, open_, from_start_)) {
    return false;
  }
  bound_->add(beta + costs_.max_priority(), made.to_goal[graph_.start()]);
  if (beta > 0.0) {
    std::vector<std::uint32_t> chain = guided(graph_, made);
    const double value = penalty(graph_.along(chain));
    if (value < best.value) best = {value, std::move(chain)};
  }
  const double most = dearest(penalty, beta, best.value, graph_.longest());
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    if (from_start_[i] + made.to_goal[i] > most) alive_[i] = 0;
  }
  guides_.push_back(std::move(made));
  return true;
}

/// Packs the graph: only cells still alive, and those of the best path.
void ExactSearch::keep_alive(const Problem& problem, Incumbent& best) {
  for (const std::uint32_t node : best.chain) alive_[node] = 1;
  cells_.clear();
  std::vector<std::uint32_t> number(graph_.size(), 0);
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    if (!alive_[i]) continue;
    number[i] = static_cast<std::uint32_t>(cells_.size());
    for (Guide& guide : guides_) guide.to_goal[cells_.size()] = guide.to_goal[i];
    cells_.push_back(graph_.cell(i));
  }
  for (Guide& guide : guides_) guide.to_goal.resize(cells_.size());
  for (std::uint32_t& node : best.chain) node = number[node];
  graph_.build(problem, costs_, cells_);
  alive_.assign(graph_.size(), 1);
}

}  // namespace ltp::planning
