// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Planner`: one interface for every local planner, and the values that go in and come out.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "ltp/cost/penalty.hpp"
#include "ltp/geometry/types.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/planning/budget.hpp"

namespace ltp {

/// What a planner may look at. Borrowed for the call, never kept.
struct Scene {
  const OccupancyGrid& occupancy;
  const Raster& priority;
};

inline constexpr double kOpen = std::numeric_limits<double>::infinity();

/// How far a path may leave the altitudes of start and goal [m], kept to 1e-9 m. {0, 0}: planar.
struct AltitudeBand {
  double below = kOpen;  ///< under the lower of both ends [m], >= 0
  double above = kOpen;  ///< over the higher of both ends [m], >= 0
};

/// A waypoint with the region in which it is served: an upright cylinder about its point.
struct Gate {
  Point point = Point::Zero();  ///< world [m]
  double radius = 0.0;          ///< horizontally [m], >= 0; 0: none but the point (its cell)
  double height = 0.0;          ///< above and below the point [m], >= 0
};

/// From a start to a goal: to the very point, or into the region about it, or through the regions
/// of several waypoints, one after the other (the horizon).
struct Query {
  Point start = Point::Zero();  ///< world [m]
  Point goal = Point::Zero();   ///< world [m]
  AltitudeBand band = {};       ///< default: open to the whole window
  double gate_radius = 0.0;     ///< of the goal's region [m], >= 0; 0: the point itself
  double gate_height = 0.0;     ///< of the goal's region, above and below it [m], >= 0
  std::vector<Gate> then = {};  ///< the waypoints after the goal, to be passed in this order

  /// Whether there is more to it than a start and a goal.
  bool has_gates() const { return gate_radius > 0.0 || !then.empty(); }
};

/// L_direct of Eq. (3) [m]: from the start through the waypoints' points, and as far as the last
/// one's region.
double direct_length(const Query& query);

enum class PlanStatus {
  Found,
  OutsideMap,    ///< start or goal lies beyond the window
  StartBlocked,  ///< the start lies in a blocked cell
  GoalBlocked,   ///< the goal lies in a blocked cell (no cell of its region is free)
  Unreachable,   ///< proved: no free path exists on this grid (to any cell of its region)
  NoneFound,     ///< gave up without proof
  OutOfBudget,   ///< a limit of the budget was reached first
};

std::string_view to_string(PlanStatus status);

struct SearchStats {
  std::int64_t expanded = 0;  ///< cells (or curves) examined
  std::int64_t pushed = 0;    ///< entries that went into the open list
  double seconds = 0.0;       ///< wall time of the call
};

struct Plan {
  PlanStatus status = PlanStatus::NoneFound;
  Path path = Path(0, 3);  ///< start ... goal, world [m]; empty unless Found
  PathTally tally;         ///< length and priority integral of `path`
  /// Where along `path` each waypoint is passed, arc length [m]: one for each that it serves, so
  /// the last is its length. Fewer than were asked for where a later one is blocked, unreachable or
  /// beyond the window. Empty unless Found.
  std::vector<double> passed;
  double penalty =
      std::numeric_limits<double>::infinity();  ///< Eq. (5) on `tally`; inf unless Found
  /// No path through the planner's graph (its vertices) has a smaller penalty, where the planner
  /// can prove one. A refined path is not on that graph and may lie below.
  std::optional<double> bound;
  /// The priority raster was off the grid's columns: the path was planned, and is tallied, over
  /// `onto_columns` of it.
  bool priority_resampled = false;
  SearchStats stats;
};

enum class PlannerFamily {
  Paper,     ///< of the paper's tables
  Ours,      ///< beyond the paper
  Baseline,  ///< of other authors, to compare with
};

std::string_view to_string(PlannerFamily family);

/// What one may rely on; bits of `PlannerInfo::traits`.
struct Trait {
  enum : unsigned {
    Complete = 1,       ///< its `Unreachable` proves that no path exists
    OnGrid = 2,         ///< its paths run through cells' vertices
    Anytime = 4,        ///< out of budget, it answers with the best path so far
    Remembers = 8,      ///< an answer may depend on what was asked before
    UsesPriority = 16,  ///< the priority map shapes its paths
    Bounds = 32,        ///< proves a lower bound of Eq. (5), see `Plan::bound`
    Regions = 64,       ///< its goal is a whole region; others are given one cell of it
    Horizon = 128,      ///< plans several waypoints jointly; others go leg by leg
  };
};

/// What a planner is. Its words must outlive it.
struct PlannerInfo {
  std::string_view name;   ///< by which it is made
  std::string_view title;  ///< as tables print it
  PlannerFamily family = PlannerFamily::Baseline;
  unsigned traits = 0;

  bool has(unsigned trait) const { return (traits & trait) == trait; }
};

/// One planner per thread: it keeps scratch memory between calls.
class Planner {
 public:
  virtual ~Planner() = default;
  virtual const PlannerInfo& info() const = 0;
  /// Of Eq. (5), by which its plans are judged.
  virtual const PenaltyWeights& weights() const = 0;
  /// Throws `std::invalid_argument` for a query that is not finite or has a negative band, radius
  /// or height, and for a negative limit.
  virtual Plan plan(const Scene& scene, const Query& query, const Budget& budget = {}) = 0;

  std::string_view name() const { return info().name; }
  bool complete() const { return info().has(Trait::Complete); }
};

}  // namespace ltp
