// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/linearised.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/additive/additive_search.hpp"
#include "planning/additive/ellipse.hpp"
#include "planning/additive/linearisation.hpp"
#include "planning/additive/penalty_bound.hpp"
#include "planning/exact/exact_search.hpp"
#include "planning/search/column_priority.hpp"
#include "planning/search/shortest_path.hpp"

namespace ltp {
namespace planning {
namespace {

constexpr double kSameAlpha = 1e-4;
constexpr double kClosingMemory = 32e6;  // bytes
constexpr int kRoundsOfNarrowing = 3;
constexpr double kWorthNarrowing = 0.01;  // of the largest priority
constexpr double kInfinity = std::numeric_limits<double>::infinity();

class LinearisedPlanner final : public GridPlanner {
 public:
  LinearisedPlanner(const PlannerInfo& info, const PenaltyWeights& weights,
                    const LinearisedOptions& options)
      : GridPlanner(info, weights), options_(options) {}

 private:
  /// What the searches of one problem have come to.
  struct Progress;

  void search(const Problem& problem, Answer& answer) override;
  void find_shortest(const Problem& problem, Answer& answer);
  bool search_once(const Problem& problem, Answer& answer, Progress& progress);
  bool choose_next(const Problem& problem, const Answer& answer, Progress& progress);
  double narrow(const Problem& problem, double penalty, PenaltyBound& bound);
  double begin_with(const Problem& problem, const PenaltyBound& bound, double max_priority) const;
  void close_gap(const Problem& problem, Answer& answer);

  LinearisedOptions options_;
  ShortestPath shortest_;
  AdditiveSearch search_;
  ColumnPriority priority_;
  ExactSearch exact_;
  Point last_goal_ = Point::Constant(std::numeric_limits<double>::quiet_NaN());
  double last_alpha_ = 0.0;
};

struct LinearisedPlanner::Progress {
  PenaltyBound bound;
  PenaltyBound::Point lowest{};  ///< of the bound
  double alpha;                  ///< of the next search; 0: the shortest path
  std::vector<double> tried;     ///< alphas
  bool shortest_known = false;
  double longest = kInfinity;  ///< no path of interest is longer [m]

