// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/bug.hpp"

#include <functional>
#include <vector>

#include "planar_bug.hpp"

namespace ltp {
namespace {

bool clear(const OccupancyGrid& grid, const Point& a, const Point& b) {
  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> ends;
  ends << a.transpose(), b.transpose();
  return !grid.first_blocked(ends);
}

/// The point over or under `point` at another height.
Point at_height(const Point& point, double z) { return {point.x(), point.y(), z}; }

Path polyline(const std::vector<Point>& way) {
  return Eigen::Map<const Path>(way.front().data(), static_cast<Eigen::Index>(way.size()), 3);
}

}  // namespace

BugPlanner::BugPlanner(const PlannerOptions& options) : options_(options) { options.check(); }

Plan BugPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    const OccupancyGrid& grid = scene.occupancy;
    // Each look around is dear, so the caller is asked every time.
    const std::function<bool()> spent = [&] {
      ++plan.stats.expanded;
      return (options_.max_expansions > 0 && plan.stats.expanded >= options_.max_expansions) ||
             (query.interrupted && query.interrupted());
    };
    PlanarBug bug(grid, options_.bug.range, spent);
    const bool level = cells.start.z() == cells.goal.z();
    const Point over_goal = level ? query.goal : at_height(query.goal, query.start.z());
    const Point over_start = at_height(query.start, query.goal.z());
    std::vector<Point> way = {query.start};
    PlanarBug::End end = PlanarBug::End::GaveUp;
    if (spent()) {
      end = PlanarBug::End::Stopped;
    } else if (clear(grid, query.start, query.goal)) {
      end = PlanarBug::End::Reached;
    } else if (level || clear(grid, over_goal, query.goal)) {
      end = bug.run(over_goal, way);
    }
    if (end == PlanarBug::End::GaveUp && !level && clear(grid, query.start, over_start)) {
      way = {query.start, over_start};
      end = bug.run(query.goal, way);
    }
    if (end == PlanarBug::End::Stopped) plan.status = PlanStatus::OutOfBudget;
    if (end == PlanarBug::End::Reached) {
      if (way.size() == 1 || way.back() != query.goal) way.push_back(query.goal);
      accept(scene, query, cells, options_.weights, polyline(way), plan);
    }
  });
}

}  // namespace ltp
