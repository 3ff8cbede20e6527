// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/navigator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"
#include "ltp/geometry/polyline.hpp"
#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp {
namespace {

/// A waypoint that takes so many plans may lie in a block larger than the window; then it is time
/// for a proof.
constexpr int kPlansBeforeProof = 5;

double horizontal_diagonal(const GridFrame& frame) { return frame.cell().head<2>().norm(); }

bool same_cell(const GridFrame& frame, const Point& a, const Point& b) {
  return frame.cell_of(a) == frame.cell_of(b);
}

}  // namespace

void NavigationOptions::check() const {
  if (!(band.below >= 0.0)) check::fail("band.below", band.below, "a number >= 0");
  if (!(band.above >= 0.0)) check::fail("band.above", band.above, "a number >= 0");
  check::not_negative("reach_distance", reach_distance);
  check::not_negative("leave_distance", leave_distance);
  check::positive("escape_distance", escape_distance);
  check::at_least("memory_widths", memory_widths, 1);
  Budget{max_expansions, time_limit}.check();
}

bool hit_on_escape(const OccupancyGrid& occupied, const PathRef& path, double from,
                   const Point& position) {
  return occupied.first_blocked(path, from, occupied.frame().cell_of(position)).has_value();
}

std::string_view to_string(NavigationStatus status) {
  switch (status) {
    case NavigationStatus::Finished:
      return "finished";
    case NavigationStatus::Following:
      return "following";
    case NavigationStatus::Escaping:
      return "escaping";
    case NavigationStatus::Holding:
      return "holding";
  }
  return "unknown";
}

Navigator::Navigator(std::unique_ptr<Planner> planner, const NavigationOptions& options,
                     Raster priority, const GridFrame& window, double inflation_radius,
                     const Point& position)
    : planner_(std::move(planner)),
      options_(options),
      priority_(std::move(priority)),
      leg_begin_(position),
      flood_(std::make_unique<planning::Flood>()),
      memory_(window, options.memory_widths, inflation_radius) {
  if (!planner_) check::fail("planner", "null", "a planner");
  options_.check();
  const double diagonal = horizontal_diagonal(window);
  if (options_.reach_distance == 0.0) options_.reach_distance = diagonal;
  if (options_.leave_distance == 0.0) options_.leave_distance = diagonal;
}

Navigator::Navigator(Navigator&&) noexcept = default;
Navigator::~Navigator() = default;

void Navigator::set_waypoints(const PathRef& waypoints) {
  for (Eigen::Index i = 0; i < waypoints.rows(); ++i) {
    check::finite("waypoints[" + std::to_string(i) + "]", Point(waypoints.row(i).transpose()));
  }
  waypoints_ = waypoints;
  next_ = 0;
  events_.clear();
  events_.reserve(waypoints.rows());
  give_up_path();
  planned_on_ = kNoVersion;
  if (finished()) return finish();
  hold(NavigationReason::Undecided);
}

void Navigator::set_priority(Raster priority) {
  priority_ = std::move(priority);
  give_up_path();  // it was made for the old one
  planned_on_ = kNoVersion;
}

NavigationStatus Navigator::update(const MapView& map, const Point& position,
                                   const std::function<bool()>& interrupted) {
  check::finite("position", position);
  take_reached(map, position);
  if (finished()) {
    finish();
  } else if (must_replan(map, position)) {
    replan(map, position, interrupted);
  }
  return status_;
}

/// Notes the end of a waypoint, reached unless there is a reason, and turns to the next one.
void Navigator::retire(const MapView& map, NavigationReason why, const Point& position) {
  const PlanStatus status = why == NavigationReason::GoalBlocked   ? PlanStatus::GoalBlocked
                            : why == NavigationReason::Unreachable ? PlanStatus::Unreachable
                                                                   : PlanStatus::Found;
  events_.push_back({next_, why == NavigationReason::None, status, why, position, waypoint(next_),
                     map.blocked.frame().origin()});
  leg_begin_ = waypoint(next_);
  ++next_;
  plans_for_waypoint_ = 0;
  give_up_path();
}

