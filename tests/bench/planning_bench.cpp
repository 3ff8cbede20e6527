// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Every planner on the same query: 100 m through the town, planar and in three dimensions.
#include <benchmark/benchmark.h>

#include <string>

#include "ltp/planning/planners.hpp"
#include "town.hpp"

namespace ltp::bench {
namespace {

void plan(benchmark::State& state, const std::string& name, const AltitudeBand& band) {
  const HeightSurface town(heights());
  const OccupancyGrid grid = window(town);
  const Raster field = priority();
  const auto planner = make_planner(name);
  Query query;
  query.start = kMiddle;
  query.goal = kMiddle + Point(80, 60, 0);
  query.band = band;
  Plan answer;
  for (auto _ : state) {
    answer = planner->plan({grid, field}, query);
    benchmark::DoNotOptimize(answer.penalty);
  }
  state.SetLabel(std::string(to_string(answer.status)));
  state.counters["expanded"] = static_cast<double>(answer.stats.expanded);
  state.counters["length_m"] = answer.tally.length;
}

[[maybe_unused]] const bool registered = [] {
  for (const PlannerInfo& info : planners()) {
    const std::string name(info.name);
    benchmark::RegisterBenchmark(("plan/" + name + "/planar").c_str(), plan, name,
                                 AltitudeBand{0.0, 0.0})
        ->Unit(benchmark::kMillisecond);
    benchmark::RegisterBenchmark(("plan/" + name + "/open").c_str(), plan, name, AltitudeBand{})
        ->Unit(benchmark::kMillisecond);
  }
  return true;
}();

}  // namespace
}  // namespace ltp::bench
