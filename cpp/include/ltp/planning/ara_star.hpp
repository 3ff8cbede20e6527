// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// ARA*: a path soon, then better ones, each with a proof of how good it is.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ltp/planning/column_field.hpp"
#include "ltp/planning/flood.hpp"
#include "ltp/planning/grid_query.hpp"
#include "ltp/planning/open_list.hpp"
#include "ltp/planning/planner.hpp"
#include "ltp/planning/search_space.hpp"

namespace ltp {

/// Likhachev, Gordon, Thrun, "ARA*: Anytime A* with provable bounds on sub-optimality", NIPS 2003,
/// on the graph and cost of `AdditiveSearch`. Each round is an A* whose heuristic is weighted; it
/// costs at most that weight times the least. The next, with a smaller weight, goes on from what
/// the last one left: cells that became cheaper after they were closed wait in a list of their own
/// (INCONS) until then. In the last round, with weight 1, they are opened again at once.
class AraSearch {
 public:
  /// Begins. All that is given is borrowed until the last `improve`.
  void begin(const Scene& scene, const Query& query, const GridQuery& cells,
             const AdditiveCost& cost, SearchStats& stats);

  /// One round. `Found`: `chain` costs at most `weight` times the least; `Unreachable`: proved;
  /// `OutOfBudget`: stopped on the way.
  PlanStatus improve(double weight, const Budget& budget, SearchStats& stats);

  double cost() const { return space_[goal_].cost; }  ///< of the best path so far
  double least() const { return least_; }             ///< no path costs less
  std::vector<Cell> chain() const;                    ///< the best path so far, start ... goal

 private:
  struct Node {
    double cost = std::numeric_limits<double>::infinity();  ///< from the start to here
    std::uint32_t stamp = 0;
    std::int32_t closed = 0;      ///< the last round that closed it
    std::int8_t from_start = -1;  ///< number of the step that led here
    bool waiting = false;         ///< its present cost has not been passed on: OPEN or INCONS
  };

  double heuristic(const Cell& cell);
  double step_cost(const Cell& from, const Cell& to, double length);
  void expand(std::uint32_t index, SearchStats& stats);
  void reweigh(double weight);

  const Scene* scene_ = nullptr;
  const Query* query_ = nullptr;
  GridQuery cells_;
  AdditiveCost cost_;
  std::array<double, kSteps> lengths_{};
  double weight_ = 1.0;
  double least_ = 0.0;
  std::int32_t round_ = 0;
  std::uint32_t goal_ = 0;

  SearchSpace<Node> space_;
  OpenList open_;
  std::vector<std::uint32_t> waiting_;  ///< cells of OPEN and INCONS, between two rounds
  std::vector<std::uint32_t> incons_;
  ColumnField field_;
  Flood flood_;
};

/// The additive cost at the first guess of `additive`; its least value bounds Eq. (5) as there. Of
/// the rounds' paths the one with the smallest penalty is the answer: a budget that ends after the
/// first round leaves a path and a bound, before that `OutOfBudget`.
class AraStarPlanner final : public Planner {
 public:
  explicit AraStarPlanner(const PlannerOptions& options);

  std::string_view name() const override { return "ara-star"; }
  bool complete() const override { return true; }
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  void search(const Scene& scene, const Query& query, const GridQuery& cells, Plan& best);

  PlannerOptions options_;
  AraSearch search_;
};

}  // namespace ltp
