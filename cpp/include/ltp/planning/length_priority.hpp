// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The paper's search, literally: LP-Dijkstra, LP-A*, WLP-A*.
#pragma once

#include <string>

#include "ltp/planning/distance_field.hpp"
#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/lazy_open_list.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/planning/search_space.hpp"

namespace ltp {

/// Backward weighted A* from goal to start over the 26-neighbour graph, ordered by Eqs. (8)-(10). A
/// cell carries one label (L, P) and is closed for good when it is expanded: reopening would turn
/// parent chains into rings, since Eq. (8) is a mean that can fall along a path. So for W_P > 0
/// this is the paper's heuristic, not an optimum of Eq. (5). For W_P = 0 and heuristic weight 0 or
/// 1 it is the shortest path on the graph; without a heuristic `DistanceField` finds it.
class LengthPriorityPlanner final : public Planner {
 public:
  /// @param heuristic_weight  W_A* of Eq. (10): 0 LP-Dijkstra, 1 LP-A*, sqrt(3) WLP-A*
  LengthPriorityPlanner(std::string name, double heuristic_weight, const PlannerOptions& options);

  std::string_view name() const override { return name_; }
  bool complete() const override { return true; }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  struct Node {
    double length = 0.0;    ///< L of the path from here to the goal [m]
    double priority = 0.0;  ///< integral of the priority along it [m]
    double g = 0.0;         ///< Eq. (8)
    std::uint32_t stamp = 0;
    std::int8_t to_goal = -1;  ///< number of the step towards the goal; -1 without a label
    bool closed = false;
  };

  /// LP-Dijkstra where priority has no weight.
  PlanStatus dijkstra(const Scene& scene, const Query& query, const GridQuery& cells,
                      SearchStats& stats);
  /// The paper's search.
  PlanStatus search(const Scene& scene, const Query& query, const GridQuery& cells,
                    SearchStats& stats);
  void trace(const GridQuery& cells);

  std::string name_;
  double heuristic_weight_;
  PlannerOptions options_;
  DistanceField field_;
  SearchSpace<Node> space_;
  LazyOpenList open_;
  ColumnPriority priority_;
  std::vector<Cell> chain_;  ///< of the last path found, start ... goal
};

}  // namespace ltp
