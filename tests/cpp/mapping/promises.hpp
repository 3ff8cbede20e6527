// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What a map must block, told from what it has occupied.
#pragma once

#include "ltp/mapping/obstacle_map.hpp"

namespace ltp::test {

/// Of a map that knows nothing beyond its window.
inline OccupancyGrid to_be_blocked(const ObstacleMap& map) {
  const ObstacleMapOptions& options = map.options();
  OccupancyGrid blocked(map.blocked().frame());
  Inflation(blocked.frame(), options.clearance(), options.inflated_parts())
      .apply(options.inflate_whole_cells ? map.occupied() : map.voxels(), blocked);
  return blocked;
}

}  // namespace ltp::test
