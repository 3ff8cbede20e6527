// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ltp/cost/penalty.hpp"
#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "navigation/escape.hpp"
#include "navigation/leg.hpp"
#include "navigation/route.hpp"

namespace ltp {
namespace {

double horizontal_diagonal(const GridFrame& frame) { return frame.cell().head<2>().norm(); }

bool same_cell(const GridFrame& frame, const Point& a, const Point& b) {
  return frame.cell_of(a) == frame.cell_of(b);
}

}  // namespace

Navigator::Navigator(std::unique_ptr<Planner> planner, const NavigationOptions& options,
                     Raster priority, const GridFrame& window, double inflation_radius,
                     const Point& position)
    : planner_(std::move(planner)),
      options_(options),
      priority_(std::move(priority)),
      gates_(window, options.gate_radius, options.gate_height,
             options.reach_distance > 0.0 ? options.reach_distance : horizontal_diagonal(window)),
      last_position_(position),
      memory_(window, inflation_radius),
      known_(window),
      route_(std::make_unique<Route>()) {
  if (!planner_) check::fail("planner", "null", "a planner");
  options_.check();
  const double diagonal = horizontal_diagonal(window);
  if (options_.reach_distance == 0.0) options_.reach_distance = diagonal;
  if (options_.leave_distance == 0.0) options_.leave_distance = diagonal;
}

Navigator::Navigator(Navigator&&) noexcept = default;
Navigator::~Navigator() = default;

void Navigator::set_waypoints(const PathRef& waypoints, const GateSizesRef& gates,
                              std::int64_t route) {
  for (Eigen::Index i = 0; i < waypoints.rows(); ++i) {
    check::finite("waypoints[" + std::to_string(i) + "]", Point(waypoints.row(i).transpose()));
  }
  gates_.set(waypoints, gates);
  waypoints_ = waypoints;
  next_ = 0;
  events_.clear();
  events_.reserve(waypoints.rows());
  untaken_.reserve(untaken_.size() + waypoints.rows());
  waypoints_given_ = route > 0 ? route : waypoints_given_ + 1;
  begin_leg();
  planned_on_ = kNoVersion;
  if (finished()) return finish();
  hold(NavigationReason::Undecided);
}

void Navigator::set_priority(Raster priority, double keep_if_within) {
  check::not_negative("keep_if_within", keep_if_within);
  priority_ = std::move(priority);
  reconsider(keep_if_within);
}

void Navigator::set_planner(std::shared_ptr<Planner> planner, double keep_if_within) {
  check::not_negative("keep_if_within", keep_if_within);
  if (!planner) check::fail("planner", "null", "a planner");
  planner_ = std::move(planner);
  reconsider(keep_if_within);
}

void Navigator::reconsider(double keep_if_within) {
  if (keep_if_within == 0.0 || path_.rows() == 0) {
    give_up_path();
    planned_on_ = kNoVersion;
  } else if (status_ == NavigationStatus::Following) {
    margin_ = keep_if_within;
  }
}

std::vector<WaypointEvent> Navigator::take_events() {
  std::vector<WaypointEvent> events = untaken_;
  untaken_.clear();  // its room stays: an update allocates nothing
  return events;
}

NavigationStatus Navigator::update(const MapView& map, const Point& position,
                                   const std::function<bool()>& interrupted) {
  check::finite("position", position);
  way_progress_.fly((position - last_position_).norm());
  take_reached(map, position);
  if (finished()) {
    finish();
  } else if (must_replan(map, position)) {
    replan(map, position, interrupted);
  } else if (margin_) {
    weigh(map, position, interrupted);
  }
  last_position_ = position;
  return status_;
}

/// Forgets what was about the last waypoint.
void Navigator::begin_leg() {
  give_up_path();
  altitudes_.reset();
  way_progress_ = {};
}

/// Notes the end of a waypoint, reached unless there is a reason, and turns to the next one.
void Navigator::retire(const MapView& map, NavigationReason why, const Point& position) {
  const PlanStatus status = why == NavigationReason::GoalBlocked   ? PlanStatus::GoalBlocked
                            : why == NavigationReason::Unreachable ? PlanStatus::Unreachable
                            : why == NavigationReason::TooFar      ? PlanStatus::NoneFound
                                                                   : PlanStatus::Found;
  events_.push_back({next_, why == NavigationReason::None, status, why, position, waypoint(next_),
                     norm(waypoint(next_) - position), map.blocked.frame().origin(),
                     waypoints_given_});
  untaken_.push_back(events_.back());
  ++next_;
  begin_leg();
}

bool Navigator::is_at(const GridFrame& frame, const Point& position, const Point& point) const {
  const Point offset = point - position;
  return offset.head<2>().norm() <= options_.reach_distance &&
         std::abs(offset.z()) <= frame.cell().z();
}

void Navigator::take_reached(const MapView& map, const Point& position) {
  while (!finished() && gates_.served(next_, position)) {
    retire(map, NavigationReason::None, position);
    planned_on_ = kNoVersion;  // whoever held has somewhere else to go
  }
}

bool Navigator::must_replan(const MapView& map, const Point& position) {
  if (path_.rows() == 0) {
    if (status_ != NavigationStatus::Holding || map.version != planned_on_) return true;
    // The same map would give the same answer, but for a way out of a blocked cell: it depends on
    // the cell, and a UAV that holds may still be braking.
    const bool stuck = reason_ == NavigationReason::NoEscape ||
                       reason_ == NavigationReason::StartInGround ||
                       map.blocked.blocked_at(position);
    return stuck && !same_cell(map.blocked.frame(), position, last_position_);
  }
  // No farther than it can have flown: a path that passes by itself is not cut short.
  const double most = 2.0 * (position - last_position_).norm() + options_.leave_distance;
  const ClosestPoint here = closest_point(path_, position, progress_, progress_ + most);
  progress_ = here.arc_length;
  if (here.distance > options_.leave_distance) return true;
  if (progress_ > served_at_ + options_.leave_distance) return true;  // it has missed the gate
  const bool arrived = is_at(map.blocked.frame(), position, target_);
  if ((stopover_ || status_ == NavigationStatus::Escaping) && arrived) return true;
  if (status_ == NavigationStatus::Escaping) {
    // It leads through blocked cells, out of them; all that it must avoid is what was really hit.
    return map.blocked.blocked_at(target_) ||
           hit_on_escape(map.occupied, path_, progress_, position);
  }
  return map.blocked.first_blocked(path_, progress_).has_value();
}

/// Plans to where the path leads, through the same waypoints, and takes that up if it is better by
/// more than the margin.
void Navigator::weigh(const MapView& map, const Point& position,
                      const std::function<bool()>& interrupted) {
  const double margin = *std::exchange(margin_, std::nullopt);
  plans_.clear();
  recall(map);
  Query query = stopover_ ? query_to(position, target_) : through_gates(position);
  if (!stopover_) query.then.resize(std::min(query.then.size(), serves_ - 1));
  const Plan& plan = ask(query, interrupted);
  if (plan.status != PlanStatus::Found || leg::passes(plan) < serves_) return;
  const Penalty penalty(planner_->weights(), direct_length(query));
  const auto judged = [&](const Path& path) {
    const Point end = path.row(path.rows() - 1).transpose();
    return penalty(tally(path, priority_), priority_.at(end.x(), end.y()));
  };
  if (!(judged(plan.path) + margin < judged(leg::rest_of(path_, progress_, position)))) return;
  if (stopover_) {
    follow(NavigationStatus::Following, plan.path);
  } else {
    follow_through(plan);
  }
}

void Navigator::give_up_path() {
  margin_.reset();
  path_.resize(0, 3);
  ++path_id_;
}

NavigationReason Navigator::follow(NavigationStatus status, const Path& path) {
  status_ = status;
  reason_ = status == NavigationStatus::Escaping ? NavigationReason::StartBlocked
                                                 : NavigationReason::None;
  path_ = path;
  target_ = path.row(path.rows() - 1).transpose();
  // For the window at all points of the path: while it is followed nothing is allocated.
  const GridFrame& frame = known_.frame();
  const Point half = 0.5 * (frame.upper() - frame.origin()) + frame.cell();
  memory_.make_room(path.colwise().minCoeff().transpose() - half,
                    path.colwise().maxCoeff().transpose() + half);
  progress_ = 0.0;
  served_at_ = std::numeric_limits<double>::infinity();
  serves_ = 1;
  margin_.reset();
  ++path_id_;
  return NavigationReason::None;
}

/// Follows a plan through the next gates.
NavigationReason Navigator::follow_through(const Plan& plan) {
  follow(NavigationStatus::Following, plan.path);
  served_at_ = leg::to_first_gate(plan);
  serves_ = leg::passes(plan);
  return NavigationReason::None;
}

NavigationReason Navigator::hold(NavigationReason reason) {
  status_ = NavigationStatus::Holding;
  reason_ = reason;
  return NavigationReason::None;
}

void Navigator::finish() {
  status_ = NavigationStatus::Finished;
  const bool none = std::none_of(events_.begin(), events_.end(),
                                 [](const WaypointEvent& event) { return event.reached; });
  reason_ = none && !events_.empty() ? NavigationReason::AllDropped : NavigationReason::None;
}

void Navigator::replan(const MapView& map, const Point& position,
                       const std::function<bool()>& interrupted) {
  give_up_path();
  plans_.clear();
  planned_on_ = map.version;
  last_position_ = position;
  recall(map);
  const MapView known{map.occupied, known_, map.version};
  while (!finished()) {
    const Query query = through_gates(position);
    NavigationReason why = NavigationReason::None;
    if (Gates::blocked(known_, query) || Gates::blocked(memory_.blocked(), query)) {
      why = NavigationReason::GoalBlocked;  // proof: the map itself
    } else if (known_.blocked_at(position)) {
      return escape(known, position);
    } else {
      why = set_out(position, interrupted);
    }
    if (why == NavigationReason::None) return;
    retire(map, why, position);
  }
  finish();
}

/// Puts together what the window shows and what is remembered of it.
void Navigator::recall(const MapView& map) {
  memory_.remember(map.blocked);
  known_ = map.blocked;
  memory_.add_to(known_);
}

/// From a position through the next gates, over the altitudes of the leg, wherever the UAV is by
/// now: with a band about its own, ways would open and close as it climbs and sinks.
Query Navigator::through_gates(const Point& position) {
  Query query = gates_.query(position, next_, options_.horizon, options_.band);
  if (!altitudes_) {
    query.band = options_.band_from(position.z(), leg::highest_waypoint(query));
    altitudes_ = altitudes_of(query);
  }
  return leg::over(*altitudes_, query);
}

/// The same to a point.
Query Navigator::query_to(const Point& position, const Point& goal) {
  if (!altitudes_) through_gates(position);
  return leg::over(*altitudes_, {position, goal});
}

const Plan& Navigator::ask(const Query& query, const std::function<bool()>& interrupted) {
  const Budget budget{options_.max_expansions, options_.time_limit, interrupted};
  plans_.push_back(
      {next_, direct_length(query), planner_->plan({known_, priority_}, query, budget)});
  ++plans_made_;
  return plans_.back().plan;
}

/// Takes up a path towards the waypoint, or holds; or says why the waypoint is to be dropped.
NavigationReason Navigator::set_out(const Point& position,
                                    const std::function<bool()>& interrupted) {
  const GridFrame& frame = known_.frame();
  const Query query = through_gates(position);
  stopover_ = false;
  if (!frame.contains(query.goal)) return take_route(query, nullptr, interrupted);
  const Plan& plan = ask(query, interrupted);
  const bool matters = options_.max_detour > 0.0 || way_progress_.measured_on(memory_.version()) ||
                       plan.status != PlanStatus::Found ||
                       leg::to_first_gate(plan) > leg::out_and_back(frame, query);
  if (matters) return take_route(query, &plan, interrupted);
  return follow_through(plan);
}

/// The same by the shortest way, given the planner's answer if the waypoint lies in the window.
NavigationReason Navigator::take_route(const Query& query, const Plan* inside,
                                       const std::function<bool()>& interrupted) {
  const GridFrame& frame = known_.frame();
  bool sealed = false;
  const PlanStatus status = find_route(query, sealed, interrupted);
  if (sealed) return NavigationReason::Unreachable;
  if (status != PlanStatus::Found) {
    if (status == PlanStatus::Unreachable && memory_.encloses(query)) {
      return hold(NavigationReason::WalledIn);
    }
    return hold(status == PlanStatus::OutOfBudget ? NavigationReason::OutOfBudget
                                                  : NavigationReason::NoPath);
  }
  const double left = route_->length();
  if (options_.max_detour > 0.0 && way_progress_.detour(left) > options_.max_detour) {
    return NavigationReason::TooFar;
  }
  const bool stalled = way_progress_.stalls(left, memory_.version(), frame.cell().minCoeff());
  const bool stays = inside != nullptr && route_->stays_in(frame);
  const bool found = inside != nullptr && inside->status == PlanStatus::Found;
  if (!stalled && found && (stays || leg::to_first_gate(*inside) <= route_->length())) {
    return follow_through(*inside);
  }
  stopover_ = !stays;
  if (stopover_ && !stalled) {
    const Point target = route_->stopover(memory_.blocked(), frame);
    const Plan& plan = ask(query_to(query.start, target), interrupted);
    if (plan.status == PlanStatus::Found) return follow(NavigationStatus::Following, plan.path);
  }
  if (!stalled && found) {  // the longer way, in the window
    stopover_ = false;
    return follow_through(plans_[plans_.size() - 2].plan);
  }
  if (!stalled && !options_.fly_route) {
    const bool spent = plans_.back().plan.status == PlanStatus::OutOfBudget;
    return hold(spent ? NavigationReason::OutOfBudget : NavigationReason::NoPath);
  }
  const Path path = stopover_ ? route_->beginning(frame) : route_->path();
  if (known_.first_blocked(path)) return hold(NavigationReason::NoPath);
  return follow(NavigationStatus::Following, path);
}

/// Looks for the shortest way to the first gate, to that of its free points nearest to the waypoint
/// which is not walled in. What a search has not found, a flood must find closed; `sealed`: it has,
/// for all of them.
PlanStatus Navigator::find_route(const Query& query, bool& sealed,
                                 const std::function<bool()>& interrupted) {
  const Point reach(query.gate_radius, query.gate_radius, query.gate_height);
  memory_.make_room(query.start.cwiseMin(query.goal - reach),
                    query.start.cwiseMax(query.goal + reach));
  std::vector<Point> ends = Gates::free_points(memory_.blocked(), query);
  if (ends.empty()) ends.push_back(query.goal);  // too far away for that
  PlanStatus status = PlanStatus::NoneFound;
  for (const Point& end : ends) {
    const Query to_end = query_to(query.start, end);
    const Point aim = towards(to_end);
    status = route_->find(memory_.blocked(), query_to(query.start, aim), interrupted);
    sealed = status == PlanStatus::Unreachable && aim == end && memory_.seals(to_end);
    if (!sealed) break;
  }
  return status;
}

/// The waypoint, for which there is made room; or a point on the straight line to one that is too
/// far away for that.
Point Navigator::towards(const Query& query) {
  const auto has_room = [&](const Point& point) {
    return memory_.make_room(query.start.cwiseMin(point), query.start.cwiseMax(point));
  };
  if (has_room(query.goal)) return query.goal;
  const Point way = query.goal - query.start;
  const Point step = way * (known_.frame().cell().minCoeff() / norm(way));
  for (int count = ObstacleMemory::kMostCells / 4; count > 0; --count) {
    const Point point = query.start + count * step;
    if (has_room(point) && !memory_.blocked().blocked_at(point)) return point;
  }
  return query.start;
}

void Navigator::escape(const MapView& map, const Point& position) {
  const Query query = query_to(position, waypoint(next_));
  const std::optional<Point> out =
      escape_point(map.occupied, map.blocked, query, options_.escape_distance);
  if (!out) {
    const Point beneath = position - Point(0.0, 0.0, map.blocked.frame().cell().z());
    const bool low = map.occupied.blocked_at(position) || map.occupied.blocked_at(beneath);
    hold(low ? NavigationReason::StartInGround : NavigationReason::NoEscape);
    return;
  }
  Path path(2, 3);
  path << position.transpose(), out->transpose();
  follow(NavigationStatus::Escaping, path);
}

}  // namespace ltp
