// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/planners/refine.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ltp::planning {
namespace {

constexpr double kFirstStep = 1.0;  // of a moved vertex [cells]
constexpr double kLastStep = 0.1;
constexpr int kSweeps = 2;                  // over all vertices with each step, at most
constexpr int kStrides = 4;                 // in a direction that pays, at most
constexpr double kGain = 1e-6;              // of Eq. (5), that a move must bring
constexpr double kVertexGain = 1e-4;        // that a new vertex must bring
constexpr double kNoLoss = 1e-9;            // that a vertex less may cost
constexpr double kRounding = 1e-12;         // of a relative or a small number
constexpr std::size_t kLookAhead = 48;      // vertices that a shortcut may skip
constexpr std::int64_t kTries = 1500;       // of a path, and ...
constexpr std::int64_t kTriesForEach = 20;  // ... for each of its vertices

// Where a vertex may go, in steps; the last two only in space.
constexpr int kMoves = 10;
constexpr double kDiagonal = 0.7071;
constexpr double kDirections[kMoves][3] = {{1, 0, 0},
                                           {-1, 0, 0},
                                           {0, 1, 0},
                                           {0, -1, 0},
                                           {kDiagonal, kDiagonal, 0},
                                           {kDiagonal, -kDiagonal, 0},
                                           {-kDiagonal, kDiagonal, 0},
                                           {-kDiagonal, -kDiagonal, 0},
                                           {0, 0, 1},
                                           {0, 0, -1}};

}  // namespace

Refiner::Refiner(const PenaltyWeights& weights) : weights_(weights) { weights.check(); }

Path Refiner::refine(const Problem& problem, const Path& path) {
  if (path.rows() < 3 || !(problem.direct_length > 0.0)) return path;
  const Sight sight(problem.grid(), problem.levels, problem.scene.priority, problem.altitudes);
  eq5_.emplace(weights_, problem.direct_length);
  cell_ = problem.frame().cell();
  if (!load(sight, path)) return path;
  relax(sight);
  if (shortcut(sight, problem.scene.priority.maximum())) relax(sight);

  Path refined(vertices_.size(), 3);
  for (std::size_t i = 0; i < vertices_.size(); ++i) {
    refined.row(static_cast<Eigen::Index>(i)) = vertices_[i].at.transpose();
  }
  if (!exact(problem, refined, path)) return path;
  return refined;
}

/// Whether the refined path is valid and no worse than the given one: the exact judges have the
/// last word over `Sight`.
bool Refiner::exact(const Problem& problem, const Path& refined, const Path& path) const {
  const GridFrame& frame = problem.frame();
  for (Eigen::Index i = 0; i < refined.rows(); ++i) {
    const Cell cell = frame.cell_of(refined.row(i).transpose());
    if (!frame.contains(cell) || !problem.levels.contains(cell)) return false;
    if (!problem.altitudes.contains(refined(i, 2))) return false;
  }
  const PathTally old = tally(path, problem.scene.priority);
  const PathTally now = tally(refined, problem.scene.priority);
  return (*eq5_)(now) <= (*eq5_)(old) + kRounding && now.length <= old.length * (1.0 + kRounding) &&
         !problem.grid().first_blocked(refined);
}

/// Takes up a path; false if it leads nowhere.
bool Refiner::load(const Sight& sight, const Path& path) {
  vertices_.clear();
  pieces_.clear();
  vertices_.reserve(path.rows());
  pieces_.reserve(path.rows());
  Piece sum;
  flat_ = true;
  for (Eigen::Index i = 0; i < path.rows(); ++i) {
    const Point at = path.row(i).transpose();
    if (i > 0) {
      pieces_.push_back(measure(sight, vertices_.back().at, at));
      pieces_.back().priority = priority(sight, vertices_.back().at, at);
      sum = sum + pieces_.back();
      flat_ = flat_ && at.z() == path(0, 2);
    }
    vertices_.push_back({at, sight.clear(at, kClearance) ? kClearance : 0.0});
  }
  longest_ = sum.length * (1.0 + kRounding);
  most_penalty_ = (*eq5_)(sum.length, sum.priority) + kRounding;
  most_vertices_ = vertices_.size();
  tries_ = kTries + kTriesForEach * path.rows();
  take(sum);
  return sum.length > 0.0;
}

