// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `NavigationReason`: why a UAV holds, escapes, or has dropped a waypoint.
#pragma once

#include <string_view>

namespace ltp {

enum class NavigationReason {
  None,           ///< there is a path, or the waypoint was reached
  Undecided,      ///< nothing has been sensed and planned since the waypoints were set
  StartBlocked,   ///< escapes: the UAV stands too near to something that was hit
  StartInGround,  ///< holds: it stands in the ground's cell or on it, and no free cell is near
  NoEscape,       ///< holds: the UAV stands too near to something, and no free cell can be reached
  WalledIn,       ///< holds: what the map holds surrounds the UAV
  OutOfBudget,    ///< holds: the planner's budget ended first
  NoPath,         ///< holds: no path was found, and nothing proves that there is none
  GoalBlocked,    ///< dropped: the waypoint lies in a blocked cell
  Unreachable,    ///< dropped: proved, all around the waypoint is closed
  TooFar,         ///< skipped: the way there is longer than `max_detour` allows
  AllDropped,     ///< finished: every waypoint was dropped
};

/// Its name, as `walled_in`.
std::string_view to_string(NavigationReason reason);

/// What it means, a plain sentence without its full stop; empty for `None`.
std::string_view sentence(NavigationReason reason);

}  // namespace ltp
