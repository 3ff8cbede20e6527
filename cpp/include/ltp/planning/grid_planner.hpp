// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GridPlanner`: what all planners over a grid do alike, so that one is only what differs.
#pragma once

#include <optional>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/planning/altitudes.hpp"
#include "ltp/planning/column_scene.hpp"
#include "ltp/planning/gate_region.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// A query on the cells of a scene's grid, which is borrowed.
struct Problem {
  /// Throws as `check_query` does. Of the waypoints after the goal it keeps, in `query` too, those
  /// before the first one that is blocked or beyond the window.
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
  /// Whether the goal is a region, or there are several.
  bool has_gates() const { return !gates.empty(); }
  /// How many gates a path has passed at a point where it had passed so many before. The last one
  /// is passed in its region or at its very point, the others in their points' cells too.
  std::size_t passed_at(const Point& point, std::size_t passed) const;
  /// Whether all that is asked for has been done at the start.
  bool served() const {
    return has_gates() ? passed_at_start == gates.size() : query.start == query.goal;
  }
  /// Where all paths end that are not served at the start, if that is the cell of the start.
  bool within_a_cell() const {
    if (!has_gates()) return start == goal;
    return served() || (passed_at_start + 1 == gates.size() && start == gates.back().own());
  }
  /// The point of the last waypoint.
  const Point& last_point() const {
    return query.then.empty() ? query.goal : query.then.back().point;
  }

  Scene scene;
  Query query;
  PenaltyWeights weights;
  Cell start;
  Cell goal;
  AltitudeRange altitudes;
  LevelRange levels;
  double direct_length;  ///< L_direct [m]
  double least_length;   ///< no path is shorter [m]
  bool column_priority;  ///< one priority holds for each column: what searches see is true
  /// The regions to be passed, in order; none where the goal is a point and the only one.
  std::vector<GateRegion> gates;
  std::size_t passed_at_start = 0;  ///< of the gates

 private:
  std::size_t usable_gates() const;
  void resolve();
};

/// The polyline through the vertices of a chain of cells, start ... goal, with its ends moved to
/// the query's (in a region only in the cell of the waypoint's point, where all gates are passed at
/// that); at least two points, also where start and goal are one.
Path path_through(const Problem& problem, const std::vector<Cell>& chain);

/// A path as far as the first of its vertices at which it has passed all gates.
Path until_served(const Problem& problem, const PathRef& path);

/// A plan with another path: that is checked, stored and tallied, and Eq. (5) evaluated. Where
/// start and goal are one the path is that point, twice, whatever is given. The check is an exact
/// walk that shares nothing with the searches: throws `std::logic_error` if the path touches a
/// blocked cell, leaves the window, its levels or its altitudes, does not lead from start to goal,
/// or passes not all gates or goes on when it has.
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
/// is answered already, and takes the time. Gates that it has no trait for are refused:
/// `make_gated` serves them all the same.
class GridPlanner : public Planner {
 public:
  const PlannerInfo& info() const final { return info_; }
  const PenaltyWeights& weights() const final { return weights_; }
  Plan plan(const Scene& scene, const Query& query, const Budget& budget = {}) final;

 protected:
  /// Throws as `PenaltyWeights::check` does.
  GridPlanner(const PlannerInfo& info, const PenaltyWeights& weights);

 private:
  /// Start and goal lie in free cells of the window, or no gate is without one. Offers paths,
  /// counts in `answer.stats`, and asks `answer.budget` as it goes on. A search that says nothing
  /// has found nothing. Problems with a region, and with several, come to planners with the traits
  /// `Regions` and `Horizon` only.
  virtual void search(const Problem& problem, Answer& answer) = 0;

  Plan plan_for(const Problem& problem, BudgetWatch& watch, SearchStats& stats);
  void check_traits(const Query& query) const;

  PlannerInfo info_;
  PenaltyWeights weights_;
  ColumnScene seen_;
};

}  // namespace ltp
