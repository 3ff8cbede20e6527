// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/wavefront.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

#include "ltp/planning/length_units.hpp"

namespace ltp {

WavefrontPlanner::WavefrontPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
}

Plan WavefrontPlanner::plan(const Scene& scene, const Query& query) {
  return answer(scene, query, [&](const GridQuery& cells, Plan& plan) {
    const Budget budget(options_.max_expansions, query.interrupted);
    plan.status =
        wave_.run(scene.occupancy, cells.levels, cells.goal, cells.start, budget, plan.stats);
    if (plan.status == PlanStatus::Found) {
      accept(scene, query, cells, options_.weights, descend(scene, cells), plan);
    }
  });
}

std::vector<Cell> WavefrontPlanner::descend(const Scene& scene, const GridQuery& cells) {
  const std::array<double, kSteps> lengths = step_lengths(scene.occupancy.frame().cell());
  const LengthUnits units(LengthUnits::longest(scene.occupancy.frame())[0]);
  open_.aim(cells.goal, units.of_steps(scene.occupancy.frame().cell()));
  std::vector<Cell> chain{cells.start};
  int here = wave_.generation();
  while (chain.back() != cells.goal) {
    const Cell cell = chain.back();
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
    double best = std::numeric_limits<double>::infinity();
    Cell next = cell;
    int gone = 0;
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;
      const Cell candidate = cell + Cell(step.dx, step.dy, step.dz);
      const int earlier = wave_.earlier(candidate, here);
      if (earlier == 0) continue;
      // A generation is counted when it begins, so what is left is half a one less on average.
      const double without = candidate == cells.goal ? 0.0 : units.metres(open_(candidate));
      const double left = std::max(without, wave_.pace() * (here - earlier - 0.5));
      if (lengths[i] + left < best) {
        best = lengths[i] + left;
        next = candidate;
        gone = earlier;
      }
    }
    assert(gone > 0);  // the wave came from somewhere
    here -= gone;
    chain.push_back(next);
  }
  return chain;
}

}  // namespace ltp
