// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `LocalTrajectoryPlanner`: the loop that flies. Waypoints, scans and poses in; plan and status
// out.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ltp/mapping/obstacle_map.hpp"
#include "ltp/navigation/navigator.hpp"

namespace ltp {

/// Holds the map, and a `Navigator` that decides on it, see there: when it replans, how it finds
/// the way beyond the window, and what proves that a waypoint cannot be reached. No clock, no I/O,
/// and no allocation in `sense` and `update` unless a plan is made.
class LocalTrajectoryPlanner {
 public:
  /// @param planner   not null; owned
  /// @param priority  p_l(x, y), in [0, 1]
  /// @param position  where the map's window begins [m]
  LocalTrajectoryPlanner(std::unique_ptr<Planner> planner, const ObstacleMapOptions& map_options,
                         const NavigationOptions& options, Raster priority, const Point& position);
  /// Flies `auto`.
  LocalTrajectoryPlanner(const ObstacleMapOptions& map_options, const NavigationOptions& options,
                         Raster priority, const Point& position);

  /// Replaces what is left of the global path. Rows are waypoints, world [m]; may be empty.
  /// @param gates  one row a waypoint, see `GateSizes`; none: those of the options
  void set_waypoints(const PathRef& waypoints, const GateSizesRef& gates = GateSizes(0, 2)) {
    navigator_.set_waypoints(waypoints, gates);
  }
  /// Another priority p_l(x, y), or another planner, not null: as `Navigator` does.
  /// @param keep_if_within  0: the path is given up. Else it is kept, unless a new one is better by
  ///                        more than that by Eq. (5), from where the UAV is
  void set_priority(Raster priority, double keep_if_within = 0.0) {
    navigator_.set_priority(std::move(priority), keep_if_within);
  }
  void set_planner(std::unique_ptr<Planner> planner, double keep_if_within = 0.0) {
    navigator_.set_planner(std::move(planner), keep_if_within);
  }

  /// Adds a scan: where its rays began (a pose turns the map's body box), where they hit, and (for
  /// carving) where those without a return ended, world frame [m].
  InsertStatistics sense(const Pose& sensor, const PointsView& hits, const PointsView& misses);
  InsertStatistics sense(const Point& origin, const PointsView& hits, const PointsView& misses) {
    return sense(Pose{origin}, hits, misses);
  }

  /// Adds what a file knows, as `ObstacleMap::load` does and throws. Unless the map forgets, ways
  /// and proofs reckon with what lies beyond the window, too.
  void load_map(const std::string& path);
  /// Forgets all obstacles, those beyond the window too: no proof rests on them any more.
  void clear_map();

  /// Decides what to do at a position [m]. Afterwards `status()`, `path()` and `events()` are up to
  /// date. `interrupted` ends a long search.
  NavigationStatus update(const Point& position,
                          const std::function<bool()>& interrupted = nullptr);

  NavigationStatus status() const { return navigator_.status(); }
  /// Why it holds or escapes, or that all waypoints were dropped; `None` where it does neither.
  NavigationReason reason() const { return navigator_.reason(); }
  /// The path to follow, beginning where the UAV was when it was made, shape (N, 3) [m]; empty when
  /// there is none.
  const Path& path() const { return navigator_.path(); }
  /// Counts the paths taken up and given up: as long as it stands, so does `path()`.
  std::int64_t path_id() const { return navigator_.path_id(); }
  /// The planner's answers when it was last asked: one, or more where waypoints were dropped on
  /// the way.
  const std::vector<PlanRecord>& plans() const { return navigator_.plans(); }
  std::int64_t plans_made() const { return navigator_.plans_made(); }  ///< since the beginning
  /// Reached and dropped waypoints, in order, since `set_waypoints`.
  const std::vector<WaypointEvent>& events() const { return navigator_.events(); }
  /// All that were not taken yet, each once, also of waypoints that were replaced since.
  std::vector<WaypointEvent> take_events() { return navigator_.take_events(); }
  int waypoint_index() const {
    return navigator_.waypoint_index();
  }  ///< the waypoint flown to; the number of them when finished
  const Path& waypoints() const { return navigator_.waypoints(); }
  const ObstacleMap& map() const { return map_; }
  const Planner& planner() const { return navigator_.planner(); }
  const Raster& priority() const { return navigator_.priority(); }

  // The names of version 0.1, for one release.
  [[deprecated("set_waypoints")]] void set_way_points(const PathRef& points) {
    set_waypoints(points);
  }
  [[deprecated("waypoints")]] const Path& way_points() const { return waypoints(); }
  [[deprecated("waypoint_index")]] int way_point_index() const { return waypoint_index(); }

 private:
  void remember_before(const Point& position);

  ObstacleMap map_;
  Navigator navigator_;
};

}  // namespace ltp