/// Changes single vertices while Eq. (5) falls.
void Refiner::relax(const Sight& sight) {
  for (double step = kFirstStep; step >= kLastStep; step *= 0.5) {
    bool changed = true;
    for (int sweep = 0; sweep < kSweeps && changed; ++sweep) {
      changed = false;
      for (std::size_t i = 1; i + 1 < vertices_.size() && tries_ > 0;) {
        if (drop(sight, i)) {
          changed = true;
        } else {
          changed |= relax(sight, i, step);
          ++i;
        }
      }
    }
  }
}

/// Moves a vertex, by steps [cells]; may cut its corner. Whether that lowered Eq. (5).
bool Refiner::relax(const Sight& sight, std::size_t vertex, double step) {
  bool changed = false;
  for (int stride = 0; stride < kStrides; ++stride) {  // towards the line between its neighbours
    const Point& at = vertices_[vertex].at;
    const Point middle = 0.5 * (vertices_[vertex - 1].at + vertices_[vertex + 1].at);
    if (!move(sight, vertex, at + 0.5 * step * (middle - at))) break;
    changed = true;
  }
  for (int k = 0; k < (flat_ ? kMoves - 2 : kMoves); ++k) {
    const Point direction(kDirections[k][0], kDirections[k][1], kDirections[k][2]);
    const Point offset = step * direction.cwiseProduct(cell_);
    for (int stride = 0; stride < kStrides; ++stride) {
      if (!move(sight, vertex, vertices_[vertex].at + offset)) break;
      changed = true;
    }
  }
  return cut(sight, vertex, 0.5) || cut(sight, vertex, 0.25) || changed;
}

/// Leaves a vertex out if that does not raise Eq. (5).
bool Refiner::drop(const Sight& sight, std::size_t vertex) {
  --tries_;
  const Vertex& from = vertices_[vertex - 1];
  const Vertex& to = vertices_[vertex + 1];
  Piece piece = measure(sight, from.at, to.at);
  const Piece rest = sum_ - pieces_[vertex - 1] - pieces_[vertex];
  if (!better(rest + piece, -kNoLoss) ||
      !sight.clear(from.at, to.at, from.clearance, to.clearance)) {
    return false;
  }
  piece.priority = priority(sight, from.at, to.at);
  const Piece sum = rest + piece;
  if (!allowed(sum)) return false;
  const auto at = static_cast<std::ptrdiff_t>(vertex);
  vertices_.erase(vertices_.begin() + at);
  pieces_.erase(pieces_.begin() + at);
  pieces_[vertex - 1] = piece;
  take(sum);
  return true;
}

/// Moves a vertex if Eq. (5) falls.
bool Refiner::move(const Sight& sight, std::size_t vertex, const Point& to) {
  --tries_;
  const Vertex& from = vertices_[vertex - 1];
  const Vertex& next = vertices_[vertex + 1];
  Piece in = measure(sight, from.at, to);
  Piece out = measure(sight, to, next.at);
  const Piece rest = sum_ - pieces_[vertex - 1] - pieces_[vertex];
  if (!better(rest + in + out, kGain) || !sight.inside(to) ||
      !sight.clear(from.at, to, from.clearance, kClearance) ||
      !sight.clear(to, next.at, kClearance, next.clearance)) {
    return false;
  }
  in.priority = priority(sight, from.at, to);
  out.priority = priority(sight, to, next.at);
  const Piece sum = rest + in + out;
  if (!allowed(sum)) return false;
  vertices_[vertex] = {to, kClearance};
  pieces_[vertex - 1] = in;
  pieces_[vertex] = out;
  take(sum);
  return true;
}

