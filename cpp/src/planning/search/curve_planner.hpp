// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CurvePlanner`: what the planners share that look for a cubic curve from start to goal.
#pragma once

#include "ltp/planning/grid_planner.hpp"

namespace ltp::planning {

inline constexpr int kLeastSegments = 2;
inline constexpr int kMostSegments = 100000;

/// A curve is flown, tallied and tested as the polyline through `segments` + 1 of its points,
/// tested exactly along its segments.
class CurvePlanner : public GridPlanner {
 protected:
  /// The curve's points relative to its start, by a parameter s that goes from 0 to 1, are sums of
  /// three control vectors; the last of them leads to the goal.
  /// @param basis  the weights of the three at s
  CurvePlanner(const PlannerInfo& info, const PenaltyWeights& weights, int segments,
               Eigen::RowVector3d (*basis)(double s));

  /// The curve of two control vectors [m], until the next call.
  const Path& draw(const Query& query, const Point& first, const Point& second);
  /// Eq. (5) of a polyline from start to goal, obstacles aside.
  static double penalty(const Problem& problem, const Path& curve);
  /// Whether a polyline keeps to the window and its levels and meets no blocked cell.
  static bool clear(const Problem& problem, const PathRef& curve);
  /// Which way is sideways: in the plane, square to a direction, to its left. Straight up there is
  /// no sideways; east is as good as any.
  static Point sideways(const Point& direction);

 private:
  Path basis_;
  Path curve_;
};

}  // namespace ltp::planning
