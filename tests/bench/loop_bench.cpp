// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// All that happens ten times a second: scan, insert, move the window, decide.
#include <benchmark/benchmark.h>

#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "town.hpp"

namespace ltp::bench {
namespace {

/// A scan and a decision every 0.3 m along a street, as an aircraft would: sense, then update.
void fly_a_street(benchmark::State& state) {
  const HeightSurface town(heights());
  const Lidar lidar;
  Scan scan;
  std::int64_t steps = 0;
  for (auto _ : state) {
    LocalTrajectoryPlanner planner(make_planner("lp-a-star"), {}, {}, priority(), kMiddle);
    Path goal(1, 3);
    goal.row(0) = (kMiddle + Point(80, 60, 0)).transpose();
    planner.set_waypoints(goal);
    Point position = kMiddle;
    for (int step = 0; step < 100; ++step, ++steps) {
      lidar.scan(town, pose(position), step, scan);
      planner.sense(scan.origin, rows(scan.hits), rows(scan.misses));
      benchmark::DoNotOptimize(planner.update(position));
      position.x() += 0.3;
    }
  }
  state.SetItemsProcessed(steps);
}
BENCHMARK(fly_a_street)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
