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
  if (problem.has_gates()) return false;  // a region is seldom walled in as a whole
  constexpr int kFaces = 6;               // the first of the 26 steps
  for (int i = 0; i < kFaces; ++i) {
    if (sees_far(problem, steps()[i].offset())) return false;
  }
  return flood_.parts(problem.grid(), problem.goal, problem.start, problem.levels, kVisitsAtOnce);
}

bool UnreachableProof::no_path(const Problem& problem) {
  if (problem.has_gates()) return cut_off(problem);
  const bool from_goal = from_ == From::Goal;
  flood_.fill(problem.grid(), from_goal ? problem.goal : problem.start, problem.levels);
  return !flood_.reached(from_goal ? problem.start : problem.goal);
}

/// Whether there is a gate of which the start reaches no cell.
bool UnreachableProof::cut_off(const Problem& problem) {
  flood_.fill(problem.grid(), problem.start, problem.levels);
  for (std::size_t i = problem.passed_at_start; i < problem.gates.size(); ++i) {
    bool reached = false;
    problem.gates[i].for_each([&](const Cell& c) { reached = reached || flood_.reached(c); });
    if (!reached) return true;
  }
  return false;
}

}  // namespace ltp::planning
