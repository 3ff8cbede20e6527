// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Navigator`: what to do next, decided on a map that somebody else keeps.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/navigation/gates.hpp"
#include "ltp/navigation/navigation_options.hpp"
#include "ltp/navigation/navigation_reason.hpp"
#include "ltp/navigation/obstacle_memory.hpp"
#include "ltp/navigation/way_progress.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

class Route;

/// What became of a waypoint.
struct WaypointEvent {
  int index = 0;         ///< of the waypoint, from 0
  bool reached = false;  ///< true: reached; false: dropped
  /// Why it was dropped: `GoalBlocked` or `Unreachable`, on proof, or `NoneFound`: it was skipped.
  /// `Found` if it was reached.
  PlanStatus reason = PlanStatus::Found;
  /// The same as it is told: `GoalBlocked`, `Unreachable` or `TooFar`; `None` if it was reached.
  NavigationReason why = NavigationReason::None;
  Point position = Point::Zero();       ///< of the UAV [m]
  Point goal = Point::Zero();           ///< the waypoint [m]
  double distance = 0.0;                ///< from the UAV to the waypoint's point [m]
  Point window_origin = Point::Zero();  ///< lowest corner of the map's window [m]
  std::int64_t route = 0;  ///< counts the calls of `set_waypoints`: by which it was given, from 1
};

using WayPointEvent [[deprecated("WaypointEvent")]] = WaypointEvent;  ///< for one release

/// One answer of the planner.
struct PlanRecord {
  int waypoint = 0;            ///< for which it was asked
  double direct_length = 0.0;  ///< L_direct of the query [m]; with a horizon of all its legs
  Plan plan;
};

/// The window as it is at a decision. Borrowed for the call, never kept.
struct MapView {
  const OccupancyGrid& occupied;  ///< planning cells with a hit in them
  const OccupancyGrid& blocked;   ///< the same, inflated
  std::int64_t version = 0;       ///< of the map: `ObstacleMap::version`
};

/// Holds the waypoints and the plan. Plans in the window, but with all that is remembered; where
/// the shortest way to the waypoint leaves the window, to a stopover on it. Replans when the path
/// is blocked (an escape, which leads through blocked cells: when a hit lies on it or its end is
/// free no more), when a waypoint or a stopover is reached or a waypoint dropped, when the UAV has
/// left its path, or is asked to reconsider it; never on a clock. Drops a waypoint only on proof:
/// it lies in a blocked cell, or a flood from it, over all that is remembered and sharing nothing
/// with any search, ends neither at the UAV nor at the edge of the known. In a world that stands
/// still every waypoint is reached or dropped after finitely many metres: see docs/method.md.
class Navigator {
 public:
  /// @param planner           not null; owned
  /// @param priority          p_l(x, y), in [0, 1]
  /// @param window            where the map's window begins
  /// @param inflation_radius  as the map's [m]
  /// @param position          of the UAV [m]
  Navigator(std::unique_ptr<Planner> planner, const NavigationOptions& options, Raster priority,
            const GridFrame& window, double inflation_radius, const Point& position);
  Navigator(Navigator&&) noexcept;
  ~Navigator();

  /// @param gates  one row a waypoint, see `GateSizes`; none: those of the options
  /// @param route  number of the call, for those who count themselves; 0: one more than the last
  void set_waypoints(const PathRef& waypoints, const GateSizesRef& gates = GateSizes(0, 2),
                     std::int64_t route = 0);

  /// Another priority p_l(x, y), or another planner (not null): of other weights, say. The path is
  /// given up, as it was made for the old one. With `keep_if_within` > 0 it is kept, unless the
  /// next update plans one to where it leads of which Eq. (5) is smaller by more than that: both
  /// from where the UAV is, by the new priority and weights. An escape stays.
  void set_priority(Raster priority, double keep_if_within = 0.0);
  void set_planner(std::shared_ptr<Planner> planner, double keep_if_within = 0.0);

  /// Keeps what a window has blocked; to be told before the map forgets it.
  void remember(const OccupancyGrid& blocked) { memory_.remember(blocked); }
  /// The same for what an earlier mission has blocked anywhere, on the window's lattice.
  void remember_everywhere(const OccupancyGrid& blocked) { memory_.add(blocked); }
  /// Forgets what was kept, with a map that was cleared: no proof rests on obstacles that are gone.
  void forget() { memory_.clear(); }
  const ObstacleMemory& memory() const { return memory_; }

