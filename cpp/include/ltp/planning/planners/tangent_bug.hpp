// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Tangent Bug: straight at the goal, and along the walls where that fails.
#pragma once

#include <memory>

#include "ltp/planning/planner.hpp"

namespace ltp {

struct TangentBugOptions {
  double range = 50.0;  ///< how far it sees [m], >= 0; 0: only what it touches

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

using BugOptions [[deprecated("now TangentBugOptions")]] = TangentBugOptions;

/// Kamon, Rimon, Rivlin, "TangentBug: a range-sensor-based navigation algorithm", Int. J. Robotics
/// Research 17 (1998), on the cells of one level. What the robot senses are the cells that it sees
/// by an exact walk, no farther than `range` away.
///
/// *Motion to the goal*: straight on while the way there is free as far as it sees; else to the
/// corner of an obstacle that it sees, nearer to the goal than itself, by which the way seems
/// shortest. *Boundary following*: where there is none, along the obstacle in the way (the side
/// that seems shorter), cell by cell by the rule of the hand on the wall, cutting across what it
/// sees. It leaves as soon as it sees a cell nearer to the goal than all of the boundary that it
/// has followed (d_reach < d_followed). Once round an obstacle it turns back to the boundary's
/// nearest cell and tries from there; a wall that it has been round and meets again from no nearer
/// ends the search. It always ends: the distances at which walls are left, and at which a wall is
/// followed again, only fall.
///
/// The path lies at the height of the start, with the climb at the goal; where that fails, at the
/// height of the goal with the climb at the start; a free straight line is flown in space. Ignores
/// priority. Not complete in space: failing, it answers `NoneFound`.
std::unique_ptr<Planner> make_tangent_bug(const PlannerInfo& info, const PenaltyWeights& weights,
                                          const TangentBugOptions& options);

}  // namespace ltp