void Navigator::take_reached(const MapView& map, const Point& position) {
  const double height = map.blocked.frame().cell().z();
  while (!finished()) {
    const Point offset = waypoint(next_) - position;
    const bool reached =
        offset.head<2>().norm() <= options_.reach_distance && std::abs(offset.z()) <= height;
    if (!reached) return;
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
  last_position_ = position;
  if (here.distance > options_.leave_distance) return true;
  const bool arrived = (target_ - position).head<2>().norm() <= options_.reach_distance;
  if ((stopover_ || status_ == NavigationStatus::Escaping) && arrived) return true;
  if (status_ == NavigationStatus::Escaping) {
    // It leads through blocked cells, out of them; all that it must avoid is what was really hit.
    return map.blocked.blocked_at(target_) ||
           hit_on_escape(map.occupied, path_, progress_, position);
  }
  return map.blocked.first_blocked(path_, progress_).has_value();
}

void Navigator::give_up_path() {
  path_.resize(0, 3);
  ++path_id_;
}

void Navigator::follow(NavigationStatus status, const Path& path, const Point& target) {
  status_ = status;
  reason_ = status == NavigationStatus::Escaping ? NavigationReason::StartBlocked
                                                 : NavigationReason::None;
  path_ = path;
  last_position_ = path.row(0).transpose();
  target_ = target;
  progress_ = 0.0;
  ++path_id_;
}

void Navigator::hold(NavigationReason reason) {
  status_ = NavigationStatus::Holding;
  reason_ = reason;
}

void Navigator::finish() {
  status_ = NavigationStatus::Finished;
  const bool none = std::none_of(events_.begin(), events_.end(),
                                 [](const WaypointEvent& event) { return event.reached; });
  reason_ = none && !events_.empty() ? NavigationReason::AllDropped : NavigationReason::None;
}

void Navigator::replan(const MapView& map, const Point& position,
                       const std::function<bool()>& interrupted) {
  const GridFrame& frame = map.blocked.frame();
  give_up_path();
  plans_.clear();
  planned_on_ = map.version;
  last_position_ = position;
  while (!finished()) {
    const Point goal = waypoint(next_);
    if (map.blocked.blocked_at(goal) && !same_cell(frame, goal, position)) {
      retire(map, NavigationReason::GoalBlocked, position);  // proof: the map itself
      continue;
    }
    if (map.blocked.blocked_at(position)) {
      const std::optional<Point> out = escape_point(map, position);
      if (!out) {
        const Point beneath = position - Point(0.0, 0.0, frame.cell().z());
        const bool low = map.occupied.blocked_at(position) || map.occupied.blocked_at(beneath);
        return hold(low ? NavigationReason::StartInGround : NavigationReason::NoEscape);
      }
      Path path(2, 3);
      path << position.transpose(), out->transpose();
      return follow(NavigationStatus::Escaping, path, *out);
    }

    const Budget budget{options_.max_expansions, options_.time_limit, interrupted};
    Query query{position, goal, options_.band};
    stopover_ = !frame.contains(goal);
    const LevelRange levels = levels_of(frame, query);
    if (stopover_) {
      const std::optional<Point> target = target_inside(map, position, levels);
      if (!target) return hold(why_no_path(map, position, levels, NavigationReason::NoStopover));
      query.goal = *target;
    }
    const bool overdue = plans_for_waypoint_ > 0 && plans_for_waypoint_ % kPlansBeforeProof == 0;
    ++plans_for_waypoint_;
    if (overdue && !stopover_ && proved_unreachable(map, position, goal)) {
      retire(map, NavigationReason::Unreachable, position);
      continue;
    }
    plans_.push_back({next_, norm(query.goal - query.start),
                      planner_->plan({map.blocked, priority_}, query, budget)});
    ++plans_made_;
    const Plan& plan = plans_.back().plan;
    if (plan.status == PlanStatus::Found) {
      return follow(NavigationStatus::Following, plan.path, query.goal);
    }
    const bool claimed = plan.status == PlanStatus::Unreachable && planner_->complete();
    if (stopover_ || !claimed || !proved_unreachable(map, position, goal)) {
      return hold(why_no_path(map, position, levels,
                              plan.status == PlanStatus::OutOfBudget ? NavigationReason::OutOfBudget
                                                                     : NavigationReason::NoPath));
    }
    retire(map, NavigationReason::Unreachable, position);
  }
  finish();
}

/// Why the UAV holds: it is walled in, or else what the planner said.
NavigationReason Navigator::why_no_path(const MapView& map, const Point& position,
                                        const LevelRange& levels, NavigationReason otherwise) {
  flood_->fill(map.blocked, map.blocked.frame().cell_of(position), levels);
  return flood_->touched_edge() ? otherwise : NavigationReason::WalledIn;
}

bool Navigator::proved_unreachable(const MapView& map, const Point& position, const Point& goal) {
  memory_.remember(map.occupied);
  return memory_.seals({position, goal, options_.band});
}

/// The last point of the leg to the waypoint that lies inside the window and can be reached.
std::optional<Point> Navigator::target_inside(const MapView& map, const Point& position,
                                              const LevelRange& levels) {
  const GridFrame& frame = map.blocked.frame();
  flood_->fill(map.blocked, frame.cell_of(position), levels);
  const Point goal = waypoint(next_);
  for (const Point& begin : {leg_begin_, position}) {
    const Point leg = goal - begin;
    const int count = static_cast<int>(std::ceil(leg.norm() / frame.cell().minCoeff()));
    for (int i = count - 1; i > 0; --i) {
      const Point candidate = begin + leg * (static_cast<double>(i) / count);
      if (same_cell(frame, candidate, position)) continue;
      if (flood_->reached(frame.cell_of(candidate))) return candidate;
    }
  }
  return std::nullopt;
}

/// The vertex of the nearest free cell to which the straight way touches nothing that was hit.
std::optional<Point> Navigator::escape_point(const MapView& map, const Point& position) const {
  const OccupancyGrid& blocked = map.blocked;
  const GridFrame& frame = blocked.frame();
  const Cell own = frame.cell_of(position);
  const Query query{position, waypoint(next_), options_.band};
  const LevelRange levels = levels_of(frame, query);
  const Cell reach = (Point::Constant(options_.escape_distance).cwiseQuotient(frame.cell()))
                         .array()
                         .ceil()
                         .matrix()
                         .cast<int>();
  std::optional<Point> nearest;
  double distance = options_.escape_distance;
  Path way(2, 3);
  way.row(0) = position.transpose();
  for (int dx = -reach.x(); dx <= reach.x(); ++dx) {
    for (int dy = -reach.y(); dy <= reach.y(); ++dy) {
      for (int level = levels.lowest; level <= levels.highest; ++level) {
        const Cell cell(own.x() + dx, own.y() + dy, level);
        if (!frame.contains(cell) || blocked.blocked(cell)) continue;
        const Point centre = vertex_of(frame, altitudes_of(query), cell);
        if ((centre - position).norm() >= distance) continue;
        way.row(1) = centre.transpose();
        if (hit_on_escape(map.occupied, way, 0.0, position)) continue;
        distance = (centre - position).norm();
        nearest = centre;
      }
    }
  }
  return nearest;
}

}  // namespace ltp
