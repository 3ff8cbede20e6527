// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GridPlanner`: what all planners over a grid do alike, so that one is only what differs.
#pragma once

#include <optional>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/planning/column_scene.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// Throws `std::invalid_argument` for a point that is not finite or a band below zero.
void check_query(const Query& query);

/// The altitudes that a path may have [m].
struct AltitudeRange {
  double lowest;
  double highest;

  /// Whether an altitude is one of them, to within 1e-9 m.
  bool contains(double z) const;
};

/// From the lower of a query's ends less what its band allows below, to the higher one and what it
/// allows above.
AltitudeRange altitudes_of(const Query& query);

/// The levels that a query's band leaves open, clipped to the frame: those of both ends, and those
/// that hold more of its altitudes than a touched face.
LevelRange levels_of(const GridFrame& frame, const Query& query);

/// Where a path passes a cell of a query's levels: the cell's centre, or the altitude nearest to it
/// that the query allows. It lies in the cell.
Point vertex_of(const GridFrame& frame, const AltitudeRange& altitudes, const Cell& cell);

/// A query on the cells of a scene's grid, which is borrowed.
struct Problem {
  /// Throws as `check_query` does.
  Problem(const Scene& scene, const Query& query, const PenaltyWeights& weights);

  const OccupancyGrid& grid() const { return scene.occupancy; }
  const GridFrame& frame() const { return scene.occupancy.frame(); }
  /// The status that answers it without a search: `OutsideMap`, `GoalBlocked`, `StartBlocked` (in
  /// this order: a blocked goal is a proof even where the start is blocked too).
  std::optional<PlanStatus> refused() const;
  /// Where a path passes a cell that holds neither of its ends.
  Point vertex(const Cell& cell) const { return vertex_of(frame(), altitudes, cell); }
  /// Where a path passes a cell: at its vertex; but its ends are points of their own.
  Point point_of(const Cell& cell) const {
    return cell == start ? query.start : cell == goal ? query.goal : vertex(cell);
  }
  /// Whether all vertices of a level lie at its centre's altitude.
  bool central(int level) const {
    const Point centre = frame().centre(Cell(0, 0, level));
    return centre.z() >= altitudes.lowest && centre.z() <= altitudes.highest;
  }
  /// Whether neighbouring levels' vertices are all as far apart as cells are high.
  bool even() const {
    return levels.count() == 1 || (central(levels.lowest) && central(levels.highest));
  }
  /// Whether the start lies in the goal's cell.
  bool within_a_cell() const { return start == goal; }

  Scene scene;
  Query query;
  PenaltyWeights weights;
  Cell start;
  Cell goal;
  AltitudeRange altitudes;
  LevelRange levels;
  double direct_length;  ///< L_direct [m]
  bool column_priority;  ///< one priority holds for each column: what searches see is true
};

/// The polyline through the vertices of a chain of cells, start ... goal, with its ends moved to
/// the query's; at least two points, also where start and goal are one.
Path path_through(const Problem& problem, const std::vector<Cell>& chain);

/// A plan with another path: that is checked, stored and tallied, and Eq. (5) evaluated. Where
/// start and goal are one the path is that point, twice, whatever is given. The check is an exact
/// walk that shares nothing with the searches: throws `std::logic_error` if the path touches a
/// blocked cell, leaves the window, its levels or its altitudes, or does not lead from start to
/// goal.
Plan accepted(const Problem& problem, Path path, const Plan& plan = {});

/// What a search says of a problem: the best of the paths that it offers, or why there is none.
class Answer {
 public:
  Answer(const Problem& problem, BudgetWatch& watch) : budget(watch), problem_(problem) {}

  /// Takes a path if none was taken yet or its Eq. (5) is smaller; says whether it did. Throws as
  /// `accepted` does.
  bool offer(Path path);
  bool offer(const std::vector<Cell>& chain) { return offer(path_through(problem_, chain)); }
  /// Takes another planner's answer as it stands, and what it did.
  void take_over(Plan plan);
  /// How a search ended that has no (further) path; a path that was taken stays the answer.
  void end(PlanStatus status);
  /// Takes all paths back.
  void withdraw(PlanStatus status);
  /// No path through the vertices has a smaller penalty than this, nor than the best path: what is
  /// proved by now. There must be a path. Nothing: no proof.
  void prove(std::optional<double> bound);

  bool found() const { return plan_.status == PlanStatus::Found; }
  const Plan& plan() const { return plan_; }
  Plan take() { return std::move(plan_); }

  BudgetWatch& budget;
  SearchStats stats;

 private:
  const Problem& problem_;
  Plan plan_;
};

/// Puts the priority on the grid's columns, resolves the query, lets `search` answer it unless it
/// is answered already, and takes the time.
class GridPlanner : public Planner {
 public:
  const PlannerInfo& info() const final { return info_; }
  Plan plan(const Scene& scene, const Query& query, const Budget& budget = {}) final;

 protected:
  /// Throws as `PenaltyWeights::check` does.
  GridPlanner(const PlannerInfo& info, const PenaltyWeights& weights);
  const PenaltyWeights& weights() const { return weights_; }

 private:
  /// Start and goal lie in free cells of the window. Offers paths, counts in `answer.stats`, and
  /// asks `answer.budget` as it goes on. A search that says nothing has found nothing.
  virtual void search(const Problem& problem, Answer& answer) = 0;

  PlannerInfo info_;
  PenaltyWeights weights_;
  ColumnScene seen_;
};

}  // namespace ltp
