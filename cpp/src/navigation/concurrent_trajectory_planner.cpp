// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/concurrent_trajectory_planner.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/polyline.hpp"

namespace ltp {

ConcurrentTrajectoryPlanner::ConcurrentTrajectoryPlanner(std::unique_ptr<Planner> planner,
                                                         const ObstacleMapOptions& map_options,
                                                         const NavigationOptions& options,
                                                         Raster priority, const Point& position)
    : map_(map_options, position),
      position_(position),
      navigator_(std::move(planner), options, std::move(priority), map_.occupied().frame(),
                 map_options.inflation_radius, position),
      known_(map_.occupied()),
      snapshots_({0, position, 0, map_.occupied(), map_.blocked(), 0, Path(0, 3)}),
      decisions_({}) {}

ConcurrentTrajectoryPlanner::~ConcurrentTrajectoryPlanner() { stop(); }

void ConcurrentTrajectoryPlanner::set_waypoints(const PathRef& waypoints) {
  for (Eigen::Index i = 0; i < waypoints.rows(); ++i) {
    check::finite("waypoints[" + std::to_string(i) + "]", Point(waypoints.row(i).transpose()));
  }
  waypoints_ = waypoints;
  none_.route = ++route_;
  none_.path_id = -route_;  // unlike any other
  none_.plans_made = given_->plans_made;
  given_ = &none_;
}

InsertStatistics ConcurrentTrajectoryPlanner::sense(const Point& origin, const PathRef& hits,
                                                    const PathRef& misses) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (failure_) std::rethrow_exception(failure_);
  }
  map_.recentre(origin);
  const InsertStatistics statistics = map_.insert(origin, hits, misses);
  if (statistics.new_cells > 0 || statistics.erased_cells > 0) ++version_;

  Snapshot& snapshot = snapshots_.back();
  snapshot.scan = ++scan_;
  snapshot.position = position_ = origin;
  snapshot.version = version_;
  snapshot.occupied = map_.occupied();
  snapshot.blocked = map_.blocked();
  if (snapshot.route != route_) {
    snapshot.route = route_;
    snapshot.waypoints = waypoints_;
  }
  snapshots_.publish();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    published_ = scan_;
  }
  news_.notify_all();
  return statistics;
}

const Decision& ConcurrentTrajectoryPlanner::decision() {
  decisions_.take();
  const Decision& newest = decisions_.front();
  given_ = newest.route == route_ ? &newest : &none_;
  return *given_;
}

std::optional<double> ConcurrentTrajectoryPlanner::blocked_at() {
  const Decision& now = *given_;
  if (now.path.rows() == 0 || now.status == NavigationStatus::Escaping) return std::nullopt;
  if (std::exchange(flown_path_, now.path_id) != now.path_id) progress_ = 0.0;
  progress_ = closest_point(now.path, position_, progress_).arc_length;
  return map_.blocked().first_blocked(now.path, progress_);
}

bool ConcurrentTrajectoryPlanner::plan() {
  if (!snapshots_.take()) return false;
  Snapshot& seen = snapshots_.front();
  if (seen.occupied.frame() != known_.frame()) navigator_.remember(known_);
  std::swap(known_, seen.occupied);  // the slot's next value overwrites all of it
  if (std::exchange(known_route_, seen.route) != seen.route) {
    navigator_.set_waypoints(seen.waypoints);
  }
  navigator_.update({known_, seen.blocked, seen.version}, seen.position,
                    [this] { return stopping_.load(std::memory_order_relaxed); });
  publish(seen.scan);
  return true;
}

void ConcurrentTrajectoryPlanner::publish(std::int64_t scan) {
  Decision& out = decisions_.back();
  out.scan = scan;
  out.status = navigator_.status();
  if (std::exchange(out.path_id, navigator_.path_id()) != navigator_.path_id()) {
    out.path = navigator_.path();
  }
  out.waypoint_index = navigator_.waypoint_index();
  out.events = navigator_.events();
  if (std::exchange(out.plans_made, navigator_.plans_made()) != navigator_.plans_made()) {
    out.plans = navigator_.plans();
  }
  out.route = known_route_;
  decisions_.publish();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    decided_ = scan;
  }
  news_.notify_all();
}

void ConcurrentTrajectoryPlanner::start() {
  if (thread_.joinable()) return;
  stopping_ = false;
  thread_ = std::thread([this] { run(); });
}

void ConcurrentTrajectoryPlanner::stop() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  news_.notify_all();
  thread_.join();
}

void ConcurrentTrajectoryPlanner::run() {
  std::unique_lock<std::mutex> lock(mutex_);
  while (true) {
    news_.wait(lock, [this] { return stopping_ || published_ > decided_; });
    if (stopping_) return;
    lock.unlock();
    try {
      plan();
    } catch (...) {
      lock.lock();
      failure_ = std::current_exception();
      news_.notify_all();
      return;
    }
    lock.lock();
  }
}

bool ConcurrentTrajectoryPlanner::wait(double seconds) {
  std::unique_lock<std::mutex> lock(mutex_);
  news_.wait_for(lock, std::chrono::duration<double>(std::min(seconds, 1e6)),
                 [this] { return decided_ >= scan_ || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  return decided_ >= scan_;
}

}  // namespace ltp