/// Replaces a vertex by two, a share of the way to its neighbours away, if Eq. (5) falls.
bool Refiner::cut(const Sight& sight, std::size_t vertex, double share) {
  if (vertices_.size() >= most_vertices_) return false;
  --tries_;
  const Vertex& from = vertices_[vertex - 1];
  const Vertex& to = vertices_[vertex + 1];
  const Point corner = vertices_[vertex].at;
  const Point a = corner + share * (from.at - corner);
  const Point b = corner + share * (to.at - corner);
  Piece in = measure(sight, from.at, a);
  Piece across = measure(sight, a, b);
  Piece out = measure(sight, b, to.at);
  const Piece rest = sum_ - pieces_[vertex - 1] - pieces_[vertex];
  if (!better(rest + in + across + out, kVertexGain) || !sight.inside(a) || !sight.inside(b) ||
      !sight.clear(from.at, a, from.clearance, kClearance) ||
      !sight.clear(a, b, kClearance, kClearance) ||
      !sight.clear(b, to.at, kClearance, to.clearance)) {
    return false;
  }
  in.priority = priority(sight, from.at, a);
  across.priority = priority(sight, a, b);
  out.priority = priority(sight, b, to.at);
  const Piece sum = rest + in + across + out;
  if (!allowed(sum)) return false;
  const auto at = static_cast<std::ptrdiff_t>(vertex);
  vertices_[vertex] = {a, kClearance};
  vertices_.insert(vertices_.begin() + at + 1, {b, kClearance});
  pieces_[vertex - 1] = in;
  pieces_[vertex] = out;
  pieces_.insert(pieces_.begin() + at, across);
  take(sum);
  return true;
}

/// Leaves out many vertices at once: the cheapest way from the first to the last one over pieces in
/// sight. Whether that lowered Eq. (5).
bool Refiner::shortcut(const Sight& sight, double max_priority) {
  // Eq. (5) linearised at the path: d penalty = per_length dL - per_priority dP.
  const double per_priority = weights_.priority / sum_.length;
  const double per_length = eq5_->per_metre() + per_priority * sum_.beside / sum_.length;
  const double least = per_length - per_priority * max_priority;  // a metre costs no less
  const std::size_t count = vertices_.size();
  costs_.assign(count, 0.0);
  previous_.assign(count, 0);
  for (std::size_t j = 1; j < count; ++j) {
    const Vertex& to = vertices_[j];
    costs_[j] =
        costs_[j - 1] + per_length * pieces_[j - 1].length - per_priority * pieces_[j - 1].beside;
    previous_[j] = j - 1;
    for (std::size_t i = j - 1; i-- > 0 && j - i <= kLookAhead;) {
      const Vertex& from = vertices_[i];
      if (costs_[i] + least * (to.at - from.at).norm() >= costs_[j]) continue;
      const Piece piece = measure(sight, from.at, to.at);
      const double cost = costs_[i] + per_length * piece.length - per_priority * piece.beside;
      if (cost >= costs_[j] || !sight.clear(from.at, to.at, from.clearance, to.clearance)) continue;
      costs_[j] = cost;
      previous_[j] = i;
    }
  }
  kept_.assign(count, 0);
  kept_[0] = 1;
  Piece sum;
  for (std::size_t j = count - 1; j > 0; j = previous_[j]) {
    kept_[j] = 1;
    const Point& from = vertices_[previous_[j]].at;
    Piece piece = measure(sight, from, vertices_[j].at);
    piece.priority = priority(sight, from, vertices_[j].at);
    sum = sum + piece;
  }
  if (!better(sum, kGain) || !allowed(sum)) return false;  // linear is not exact
  std::size_t left = 0;
  for (std::size_t j = 0; j < count; ++j) {
    if (!kept_[j]) continue;
    vertices_[left] = vertices_[j];
    if (left++ == 0) continue;
    const Point& from = vertices_[left - 2].at;
    pieces_[left - 2] = measure(sight, from, vertices_[left - 1].at);
    pieces_[left - 2].priority = priority(sight, from, vertices_[left - 1].at);
  }
  vertices_.resize(left, vertices_.front());
  pieces_.resize(left - 1);
  take(sum);
  return true;
}

