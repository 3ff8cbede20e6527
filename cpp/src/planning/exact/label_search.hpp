// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `LabelSearch`: the exact optimum of Eq. (5) over the simple paths of a graph.
#pragma once

#include <cstdint>
#include <vector>

#include "planning/exact/cell_graph.hpp"
#include "planning/search/arena.hpp"

namespace ltp::planning {

/// Eq. (5), moved up by W_P p_max so that it is never negative: F(L, R) = a L + b R / L with R =
/// p_max L - P, a = W_L / L_direct, b = W_P.
struct ShiftedPenalty {
  double per_metre = 0.0;        ///< a [1/m]
  double priority_weight = 0.0;  ///< b
  double operator()(const StepCost& sum) const {
    return per_metre * sum.length + priority_weight * sum.loss / sum.length;
  }
};

/// For each node, the least `beta` L + R on the way to the goal.
struct Guide {
  double beta = 0.0;
  std::vector<double> to_goal;
};

struct LabelTask {
  const CellGraph& graph;
  ShiftedPenalty penalty;
  const std::vector<Guide>& guides;           ///< at least one; the first orders the search
  const std::vector<double>& length_to_goal;  ///< the least one [m]
  double factor = 1.0;                        ///< >= 1; what may be left of F
  double memory = 0.0;                        ///< for labels and their queue [bytes]
};

/// The best simple path known.
struct Incumbent {
  double value = 0.0;                ///< F
  std::vector<std::uint32_t> chain;  ///< nodes, start ... goal
};

/// Labels (L, R) of paths from the start, best first by a lower bound on F.
///
/// **Bound.** All that is left to the goal costs at least `beta` L + R >= what a guide says. With
/// F < F*, that is a quadratic inequality in the whole path's L; a label goes where the
/// inequalities of all guides have no common L. What they have in common is the label's range [low,
/// high].
///
/// **Dominance.** Of two labels of a node, A dominates B if F of A's path is not above B's whatever
/// follows, as long as F of B's path is below F* (the rest does not matter). With d = L_B - L_A, e
/// = R_B - R_A and y the length of B's whole path, F_B - F_A >= 0 is b e >= d (F_B - 2 a y + a d).
/// So it holds if  b e >= d (F* - 2 a low_B + a d)  for d >= 0,  and if  b e >= d (bound_B - 2 a
/// high_B + a d)  for d < 0. The narrower the range, the nearer is this to one label a node.
///
/// **Simple paths.** Both hold for walks. Where circling pays (steps with a priority above that of
/// the linearised penalty) the best walk may pass a node twice; such nodes become critical (Righini
/// and Salani's decremental state space relaxation): labels remember which critical nodes they have
/// passed, never pass one twice, and A must then have passed none that B has not. Repeated until
/// the best walk is simple.
class LabelSearch {
 public:
  /// Improves `best`, which must be a path of the graph. Found: `best` is within `factor` of the
  /// optimum. OutOfBudget: expansions, memory, or more than 64 critical nodes.
  PlanStatus run(const LabelTask& task, BudgetWatch& budget, SearchStats& stats, Incumbent& best);

  /// No simple path has a smaller F, however the last run ended.
  double proved() const { return proved_; }

 private:
  struct Label {
    StepCost sum;
    std::uint64_t passed;  ///< critical nodes
    float low, high;       ///< lengths that a path through here that is good enough can have [m]
    std::uint32_t node;
    std::uint32_t parent;
    std::uint32_t next;  ///< of the same node's
    bool dominated;
  };
  struct Range {
    double low, high;
    double bound;  ///< on F
  };

  bool solve_relaxed(BudgetWatch& budget, SearchStats& stats, Incumbent& best);
  bool possible(std::uint32_t node, const StepCost& sum, Range& range) const;
  bool is_dominated(const Label& label, const Range& range);
  void arrive(std::uint32_t parent, const StepCost& sum, Incumbent& best);
  bool add_critical();

  const LabelTask* task_ = nullptr;
  double enough_ = 0.0;  ///< only a smaller F is of interest
  double floor_ = 0.0;   ///< no walk has a smaller F
  double proved_ = 0.0;
  double walk_value_ = 0.0;  ///< F of the best walk that is not simple
  std::vector<std::uint32_t> walk_;
  std::vector<std::int8_t> critical_;  ///< the number of each critical node; -1: is none
  int criticals_ = 0;
  std::vector<double> guidance_;  ///< [node][guide], so that a node's stand together
  std::vector<std::uint32_t> heads_;
  Arena<Label> labels_;
  OpenList open_;
};

}  // namespace ltp::planning
