// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// GGWP beside a wave as textbooks have it, through the city of boxes; and floods.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <vector>

#include "each_query.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "ltp/planning/planners.hpp"
#include "planning/search/flood.hpp"
#include "planning_city.hpp"

namespace ltp::bench {
namespace {

using namespace planning;  // NOLINT: what is measured

const LevelRange kAllLevels{0, kCityFrame.nz() - 1};

std::vector<Query> with_band(std::vector<Query> queries, const AltitudeBand& band) {
  for (Query& query : queries) query.band = band;
  return queries;
}

/// The whole of `plan()`. Counter: by how much its paths are longer than the shortest, in the mean.
void ggwp(benchmark::State& state, const AltitudeBand& band) {
  const OccupancyGrid grid = city();
  const Raster priority = city_priority();
  const Scene scene{grid, priority};
  const std::vector<Query> queries = with_band(city_queries(), band);
  const auto planner = make_planner("ggwp");
  double longer = 0.0;
  PlannerOptions lengths_only;
  lengths_only.weights = {1.0, 0.0};
  const auto shortest = make_planner("additive", lengths_only);
  for (const Query& query : queries) {
    longer += planner->plan(scene, query).tally.length / shortest->plan(scene, query).tally.length /
              static_cast<double>(queries.size());
  }
  each_query(state, queries, [&](const Query& query) {
    const Plan plan = planner->plan(scene, query);
    if (plan.status != PlanStatus::Found) state.SkipWithError("an unexpected answer");
    return plan.stats.expanded;
  });
  state.counters["length_ratio"] = longer;
}
BENCHMARK_CAPTURE(ggwp, open, AltitudeBand{})->Name("ggwp/ltp")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(ggwp, planar, AltitudeBand{0, 0})
    ->Name("ggwp/ltp_planar")
    ->Unit(benchmark::kMillisecond);

/// Cell by cell, first in, first out, over the 26 steps; hops only, no descent. Returns the cells
/// reached.
std::int64_t scalar_wave(const OccupancyGrid& grid, const Cell& from, const Cell& to,
                         const LevelRange& levels, std::vector<std::int32_t>& hops,
                         std::vector<std::int64_t>& queue) {
  const GridFrame& frame = grid.frame();
  hops.assign(static_cast<std::size_t>(frame.size()), -1);
  queue.assign(1, frame.index(from));
  hops[frame.index(from)] = 0;
  const std::int64_t end = frame.index(to);
  for (std::size_t head = 0; head < queue.size() && hops[end] < 0; ++head) {
    const Cell cell = frame.cell_at(queue[head]);
    const std::uint32_t blocked = blocked_surroundings(grid, cell, levels);
    for (const Step& step : steps()) {
      if (blocked & step.box) continue;
      const std::int64_t next = frame.index(cell + step.offset());
      if (hops[next] >= 0) continue;
      hops[next] = hops[queue[head]] + 1;
      queue.push_back(next);
    }
  }
  return static_cast<std::int64_t>(queue.size());
}

void textbook(benchmark::State& state, const AltitudeBand& band) {
  const OccupancyGrid grid = city();
  std::vector<std::int32_t> hops;
  std::vector<std::int64_t> queue;
  each_query(state, with_band(city_queries(), band), [&](const Query& query) {
    return scalar_wave(grid, kCityFrame.cell_of(query.goal), kCityFrame.cell_of(query.start),
                       levels_of(kCityFrame, query), hops, queue);
  });
}
BENCHMARK_CAPTURE(textbook, open, AltitudeBand{})
    ->Name("ggwp/scalar_wave")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(textbook, planar, AltitudeBand{0, 0})
    ->Name("ggwp/scalar_wave_planar")
    ->Unit(benchmark::kMillisecond);

/// From the street, through all that is free.
void flood_window(benchmark::State& state) {
  const OccupancyGrid grid = city();
  const Cell from = kCityFrame.cell_of(city_queries().front().start);
  Flood flood;
  for (auto _ : state) flood.fill(grid, from, kAllLevels);
  state.counters["cells"] = static_cast<double>(flood.count());
}
BENCHMARK(flood_window)->Name("flood/window/ltp")->Unit(benchmark::kMillisecond);

/// From inside the boxes of the hollow city.
void flood_enclosed(benchmark::State& state) {
  const OccupancyGrid grid = city(true);
  Flood flood;
  each_query(state, walled_in_queries(), [&](const Query& query) {
    flood.fill(grid, kCityFrame.cell_of(query.goal), kAllLevels);
    return flood.count();
  });
}
BENCHMARK(flood_enclosed)->Name("flood/enclosed/ltp")->Unit(benchmark::kMicrosecond);

/// One bit a cell, read once.
void floor_read(benchmark::State& state) {
  const OccupancyGrid grid = city();
  for (auto _ : state) benchmark::DoNotOptimize(grid.count());
}
BENCHMARK(floor_read)->Name("flood/floor_read")->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ltp::bench
