// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/navigation/navigation_reason.hpp"

#include <array>
#include <cstddef>

namespace ltp {
namespace {

struct Words {
  std::string_view name;
  std::string_view sentence;
};

/// In the order of the enum.
constexpr std::array<Words, 12> kWords{{
    {"none", ""},
    {"undecided", "nothing has been planned yet"},
    {"start_blocked",
     "the UAV stands too near to what was hit and leaves by the nearest free cell"},
    {"start_in_ground",
     "start in the ground's cell: the UAV is less than a free cell above what lies beneath it, and "
     "no free cell is near"},
    {"no_escape", "the UAV stands too near to what was hit, and no free cell can be reached"},
    {"walled_in", "the UAV is walled in by its own map"},
    {"out_of_budget", "the planner's budget ran out before it found a path"},
    {"no_path", "no path was found, and no proof that there is none"},
    {"goal_blocked", "the waypoint lies in a blocked cell of the map"},
    {"unreachable", "the waypoint is proved unreachable: all around it is closed"},
    {"too_far", "the waypoint is too far: the way to it is longer than the largest detour allows"},
    {"all_dropped", "all waypoints were dropped, none was reached"},
}};

const Words& words(NavigationReason reason) { return kWords.at(static_cast<std::size_t>(reason)); }

}  // namespace

std::string_view to_string(NavigationReason reason) { return words(reason).name; }

std::string_view sentence(NavigationReason reason) { return words(reason).sentence; }

}  // namespace ltp
