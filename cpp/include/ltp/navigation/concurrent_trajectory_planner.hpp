// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ConcurrentTrajectoryPlanner`: the loop that flies, mapping on one thread and planning on
// another.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "ltp/mapping/obstacle_map.hpp"
#include "ltp/navigation/navigator.hpp"
#include "ltp/navigation/triple_buffer.hpp"

namespace ltp {

/// What the planning thread decided on one scan's map.
struct Decision {
  std::int64_t scan = 0;  ///< number of the last scan that it knows, from 1; 0: none yet
  NavigationStatus status = NavigationStatus::Holding;
  NavigationReason reason = NavigationReason::Undecided;  ///< why it holds or escapes
  Path path = Path(0, 3);  ///< valid on that map (N, 3) [m]; empty when there is none
  std::int64_t path_id = 0;
  int waypoint_index = 0;
  std::vector<WaypointEvent> events;
  std::vector<PlanRecord> plans;
  std::int64_t plans_made = 0;
  std::int64_t route = 0;    ///< counts the calls of `set_waypoints` that it knows of
  std::int64_t changes = 0;  ///< counts those of `set_priority` and `set_planner`
};

/// A `LocalTrajectoryPlanner` whose scans never wait for a plan. The thread of the sensor inserts a
/// scan, publishes a snapshot of the window and reads the newest decision; the planning thread
/// takes the newest snapshot, decides as a `Navigator` does, and publishes its decision. Both pass
/// through triple buffers: no lock is held while mapping or planning, and a lock only to sleep,
/// to wake and to tell events. A decision holds on the map that it was made on; whether it still
/// does on the newest one, the thread of the sensor checks with every scan (`blocked_at`).
///
/// All but `plan` is for one thread, that of the sensor. Either `start` the planning thread, or
/// call `plan` yourself, from the same thread or another. If each scan is waited for, every
/// decision is that of a `LocalTrajectoryPlanner` which is updated where the scans were made; a
/// map that was loaded or cleared is handed over as a scan's is, and can be waited for alike.
class ConcurrentTrajectoryPlanner {
 public:
  /// As those of `LocalTrajectoryPlanner`.
  ConcurrentTrajectoryPlanner(std::unique_ptr<Planner> planner,
                              const ObstacleMapOptions& map_options,
                              const NavigationOptions& options, Raster priority,
                              const Point& position);
  ~ConcurrentTrajectoryPlanner();

  /// Replaces what is left of the global path, from the next scan on; until then there is no path.
  /// Rows are waypoints, world [m]; may be empty.
  /// @param gates  one row a waypoint, see `GateSizes`; none: those of the options
  void set_waypoints(const PathRef& waypoints, const GateSizesRef& gates = GateSizes(0, 2));
  /// Another priority p_l(x, y), or another planner (not null), from the next scan on; until then
  /// there is no path, or the one flown, see `LocalTrajectoryPlanner`.
  void set_priority(Raster priority, double keep_if_within = 0.0);
  void set_planner(std::unique_ptr<Planner> planner, double keep_if_within = 0.0);

  /// Adds a scan as `LocalTrajectoryPlanner` does and hands the map over; the UAV is where the rays
  /// began [m]. Throws what the planning thread has thrown, if it has.
  InsertStatistics sense(const Pose& sensor, const PointsView& hits, const PointsView& misses);
  InsertStatistics sense(const Point& origin, const PointsView& hits, const PointsView& misses) {
    return sense(Pose{origin}, hits, misses);
  }

  /// As `LocalTrajectoryPlanner` does; the map is handed over at once, with the UAV where it was at
  /// the last scan. Throw what the planning thread has thrown, if it has.
  void load_map(const std::string& path);
  void clear_map();

