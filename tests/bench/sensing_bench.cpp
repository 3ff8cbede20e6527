// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// One scan of 65,536 rays, level and tilted, and the floor beside it: reading each height under it.
#include <benchmark/benchmark.h>

#include "city.hpp"
#include "ltp/grid/ray_walk.hpp"
#include "ltp/sensing/height_surface.hpp"

namespace ltp::bench {
namespace {

void count_rays(benchmark::State& state, std::size_t scans) {
  const double rays = static_cast<double>(state.iterations() * scans) * city_lidar().pattern.size();
  state.counters["rays_per_second"] = benchmark::Counter(rays, benchmark::Counter::kIsRate);
}

void scan(benchmark::State& state, bool tilted) {
  const City city;
  const HeightSurface surface(city.heights());
  const Lidar lidar(city_lidar());
  const std::vector<Pose> poses = city_flight(city, tilted);
  Scan scan;
  std::int64_t hits = 0;
  for (auto _ : state) {
    for (const Pose& pose : poses) {
      lidar.scan(surface, pose, 0, scan, Misses::Counted);
      hits += scan.statistics.hits;
    }
  }
  count_rays(state, poses.size());
  state.counters["hits"] = static_cast<double>(hits) / (state.iterations() * poses.size());
}
BENCHMARK_CAPTURE(scan, level, false)->Name("lidar/level/ltp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(scan, tilted, true)->Name("lidar/tilted/ltp")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
