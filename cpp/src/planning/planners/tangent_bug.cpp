// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planners/tangent_bug.hpp"

#include <functional>
#include <vector>

#include "ltp/geometry/check.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/planar_bug.hpp"

namespace ltp {
namespace planning {
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

class TangentBugPlanner final : public GridPlanner {
 public:
  TangentBugPlanner(const PlannerInfo& info, const PenaltyWeights& weights,
                    const TangentBugOptions& options)
      : GridPlanner(info, weights), options_(options) {}

 private:
  void search(const Problem& problem, Answer& answer) override {
    const OccupancyGrid& grid = problem.grid();
    const Query& query = problem.query;
    // Each look around is dear, so the caller is asked every time.
    const std::function<bool()> spent = [&] {
      return answer.budget.spent_now(++answer.stats.expanded);
    };
    PlanarBug bug(grid, options_.range, spent);
    const bool level = problem.start.z() == problem.goal.z();
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
    if (end == PlanarBug::End::Stopped) answer.end(PlanStatus::OutOfBudget);
    if (end != PlanarBug::End::Reached) return;
    if (way.size() == 1 || way.back() != query.goal) way.push_back(query.goal);
    answer.offer(polyline(way));
  }

  TangentBugOptions options_;
};

}  // namespace
}  // namespace planning

void TangentBugOptions::check() const { check::not_negative("tangent_bug.range", range); }

std::unique_ptr<Planner> make_tangent_bug(const PlannerInfo& info, const PenaltyWeights& weights,
                                          const TangentBugOptions& options) {
  options.check();
  return std::make_unique<planning::TangentBugPlanner>(info, weights, options);
}

}  // namespace ltp
