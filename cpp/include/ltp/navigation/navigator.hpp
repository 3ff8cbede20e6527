// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Navigator`: what to do next, decided on a map that somebody else keeps.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/navigation/navigation_reason.hpp"
#include "ltp/navigation/obstacle_memory.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

struct NavigationOptions {
  AltitudeBand band{0.0,
                    0.0};  ///< about the altitudes of UAV and waypoint [m]; {0, 0}: planar flight
  double reach_distance =
      0.0;  ///< a waypoint is reached within it, horizontally [m]; 0: one horizontal cell diagonal
  double leave_distance =
      0.0;  ///< farther from its path the UAV has left it [m]; 0: one horizontal cell diagonal
  double escape_distance =
      20.0;  ///< how far to look for a free cell when standing in a blocked one [m]

  std::int64_t max_expansions = 0;  ///< of a plan, see `Budget`; 0: no limit
  double time_limit = 0.0;          ///< of a plan, see `Budget` [s]; 0: no limit

  /// How many windows wide the memory of obstacles is from which proofs are drawn, >= 1; 1 where
  /// obstacles move.
  int memory_widths = 3;

  void check() const;
};

enum class NavigationStatus {
  Finished,   ///< no waypoint is left (or none was given)
  Following,  ///< there is a path to the next waypoint, or towards it where it lies beyond the
              ///< window
  Escaping,   ///< the UAV stands in a blocked cell: the path leads to the nearest free one
  Holding,    ///< no path and no proof: stay, and try again when the map has changed
};

std::string_view to_string(NavigationStatus status);

/// What became of a waypoint.
struct WaypointEvent {
  int index = 0;         ///< of the waypoint, from 0
  bool reached = false;  ///< true: reached; false: dropped
  /// Why it was dropped: `GoalBlocked` or `Unreachable`, nothing else; `Found` if it was reached.
  PlanStatus reason = PlanStatus::Found;
  /// The same as it is told: `GoalBlocked` or `Unreachable`; `None` if it was reached.
  NavigationReason why = NavigationReason::None;
  Point position = Point::Zero();       ///< of the UAV [m]
  Point goal = Point::Zero();           ///< the waypoint [m]
  Point window_origin = Point::Zero();  ///< lowest corner of the map's window [m]
};

using WayPointEvent [[deprecated("WaypointEvent")]] = WaypointEvent;  ///< for one release

/// One answer of the planner.
struct PlanRecord {
  int waypoint = 0;            ///< for which it was asked
  double direct_length = 0.0;  ///< L_direct of the query [m]
  Plan plan;
};

/// The window as it is at a decision. Borrowed for the call, never kept.
struct MapView {
  const OccupancyGrid& occupied;  ///< planning cells with a hit in them
  const OccupancyGrid& blocked;   ///< the same, inflated
  std::int64_t version = 0;       ///< of the map: `ObstacleMap::version`
};

/// Whether a cell that was hit lies on an escape at or beyond an arc length [m]. The cell of the
/// UAV's position counts as free: it is there.
bool hit_on_escape(const OccupancyGrid& occupied, const PathRef& path, double from,
                   const Point& position);

/// Holds the waypoints and the plan. Replans when the path is blocked (an escape, which leads
/// through blocked cells: when a hit lies on it or its end is free no more), when a waypoint is
/// reached or dropped, when the UAV has left its path; never on a clock. Drops a waypoint only on
/// proof: the map has it in a blocked cell, or a flood from it, over all that is remembered and
/// sharing nothing with the planners, ends neither at the UAV nor at the edge of the known.
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

  void set_waypoints(const PathRef& waypoints);
  void set_priority(Raster priority);

  /// Keeps what a window holds for proofs; to be told before the map forgets it.
  void remember(const OccupancyGrid& occupied) { memory_.remember(occupied); }
  /// Forgets what was kept, with a map that was cleared: no proof rests on obstacles that are gone.
  void forget() { memory_.clear(); }

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
  void take_reached(const MapView& map, const Point& position);
  bool must_replan(const MapView& map, const Point& position);
  void replan(const MapView& map, const Point& position, const std::function<bool()>& interrupted);
  bool proved_unreachable(const MapView& map, const Point& position, const Point& goal);
  std::optional<Point> target_inside(const MapView& map, const Point& position,
                                     const LevelRange& levels);
  std::optional<Point> escape_point(const MapView& map, const Point& position) const;
  NavigationReason why_no_path(const MapView& map, const Point& position, const LevelRange& levels,
                               NavigationReason otherwise);
  void follow(NavigationStatus status, const Path& path, const Point& target);
  void hold(NavigationReason reason);
  void finish();
  void give_up_path();

  std::unique_ptr<Planner> planner_;
  NavigationOptions options_;
  Raster priority_;
  Path waypoints_ = Path(0, 3);
  Point leg_begin_ = Point::Zero();  ///< where the leg to the current waypoint began
  int next_ = 0;
  std::vector<WaypointEvent> events_;

  NavigationStatus status_ = NavigationStatus::Finished;
  NavigationReason reason_ = NavigationReason::None;
  Path path_ = Path(0, 3);
  Point target_ =
      Point::Zero();       ///< the end of `path_`: a waypoint, or a stopover on the way to it
  bool stopover_ = false;  ///< whether `target_` is not the waypoint itself
  double progress_ = 0.0;  ///< arc length of `path_` already flown [m]
  Point last_position_ = Point::Zero();  ///< of the UAV, where `progress_` was noted [m]
  std::int64_t path_id_ = 0;
  std::int64_t planned_on_ = kNoVersion;  ///< version of the map that was last planned on
  std::vector<PlanRecord> plans_;
  std::int64_t plans_made_ = 0;
  int plans_for_waypoint_ = 0;
  std::unique_ptr<planning::Flood> flood_;
  ObstacleMemory memory_;
};

}  // namespace ltp
