// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/bezier.hpp"

#include <algorithm>
#include <limits>

#include "ltp/planning/curve.hpp"

namespace ltp {
namespace {

constexpr int kAskAfterPieces = 1 << 14;

/// The i-th of `count` offsets spread evenly over [-reach, reach]; the middle one is 0.
double offset(int i, int count, double reach) {
  return count > 1 ? reach * (2.0 * i / (count - 1) - 1.0) : 0.0;
}

}  // namespace

BezierPlanner::BezierPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
  basis_.resize(options.bezier.segments + 1, 3);
  curve_.resize(options.bezier.segments + 1, 3);
  for (int i = 0; i < basis_.rows(); ++i) {
    const double s = static_cast<double>(i) / options.bezier.segments;
    const double r = 1.0 - s;
    basis_.row(i) << 3.0 * r * r * s, 3.0 * r * s * s, s * s * s;  // Eq. (6)
  }
}

void BezierPlanner::draw(const Query& query, double first, double second, double height) {
  const Point direct = query.goal - query.start;
  const Point side = sideways(direct);
  const Point up(0.0, 0.0, height);
  // All relative to P0, whose weight is therefore not needed.
  Eigen::Matrix3d control;
  control.row(0) = (direct / 3.0 + first * side + up).transpose();
  control.row(1) = (direct * (2.0 / 3.0) + second * side + up).transpose();
  control.row(2) = direct.transpose();
  curve_.noalias() = basis_ * control;
  curve_.rowwise() += query.start.transpose();
  curve_.row(0) = query.start.transpose();
  curve_.row(curve_.rows() - 1) = query.goal.transpose();
}

Plan BezierPlanner::plan(const Scene& scene, const Query& query) {
  const BezierOptions& options = options_.bezier;
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    const Penalty penalty(options_.weights, cells.direct_length);
    // Eq. (3) has no price for a loop back to where the UAV is: it stays there.
    const bool moves = cells.direct_length > 0.0;
    const int offsets = moves ? options.offsets : 1;
    const int z_offsets = moves ? options.z_offsets : 1;
    const std::int64_t ask_every = std::max(1, kAskAfterPieces / options.segments);
    const double goal_priority = scene.priority.at(query.goal.x(), query.goal.y());
    double best = std::numeric_limits<double>::infinity();
    Path path;
    bool stopped = false;
    for (int k = 0; k < z_offsets && !stopped; ++k) {
      for (int i = 0; i < offsets && !stopped; ++i) {
        for (int j = 0; j < offsets && !stopped; ++j) {
          // Curves are dear: the caller is asked after so many pieces of them.
          stopped =
              (options_.max_expansions > 0 && plan.stats.expanded >= options_.max_expansions) ||
              (query.interrupted && plan.stats.expanded % ask_every == ask_every - 1 &&
               query.interrupted());
          if (stopped) break;
          ++plan.stats.expanded;
          draw(query, offset(i, offsets, options.reach), offset(j, offsets, options.reach),
               offset(k, z_offsets, options.z_reach));
          const double cost = penalty(tally(curve_, scene.priority), goal_priority);  // Eq. (7)
          if (cost >= best || !inside(scene.occupancy.frame(), cells.levels, curve_) ||
              scene.occupancy.first_blocked(curve_)) {
            continue;
          }
          best = cost;
          path = curve_;
        }
      }
    }
    if (stopped) {
      plan.status = PlanStatus::OutOfBudget;
    } else if (path.rows() > 0) {
      accept(scene, query, cells, options_.weights, std::move(path), plan);
    }
  });
}

}  // namespace ltp