  /// Decides what to do at a position inside the map's window [m]. `interrupted` ends a long
  /// search. Allocates nothing unless a plan is made.
  NavigationStatus update(const MapView& map, const Point& position,
                          const std::function<bool()>& interrupted = nullptr);

  // What was decided: see `LocalTrajectoryPlanner`.
  NavigationStatus status() const { return status_; }
  NavigationReason reason() const { return reason_; }
  const Path& path() const { return path_; }
  std::int64_t path_id() const { return path_id_; }
  const std::vector<PlanRecord>& plans() const { return plans_; }
  std::int64_t plans_made() const { return plans_made_; }
  const std::vector<WaypointEvent>& events() const { return events_; }
  std::vector<WaypointEvent> take_events();
  int waypoint_index() const { return next_; }
  const Path& waypoints() const { return waypoints_; }
  const Planner& planner() const { return *planner_; }
  const Raster& priority() const { return priority_; }

  // The names of version 0.1, for one release.
  [[deprecated("set_waypoints")]] void set_way_points(const PathRef& points) {
    set_waypoints(points);
  }
  [[deprecated("waypoints")]] const Path& way_points() const { return waypoints(); }
  [[deprecated("waypoint_index")]] int way_point_index() const { return waypoint_index(); }

 private:
  static constexpr std::int64_t kNoVersion = -1;

  bool finished() const { return next_ >= waypoints_.rows(); }
  Point waypoint(int index) const { return waypoints_.row(index).transpose(); }
  void retire(const MapView& map, NavigationReason why, const Point& position);
  void begin_leg();
  bool is_at(const GridFrame& frame, const Point& position, const Point& point) const;
  void take_reached(const MapView& map, const Point& position);
  bool must_replan(const MapView& map, const Point& position);
  void reconsider(double keep_if_within);
  void weigh(const MapView& map, const Point& position, const std::function<bool()>& interrupted);
  void replan(const MapView& map, const Point& position, const std::function<bool()>& interrupted);
  void recall(const MapView& map);
  NavigationReason set_out(const Point& position, const std::function<bool()>& interrupted);
  NavigationReason take_route(const Query& query, const Plan* inside,
                              const std::function<bool()>& interrupted);
  void escape(const MapView& map, const Point& position);
  Query through_gates(const Point& position);
  Query query_to(const Point& position, const Point& goal);
  PlanStatus find_route(const Query& query, bool& sealed, const std::function<bool()>& interrupted);
  Point towards(const Query& query);
  const Plan& ask(const Query& query, const std::function<bool()>& interrupted);
  NavigationReason follow(NavigationStatus status, const Path& path);
  NavigationReason follow_through(const Plan& plan);
  NavigationReason hold(NavigationReason reason);
  void finish();
  void give_up_path();

  std::shared_ptr<Planner> planner_;
  NavigationOptions options_;
  Raster priority_;
  Path waypoints_ = Path(0, 3);
  Gates gates_;
  int next_ = 0;
  std::optional<AltitudeRange> altitudes_;  ///< of the leg, from its first plan on
  std::vector<WaypointEvent> events_;       ///< about these waypoints
  std::vector<WaypointEvent> untaken_;      ///< about all that were ever given
  std::int64_t waypoints_given_ = 0;        ///< number of the last call of `set_waypoints`

  NavigationStatus status_ = NavigationStatus::Finished;
  NavigationReason reason_ = NavigationReason::None;
  Path path_ = Path(0, 3);
  Point target_ =
      Point::Zero();        ///< the end of `path_`: a waypoint, or a stopover on the way to it
  bool stopover_ = false;   ///< whether `target_` is not the waypoint itself
  double progress_ = 0.0;   ///< arc length of `path_` already flown [m]
  double served_at_ = 0.0;  ///< arc length of `path_` at which the next waypoint is served [m]
  std::size_t serves_ = 0;  ///< waypoints that `path_` passes, if its end is no stopover
  std::optional<double> margin_;  ///< by which a path must be better than `path_`, if one is sought
  Point last_position_ = Point::Zero();  ///< of the UAV [m]
  std::int64_t path_id_ = 0;
  std::int64_t planned_on_ = kNoVersion;  ///< version of the map that was last planned on
  std::vector<PlanRecord> plans_;
  std::int64_t plans_made_ = 0;

  ObstacleMemory memory_;
  OccupancyGrid known_;  ///< of the window: what it has blocked, and what is remembered
  std::unique_ptr<Route> route_;
  WayProgress way_progress_;  ///< on the way to the current waypoint
};

}  // namespace ltp
