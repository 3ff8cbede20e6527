// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/planner.hpp"

namespace ltp {

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
