// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ltp/planning/penalty_bound.hpp"
#include "ltp/planning/stopwatch.hpp"

namespace ltp {
namespace {

// Where the first linearisation is made: a path this much longer than the direct one, over ground
// this good. On the paper's maps at its operating point the exact optima lie near by, and a wrong
// guess costs little.
constexpr double kLikelyDetour = 1.1;
constexpr double kLikelyPriority = 0.75;
constexpr double kSameAlpha = 1e-4;

/// Whether the raster's cells are the grid's columns; only then does the search see each path's
/// true priority.
bool aligned(const GridFrame& frame, const Raster& raster) {
  if (frame.cell().x() != raster.cell() || frame.cell().y() != raster.cell()) return false;
  const Eigen::Array2d offset =
      (frame.origin().head<2>() - raster.origin()).array() / raster.cell();
  return ((offset - offset.round()).abs() < 1e-9).all();
}

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
  const Stopwatch watch;
  Plan plan;
  const auto [refused, cells] = resolve(scene, query);
  if (refused) {
    plan.status = *refused;
  } else {
    search(scene, query, cells, plan);
  }
  plan.stats.seconds = watch.seconds();
  return plan;
}

void LinearisedPlanner::search(const Scene& scene, const Query& query, const GridQuery& cells,
                               Plan& best) {
  const GridFrame& frame = scene.occupancy.frame();
  const Budget budget(options_.max_expansions, query.interrupted);
  const bool alone = options_.weights.priority == 0.0 || cells.start == cells.goal;
  std::optional<PenaltyBound> bound;
  double alpha = 1.0;
  if (!alone) {
    const double most = std::max(scene.priority.maximum(), 0.0);
    bound.emplace(options_.weights, cells.direct_length, most);
    alpha = options_.linearised.alpha > 0.0
                ? options_.linearised.alpha
                : bound->alpha_at(kLikelyDetour * cells.direct_length, kLikelyPriority * most);
    alpha = std::max(alpha, bound->least_alpha());
  }

  std::vector<double> tried;
  for (int i = 0; i < max_searches_; ++i) {
    const AdditiveResult found =
        search_.run(scene, query, cells, {alpha, alone ? 0.0 : 1.0}, budget, best.stats);
    if (found.status != PlanStatus::Found) {
      // Out of budget: what was found before stands, and so does its bound.
      if (i == 0) best.status = found.status;
      return;
    }
    Plan candidate;
    accept(scene, query, cells, options_.weights, path_through(frame, query, found.chain),
           candidate);
    if (best.status != PlanStatus::Found || candidate.penalty < best.penalty) {
      candidate.stats = best.stats;
      candidate.bound = best.bound;
      best = std::move(candidate);
    }
    if (alone) {
      best.bound = best.penalty;  // the shortest path, or the only one
      return;
    }
    bound->add(alpha, found.cost);
    tried.push_back(alpha);
    const PenaltyBound::Point lowest = bound->lowest();
    if (aligned(frame, scene.priority)) best.bound = std::min(lowest.value, best.penalty);
    if (best.penalty - lowest.value <= options_.linearised.tolerance) return;
    // Where the bound lies on a corner of two constraints, the slope there cuts the corner off.
    // Where it lies on one of them, the slope is that search's own; then the best path's slope is
    // the one to look along.
    const double slopes[] = {lowest.alpha,
                             bound->alpha_at(best.tally.length, best.tally.mean_priority())};
    alpha = 0.0;
    for (const double slope : slopes) {
      const double usable = std::max(slope, bound->least_alpha());
      if (alpha == 0.0 && !is_known(usable, tried)) alpha = usable;
    }
    if (alpha == 0.0) return;
  }
}

}  // namespace ltp
