// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A planner of your own behind the interface of all planners: it climbs until the straight way is
// free. `GridPlanner` does what all planners do alike: it checks the query, the path and the
// budget, and evaluates Eq. (5). Asked one question, beside `auto`; then the loop that flies takes
// it.
#include <algorithm>
#include <iostream>
#include <ltp/navigation/local_trajectory_planner.hpp>
#include <ltp/planning/grid_planner.hpp>
#include <ltp/planning/planners.hpp>
#include <memory>
#include <utility>

class UpAndOver : public ltp::GridPlanner {
 public:
  UpAndOver() : GridPlanner({"up-and-over", "Up and over"}, ltp::PenaltyWeights{}) {}

 private:
  void search(const ltp::Problem& problem, ltp::Answer& answer) override {
    const ltp::Point& start = problem.query.start;
    const ltp::Point& goal = problem.query.goal;
    const double step = problem.frame().cell().z();
    const double top = problem.frame().centre({0, 0, problem.levels.highest}).z();
    for (double z = std::max(start.z(), goal.z()); z <= top; z += step) {
      if (answer.budget.spent(answer.stats.expanded)) {
        return answer.end(ltp::PlanStatus::OutOfBudget);
      }
      ++answer.stats.expanded;
      ltp::Path path(4, 3);
      path << start.x(), start.y(), start.z(), start.x(), start.y(), z, goal.x(), goal.y(), z,
          goal.x(), goal.y(), goal.z();
      if (problem.grid().first_blocked(path)) continue;
      answer.offer(path);
      return;
    }
  }  // that says nothing has found nothing, which proves nothing
};

int main() {
  ltp::OccupancyGrid grid(ltp::GridFrame({0, 0, 0}, {2, 2, 4}, {100, 100, 20}));
  for (int iy = 0; iy < 100; ++iy) {
    for (int iz = 0; iz < 12; ++iz) grid.set({50, iy, iz});  // a wall 48 m high, with no way round
  }
  const ltp::Raster priority(ltp::Raster::Values::Constant(100, 100, 0.5), {0, 0}, 2.0);
  std::unique_ptr<ltp::Planner> planners[] = {std::make_unique<UpAndOver>(),
                                              ltp::make_planner("auto")};
  for (const auto& planner : planners) {
    const ltp::Plan plan = planner->plan({grid, priority}, {{20, 100, 20}, {180, 100, 20}});
    std::cout << planner->name() << ": " << ltp::to_string(plan.status) << ", " << plan.tally.length
              << " m, penalty " << plan.penalty << '\n';
  }
  const ltp::LocalTrajectoryPlanner loop(std::move(planners[0]), {}, {}, priority, {20, 100, 20});
  std::cout << "the loop flies " << loop.planner().name() << '\n';
}
