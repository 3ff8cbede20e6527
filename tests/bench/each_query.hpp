// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A benchmark of many queries: each is timed alone, so that the median of all can be told.
#pragma once

#include <benchmark/benchmark.h>
#include <time.h>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include "ltp/planning/planner.hpp"

namespace ltp::bench {

/// Processor time of this thread [s].
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Answers all queries in each iteration. Counters: the median query, the 95th percentile and the
/// worst, each at its best; cells settled a query, and the time of each if there were any.
/// @param answer  (const Query&) -> how many cells it settled
template <typename Answer>
void each_query(benchmark::State& state, const std::vector<Query>& queries, Answer&& answer) {
  std::vector<double> best(queries.size(), std::numeric_limits<double>::infinity());
  double settled = 0.0;
  double spent = 0.0;
  for (auto _ : state) {
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const double begin = cpu_seconds();
      settled += static_cast<double>(answer(queries[i]));
      const double seconds = cpu_seconds() - begin;
      best[i] = std::min(best[i], seconds);
      spent += seconds;
    }
  }
  std::sort(best.begin(), best.end());
  state.counters["a_query"] = best[best.size() / 2];
  state.counters["p95_query"] = best[best.size() * 95 / 100];
  state.counters["worst_query"] = best.back();
  state.counters["settled"] =
      settled / static_cast<double>(state.iterations()) / static_cast<double>(queries.size());
  if (settled > 0.0) state.counters["a_cell"] = spent / settled;
}

}  // namespace ltp::bench
