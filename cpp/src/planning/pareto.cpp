// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/pareto.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/linearisation.hpp"
#include "ltp/planning/stopwatch.hpp"

namespace ltp {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMegabyte = 1e6;
constexpr double kMargin = 1.0 + 1e-9;  // of costs that were summed in different orders
constexpr int kRounds = 8;              // linearisations tried on the narrowed graph
constexpr double kSame = 1e-6;          // slopes nearer than this tell the same

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

ParetoPlanner::ParetoPlanner(const PlannerOptions& options) : options_(options) { options.check(); }

Plan ParetoPlanner::plan(const Scene& scene, const Query& query) {
  const Stopwatch watch;
  Plan plan;
  const auto [refused, cells] = resolve(scene, query);
  if (refused) {
    plan.status = *refused;
  } else {
    const Budget budget(options_.max_expansions, query.interrupted);
    PlanStatus status = seed(scene, query, cells, budget, plan);
    if (status == PlanStatus::Found && !plan.bound) {
      status = solve(scene, query, cells, budget, plan);
    }
    if (status != PlanStatus::Found) {
      const SearchStats stats = plan.stats;
      plan = Plan{};
      plan.stats = stats;
      plan.status = status;
    }
  }
  plan.stats.seconds = watch.seconds();
  return plan;
}

/// A good path by a few additive searches. Its `bound` is set where it is the optimum.
PlanStatus ParetoPlanner::seed(const Scene& scene, const Query& query, const GridQuery& cells,
                               const Budget& budget, Plan& best) {
  const PenaltyWeights& weights = options_.weights;
  const bool alone = weights.priority == 0.0 || cells.start == cells.goal;
  const double most = std::max(scene.priority.maximum(), 0.0);
  PenaltyBound bound(weights, cells.direct_length, most);
  double alpha = 1.0;
  if (!alone) {
    alpha = first_alpha(bound, cells.direct_length, most, options_.linearised.alpha);
  }
  std::vector<double> tried;
  for (int i = 0; i < options_.linearised.searches; ++i) {
    const AdditiveResult found =
        search_.run(scene, query, cells, {alpha, alone ? 0.0 : 1.0}, budget, best.stats);
    if (found.status != PlanStatus::Found) return found.status;
    Plan candidate;
    accept(scene, query, cells, weights, path_through(scene.occupancy.frame(), query, found.chain),
           candidate);
    if (best.status != PlanStatus::Found || candidate.penalty < best.penalty) {
      candidate.stats = best.stats;
      best = std::move(candidate);
      cells_ = found.chain;
    }
    if (alone) {
      best.bound = best.penalty;
      break;
    }
    bound.add(alpha, found.cost);
    tried.push_back(alpha);
    const PenaltyBound::Point lowest = bound.lowest();
    if (best.penalty - lowest.value <= options_.linearised.tolerance) break;
    alpha = std::max(lowest.alpha, bound.least_alpha());
    const bool known = std::any_of(tried.begin(), tried.end(),
                                   [&](double other) { return std::abs(other - alpha) < kSame; });
    if (known) break;
  }
  return PlanStatus::Found;
}

PlanStatus ParetoPlanner::solve(const Scene& scene, const Query& query, const GridQuery& cells,
                                const Budget& budget, Plan& best) {
  const GridFrame& frame = scene.occupancy.frame();
  const PenaltyWeights& weights = options_.weights;
  const ShiftedPenalty penalty{weights.length / cells.direct_length, weights.priority};
  const double all = static_cast<double>(frame.size()) * frame.cell().norm();
  costs_.reset(scene, query, cells, all);
  Incumbent incumbent{penalty(costs_.along(cells_)), {}};
  if (penalty.per_metre > 0.0) {
    costs_.reset(scene, query, cells, std::min(all, 2.0 * incumbent.value / penalty.per_metre));
    incumbent.value = penalty(costs_.along(cells_));
  }
  PenaltyBound bound(weights, cells.direct_length, costs_.most_priority());
  if (!narrow(scene, cells, penalty, budget, best.stats, bound, incumbent)) {
    return PlanStatus::OutOfBudget;
  }
  const double used = static_cast<double>(graph_.bytes()) +
                      static_cast<double>(sizeof(double)) * graph_.size() * (guides_.size() + 1);
  const LabelTask task{graph_,
                       penalty,
                       guides_,
                       length_to_goal_,
                       1.0 + options_.pareto.eps,
                       options_.pareto.memory * kMegabyte - used};
  const PlanStatus status = labels_.run(task, budget, best.stats, incumbent);
  if (status != PlanStatus::Found) return status;

  Plan exact;
  accept(scene, query, cells, weights, path_of(frame, query, incumbent.chain), exact);
  // Where the raster's cells are not the grid's columns, the seed may by chance be better.
  if (exact.penalty < best.penalty) {
    exact.stats = best.stats;
    best = std::move(exact);
  }
  if (aligned(frame, scene.priority)) {
    const double value = incumbent.value / task.factor - weights.priority * costs_.most_priority();
    best.bound = std::min(best.penalty, value - 1e-9 * (1.0 + std::abs(value)));
  }
  return PlanStatus::Found;
}

/// Leaves in `graph_` the cells that a better path than `best` may use, with their guides.
bool ParetoPlanner::narrow(const Scene& scene, const GridQuery& cells,
                           const ShiftedPenalty& penalty, const Budget& budget, SearchStats& stats,
                           PenaltyBound& bound, Incumbent& best) {
  const std::vector<Cell> chain = cells_;
  double beta = slope_at(penalty, best.value, costs_.along(chain).length);
  if (!corridor_.find(scene, cells, costs_, beta, dearest(penalty, beta, best.value, kInfinity),
                      budget, stats, cells_)) {
    return false;
  }
  graph_.build(scene, cells, costs_, cells_);
  if (static_cast<double>(graph_.bytes()) > options_.pareto.memory * kMegabyte) return false;
  best.chain.clear();
  for (const Cell& cell : chain) best.chain.push_back(graph_.node(cell));
  alive_.assign(graph_.size(), 1);
  guides_.clear();

  double highest = -kInfinity;  // bound so far, and the guide that gives most of it
  std::size_t first = 0;
  for (int round = 0; round < kRounds; ++round) {
    if (!guide(beta, penalty, budget, stats, bound, best)) return false;
    const PenaltyBound::Point lowest = bound.lowest();
    if (lowest.value > highest + 1e-9) {
      highest = lowest.value;
      first = guides_.size() - 1;
    }
    const double most = costs_.most_priority();
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
  keep_alive(scene, cells, best);
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
    if (!guide(slope, penalty, budget, stats, bound, best)) return false;
  }
  for (const bool from_start : {true, false}) {
    if (!least_costs(graph_, from_start ? graph_.start() : graph_.goal(), {1.0, 0.0}, budget, stats,
                     open_, from_start ? from_start_ : length_to_goal_)) {
      return false;
    }
  }
  for (std::uint32_t i = 0; i < graph_.size(); ++i) {
    if (from_start_[i] + length_to_goal_[i] > high * kMargin) alive_[i] = 0;
  }
  guides_.push_back({0.0, std::move(length_to_goal_)});  // goes with the guides through the sieve
  keep_alive(scene, cells, best);
  length_to_goal_ = std::move(guides_.back().to_goal);
  guides_.pop_back();
  return true;
}

/// Adds a guide, improves `best` by its path, and marks the cells that are too dear.
bool ParetoPlanner::guide(double beta, const ShiftedPenalty& penalty, const Budget& budget,
                          SearchStats& stats, PenaltyBound& bound, Incumbent& best) {
  Guide made{beta, {}};
  const CostFactors factors{beta, 1.0};
  if (!least_costs(graph_, graph_.goal(), factors, budget, stats, open_, made.to_goal) ||
      !least_costs(graph_, graph_.start(), factors, budget, stats, open_, from_start_)) {
    return false;
  }
  bound.add(beta + costs_.most_priority(), made.to_goal[graph_.start()]);
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
void ParetoPlanner::keep_alive(const Scene& scene, const GridQuery& cells, Incumbent& best) {
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
  graph_.build(scene, cells, costs_, cells_);
  alive_.assign(graph_.size(), 1);
}

Path ParetoPlanner::path_of(const GridFrame& frame, const Query& query,
                            const std::vector<std::uint32_t>& chain) const {
  std::vector<Cell> cells;
  for (const std::uint32_t node : chain) cells.push_back(graph_.cell(node));
  return path_through(frame, query, cells);
}

Front ParetoPlanner::front(const Scene& scene, const Query& query, double eps) {
  check::not_negative("eps", eps);
  const Stopwatch watch;
  Front front;
  const auto [refused, cells] = resolve(scene, query);
  const Budget budget(options_.max_expansions, query.interrupted);
  const auto search = [&, &cells = cells] {
    const GridFrame& frame = scene.occupancy.frame();
    const double memory = options_.pareto.memory * kMegabyte;
    costs_.reset(scene, query, cells, static_cast<double>(frame.size()) * frame.cell().norm());
    if (!corridor_.find(scene, cells, costs_, 1.0, kInfinity, budget, front.stats, cells_)) {
      return PlanStatus::OutOfBudget;
    }
    if (std::find(cells_.begin(), cells_.end(), cells.start) == cells_.end()) {
      return PlanStatus::Unreachable;
    }
    graph_.build(scene, cells, costs_, cells_);
    Guide loss;
    if (!least_costs(graph_, graph_.goal(), {1.0, 0.0}, budget, front.stats, open_,
                     length_to_goal_) ||
        !least_costs(graph_, graph_.goal(), {0.0, 1.0}, budget, front.stats, open_, loss.to_goal)) {
      return PlanStatus::OutOfBudget;
    }
    std::vector<FrontSearch::Solution> found;
    const PlanStatus status = fronts_.run({graph_, length_to_goal_, loss.to_goal, 1.0 + eps,
                                           memory - static_cast<double>(graph_.bytes())},
                                          budget, front.stats, found);
    if (status != PlanStatus::Found) return status;
    for (const FrontSearch::Solution& solution : found) {
      Plan plan;
      accept(scene, query, cells, options_.weights, path_of(frame, query, solution.chain), plan);
      front.tallies.push_back(plan.tally);
      front.paths.push_back(std::move(plan.path));
    }
    return status;
  };
  front.status = refused ? *refused : search();
  front.stats.seconds = watch.seconds();
  return front;
}

}  // namespace ltp
