// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `InsertStatistics`: what became of the points of a scan, or of many, and what is odd about it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ltp/mapping/obstacle_map_options.hpp"

namespace ltp {

/// Each hit is counted once: `marked`, `too_near`, `in_body`, `outside`, `out_of_range` or
/// `invalid`.
struct InsertStatistics {
  std::int64_t marked = 0;    ///< hits that fell into the window
  std::int64_t too_near = 0;  ///< hits nearer than the blind distance: ignored
  std::int64_t in_body = 0;   ///< hits in the body box: ignored
  /// Hits beyond the window: kept for when it comes there, if the map remembers and does not carve.
  std::int64_t outside = 0;
  /// Hits at or beyond the map's maximum range: treated as misses. Many of them, and the sensor
  /// sees farther than the map was told.
  std::int64_t out_of_range = 0;
  std::int64_t invalid = 0;       ///< hits or misses that are not finite: ignored
  std::int64_t new_cells = 0;     ///< planning cells that became occupied
  std::int64_t erased_cells = 0;  ///< planning cells that became free by carving

  InsertStatistics& operator+=(const InsertStatistics& other);

  /// A sentence for each way in which a map of these options loses more hits than it should: to its
  /// maximum range, to the edges of its window (0.1 % of the hits, *assumed*), to its blind
  /// distance (any), to its body box (a tenth, *assumed*). Empty if all is well.
  std::vector<std::string> warnings(const ObstacleMapOptions& options) const;
};

}  // namespace ltp
