// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/curve_planner.hpp"

namespace ltp::planning {

CurvePlanner::CurvePlanner(const PlannerInfo& info, const PenaltyWeights& weights, int segments,
                           Eigen::RowVector3d (*basis)(double s))
    : GridPlanner(info, weights), basis_(segments + 1, 3), curve_(segments + 1, 3) {
  for (int i = 0; i <= segments; ++i) basis_.row(i) = basis(static_cast<double>(i) / segments);
}

const Path& CurvePlanner::draw(const Query& query, const Point& first, const Point& second) {
  // All relative to the start, whose weight is therefore not needed.
  Eigen::Matrix3d control;
  control.row(0) = first.transpose();
  control.row(1) = second.transpose();
  control.row(2) = (query.goal - query.start).transpose();
  curve_.noalias() = basis_ * control;
  curve_.rowwise() += query.start.transpose();
  curve_.row(0) = query.start.transpose();
  curve_.row(curve_.rows() - 1) = query.goal.transpose();
  return curve_;
}

double CurvePlanner::penalty(const Problem& problem, const Path& curve) {
  const Point& goal = problem.query.goal;
  return Penalty(problem.weights, problem.direct_length)(
      tally(curve, problem.scene.priority), problem.scene.priority.at(goal.x(), goal.y()));
}

bool CurvePlanner::clear(const Problem& problem, const PathRef& curve) {
  for (Eigen::Index i = 0; i < curve.rows(); ++i) {
    const Cell cell = problem.frame().cell_of(curve.row(i).transpose());
    if (!problem.frame().contains(cell) || !problem.levels.contains(cell)) return false;
    if (!problem.altitudes.contains(curve(i, 2))) return false;
  }
  return !problem.grid().first_blocked(curve);
}

Point CurvePlanner::sideways(const Point& direction) {
  const Eigen::Vector2d plane = direction.head<2>();
  if (!(plane.norm() > 0.0)) return Point::UnitX();
  const Eigen::Vector2d side = Eigen::Vector2d(-plane.y(), plane.x()).normalized();
  return Point(side.x(), side.y(), 0.0);
}

}  // namespace ltp::planning
