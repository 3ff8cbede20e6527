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
                 map_options.clearance(), position),
      known_(map_.blocked()),
      snapshots_({0,
                  0,
                  position,
                  0,
                  0,
                  nullptr,
                  map_.occupied(),
                  map_.blocked(),
                  0,
                  Path(0, 3),
                  GateSizes(0, 2),
                  {}}),
      decisions_({}) {}

ConcurrentTrajectoryPlanner::~ConcurrentTrajectoryPlanner() { stop(); }

void ConcurrentTrajectoryPlanner::set_waypoints(const PathRef& waypoints,
                                                const GateSizesRef& gates) {
  for (Eigen::Index i = 0; i < waypoints.rows(); ++i) {
    check::finite("waypoints[" + std::to_string(i) + "]", Point(waypoints.row(i).transpose()));
  }
  check_gates(gates, waypoints.rows());
  waypoints_ = waypoints;
  gates_ = gates;
  ++route_;
  nothing_decided();
  none_.waypoint_index = 0;
  none_.events.clear();
}

void ConcurrentTrajectoryPlanner::set_priority(Raster priority, double keep_if_within) {
  check::not_negative("keep_if_within", keep_if_within);
  aims_.priority = std::make_shared<const Raster>(std::move(priority));
  change(keep_if_within);
}

void ConcurrentTrajectoryPlanner::set_planner(std::unique_ptr<Planner> planner,
                                              double keep_if_within) {
  check::not_negative("keep_if_within", keep_if_within);
  if (!planner) check::fail("planner", "null", "a planner");
  aims_.planner = std::move(planner);
  change(keep_if_within);
}

void ConcurrentTrajectoryPlanner::change(double keep_if_within) {
  ++aims_.changes;
  aims_.keep_if_within = keep_if_within;
  if (keep_if_within > 0.0) return;
  aims_.given_up = aims_.changes;
  nothing_decided();
}

/// Until there is a decision that knows what was just set. What became of the waypoints stays.
void ConcurrentTrajectoryPlanner::nothing_decided() {
  none_.waypoint_index = given_->waypoint_index;
  none_.events = given_->events;
  none_.plans_made = given_->plans_made;
  none_.route = route_;
  none_.changes = aims_.changes;
  none_.path_id = -(route_ + aims_.changes);  // unlike any other
  given_ = &none_;
}

InsertStatistics ConcurrentTrajectoryPlanner::sense(const Pose& sensor, const PointsView& hits,
                                                    const PointsView& misses) {
  pass_on_failure();
  const InsertStatistics statistics = map_.sense(sensor, hits, misses);
  ++scan_;
  position_ = sensor.position;
  hand_over();
  return statistics;
}

void ConcurrentTrajectoryPlanner::load_map(const std::string& path) {
  pass_on_failure();
  map_.load(path);
  if (auto blocked = map_.blocked_everywhere(ObstacleMemory::kMostCells)) {
    loaded_ = std::make_shared<const OccupancyGrid>(*std::move(blocked));
  }
  hand_over();
}

void ConcurrentTrajectoryPlanner::clear_map() {
  pass_on_failure();
  map_.clear();
  loaded_.reset();
  ++clearings_;
  hand_over();
}

void ConcurrentTrajectoryPlanner::pass_on_failure() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

/// Publishes a snapshot of what the sensor's thread knows.
void ConcurrentTrajectoryPlanner::hand_over() {
  Snapshot& snapshot = snapshots_.back();
  snapshot.number = ++handed_over_;
  snapshot.scan = scan_;
  snapshot.position = position_;
  snapshot.version = map_.version();
  snapshot.clearings = clearings_;
  snapshot.loaded = loaded_;
  snapshot.occupied = map_.occupied();
  snapshot.blocked = map_.blocked();
  if (snapshot.route != route_) {
    snapshot.route = route_;
    snapshot.waypoints = waypoints_;
    snapshot.gates = gates_;
  }
  snapshot.aims = aims_;
  snapshots_.publish();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    published_ = handed_over_;
  }
  news_.notify_all();
}

