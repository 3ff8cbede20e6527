// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The 26 steps from a cell to its neighbours, their lengths, and which of them a blocked cell
// forbids.
#pragma once

#include <array>
#include <cstdint>

#include "ltp/grid/frame.hpp"
#include "ltp/grid/occupancy_grid.hpp"

namespace ltp {

inline constexpr int kSteps = 26;

/// The bit of the offset (dx, dy, dz), each -1, 0 or 1, in a 27-bit mask of a cell's surroundings.
constexpr int neighbour_bit(int dx, int dy, int dz) { return (dx + 1) * 9 + (dy + 1) * 3 + dz + 1; }

/// One step to a neighbour. It is legal when no cell of its bounding box is blocked: the target,
/// and every cell whose edge or corner a diagonal step would squeeze past.
struct Step {
  std::int8_t dx, dy, dz;
  std::int8_t opposite;  ///< the number of the step back
  std::uint32_t box;     ///< the surroundings' bits that must all be free
};

/// Faces first, then edges, then corners; within each by (dx, dy, dz). Ties are broken in this
/// order.
const std::array<Step, kSteps>& steps();

/// Metric lengths of the steps on cells of the given edges [m].
std::array<double, kSteps> step_lengths(const Point& cell);

/// Levels of the window that a search may use, both ends included.
struct LevelRange {
  int lowest = 0;
  int highest = 0;
};

/// The 27-bit mask of the blocked cells round a cell. Cells outside the frame or the levels count
/// as blocked.
inline std::uint32_t blocked_surroundings(const OccupancyGrid& grid, const Cell& cell,
                                          const LevelRange& levels) {
  const GridFrame& frame = grid.frame();
  const std::uint32_t outside =
      (cell.z() <= levels.lowest ? 1u : 0u) | (cell.z() >= levels.highest ? 4u : 0u);
  std::uint32_t mask = 0;
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      const int ix = cell.x() + dx;
      const int iy = cell.y() + dy;
      std::uint32_t three = 7;
      if (static_cast<unsigned>(ix) < static_cast<unsigned>(frame.nx()) &&
          static_cast<unsigned>(iy) < static_cast<unsigned>(frame.ny())) {
        const std::uint64_t* column = grid.column(ix, iy);
        const int low = cell.z() - 1;  // the three levels z - 1, z, z + 1
        if (low < 0) {
          three = static_cast<std::uint32_t>(column[0] << 1) & 7u;
        } else {
          std::uint64_t bits = column[low >> 6] >> (low & 63);
          // The three levels may straddle two words.
          if ((low & 63) > 61 && (low >> 6) + 1 < grid.words_per_column()) {
            bits |= column[(low >> 6) + 1] << (64 - (low & 63));
          }
          three = static_cast<std::uint32_t>(bits) & 7u;
        }
        three |= outside;
      }
      mask |= three << neighbour_bit(dx, dy, -1);
    }
  }
  return mask;
}

}  // namespace ltp
