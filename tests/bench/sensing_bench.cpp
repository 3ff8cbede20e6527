// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// One scan of 65,536 rays, level and tilted, and the floor beside it: reading each height under it.
#include <benchmark/benchmark.h>

#include "lidar_city.hpp"
#include "ltp/grid/ray_walk.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp::bench {
namespace {

using Counter = benchmark::Counter;

void count_rays(benchmark::State& state, std::size_t scans) {
  const double rays = static_cast<double>(scans) * static_cast<double>(city_lidar().pattern.size());
  state.counters["rays_per_second"] = Counter(rays, Counter::kIsIterationInvariantRate);
}

void scan(benchmark::State& state, bool tilted, Misses misses) {
  const City city;
  const HeightSurface surface(city.heights());
  const Lidar lidar(city_lidar());
  const std::vector<Pose> poses = city_flight(city, tilted);
  Scan scan;
  std::int64_t hits = 0;
  for (auto _ : state) {
    for (const Pose& pose : poses) {
      lidar.scan(surface, pose, 0, scan, misses);
      hits += scan.statistics.hits;
    }
  }
  count_rays(state, poses.size());
  state.counters["hits"] = Counter(static_cast<double>(hits) / static_cast<double>(poses.size()),
                                   Counter::kAvgIterations);
}
BENCHMARK_CAPTURE(scan, level, false, Misses::Counted)
    ->Name("lidar/level/ltp")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, level_misses, false, Misses::Listed)
    ->Name("lidar/level/ltp_misses")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted, true, Misses::Counted)
    ->Name("lidar/tilted/ltp")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted_misses, true, Misses::Listed)
    ->Name("lidar/tilted/ltp_misses")
    ->Unit(benchmark::kMillisecond);

/// The floor of anything that walks: to read, once, the height of each cell that a scan's rays
/// cross before they end; for a level scan each cell once an azimuth, since its beams share the
/// track.
void floor(benchmark::State& state, bool tilted) {
  const City city;
  const HeightSurface surface(city.heights());
  const Lidar lidar(city_lidar());
  const Pose pose = city_flight(city, tilted).front();
  const int rows = lidar.options().pattern.rows;
  std::vector<int> walked;
  std::vector<int> fan;
  for (Eigen::Index ray = 0; ray < lidar.directions().rows(); ++ray) {
    if (!tilted && ray % rows == 0) fan.clear();
    const Point direction = pose.world_from_body * Point(lidar.directions().row(ray).transpose());
    const double range = std::min(surface.cast(pose.position, direction, 50.0).range, 50.0);
    const Point end = pose.position + range * direction;
    walk_segment<2>(pose.position.head<2>(), end.head<2>(),
                    [&](const auto& cell, double /*t_in*/, double /*t_out*/) {
                      fan.push_back(cell.x() * City::kEdge + cell.y());
                      return true;
                    });
    if (tilted || ray % rows == rows - 1) {
      std::sort(fan.begin(), fan.end());
      fan.erase(std::unique(fan.begin(), fan.end()), fan.end());
      walked.insert(walked.end(), fan.begin(), fan.end());
      fan.clear();
    }
  }
  const double* heights = surface.heights().values().data();
  for (auto _ : state) {
    double highest = 0.0;
    for (const int cell : walked) highest = std::max(highest, heights[cell]);
    benchmark::DoNotOptimize(highest);
  }
  count_rays(state, 1);
  const auto cells = static_cast<double>(walked.size());
  state.counters["cells"] = cells;
  state.counters["seconds_per_cell"] =
      Counter(cells, Counter::kIsIterationInvariantRate | Counter::kInvert);
  std::sort(walked.begin(), walked.end());
  const auto distinct = std::unique(walked.begin(), walked.end()) - walked.begin();
  state.counters["bytes"] = static_cast<double>(distinct) * sizeof(double);
}
BENCHMARK_CAPTURE(floor, level, false)->Name("lidar/level/floor")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(floor, tilted, true)->Name("lidar/tilted/floor")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
