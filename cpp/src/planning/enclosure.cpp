// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/enclosure.hpp"

namespace ltp {
namespace {

constexpr int kFar = 32;              // cells
constexpr std::size_t kMany = 16384;  // cells: some 0.2 ms
constexpr int kFaces = 6;             // the first of the 26 steps; what these reach, six reach too

bool is_open(const OccupancyGrid& grid, const Cell& cell, const LevelRange& levels) {
  return cell.z() >= levels.lowest && cell.z() <= levels.highest && grid.frame().contains(cell) &&
         !grid.blocked(cell);
}

bool sees_far(const OccupancyGrid& grid, const Cell& from, const Cell& along,
              const LevelRange& levels) {
  for (int i = 1; i <= kFar; ++i) {
    if (!is_open(grid, from + i * along, levels)) return false;
  }
  return true;
}

}  // namespace

bool Enclosure::parts(const OccupancyGrid& grid, const Cell& inside, const Cell& outside,
                      const LevelRange& levels) {
  const auto face = [](int i) { return Cell(steps()[i].dx, steps()[i].dy, steps()[i].dz); };
  for (int i = 0; i < kFaces; ++i) {
    if (sees_far(grid, inside, face(i), levels)) return false;
  }
  space_.begin(grid.frame(), levels);
  space_.visit(space_.index(inside));
  waiting_.assign(1, inside);
  for (std::size_t seen = 1; !waiting_.empty();) {
    const Cell cell = waiting_.back();
    waiting_.pop_back();
    for (int i = 0; i < kFaces; ++i) {
      const Cell next = cell + face(i);
      if (!is_open(grid, next, levels) || space_.visited(space_.index(next))) continue;
      if (next == outside || ++seen > kMany) return false;
      space_.visit(space_.index(next));
      waiting_.push_back(next);
    }
  }
  return true;
}

}  // namespace ltp
