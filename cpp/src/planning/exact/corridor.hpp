// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Corridor`: the cells that a path cheap enough may use.
#pragma once

#include <vector>

#include "planning/additive/column_costs.hpp"
#include "planning/exact/step_costs.hpp"
#include "planning/search/open_list.hpp"
#include "planning/search/search_space.hpp"

namespace ltp::planning {

/// Backward A* from the goal with the cost `beta` L + R, ended not at the start but where every
/// cell left costs too much. Its heuristic is the cost over the columns from the start.
class Corridor {
 public:
  /// Fills `cells` with all those of which a path from start to goal through them may cost `most`
  /// or less, and maybe others. False: out of budget.
  bool find(const Problem& problem, const StepCosts& costs, double beta, double most,
            BudgetWatch& budget, SearchStats& stats, std::vector<Cell>& cells);

 private:
  struct Node {
    double cost = 0.0;
    std::uint32_t stamp = 0;
    bool labelled = false;
    bool closed = false;
  };
  SearchSpace<Node> space_;
  OpenList open_;
  ColumnCosts to_start_;
};

}  // namespace ltp::planning