/// The priority along a piece; not asked for where it has no weight.
double Refiner::priority(const Sight& sight, const Point& a, const Point& b) const {
  return weights_.priority > 0.0 ? sight.priority(a, b) : 0.0;
}

/// A piece but for its priority.
Refiner::Piece Refiner::measure(const Sight& sight, const Point& a, const Point& b) const {
  const Point way = b - a;
  Piece piece{way.norm()};
  if (weights_.priority == 0.0) return piece;
  const double width = way.head<2>().norm();
  const double aside = width > 0.0 ? kBeside * cell_.head<2>().minCoeff() / width : 0.0;
  const Point left(-aside * way.y(), aside * way.x(), 0.0);
  piece.beside = 0.5 * (sight.priority(a + left, b + left) + sight.priority(a - left, b - left));
  return piece;
}

void Refiner::take(const Piece& path) {
  sum_ = path;
  penalty_ = (*eq5_)(path.length, path.beside);
}

namespace {

class RefinedPlanner final : public Planner {
 public:
  RefinedPlanner(std::unique_ptr<Planner> planner, const PenaltyWeights& weights)
      : planner_(std::move(planner)), weights_(weights), refiner_(weights) {}

  const PlannerInfo& info() const override { return planner_->info(); }
  const PenaltyWeights& weights() const override { return weights_; }
  Plan plan(const Scene& scene, const Query& query, const Budget& budget) override {
    check_query(query);
    const Scene seen = seen_.of(scene);
    Plan plan = planner_->plan(seen, query, budget);
    plan.priority_resampled = seen_.resampled();
    if (plan.status != PlanStatus::Found) return plan;
    const Stopwatch stopwatch;
    Query served = query;
    served.then.resize(plan.passed.size() - 1);
    const Problem problem(seen, served, weights_);
    plan = problem.has_gates() ? by_legs(problem, plan)
                               : accepted(problem, refiner_.refine(problem, plan.path), plan);
    plan.stats.seconds += stopwatch.seconds();
    return plan;
  }

 private:
  /// Each leg between the vertices at which gates are passed: these stay. Together they may be
  /// worse than the given path; then that stands.
  Plan by_legs(const Problem& problem, const Plan& plan) {
    const Path& path = plan.path;
    std::vector<Eigen::Index> ends{0};
    std::size_t passed = problem.passed_at_start;
    for (Eigen::Index i = 1; i < path.rows(); ++i) {
      const std::size_t now = problem.passed_at(path.row(i).transpose(), passed);
      if (now > passed) ends.push_back(i);
      passed = now;
    }
    Path refined = path.topRows(1);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const Path leg = path.middleRows(ends[i - 1], ends[i] - ends[i - 1] + 1);
      const Point from = leg.row(0).transpose();
      const Point to = leg.row(leg.rows() - 1).transpose();
      const auto [low, high] = std::minmax(from.z(), to.z());
      const Query query{from,
                        to,
                        {std::max(0.0, low - problem.altitudes.lowest),
                         std::max(0.0, problem.altitudes.highest - high)}};
      const Path better = refiner_.refine(Problem(problem.scene, query, weights_), leg);
      const Eigen::Index size = refined.rows();
      refined.conservativeResize(size + better.rows() - 1, 3);
      refined.bottomRows(better.rows() - 1) = better.bottomRows(better.rows() - 1);
    }
    if (refined.rows() < 2) return plan;
    Plan better = accepted(problem, until_served(problem, refined), plan);
    return better.penalty <= plan.penalty && better.tally.length <= plan.tally.length ? better
                                                                                      : plan;
  }

  std::unique_ptr<Planner> planner_;
  PenaltyWeights weights_;
  Refiner refiner_;
  ColumnScene seen_;
};

}  // namespace

std::unique_ptr<Planner> make_refined(std::unique_ptr<Planner> planner,
                                      const PenaltyWeights& weights) {
  return std::make_unique<RefinedPlanner>(std::move(planner), weights);
}

}  // namespace ltp::planning