  bool knows(double other) const {
    return std::any_of(tried.begin(), tried.end(),
                       [&](double one) { return std::abs(one - other) < kSameAlpha; });
  }
  /// Steps cost something only above the least alpha.
  double usable(double other) const { return std::max(other, bound.min_alpha()); }
  /// Of Eq. (5) at the best path.
  double slope(const Answer& answer) const {
    const PathTally& tally = answer.plan().tally;
    return bound.alpha_at(tally.length, tally.mean_priority());
  }
};

void LinearisedPlanner::search(const Problem& problem, Answer& answer) {
  if (problem.within_a_cell()) {
    answer.offer(std::vector<Cell>{problem.start});
    return answer.prove(answer.plan().penalty);  // the only path
  }
  if (problem.weights.priority == 0.0) return find_shortest(problem, answer);

  const double most = std::max(problem.scene.priority.maximum(), 0.0);
  const PenaltyBound unbounded(problem.weights, problem.direct_length, most, problem.least_length);
  Progress progress{unbounded, {}, begin_with(problem, unbounded, most), {}};
  if (options_.effort > 0 && !options_.whole_first) answer.budget.allow(options_.effort);
  bool whole = search_once(problem, answer, progress);
  if (!answer.found()) return;
  if (options_.effort > 0 && options_.whole_first) {
    answer.budget.allow(answer.stats.expanded + options_.effort);
  }
  const auto is_open = [&] {
    return answer.plan().penalty - progress.lowest.value > options_.tolerance;
  };
  for (int i = 1; i < options_.searches && whole && is_open(); ++i) {
    if (!choose_next(problem, answer, progress)) break;
    whole = search_once(problem, answer, progress);
  }
  if (whole) close_gap(problem, answer);
  last_goal_ = problem.query.goal;
  last_alpha_ = progress.slope(answer);
}

void LinearisedPlanner::find_shortest(const Problem& problem, Answer& answer) {
  if (problem.has_gates()) {
    const AdditiveResult found = search_.run(problem, {1.0, 0.0}, answer.budget, answer.stats);
    if (found.status != PlanStatus::Found) return answer.end(found.status);
    answer.offer(found.chain);
    return answer.prove(answer.plan().penalty);
  }
  const PlanStatus status = shortest_.run(problem, answer.budget, answer.stats);
  if (status != PlanStatus::Found) return answer.end(status);
  answer.offer(shortest_.chain());
  answer.prove(answer.plan().penalty);
}

/// Searches with `progress.alpha` and draws the bound anew. Whether the search went to its end:
/// what one that was stopped has proved counts as well.
bool LinearisedPlanner::search_once(const Problem& problem, Answer& answer, Progress& progress) {
  const bool shortest = progress.alpha == 0.0;
  const AdditiveCost cost = shortest ? AdditiveCost{1.0, 0.0} : AdditiveCost{progress.alpha, 1.0};
  const AdditiveResult result =
      search_.run(problem, cost, answer.budget, answer.stats, progress.longest);
  if (result.status == PlanStatus::Found) {
    answer.offer(result.chain);
  } else {
    answer.end(result.status);
    if (!answer.found()) return false;
  }
  if (shortest) {
    progress.bound.add_min_length(result.cost);
    progress.shortest_known = true;
  } else {
    progress.bound.add(progress.alpha, result.cost);
    progress.tried.push_back(progress.alpha);
  }
  progress.lowest = progress.bound.lowest();
  if (problem.column_priority) answer.prove(progress.lowest.value);
  return result.status == PlanStatus::Found;
}

/// Where the bound lies on a corner of two constraints, the slope there cuts the corner off. Where
/// it lies on one of them, the slope is that search's own: then the shortest path tells whether
/// there are paths that short, and the best path's slope is the last to look along. Whether there
/// is anything left to search with.
bool LinearisedPlanner::choose_next(const Problem& problem, const Answer& answer,
                                    Progress& progress) {
  const PenaltyBound::Point& lowest = progress.lowest;
  const Plan& best = answer.plan();
  const double slope = progress.slope(answer);
  if (std::min(lowest.alpha, slope) < progress.bound.min_alpha()) {
    progress.longest = narrow(problem, best.penalty, progress.bound);
  }
  if (!progress.knows(progress.usable(lowest.alpha))) {
    progress.alpha = progress.usable(lowest.alpha);
  } else if (!progress.shortest_known && lowest.length < best.tally.length) {
    progress.alpha = 0.0;
  } else if (!progress.knows(progress.usable(slope))) {
    progress.alpha = progress.usable(slope);
  } else {
    return false;
  }
  return true;
}

/// Leaves over only paths that may have a smaller penalty than the best: bounds their length, and
/// with it the ground that they can visit and the best priority there, and so on. Returns the
/// length [m].
double LinearisedPlanner::narrow(const Problem& problem, double penalty, PenaltyBound& bound) {
  const GridFrame& frame = problem.frame();
  // Steps see more of a finer raster than the columns' centres: there only its maximum is safe.
  if (!problem.column_priority) return kInfinity;
  priority_.reset(frame, problem.scene.priority);
  // Between two centres a step may touch the columns beside it.
  const double margin = 4.0 * frame.cell().head<2>().norm();
  double longest = bound.longest_below(penalty);
  for (int i = 0; i < kRoundsOfNarrowing; ++i) {
    const double most = bound.max_priority();
    const Ellipse ground(problem, longest + margin);
    const double found = max_priority(frame, priority_, ground, (1.0 - kWorthNarrowing) * most);
    if (found >= (1.0 - kWorthNarrowing) * most) break;
    bound.set_max_priority(found);
    longest = bound.longest_below(penalty);
  }
  return longest;
}

double LinearisedPlanner::begin_with(const Problem& problem, const PenaltyBound& bound,
                                     double max_priority) const {
  const double likely = 0.5 * (problem.direct_length + problem.least_length);  // end amid a region
  const double guess = first_alpha(bound, likely, max_priority, options_.alpha);
  const bool known = options_.remember && options_.alpha == 0.0 && problem.query.goal == last_goal_;
  return known ? std::max(guess, last_alpha_) : guess;
}

void LinearisedPlanner::close_gap(const Problem& problem, Answer& answer) {
  const std::optional<double> bound = answer.plan().bound;
  if (problem.has_gates()) return;  // the exact search knows one goal
  if (!bound || answer.plan().penalty - *bound <= options_.tolerance) return;
  if (options_.searches == 1 || options_.closing == 0 || problem.weights.length == 0.0) return;
  answer.budget.allow(answer.stats.expanded + options_.closing);
  exact_.improve(problem, {0.0, options_.tolerance, kClosingMemory}, answer);
  if (exact_.proved()) answer.prove(std::max(*bound, *exact_.proved()));
}

}  // namespace
}  // namespace planning

void LinearisedOptions::check() const {
  check::not_negative("linearised.alpha", alpha);
  check::not_negative("linearised.tolerance", tolerance);
  check::at_least("linearised.searches", searches, 1);
  check::at_least("linearised.effort", effort, 0);
  check::at_least("linearised.closing", closing, 0);
}

std::unique_ptr<Planner> make_linearised(const PlannerInfo& info, const PenaltyWeights& weights,
                                         const LinearisedOptions& options) {
  options.check();
  return std::make_unique<planning::LinearisedPlanner>(info, weights, options);
}

}  // namespace ltp
