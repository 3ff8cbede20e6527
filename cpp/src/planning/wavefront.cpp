// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/wavefront.hpp"

#include <cassert>
#include <limits>

#include "ltp/planning/stopwatch.hpp"

namespace ltp {

WavefrontPlanner::WavefrontPlanner(const PlannerOptions& options) : options_(options) {
  options.check();
}

Plan WavefrontPlanner::plan(const Scene& scene, const Query& query) {
  const Stopwatch watch;
  Plan plan;
  const auto [refused, cells] = resolve(scene, query);
  plan.status = refused ? *refused : propagate(scene, query, cells, plan.stats);
  if (plan.status == PlanStatus::Found) {
    Path path = path_through(scene.occupancy.frame(), query, descend(scene, cells));
    accept(scene, query, cells, options_.weights, std::move(path), plan);
  }
  plan.stats.seconds = watch.seconds();
  return plan;
}

PlanStatus WavefrontPlanner::propagate(const Scene& scene, const Query& query,
                                       const GridQuery& cells, SearchStats& stats) {
  const GridFrame& frame = scene.occupancy.frame();
  const std::array<double, kSteps> lengths = step_lengths(frame.cell());
  const Budget budget(options_.max_expansions, query.interrupted);
  space_.begin(frame, cells.levels);
  const std::uint32_t start = space_.index(cells.start);
  const std::uint32_t goal = space_.index(cells.goal);
  space_.visit(goal).generation = 0;
  front_.assign(1, goal);
  ++stats.pushed;

  for (std::int32_t generation = 1; !front_.empty(); ++generation) {
    if (space_.visited(start)) return PlanStatus::Found;
    next_.clear();
    for (const std::uint32_t index : front_) {
      ++stats.expanded;
      if (budget.spent(stats.expanded)) return PlanStatus::OutOfBudget;
      const Cell cell = space_.cell(index);
      const double value = space_[index].value;
      const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
      for (int i = 0; i < kSteps; ++i) {
        const Step& step = steps()[i];
        if (blocked & step.box) continue;
        const std::uint32_t other = space_.index(cell + Cell(step.dx, step.dy, step.dz));
        Node& node = space_.visit(other);
        if (node.generation < 0) {
          node.generation = generation;
          node.value = value + lengths[i];
          next_.push_back(other);
          ++stats.pushed;
        } else if (node.generation == generation && value + lengths[i] < node.value) {
          node.value = value + lengths[i];
        }
      }
    }
    front_.swap(next_);
  }
  return PlanStatus::Unreachable;
}

std::vector<Cell> WavefrontPlanner::descend(const Scene& scene, const GridQuery& cells) {
  const std::array<double, kSteps> lengths = step_lengths(scene.occupancy.frame().cell());
  std::vector<Cell> chain{cells.start};
  while (chain.back() != cells.goal) {
    const Cell cell = chain.back();
    const std::uint32_t blocked = blocked_surroundings(scene.occupancy, cell, cells.levels);
    // The cell's own parent offers its value exactly, so the best offer is never higher and the
    // value falls at every step: the descent ends at the goal, no longer than the wave's own path.
    double best = std::numeric_limits<double>::infinity();
    Cell next = cell;
    for (int i = 0; i < kSteps; ++i) {
      const Step& step = steps()[i];
      if (blocked & step.box) continue;
      const Cell candidate = cell + Cell(step.dx, step.dy, step.dz);
      const std::uint32_t index = space_.index(candidate);
      if (!space_.visited(index)) continue;
      const double offer = space_[index].value + lengths[i];
      if (offer < best) {
        best = offer;
        next = candidate;
      }
    }
    assert(next != cell);
    chain.push_back(next);
  }
  return chain;
}

}  // namespace ltp
