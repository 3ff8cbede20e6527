// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Planner`: one interface for every local planner, and the values that go in and come out.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string_view>

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

struct Query {
  Point start = Point::Zero();  ///< world [m]
  Point goal = Point::Zero();   ///< world [m]
  AltitudeBand band = {};       ///< default: open to the whole window
};

enum class PlanStatus {
  Found,
  OutsideMap,    ///< start or goal lies beyond the window
  StartBlocked,  ///< the start lies in a blocked cell
  GoalBlocked,   ///< the goal lies in a blocked cell
  Unreachable,   ///< proved: no free path exists on this grid
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
  /// Throws `std::invalid_argument` for a query that is not finite or has a negative band, and for
  /// a negative limit.
  virtual Plan plan(const Scene& scene, const Query& query, const Budget& budget = {}) = 0;

  std::string_view name() const { return info().name; }
  bool complete() const { return info().has(Trait::Complete); }
};

}  // namespace ltp
