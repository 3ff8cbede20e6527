// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// GGWP, the paper's greedy grid-based wavefront propagation: short paths, no priority.
#pragma once

#include <vector>

#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/planning/search_space.hpp"

namespace ltp {

/// A wave of unit hops over the 26 neighbours goes out from the goal, cell by cell in
/// first-in-first-out order, until the generation that reaches the start is complete; then the path
/// descends the navigation function. The function is the metric length of the wave's own path: a
/// cell takes the shortest offer that it gets in the generation that first reaches it, and none
/// later (that is the greed: O(N), no priority queue). Bound: a path has at most N hops of the
/// longest step where the shortest has at least N of the shortest step, so it is at most longest /
/// shortest times too long: sqrt(3) on cubes, sqrt(2) in planar flight, sqrt(6) on 2 x 2 x 4 m.
class WavefrontPlanner final : public Planner {
 public:
  explicit WavefrontPlanner(const PlannerOptions& options);

  std::string_view name() const override { return "ggwp"; }
  bool complete() const override { return true; }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  struct Node {
    double value = 0.0;  ///< the navigation function: metres to the goal along the wave
    std::uint32_t stamp = 0;
    std::int32_t generation = -1;  ///< hops from the goal; -1: not reached
  };

  PlanStatus propagate(const Scene& scene, const Query& query, const GridQuery& cells,
                       SearchStats& stats);
  std::vector<Cell> descend(const Scene& scene, const GridQuery& cells);

  PlannerOptions options_;
  SearchSpace<Node> space_;
  std::vector<std::uint32_t> front_;
  std::vector<std::uint32_t> next_;
};

}  // namespace ltp
