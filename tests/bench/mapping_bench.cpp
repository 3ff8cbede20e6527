// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What happens ten times a second: scan, insert, move the window, decide.
#include <benchmark/benchmark.h>

#include "ltp/mapping/obstacle_map.hpp"
#include "ltp/navigation/local_trajectory_planner.hpp"
#include "ltp/planning/planner.hpp"
#include "town.hpp"

namespace ltp::bench {
namespace {

Scan scan_at(const HeightSurface& town, const Lidar& lidar, const Point& position) {
  Scan scan;
  lidar.scan(town, pose(position), 0, scan);
  return scan;
}

void scan(benchmark::State& state) {
  const HeightSurface town(heights());
  const Lidar lidar;
  Scan scan;
  std::uint64_t sequence = 0;
  for (auto _ : state) lidar.scan(town, pose(kMiddle), sequence++, scan);
  state.counters["rays"] = static_cast<double>(lidar.options().pattern.size());
}
BENCHMARK(scan)->Unit(benchmark::kMicrosecond);

/// A scan of what the map knows already (0) or of a place where it has never been (1).
void insert(benchmark::State& state) {
  const HeightSurface town(heights());
  const Scan scan = scan_at(town, Lidar(), kMiddle);
  ObstacleMap map({}, kMiddle);
  for (auto _ : state) {
    if (state.range(0) == 1) {
      state.PauseTiming();
      map.clear();
      state.ResumeTiming();
    }
    map.insert(scan.origin, rows(scan.hits), rows(scan.misses));
  }
  state.counters["hits"] = static_cast<double>(scan.hits.size());
}
BENCHMARK(insert)->Arg(0)->Arg(1)->ArgName("fresh")->Unit(benchmark::kMicrosecond);

/// One cell to and fro.
void recentre(benchmark::State& state) {
  const HeightSurface town(heights());
  ObstacleMap map({}, kMiddle);
  const Scan scan = scan_at(town, Lidar(), kMiddle);
  map.insert(scan.origin, rows(scan.hits));
  const double edge = map.options().cell.x();
  bool away = false;
  for (auto _ : state) {
    away = !away;
    map.recentre(kMiddle + Point(away ? edge : 0.0, 0, 0));
  }
}
BENCHMARK(recentre)->Unit(benchmark::kMicrosecond);

/// What a planning thread needs: a copy of the window.
void snapshot(benchmark::State& state) {
  const HeightSurface town(heights());
  const OccupancyGrid grid = window(town);
  OccupancyGrid copy = grid;
  for (auto _ : state) {
    copy = grid;
    benchmark::DoNotOptimize(copy.words().data());
  }
}
BENCHMARK(snapshot)->Unit(benchmark::kMicrosecond);

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
    planner.set_way_points(goal);
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
