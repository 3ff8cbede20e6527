// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Enclosure`: a quick look whether a cell is walled in, before a search sets out for it.
#pragma once

#include <cstdint>
#include <vector>

#include "ltp/planning/search_space.hpp"

namespace ltp {

/// Goals inside of buildings: what no ray has touched counts as free, so their insides do. A cell
/// from which one sees far along an axis is not looked at any further, so this costs most queries
/// next to nothing.
class Enclosure {
 public:
  /// Whether the free cells round one are few, and another is not among them: a proof that no path
  /// leads from one to the other. False says nothing.
  bool parts(const OccupancyGrid& grid, const Cell& inside, const Cell& outside,
             const LevelRange& levels);

 private:
  struct Node {
    std::uint32_t stamp = 0;
  };

  SearchSpace<Node> space_;
  std::vector<Cell> waiting_;
};

}  // namespace ltp