  /// Takes the newest decision. It stands until the next call.
  const Decision& decision();
  /// What became of waypoints, each told once: also what no decision that was read has told,
  /// because other waypoints were set meanwhile (`WaypointEvent::route` says about which it is).
  std::vector<WaypointEvent> take_events();
  /// The arc length of that decision's path [m] at which the newest map blocks it, ahead of the
  /// UAV; empty if it is free. An escape leads through blocked cells: it is blocked where something
  /// was hit, and at its end if that is free no more.
  std::optional<double> blocked_at();

  /// Decides on the newest snapshot. Whether there was a new one.
  bool plan();

  /// Begins and ends the planning thread; ending it interrupts a long search.
  void start();
  void stop();
  /// Sleeps until the newest map has been decided on, at most so long [s]. Whether it has. Throws
  /// what the planning thread has thrown.
  bool wait(double seconds);

  const Path& waypoints() const { return waypoints_; }
  const ObstacleMap& map() const { return map_; }
  std::int64_t scans() const { return scan_; }  ///< sensed so far

  // The names of version 0.1, for one release.
  [[deprecated("set_waypoints")]] void set_way_points(const PathRef& points) {
    set_waypoints(points);
  }
  [[deprecated("waypoints")]] const Path& way_points() const { return waypoints(); }

 private:
  using SharedGrid = std::shared_ptr<const OccupancyGrid>;

  /// What a planner goes by; null: as the constructor was told. The planner is the planning
  /// thread's alone.
  struct Aims {
    std::int64_t changes = 0;   ///< so many
    std::int64_t given_up = 0;  ///< number of the last one that gave up the path
    double keep_if_within = 0.0;
    std::shared_ptr<const Raster> priority;
    std::shared_ptr<Planner> planner;
  };

  struct Snapshot {
    std::int64_t number;
    std::int64_t scan;
    Point position;
    std::int64_t version;    ///< of the map
    std::int64_t clearings;  ///< of the map
    SharedGrid loaded;       ///< what was blocked anywhere when a map was loaded last
    OccupancyGrid occupied;
    OccupancyGrid blocked;
    std::int64_t route;  ///< number of the waypoints
    Path waypoints;
    GateSizes gates;
    Aims aims;
  };

  void pass_on_failure();
  void hand_over();
  void change(double keep_if_within);
  void nothing_decided();
  void run();
  void take_over(Snapshot& seen);
  void publish(const Snapshot& seen);

  // The sensor's thread.
  ObstacleMap map_;
  std::int64_t scan_ = 0;
  std::int64_t handed_over_ = 0;  ///< number of the newest snapshot
  std::int64_t clearings_ = 0;    ///< of the map
  SharedGrid loaded_;             ///< see `Snapshot`
  Point position_;                ///< of the last scan [m]
  Path waypoints_ = Path(0, 3);
  GateSizes gates_ = GateSizes(0, 2);
  std::int64_t route_ = 0;  ///< number of the waypoints
  Aims aims_;
  /// What there is while the newest decision is about other waypoints, or a path given up.
  Decision none_;
  const Decision* given_ = &none_;
  std::int64_t flown_path_ = 0;  ///< `path_id` of the path that `progress_` is about
  double progress_ = 0.0;        ///< arc length of it already flown [m]

  // The planning thread.
  Navigator navigator_;
  OccupancyGrid known_;  ///< blocked cells of the snapshot decided on last
  std::int64_t known_route_ = 0;
  Aims known_aims_;
  std::int64_t known_clearings_ = 0;
  SharedGrid known_loaded_;

  TripleBuffer<Snapshot> snapshots_;
  TripleBuffer<Decision> decisions_;

  std::mutex mutex_;  ///< of what follows; never held while mapping or planning
  std::condition_variable news_;
  std::int64_t published_ = 0;  ///< number of the newest snapshot
  std::int64_t decided_ = 0;    ///< number of the newest snapshot decided on
  std::vector<WaypointEvent> untaken_;
  std::exception_ptr failure_;
  std::atomic<bool> stopping_{false};
  std::thread thread_;
};

}  // namespace ltp
