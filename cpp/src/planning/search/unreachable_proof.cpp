// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/unreachable_proof.hpp"

namespace ltp::planning {
namespace {

/// Visits to columns of the short look: some 20 us, enough for most buildings.
constexpr std::size_t kVisitsAtOnce = 1024;
/// Who sees so many cells along an axis is hardly inside of a building; spares most questions even
/// the short look.
constexpr int kFar = 32;

bool sees_far(const Problem& problem, const Cell& along) {
  for (int i = 1; i <= kFar; ++i) {
    const Cell cell = problem.goal + i * along;
    if (!problem.frame().contains(cell) || !problem.levels.contains(cell) ||
        problem.grid().blocked(cell)) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool UnreachableProof::at_once(const Problem& problem) {
  constexpr int kFaces = 6;  // the first of the 26 steps
  for (int i = 0; i < kFaces; ++i) {
    if (sees_far(problem, steps()[i].offset())) return false;
  }
  return flood_.parts(problem.grid(), problem.goal, problem.start, problem.levels, kVisitsAtOnce);
}

bool UnreachableProof::no_path(const Problem& problem) {
  const bool from_goal = from_ == From::Goal;
  flood_.fill(problem.grid(), from_goal ? problem.goal : problem.start, problem.levels);
  return !flood_.reached(from_goal ? problem.start : problem.goal);
}

}  // namespace ltp::planning
