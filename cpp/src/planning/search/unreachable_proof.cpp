// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/unreachable_proof.hpp"

namespace ltp::planning {
namespace {

/// Visits to columns of the short look: some 20 us, enough for most buildings.
constexpr std::size_t kVisitsAtOnce = 1024;

}  // namespace

bool UnreachableProof::at_once(const Problem& problem) {
  return flood_.parts(problem.grid(), problem.goal, problem.start, problem.levels, kVisitsAtOnce);
}

bool UnreachableProof::no_path(const Problem& problem) {
  const bool from_goal = from_ == From::Goal;
  flood_.fill(problem.grid(), from_goal ? problem.goal : problem.start, problem.levels);
  return !flood_.reached(from_goal ? problem.start : problem.goal);
}

}  // namespace ltp::planning
