// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Ways beyond the window: the shortest way over 2 km x 2 km of what is remembered.
#include <benchmark/benchmark.h>

#include <random>
#include <string>
#include <vector>

#include "each_query.hpp"
#include "navigation/route.hpp"
#include "planning_city.hpp"

namespace ltp::bench {
namespace {

constexpr int kTimes = 5;  // the city, along each axis
const GridFrame kWideFrame({0, 0, 0}, {2, 2, 4}, {200 * kTimes, 200 * kTimes, 40});

/// The city of boxes five by five times, turned about: a fifth of all cells is blocked.
OccupancyGrid wide_city() {
  const OccupancyGrid part = city();
  OccupancyGrid grid(kWideFrame);
  for (int ix = 0; ix < kWideFrame.nx(); ++ix) {
    for (int iy = 0; iy < kWideFrame.ny(); ++iy) {
      const bool flip_x = (ix / 200 + iy / 200) % 2 != 0;
      const bool flip_y = (ix / 200) % 2 != 0;
      const int x = flip_x ? 199 - ix % 200 : ix % 200;
      const int y = flip_y ? 199 - iy % 200 : iy % 200;
      grid.column(ix, iy)[0] = part.column(x, y)[0];
    }
  }
  return grid;
}

/// 50 queries from free cell to free cell, 1 to 2 km apart.
std::vector<Query> wide_queries(const OccupancyGrid& grid, const AltitudeBand& band) {
  std::mt19937 random(77);
  std::vector<Query> queries;
  const int edge = kWideFrame.nx();
  while (queries.size() < 50) {
    const Cell start(draw(random, 0, edge - 1), draw(random, 0, edge - 1), kFlightLevel);
    const Cell goal(draw(random, 0, edge - 1), draw(random, 0, edge - 1), kFlightLevel);
    const double apart = (kWideFrame.centre(goal) - kWideFrame.centre(start)).norm();
    if (grid.blocked(start) || grid.blocked(goal) || apart < 1000.0 || apart > 2000.0) continue;
    queries.push_back({kWideFrame.centre(start), kWideFrame.centre(goal), band});
  }
  return queries;
}

void route(benchmark::State& state, const AltitudeBand& band) {
  const OccupancyGrid grid = wide_city();
  Route way;
  each_query(state, wide_queries(grid, band), [&](const Query& query) {
    if (way.find(grid, query, nullptr) != PlanStatus::Found) state.SkipWithError("no way");
    return static_cast<std::int64_t>(way.path().rows());
  });
}
BENCHMARK_CAPTURE(route, planar, AltitudeBand{0.0, 0.0})
    ->Name("route/2km_planar")
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(route, open, AltitudeBand{})
    ->Name("route/2km_open")
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ltp::bench