const Decision& ConcurrentTrajectoryPlanner::decision() {
  decisions_.take();
  const Decision& newest = decisions_.front();
  const bool current = newest.route == route_ && newest.changes >= aims_.given_up;
  given_ = current ? &newest : &none_;
  return *given_;
}

std::vector<WaypointEvent> ConcurrentTrajectoryPlanner::take_events() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::exchange(untaken_, {});
}

std::optional<double> ConcurrentTrajectoryPlanner::blocked_at() {
  const Decision& now = *given_;
  if (now.path.rows() == 0) return std::nullopt;
  if (std::exchange(flown_path_, now.path_id) != now.path_id) progress_ = 0.0;
  progress_ = closest_point(now.path, position_, progress_).arc_length;
  if (now.status != NavigationStatus::Escaping) {
    return map_.blocked().first_blocked(now.path, progress_);
  }
  const OccupancyGrid& occupied = map_.occupied();
  const Cell own = occupied.frame().cell_of(position_);
  if (const auto hit = occupied.first_blocked(now.path, progress_, own)) return hit;
  const Point end = now.path.row(now.path.rows() - 1).transpose();
  if (map_.blocked().blocked_at(end)) return length(now.path);
  return std::nullopt;
}

bool ConcurrentTrajectoryPlanner::plan() {
  if (!snapshots_.take()) return false;
  Snapshot& seen = snapshots_.front();
  take_over(seen);
  navigator_.update({seen.occupied, known_, seen.version}, seen.position,
                    [this] { return stopping_.load(std::memory_order_relaxed); });
  publish(seen);
  return true;
}

/// Tells the navigator what is new in a snapshot.
void ConcurrentTrajectoryPlanner::take_over(Snapshot& seen) {
  if (std::exchange(known_clearings_, seen.clearings) != seen.clearings) {
    navigator_.forget();
  } else if (seen.blocked.frame() != known_.frame()) {
    navigator_.remember(known_);
  }
  if (std::exchange(known_loaded_, seen.loaded) != seen.loaded && seen.loaded) {
    navigator_.remember_everywhere(*seen.loaded);
  }
  std::swap(known_, seen.blocked);  // the slot's next value overwrites all of it
  if (std::exchange(known_route_, seen.route) != seen.route) {
    navigator_.set_waypoints(seen.waypoints, seen.gates, seen.route);
  }
  if (known_aims_.changes == seen.aims.changes) return;
  const Aims old = std::exchange(known_aims_, seen.aims);
  const bool gives_up = seen.aims.given_up > old.changes;
  const double keep = gives_up ? 0.0 : seen.aims.keep_if_within;
  if (seen.aims.planner != old.planner) navigator_.set_planner(seen.aims.planner, keep);
  if (seen.aims.priority != old.priority) navigator_.set_priority(*seen.aims.priority, keep);
}

void ConcurrentTrajectoryPlanner::publish(const Snapshot& seen) {
  Decision& out = decisions_.back();
  out.scan = seen.scan;
  out.status = navigator_.status();
  out.reason = navigator_.reason();
  if (std::exchange(out.path_id, navigator_.path_id()) != navigator_.path_id()) {
    out.path = navigator_.path();
  }
  out.waypoint_index = navigator_.waypoint_index();
  out.events = navigator_.events();
  if (std::exchange(out.plans_made, navigator_.plans_made()) != navigator_.plans_made()) {
    out.plans = navigator_.plans();
  }
  out.route = known_route_;
  out.changes = known_aims_.changes;
  const std::vector<WaypointEvent> fresh = navigator_.take_events();
  decisions_.publish();
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    untaken_.insert(untaken_.end(), fresh.begin(), fresh.end());
    decided_ = seen.number;
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
                 [this] { return decided_ >= handed_over_ || failure_; });
  if (failure_) std::rethrow_exception(failure_);
  return decided_ >= handed_over_;
}

}  // namespace ltp
