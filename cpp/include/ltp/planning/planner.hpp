// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Planner`: one interface for every local planner, and the values that go in and come out.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ltp/cost/penalty.hpp"
#include "ltp/geometry/types.hpp"
#include "ltp/grid/neighbourhood.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"

namespace ltp {

/// What a planner may look at. Borrowed for the call, never kept.
struct Scene {
  const OccupancyGrid& occupancy;
  const Raster& priority;
};

/// How far a path may leave the altitudes between its start and its goal. {0, 0} is planar flight.
struct AltitudeBand {
  double below =
      std::numeric_limits<double>::infinity();  ///< under the lower of both ends [m], >= 0
  double above =
      std::numeric_limits<double>::infinity();  ///< over the higher of both ends [m], >= 0
};

struct Query {
  Point start = Point::Zero();  ///< world [m]
  Point goal = Point::Zero();   ///< world [m]
  AltitudeBand band;            ///< default: open to the whole window
  /// Asked now and then during a long search; `true` ends it with `OutOfBudget`.
  std::function<bool()> interrupted = nullptr;
};

enum class PlanStatus {
  Found,
  OutsideMap,    ///< start or goal lies beyond the window
  StartBlocked,  ///< the start lies in a blocked cell
  GoalBlocked,   ///< the goal lies in a blocked cell
  Unreachable,   ///< proved: no free path exists on this grid
  NoneFound,     ///< gave up without proof
  OutOfBudget,   ///< the caller's limit was reached first
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
  /// No path through the planner's graph (cell centres) has a smaller penalty, where the planner
  /// can prove one. A refined path is not on that graph and may lie below.
  std::optional<double> bound;
  SearchStats stats;
};

/// One planner per thread: it keeps scratch memory between calls.
class Planner {
 public:
  virtual ~Planner() = default;
  virtual std::string_view name() const = 0;
  /// Whether its failure proves that no path exists.
  virtual bool complete() const = 0;
  /// Throws `std::invalid_argument` for a query that is not finite or has a negative band.
  virtual Plan plan(const Scene& scene, const Query& query) = 0;
};

/// The levels that a query's band leaves open, clipped to the frame.
LevelRange levels_of(const GridFrame& frame, const Query& query);

/// Bezier's search, see `BezierPlanner`.
struct BezierOptions {
  int offsets = 41;      ///< M, offsets tried for each of the two control points, odd and >= 1
  double reach = 60.0;   ///< largest sideways offset [m], > 0
  int z_offsets = 1;     ///< offsets tried in height for both control points together, odd and >= 1
  double z_reach = 0.0;  ///< largest offset in height [m], >= 0
  int segments = 64;     ///< straight pieces that the curve is flown in, 2 to 100000
};

/// The linearised searches, see `LinearisedPlanner`.
struct LinearisedOptions {
  double alpha = 0.0;       ///< of the first search; 0: from the weights
  double tolerance = 0.01;  ///< of Eq. (5): `sweep` stops when path and bound are this close, >= 0
  int searches = 12;        ///< that `sweep` makes at most, >= 1
  std::int64_t effort = 0;  ///< expansions that `sweep` may spend after its first path; 0: no limit
  /// Labels and cells that `sweep` may spend on closing the gap that is left, >= 0.
  std::int64_t closing = 200000;
};

/// The exact search, see `ParetoPlanner`.
struct ParetoOptions {
  double memory = 512.0;  ///< for its labels; more is `OutOfBudget` [MB], > 0
  double eps = 0.0;       ///< Eq. (5) + W_P p_max may be this part above its optimum, >= 0
};

/// riskA*, see `RiskAStarPlanner`.
struct RiskOptions {
  double length_factor = 0.1;  ///< what a metre costs beside its risk (0 to 1 a metre), > 0
};

/// ARA*, see `AraStarPlanner`.
struct AraOptions {
  double first_weight = 3.0;  ///< of the heuristic in the first round, 1 to 100
  double step = 0.5;          ///< by which it falls from round to round, to 1; >= 0.01
};

/// Tangent Bug, see `BugPlanner`.
struct BugOptions {
  double range = 50.0;  ///< how far it sees [m], >= 0; 0: only what it touches
};

/// The optimised Hermite curve, see `HermitePlanner`.
struct HermiteOptions {
  int segments = 64;    ///< straight pieces that the curve is flown in, 2 to 100000
  int starts = 5;       ///< sideways tangents tried at each end to begin with, odd and >= 1
  double reach = 3.0;   ///< the largest of them, in direct lengths, over 0, at most 1000
  int refined = 4;      ///< the best so many of those curves are optimised, >= 1
  int iterations = 24;  ///< rounds of the optimisation of each, >= 0
};

/// What every planner can be told. A planner ignores what does not concern it.
struct PlannerOptions {
  PenaltyWeights weights;
  std::int64_t max_expansions = 0;  ///< give up (`OutOfBudget`) after so many; 0: no limit
  /// Eq. (9) as printed lacks the factor W_L, so that its heuristic weighs 1 / W_L too much. True
  /// scales it.
  bool scaled_heuristic = false;
  /// Frees the path from the grid's directions, see `Refiner`: never a larger penalty.
  bool refine = false;
  BezierOptions bezier;
  LinearisedOptions linearised;
  ParetoOptions pareto;
  AraOptions ara;
  RiskOptions risk;
  BugOptions bug;
  HermiteOptions hermite;

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// The planners' names, in the order of the paper's tables.
const std::vector<std::string_view>& planner_names();

/// Makes a planner by its name; `auto` is what a UAV should fly. Throws `std::invalid_argument` for
/// an unknown one, listing those known.
std::unique_ptr<Planner> make_planner(std::string_view name = "auto",
                                      const PlannerOptions& options = {});

}  // namespace ltp
