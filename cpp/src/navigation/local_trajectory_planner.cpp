// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/local_trajectory_planner.hpp"

#include "ltp/geometry/check.hpp"

namespace ltp {

LocalTrajectoryPlanner::LocalTrajectoryPlanner(std::unique_ptr<Planner> planner,
                                               const ObstacleMapOptions& map_options,
                                               const NavigationOptions& options, Raster priority,
                                               const Point& position)
    : map_(map_options, position),
      navigator_(std::move(planner), options, std::move(priority), map_.occupied().frame(),
                 map_options.inflation_radius, position) {}

LocalTrajectoryPlanner::LocalTrajectoryPlanner(const ObstacleMapOptions& map_options,
                                               const NavigationOptions& options, Raster priority,
                                               const Point& position)
    : LocalTrajectoryPlanner(make_planner(), map_options, options, std::move(priority), position) {}

InsertStatistics LocalTrajectoryPlanner::sense(const Point& origin, const PathRef& hits,
                                               const PathRef& misses) {
  recentre(origin);
  const InsertStatistics statistics = map_.insert(origin, hits, misses);
  if (statistics.new_cells > 0 || statistics.erased_cells > 0) ++version_;
  return statistics;
}

NavigationStatus LocalTrajectoryPlanner::update(const Point& position,
                                                const std::function<bool()>& interrupted) {
  check::finite("position", position);
  recentre(position);
  return navigator_.update({map_.occupied(), map_.blocked(), version_}, position, interrupted);
}

void LocalTrajectoryPlanner::recentre(const Point& position) {
  if (map_.occupied().frame().shift_to_centre(position) == Cell::Zero()) return;
  navigator_.remember(map_.occupied());  // before it is forgotten
  map_.recentre(position);
}

}  // namespace ltp
