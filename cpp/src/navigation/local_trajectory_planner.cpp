// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/local_trajectory_planner.hpp"

#include "ltp/geometry/check.hpp"
#include "ltp/planning/planners.hpp"

namespace ltp {

LocalTrajectoryPlanner::LocalTrajectoryPlanner(std::unique_ptr<Planner> planner,
                                               const ObstacleMapOptions& map_options,
                                               const NavigationOptions& options, Raster priority,
                                               const Point& position)
    : map_(map_options, position),
      navigator_(std::move(planner), options, std::move(priority), map_.occupied().frame(),
                 map_options.clearance(), position) {}

LocalTrajectoryPlanner::LocalTrajectoryPlanner(const ObstacleMapOptions& map_options,
                                               const NavigationOptions& options, Raster priority,
                                               const Point& position)
    : LocalTrajectoryPlanner(make_planner(), map_options, options, std::move(priority), position) {}

InsertStatistics LocalTrajectoryPlanner::sense(const Pose& sensor, const PointsView& hits,
                                               const PointsView& misses) {
  remember_before(sensor.position);
  return map_.sense(sensor, hits, misses);
}

/// What the window will have left, centred on a position, is remembered.
void LocalTrajectoryPlanner::remember_before(const Point& position) {
  if (!position.allFinite()) return;  // which the map refuses
  const bool leaves = !map_.blocked().frame().shift_to_centre(position).isZero();
  if (leaves) navigator_.remember(map_.blocked());
}

void LocalTrajectoryPlanner::load_map(const std::string& path) {
  map_.load(path);
  const auto blocked = map_.blocked_everywhere(ObstacleMemory::kMostCells);
  if (blocked) navigator_.remember_everywhere(*blocked);
}

void LocalTrajectoryPlanner::clear_map() {
  map_.clear();
  navigator_.forget();
}

NavigationStatus LocalTrajectoryPlanner::update(const Point& position,
                                                const std::function<bool()>& interrupted) {
  check::finite("position", position);
  remember_before(position);
  map_.recentre(position);
  return navigator_.update({map_.occupied(), map_.blocked(), map_.version()}, position,
                           interrupted);
}

}  // namespace ltp
