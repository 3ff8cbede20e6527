// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Ellipse`: the ground that a path of bounded length from start to goal can visit.
#pragma once

#include <limits>

#include "ltp/grid/frame.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/column_priority.hpp"

namespace ltp::planning {

/// Its foci are start and goal, the distances to them add up to `longest` at most [m].
struct Ellipse {
  Eigen::Vector2d start = Eigen::Vector2d::Zero();
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();
  double longest = std::numeric_limits<double>::infinity();

  Ellipse() = default;
  /// A path to a region may end short of its point, by the region's reach at most.
  Ellipse(const Problem& problem, double longest_path)
      : start(problem.query.start.head<2>()),
        goal(problem.last_point().head<2>()),
        longest(longest_path + (problem.has_gates() ? problem.gates.back().reach() : 0.0)) {}

  bool unbounded() const { return longest == std::numeric_limits<double>::infinity(); }
  bool contains(const Eigen::Vector2d& point) const {
    return (point - start).norm() + (point - goal).norm() <= longest;
  }
};

/// The largest priority, >= 0, of a window's columns in an ellipse; not the largest one, but
/// `enough` or more, where that is reached.
double max_priority(const GridFrame& frame, const ColumnPriority& priority, const Ellipse& ellipse,
                    double enough);

}  // namespace ltp::planning
