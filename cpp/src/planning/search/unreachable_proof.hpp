// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `UnreachableProof`: a flood that dominates a search the whole window where no path exists.
#pragma once

#include <cstdint>

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/flood.hpp"

namespace ltp::planning {

/// A goal inside of a building, which no ray has touched, counts as free. A search that must prove
/// it unreachable visits all that the other end can reach; a flood from the side that is walled in
/// costs next to nothing, and one from the other side little.
class UnreachableProof {
 public:
  /// Which end a flood begins at: the one that the search comes to last.
  enum class From { Start, Goal };

  /// @param patience  expansions of a search before a flood without a limit, which costs about as
  /// much as they did
  UnreachableProof(From from, std::int64_t patience) : from_(from), patience_(patience) {}

  /// Begins a search.
  void begin() { expanded_ = 0; }
  /// Before it sets out: whether a short look round the goal proves that there is no path.
  bool at_once(const Problem& problem);
  /// To be asked once for each cell that the search expands. Whether there is no path.
  bool after_expansion(const Problem& problem) {
    return ++expanded_ == patience_ && no_path(problem);
  }

 private:
  bool no_path(const Problem& problem);
  bool cut_off(const Problem& problem);

  From from_;
  std::int64_t patience_;
  std::int64_t expanded_ = 0;
  Flood flood_;
};

}  // namespace ltp::planning
