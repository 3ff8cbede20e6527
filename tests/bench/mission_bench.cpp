// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the memory of a mission costs: a scan that adds nothing, one that is all new, a window that
// comes back.
#include <benchmark/benchmark.h>

#include "flight.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace ltp::bench {
namespace {

ObstacleMapOptions options(bool remember, bool carve = false) {
  ObstacleMapOptions options;
  options.remember = remember;
  options.carve_free_space = carve;
  return options;
}

void insert(ObstacleMap& map, const Scan& scan) {
  map.insert(scan.origin, rows(scan.hits), rows(scan.misses));
}

ObstacleMap flown_map(const ObstacleMapOptions& options) {
  ObstacleMap map(options, kMiddle);
  for (const Scan& scan : flight()) insert(map, scan);
  return map;
}

void scan_nothing_new(benchmark::State& state, bool remember) {
  ObstacleMap map = flown_map(options(remember));
  for (auto _ : state) insert(map, flight().front());
}
BENCHMARK_CAPTURE(scan_nothing_new, remember, true)
    ->Name("mission/scan_nothing_new/remember")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(scan_nothing_new, forget, false)
    ->Name("mission/scan_nothing_new/forget")
    ->Unit(benchmark::kMicrosecond);

/// A first scan: thousands of voxels at once. In flight it is some tens.
void scan_all_new(benchmark::State& state, bool remember) {
  ObstacleMap map(options(remember), kMiddle);
  double voxels = 0.0;
  for (auto _ : state) {
    state.PauseTiming();
    map.clear();
    state.ResumeTiming();
    insert(map, flight().front());
    voxels += static_cast<double>(map.voxels().count());
  }
  const double scans = static_cast<double>(state.iterations());
  state.counters["voxels"] = voxels / scans;
  if (remember) {
    const double bytes = static_cast<double>(map.mission()->bytes());
    state.counters["bytes_a_voxel"] = bytes * scans / voxels;
  }
}
BENCHMARK_CAPTURE(scan_all_new, remember, true)
    ->Name("mission/scan_all_new/remember")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(scan_all_new, forget, false)
    ->Name("mission/scan_all_new/forget")
    ->Unit(benchmark::kMicrosecond);

/// Away and back, so that half of each pair of moves restores: by one cell at the edge of what was
/// flown through (a cell's slab that is full), or by the whole window.
void come_back(benchmark::State& state, double metres, bool carve) {
  ObstacleMap map = flown_map(options(true, carve));
  const Point full = kMiddle + Point(200.0, 0, 0);  // the window ends amid what is known
  const std::int64_t all = map.voxels().count();
  for (auto _ : state) {
    map.recentre(full + Point(metres, 0, 0));
    map.recentre(full);
  }
  map.recentre(kMiddle);
  if (map.voxels().count() != all) return state.SkipWithError("voxels were lost");
  state.counters["voxels"] = static_cast<double>(all);
}
BENCHMARK_CAPTURE(come_back, cell, 2.0, false)
    ->Name("mission/roll_to_and_fro/cell")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(come_back, window, 400.0, false)
    ->Name("mission/roll_to_and_fro/window")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(come_back, carved_cell, 2.0, true)
    ->Name("mission/roll_to_and_fro/carved_cell")
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(come_back, carved_window, 400.0, true)
    ->Name("mission/roll_to_and_fro/carved_window")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
