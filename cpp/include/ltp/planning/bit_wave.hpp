// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `BitWave`: a wave through the free cells of a grid, 64 cells at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/planning/grid_query.hpp"

namespace ltp {

/// Generation by generation, each as long as the shortest edge of a cell. A generation takes every
/// step along an axis for which another edge has passed, and in a share sqrt(2) - 1 of them the
/// diagonal steps of the plane: so the wave in the open plane is the octagon of all cells within
/// one distance. Steps obey the squeeze rule, so it reaches what a flood reaches.
///
/// The cells of one (x, z) lie along y as the bits of words: one level is as dense as all of them.
/// Only words at the wave's front cost more than a glance. Allocates for the largest grid so far.
class BitWave {
 public:
  /// Spreads from one free cell until it has reached another (`Found`), has run dry
  /// (`Unreachable`) or must stop (`OutOfBudget`). Adds the cells reached to `stats`.
  PlanStatus run(const OccupancyGrid& grid, const LevelRange& levels, const Cell& from,
                 const Cell& to, const Budget& budget, SearchStats& stats);

  /// In which `to` was reached.
  int generation() const { return generation_; }
  /// How much earlier than one of generation `here` a cell was reached to which there is a legal
  /// step from there; 0: no earlier, or never. Both are inside.
  int earlier(const Cell& neighbour, int here) const;
  double pace() const { return pace_; }  ///< how far a wave comes in a generation [m]

 private:
  /// The steps of a generation.
  struct Pattern {
    bool x, y, z, diagonal;
  };
  /// Cells that a generation added: bits of one word of a row.
  struct Addition {
    std::uint32_t row;
    std::uint32_t word;
    std::uint64_t bits;
  };
  /// The y that the wave has reached in a row, both ends included.
  struct Extent {
    int low, high;
  };
  /// The x and levels that it has reached.
  struct Box {
    int x_low, x_high, level_low, level_high;
  };

  void begin(const OccupancyGrid& grid, const LevelRange& levels);
  void prepare(const OccupancyGrid& grid, int x_low, int x_high);
  void prepare_row(const OccupancyGrid& grid, int ix);
  Pattern pattern(int generation) const;
  void spread(const Pattern& steps);
  std::int64_t settle(int generation);
  /// Rows lie by x, then level, one more at each border.
  std::size_t row_of(int ix, int level) const {
    return static_cast<std::size_t>(ix + 1) * (levels_ + 2) + (level + 1);
  }
  /// The first word of a row with cells in it; before it and after the last lies an empty one.
  std::size_t begin_of(std::size_t row) const { return row * (words_ + 2) + 1; }
  std::size_t word_of(const Cell& cell) const {
    return begin_of(row_of(cell.x(), cell.z() - lowest_)) + (cell.y() >> 6);
  }

  int nx_ = 0, ny_ = 0;
  int levels_ = 0, lowest_ = 0;   ///< how many are open, and the first of them
  int words_ = 0;                 ///< of a row
  std::array<double, 3> rate_{};  ///< steps along each axis in a generation
  double pace_ = 0.0;
  int patience_ = 0;  ///< so many generations may add nothing
  int generation_ = 0;
  int planes_ = 0;  ///< bits of a cell's generation that are kept: they tell neighbours apart
  int prepared_low_ = 0, prepared_high_ = -1;  ///< the x whose words are valid
  Box box_{};
  std::vector<Extent> extents_;      ///< [row]
  std::vector<std::uint64_t> free_;  // beyond the window there are no bits
  std::vector<std::uint64_t> reached_;
  std::vector<std::uint64_t> numbers_;  ///< [word][plane]
  std::vector<Addition> added_;
};

}  // namespace ltp
