// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `LocalTrajectoryPlanner`: the loop that flies. Way-points, scans and poses in; plan and status
// out.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "ltp/grid/raster.hpp"
#include "ltp/mapping/obstacle_map.hpp"
#include "ltp/navigation/obstacle_memory.hpp"
#include "ltp/planning/flood.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

struct NavigationOptions {
  AltitudeBand band{0.0,
                    0.0};  ///< about the altitudes of UAV and way-point [m]; {0, 0}: planar flight
  double reach_distance =
      0.0;  ///< a way-point is reached within it, horizontally [m]; 0: one horizontal cell diagonal
  double leave_distance =
      0.0;  ///< farther from its path the UAV has left it [m]; 0: one horizontal cell diagonal
  double escape_distance =
      20.0;  ///< how far to look for a free cell when standing in a blocked one [m]

  /// How many windows wide the memory of obstacles is from which proofs are drawn, >= 1; 1 where
  /// obstacles move.
  int memory_widths = 3;

  void check() const;
};

enum class NavigationStatus {
  Finished,   ///< no way-point is left (or none was given)
  Following,  ///< there is a path to the next way-point, or towards it where it lies beyond the
              ///< window
  Escaping,   ///< the UAV stands in a blocked cell: the path leads to the nearest free one
  Holding,    ///< no path and no proof: stay, and try again when the map has changed
};

std::string_view to_string(NavigationStatus status);

/// What became of a way-point.
struct WayPointEvent {
  int index = 0;         ///< of the way-point, from 0
  bool reached = false;  ///< true: reached; false: dropped
  /// Why it was dropped: `GoalBlocked` or `Unreachable`, nothing else; `Found` if it was reached.
  PlanStatus reason = PlanStatus::Found;
  Point position = Point::Zero();       ///< of the UAV [m]
  Point goal = Point::Zero();           ///< the way-point [m]
  Point window_origin = Point::Zero();  ///< lowest corner of the map's window [m]
};

/// One answer of the planner.
struct PlanRecord {
  int way_point = 0;           ///< for which it was asked
  double direct_length = 0.0;  ///< L_direct of the query [m]
  Plan plan;
};

/// Holds the map, the way-points and the plan. Replans when the path is blocked, when a way-point
/// is reached or dropped, when the UAV has left its path; never on a clock. Drops a way-point only
/// on proof: the map has it in a blocked cell, or a flood from it, over all that is remembered and
/// sharing nothing with the planners, ends neither at the UAV nor at the edge of the known. No
/// clock, no I/O, and no allocation in `sense` and `update` unless a plan is made.
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

  /// Replaces what is left of the global path. Rows are way-points, world [m]; may be empty.
  void set_way_points(const PathRef& way_points);
  void set_priority(Raster priority);

  /// Adds a scan: where its rays began, where they hit, and (for carving) where those without a
  /// return ended [m].
  InsertStatistics sense(const Point& origin, const PathRef& hits, const PathRef& misses);

  /// Decides what to do at a position [m]. Afterwards `status()`, `path()` and `events()` are up to
  /// date. `interrupted` ends a long search.
  NavigationStatus update(const Point& position,
                          const std::function<bool()>& interrupted = nullptr);

  NavigationStatus status() const { return status_; }
  /// The path to follow, beginning where the UAV was when it was made, shape (N, 3) [m]; empty when
  /// there is none.
  const Path& path() const { return path_; }
  /// Counts the paths taken up and given up: as long as it stands, so does `path()`.
  std::int64_t path_id() const { return path_id_; }
  /// The planner's answers when it was last asked: one, or more where way-points were dropped on
  /// the way.
  const std::vector<PlanRecord>& plans() const { return plans_; }
  std::int64_t plans_made() const { return plans_made_; }  ///< since the beginning
  /// Reached and dropped way-points, in order, since `set_way_points`.
  const std::vector<WayPointEvent>& events() const { return events_; }
  int way_point_index() const {
    return next_;
  }  ///< the way-point flown to; the number of them when finished
  const Path& way_points() const { return way_points_; }
  const ObstacleMap& map() const { return map_; }
  ObstacleMap& map() { return map_; }
  const Planner& planner() const { return *planner_; }
  const Raster& priority() const { return priority_; }

 private:
  bool finished() const { return next_ >= way_points_.rows(); }
  Point way_point(int index) const { return way_points_.row(index).transpose(); }
  void retire(bool reached, PlanStatus reason, const Point& position);
  void take_reached(const Point& position);
  bool must_replan(const Point& position);
  void replan(const Point& position, const std::function<bool()>& interrupted);
  void recentre(const Point& position);
  bool proved_unreachable(const Point& position, const Point& goal);
  std::optional<Point> target_inside(const Point& position, const LevelRange& levels);
  std::optional<Point> escape_point(const Point& position) const;
  void follow(NavigationStatus status, const Path& path, const Point& target);
  void give_up_path();

  std::unique_ptr<Planner> planner_;
  NavigationOptions options_;
  ObstacleMap map_;
  Raster priority_;
  Path way_points_ = Path(0, 3);
  Point leg_begin_ = Point::Zero();  ///< where the leg to the current way-point began
  int next_ = 0;
  std::vector<WayPointEvent> events_;

  NavigationStatus status_ = NavigationStatus::Finished;
  Path path_ = Path(0, 3);
  Point target_ =
      Point::Zero();       ///< the end of `path_`: a way-point, or a stopover on the way to it
  bool stopover_ = false;  ///< whether `target_` is not the way-point itself
  double progress_ = 0.0;  ///< arc length of `path_` already flown [m]
  std::int64_t path_id_ = 0;
  bool map_changed_ = false;  ///< since the last plan
  std::vector<PlanRecord> plans_;
  std::int64_t plans_made_ = 0;
  int plans_for_way_point_ = 0;
  Flood flood_;
  ObstacleMemory memory_;
};

}  // namespace ltp
