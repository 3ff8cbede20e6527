// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ltp/planning/ellipse.hpp"
#include "ltp/planning/linearisation.hpp"

namespace ltp {
namespace {

constexpr double kSameAlpha = 1e-4;
constexpr double kClosingMemory = 32e6;  // bytes
constexpr int kRoundsOfNarrowing = 3;
constexpr double kWorthNarrowing = 0.01;  // of the largest priority

bool is_known(double alpha, const std::vector<double>& tried) {
  return std::any_of(tried.begin(), tried.end(),
                     [&](double other) { return std::abs(other - alpha) < kSameAlpha; });
}

}  // namespace

LinearisedPlanner::LinearisedPlanner(std::string name, int max_searches,
                                     const PlannerOptions& options)
    : name_(std::move(name)), max_searches_(max_searches), options_(options) {
  options.check();
}

Plan LinearisedPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    if (options_.weights.priority == 0.0 && cells.start != cells.goal) {
      shortest(scene, query, cells, plan);
    } else {
      search(scene, query, cells, plan);
    }
  });
}

void LinearisedPlanner::shortest(const Scene& scene, const Query& query, const GridQuery& cells,
                                 Plan& plan) {
  const Budget budget(options_.max_expansions, query.interrupted);
  plan.status = shortest_.run(scene, query, cells, budget, plan.stats);
  if (plan.status != PlanStatus::Found) return;
  accept(scene, query, cells, options_.weights, shortest_.chain(), plan);
  plan.bound = plan.penalty;
}

/// Leaves over only paths that may have a smaller penalty than the best: bounds their length, and
/// with it the ground that they can visit and the best priority there, and so on. Returns the
/// length [m].
double LinearisedPlanner::narrow(const Scene& scene, const Query& query, double penalty,
                                 PenaltyBound& bound) {
  const GridFrame& frame = scene.occupancy.frame();
  // Steps see more of a finer raster than the columns' centres: there only its maximum is safe.
  if (!aligned(frame, scene.priority)) return std::numeric_limits<double>::infinity();
  priority_.reset(frame, scene.priority);
  // Between two centres a step may touch the columns beside it.
  const double margin = 4.0 * frame.cell().head<2>().norm();
  double longest = bound.longest_below(penalty);
  for (int i = 0; i < kRoundsOfNarrowing; ++i) {
    const double most = bound.most_priority();
    const Ellipse ground(query, longest + margin);
    const double found = most_priority(frame, priority_, ground, (1.0 - kWorthNarrowing) * most);
    if (found >= (1.0 - kWorthNarrowing) * most) break;
    bound.set_most_priority(found);
    longest = bound.longest_below(penalty);
  }
  return longest;
}

double LinearisedPlanner::begin_with(const PenaltyBound& bound, const GridQuery& cells,
                                     const Query& query, double most_priority) const {
  const double fixed = options_.linearised.alpha;
  const double guess = first_alpha(bound, cells.direct_length, most_priority, fixed);
  return fixed == 0.0 && query.goal == last_goal_ ? std::max(guess, last_alpha_) : guess;
}

void LinearisedPlanner::search(const Scene& scene, const Query& query, const GridQuery& cells,
                               Plan& best) {
  const GridFrame& frame = scene.occupancy.frame();
  std::int64_t limit = options_.max_expansions;
  double longest = std::numeric_limits<double>::infinity();
  const auto run = [&](const AdditiveCost& cost) {
    const Budget budget(limit, query.interrupted);
    const AdditiveResult found =
        search_.run(scene, query, cells, cost, budget, best.stats, longest);
    if (found.status != PlanStatus::Found) return found;
    Plan candidate;
    accept(scene, query, cells, options_.weights, found.chain, candidate);
    if (best.status != PlanStatus::Found || candidate.penalty < best.penalty) {
      candidate.stats = best.stats;
      candidate.bound = best.bound;
      best = std::move(candidate);
    }
    return found;
  };

  if (cells.start == cells.goal) {
    run({1.0, 0.0});
    best.bound = best.penalty;  // the only path
    return;
  }
  const double most = std::max(scene.priority.maximum(), 0.0);
  PenaltyBound bound(options_.weights, cells.direct_length, most);
  double alpha = begin_with(bound, cells, query, most);
  std::vector<double> tried;
  const auto slope = [&] { return bound.alpha_at(best.tally.length, best.tally.mean_priority()); };
  bool shortest_known = false;
  bool stopped = false;
  for (int i = 0; i < max_searches_; ++i) {
    const bool shortest = alpha == 0.0;
    const AdditiveResult found = run(shortest ? AdditiveCost{1.0, 0.0} : AdditiveCost{alpha, 1.0});
    if (i == 0 && found.status != PlanStatus::Found) {
      best.status = found.status;
      return;
    }
    if (i == 0 && options_.linearised.effort > 0) {
      const std::int64_t enough = best.stats.expanded + options_.linearised.effort;
      limit = limit > 0 ? std::min(limit, enough) : enough;
    }
    // What a search that was stopped has proved counts as well.
    if (shortest) {
      bound.add_least_length(found.cost);
      shortest_known = true;
    } else {
      bound.add(alpha, found.cost);
      tried.push_back(alpha);
    }
    const PenaltyBound::Point lowest = bound.lowest();
    if (aligned(frame, scene.priority)) best.bound = std::min(lowest.value, best.penalty);
    stopped = found.status != PlanStatus::Found;
    if (stopped) break;
    if (best.penalty - lowest.value <= options_.linearised.tolerance) break;
    // Where the bound lies on a corner of two constraints, the slope there cuts the corner off.
    // Where it lies on one of them, the slope is that search's own: then the shortest path tells
    // whether there are paths that short, and the best path's slope is the last to look along.
    if (std::min(lowest.alpha, slope()) < bound.least_alpha()) {
      longest = narrow(scene, query, best.penalty, bound);
    }
    const auto usable = [&](double next) { return std::max(next, bound.least_alpha()); };
    if (!is_known(usable(lowest.alpha), tried)) {
      alpha = usable(lowest.alpha);
    } else if (!shortest_known && lowest.length < best.tally.length) {
      alpha = 0.0;
    } else if (!is_known(usable(slope()), tried)) {
      alpha = usable(slope());
    } else {
      break;
    }
  }
  const LinearisedOptions& options = options_.linearised;
  const bool open = best.bound && best.penalty - *best.bound > options.tolerance;
  if (open && !stopped && max_searches_ > 1 && options.closing > 0 &&
      options_.weights.length > 0.0) {
    const std::int64_t enough = best.stats.expanded + options.closing;
    const std::int64_t most_expanded =
        options_.max_expansions > 0 ? std::min(options_.max_expansions, enough) : enough;
    const Budget budget(most_expanded, query.interrupted);
    exact_.improve(scene, query, cells, options_.weights, {0.0, options.tolerance, kClosingMemory},
                   budget, best);
    if (exact_.proved()) {
      best.bound = std::min(best.penalty, std::max(*best.bound, *exact_.proved()));
    }
  }
  last_goal_ = query.goal;
  last_alpha_ = slope();
}

}  // namespace ltp
