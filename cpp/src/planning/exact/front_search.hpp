// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `FrontSearch`: all paths of a graph of which none is both shorter and over better ground.
#pragma once

#include <cstdint>
#include <vector>

#include "planning/exact/cell_graph.hpp"
#include "planning/search/arena.hpp"

namespace ltp::planning {

/// A*pex (Zhang et al. 2022) on (L, R): each entry of the queue stands for paths of which none has
/// less length or loss than its *apex*, and of which one, its *representative*, is worse than the
/// apex by `factor` at most. Entries of one node are merged while that holds. For `factor` = 1
/// nothing is merged, and it is BOA* (Hernandez et al. 2020): entries come by rising length, so one
/// number a node, the least loss so far, tells whether another is dominated.
class FrontSearch {
 public:
  struct Solution {
    StepCost sum;
    std::vector<std::uint32_t> chain;  ///< nodes, start ... goal; a simple path
  };
  struct Task {
    const CellGraph& graph;
    const std::vector<double>& length_to_goal;
    const std::vector<double>& loss_to_goal;
    double factor = 1.0;  ///< >= 1
    double memory = 0.0;  ///< for the entries and their queue [bytes]
  };
  /// By rising length and falling loss, none dominated. For each simple path of the graph one of
  /// them has at most `factor` times its length and its loss.
  PlanStatus run(const Task& task, BudgetWatch& budget, SearchStats& stats,
                 std::vector<Solution>& front);

 private:
  struct Entry {
    StepCost apex;
    StepCost representative;
    std::uint32_t node;
    std::uint32_t parent;
    std::uint32_t next;  ///< of the same node's that are open
    bool open;
  };
  bool merge(const Task& task, Entry& entry);

  Arena<Entry> entries_;
  OpenList open_;
  std::vector<double> least_loss_;
  std::vector<std::uint32_t> heads_;
};

}  // namespace ltp::planning
