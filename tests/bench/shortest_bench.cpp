// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Shortest paths through a city of boxes: one query, Dijkstra's way too, the whole field, and the
// proof that there is no way.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

#include "each_query.hpp"
#include "ltp/planning/planners.hpp"
#include "planning/search/distance_field.hpp"
#include "planning_city.hpp"

namespace ltp::bench {
namespace {

using namespace planning;  // NOLINT: what is measured

const LevelRange kAllLevels{0, kCityFrame.nz() - 1};

/// The whole of `plan()`.
void plan(benchmark::State& state, const std::string& name, double priority_weight,
          PlanStatus expected) {
  const bool walled_in = expected == PlanStatus::Unreachable;
  const OccupancyGrid grid = city(walled_in);
  const Raster priority = city_priority();
  PlannerOptions options;
  options.weights = {1.0, priority_weight};
  const auto planner = make_planner(name, options);
  const Scene scene{grid, priority};
  each_query(state, walled_in ? walled_in_queries() : city_queries(), [&](const Query& query) {
    const Plan plan = planner->plan(scene, query);
    if (plan.status != expected) state.SkipWithError("an unexpected answer");
    return plan.stats.expanded;
  });
}
BENCHMARK_CAPTURE(plan, shortest, std::string("additive"), 0.0, PlanStatus::Found)
    ->Name("shortest/ltp")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan, dijkstra, std::string("lp-dijkstra"), 0.0, PlanStatus::Found)
    ->Name("dijkstra/ltp")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan, unreachable, std::string("auto"), 0.0, PlanStatus::Unreachable)
    ->Name("unreachable/ltp")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plan, unreachable_weighted, std::string("auto"), 1.0, PlanStatus::Unreachable)
    ->Name("unreachable/ltp_with_priority")
    ->Unit(benchmark::kMillisecond);

/// As textbooks have it: a binary heap, doubles, stale entries skipped. Returns the cells settled.
std::int64_t textbook(const OccupancyGrid& grid, const Cell& source, const Cell& target,
                      std::vector<double>& distances) {
  const GridFrame& frame = grid.frame();
  const std::array<double, kSteps> lengths = step_lengths(frame.cell());
  distances.assign(static_cast<std::size_t>(frame.size()), std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distances[frame.index(source)] = 0.0;
  open.push({0.0, frame.index(source)});
  const std::int64_t end = frame.index(target);
  std::int64_t settled = 0;
  while (!open.empty()) {
    const auto [distance, index] = open.top();
    open.pop();
    if (distance > distances[index]) continue;
    ++settled;
    if (index == end) break;
    const Cell cell = frame.cell_at(index);
    const std::uint32_t blocked = blocked_surroundings(grid, cell, kAllLevels);
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;
      const std::int64_t next = frame.index(cell + step.offset());
      const double total = distance + lengths[i];
      if (total >= distances[next]) continue;
      distances[next] = total;
      open.push({total, next});
    }
  }
  return settled;
}

void textbook_queries(benchmark::State& state) {
  const OccupancyGrid grid = city();
  std::vector<double> distances;
  each_query(state, city_queries(), [&](const Query& query) {
    return textbook(grid, kCityFrame.cell_of(query.start), kCityFrame.cell_of(query.goal),
                    distances);
  });
}
BENCHMARK(textbook_queries)->Name("dijkstra/textbook")->Unit(benchmark::kMillisecond);

void field(benchmark::State& state) {
  const OccupancyGrid grid = city();
  const Cell source = kCityFrame.cell_of(city_queries().front().start);
  DistanceField field;
  std::vector<double> distances(static_cast<std::size_t>(kCityFrame.size()));
  SearchStats stats;
  BudgetWatch budget{Budget{}};
  const double begin = cpu_seconds();
  for (auto _ : state) {
    field.run(grid, source, kAllLevels, budget, stats);
    field.copy_to(distances.data());
    benchmark::DoNotOptimize(distances.data());
  }
  const auto settled = static_cast<double>(stats.expanded);
  state.counters["settled"] = settled / static_cast<double>(state.iterations());
  state.counters["a_cell"] = (cpu_seconds() - begin) / settled;
}
BENCHMARK(field)->Name("distance_field/ltp")->Unit(benchmark::kMillisecond);

/// Eight bytes a cell.
void floor_write(benchmark::State& state) {
  std::vector<double> distances(static_cast<std::size_t>(kCityFrame.size()));
  double value = 0.0;
  for (auto _ : state) {
    std::fill(distances.begin(), distances.end(), value += 1.0);
    benchmark::DoNotOptimize(distances.data());
    benchmark::ClobberMemory();
  }
}
BENCHMARK(floor_write)->Name("distance_field/floor_write")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
