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
inline int neighbour_bit(const Cell& offset) {
  return neighbour_bit(offset.x(), offset.y(), offset.z());
}

/// One step to a neighbour. It is legal when no cell of its bounding box is blocked: the target,
/// and every cell whose edge or corner a diagonal step would squeeze past.
struct Step {
  std::int8_t dx, dy, dz;
  std::int8_t opposite;  ///< the number of the step back
  std::uint32_t box;     ///< the surroundings' bits that must all be free

  Cell offset() const { return Cell(dx, dy, dz); }
};

namespace detail {

constexpr std::uint32_t box_of(int dx, int dy, int dz) {
  std::uint32_t box = 0;
  for (int x = 0; x <= dx * dx; ++x) {
    for (int y = 0; y <= dy * dy; ++y) {
      for (int z = 0; z <= dz * dz; ++z) {
        // The walker's own cell is not asked about: a UAV may stand in a coarse blocked cell.
        if (x + y + z > 0) box |= std::uint32_t{1} << neighbour_bit(dx * x, dy * y, dz * z);
      }
    }
  }
  return box;
}

constexpr std::array<Step, kSteps> make_steps() {
  std::array<Step, kSteps> all{};
  int count = 0;
  for (int kind = 1; kind <= 3; ++kind) {
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          if (dx * dx + dy * dy + dz * dz != kind) continue;
          Step& step = all[count++];
          step.dx = static_cast<std::int8_t>(dx);
          step.dy = static_cast<std::int8_t>(dy);
          step.dz = static_cast<std::int8_t>(dz);
          step.box = box_of(dx, dy, dz);
        }
      }
    }
  }
  for (Step& step : all) {
    for (int i = 0; i < kSteps; ++i) {
      if (all[i].dx == -step.dx && all[i].dy == -step.dy && all[i].dz == -step.dz) {
        step.opposite = static_cast<std::int8_t>(i);
      }
    }
  }
  return all;
}

inline constexpr std::array<Step, kSteps> kAllSteps = make_steps();

}  // namespace detail

/// Faces first, then edges, then corners; within each by (dx, dy, dz). Ties are broken in this
/// order.
inline const std::array<Step, kSteps>& steps() { return detail::kAllSteps; }

inline constexpr int kNoStep = -1;
/// The number of the step that adds an offset; `kNoStep` if none does.
int step_by(const Cell& offset);
/// The number of the step from a cell to its neighbour.
inline int step_between(const Cell& from, const Cell& to) { return step_by(to - from); }

/// Metric lengths of the steps on cells of the given edges [m].
std::array<double, kSteps> step_lengths(const Point& cell);

/// The bits of the nine cells below: (-1 ... 1, -1 ... 1, -1).
inline constexpr std::uint32_t kBottomBits = 0111111111;

/// Levels of the window that a search may use, both ends included.
struct LevelRange {
  int lowest = 0;
  int highest = 0;

  int count() const { return highest - lowest + 1; }
  bool contains(const Cell& cell) const { return cell.z() >= lowest && cell.z() <= highest; }
};

/// The 27-bit mask of the blocked cells round a cell. Cells outside the frame or the levels count
/// as blocked.
inline std::uint32_t blocked_surroundings(const OccupancyGrid& grid, const Cell& cell,
                                          const LevelRange& levels) {
  const GridFrame& frame = grid.frame();
  const std::uint32_t outside =
      (cell.z() <= levels.lowest ? 1u : 0u) | (cell.z() >= levels.highest ? 4u : 0u);
  std::uint32_t mask = 0;
  if (grid.words_per_column() == 1 && cell.x() > 0 && cell.x() < frame.nx() - 1 && cell.y() > 0 &&
      cell.y() < frame.ny() - 1 && cell.z() > 0) {  // most cells: nine words, and no questions
    for (int dx = -1; dx <= 1; ++dx) {
      const std::uint64_t* column = grid.column(cell.x() + dx, cell.y());
      for (int dy = -1; dy <= 1; ++dy) {
        const std::uint64_t three = column[dy] >> (cell.z() - 1) & 7u;
        mask |= static_cast<std::uint32_t>(three) << neighbour_bit(dx, dy, -1);
      }
    }
    return mask | outside * kBottomBits;
  }
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
