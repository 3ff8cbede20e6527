// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planner.hpp"

#include <algorithm>
#include <cmath>

#include "ltp/geometry/norm.hpp"

namespace ltp {
namespace {

/// From a point to the nearest one in a gate [m].
double distance_to(const Gate& gate, const Point& from) {
  const Point offset = gate.point - from;
  const double aside = std::max(0.0, offset.head<2>().norm() - gate.radius);
  const double over = std::max(0.0, std::abs(offset.z()) - gate.height);
  return std::hypot(aside, over);
}

}  // namespace

double direct_length(const Query& query) {
  if (!query.has_gates()) return norm(query.goal - query.start);
  double sum = 0.0;
  Point from = query.start;
  Gate last{query.goal, query.gate_radius, query.gate_height};
  for (const Gate& gate : query.then) {
    sum += norm(last.point - from);
    from = last.point;
    last = gate;
  }
  return sum + distance_to(last, from);
}

std::string_view to_string(PlanStatus status) {
  switch (status) {
    case PlanStatus::Found:
      return "found";
    case PlanStatus::OutsideMap:
      return "outside_map";
    case PlanStatus::StartBlocked:
      return "start_blocked";
    case PlanStatus::GoalBlocked:
      return "goal_blocked";
    case PlanStatus::Unreachable:
      return "unreachable";
    case PlanStatus::NoneFound:
      return "none_found";
    case PlanStatus::OutOfBudget:
      return "out_of_budget";
  }
  return "unknown";
}

std::string_view to_string(PlannerFamily family) {
  switch (family) {
    case PlannerFamily::Paper:
      return "paper";
    case PlannerFamily::Ours:
      return "ours";
    case PlannerFamily::Baseline:
      return "baseline";
  }
  return "unknown";
}

}  // namespace ltp
