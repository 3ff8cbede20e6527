// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The map's window, once it has been flown through: asked, moved, inflated and copied.
#include <benchmark/benchmark.h>

#include <cstring>

#include "flight.hpp"
#include "ltp/mapping/obstacle_map.hpp"

namespace ltp::bench {
namespace {

ObstacleMap flown_map() {
  ObstacleMap map({}, kMiddle);
  for (const Scan& scan : flight()) map.insert(scan.origin, rows(scan.hits));
  return map;
}

/// One cell to and fro along an axis.
void roll(benchmark::State& state, int axis) {
  ObstacleMap map = flown_map();
  const Point there = kMiddle + map.options().cell[axis] * Point::Unit(axis);
  bool away = false;
  for (auto _ : state) {
    away = !away;
    benchmark::DoNotOptimize(map.recentre(away ? there : kMiddle));
  }
}
BENCHMARK_CAPTURE(roll, x, 0)->Name("roll/x/ltp")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(roll, y, 1)->Name("roll/y/ltp")->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(roll, z, 2)->Name("roll/z/ltp")->Unit(benchmark::kMicrosecond);

/// Moving what the map holds by one row: occupied, blocked, and the voxels of half their height.
void roll_floor(benchmark::State& state) {
  const ObstacleMap map = flown_map();
  std::vector<std::uint64_t> planning = map.occupied().words();
  std::vector<std::uint64_t> blocked = map.blocked().words();
  std::vector<std::uint64_t> voxels = map.voxels().words();
  const auto move = [](std::vector<std::uint64_t>& words, std::size_t by) {
    std::memmove(words.data(), words.data() + by, (words.size() - by) * sizeof(words.front()));
    benchmark::DoNotOptimize(words.data());
  };
  for (auto _ : state) {
    move(planning, 200);
    move(blocked, 200);
    move(voxels, 400);
  }
}
BENCHMARK(roll_floor)->Name("roll/floor_memmove")->Unit(benchmark::kMicrosecond);

/// By 4 m, one new cell after the other.
void inflate_cell(benchmark::State& state) {
  const ObstacleMap map = flown_map();
  const GridFrame& frame = map.occupied().frame();
  Inflation inflation(frame, 4.0);
  OccupancyGrid blocked(frame);
  std::vector<Cell> cells;
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    if (map.occupied().blocked(frame.cell_at(i))) cells.push_back(frame.cell_at(i));
  }
  for (auto _ : state) {
    for (const Cell& cell : cells) inflation.add(cell, blocked);
    benchmark::DoNotOptimize(blocked.words().data());
  }
  state.counters["a_cell"] = benchmark::Counter(
      static_cast<double>(cells.size()),
      benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(inflate_cell)->Name("inflate/cell/ltp")->Unit(benchmark::kMicrosecond);

/// By 4 m, anew.
void inflate_window(benchmark::State& state) {
  const ObstacleMap map = flown_map();
  Inflation inflation(map.occupied().frame(), 4.0);
  OccupancyGrid blocked(map.occupied().frame());
  for (auto _ : state) {
    inflation.apply(map.occupied(), blocked);
    benchmark::DoNotOptimize(blocked.words().data());
  }
  state.counters["occupied"] = static_cast<double>(map.occupied().count());
}
BENCHMARK(inflate_window)->Name("inflate/window/ltp")->Unit(benchmark::kMicrosecond);

/// What a planning thread gets: a copy of the window, at the price of a memcpy.
void snapshot(benchmark::State& state) {
  const ObstacleMap map = flown_map();
  OccupancyGrid copy = map.blocked();
  for (auto _ : state) {
    copy = map.blocked();
    benchmark::DoNotOptimize(copy.words().data());
  }
}
BENCHMARK(snapshot)->Name("snapshot/ltp")->Unit(benchmark::kMicrosecond);

void snapshot_floor(benchmark::State& state) {
  const ObstacleMap map = flown_map();
  const std::vector<std::uint64_t>& words = map.blocked().words();
  std::vector<std::uint64_t> copy(words.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), words.data(), words.size() * sizeof(words.front()));
    benchmark::DoNotOptimize(copy.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(snapshot_floor)->Name("snapshot/floor_memcpy")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ltp::bench
