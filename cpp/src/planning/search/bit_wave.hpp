// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `BitWave`: a wave through the free cells of a grid, 64 cells at a time.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/planning/grid_planner.hpp"

namespace ltp::planning {

/// Generation by generation, each as long as the shortest edge of a cell. A generation takes every
/// step along an axis for which another edge has passed, and in a share sqrt(2) - 1 of them the
/// diagonal steps of the plane: so the wave in the open plane is the octagon of all cells within
/// one distance. Steps obey the squeeze rule, so it reaches what a flood reaches.
///
/// 64 cells along y are the bits of a word, so one level is as dense as all of them. Words that
/// differ in the level only lie side by side, so several are spread at once where the processor
/// can; on a single level, those that differ in x only (below, `inner` is that axis and `outer` the
/// other). Only words at the wave's front cost more than a glance. Allocates for the largest grid
/// so far.
class BitWave {
 public:
  /// Spreads from one free cell until it has reached another (`Found`), has run dry
  /// (`Unreachable`) or must stop (`OutOfBudget`). Adds the cells reached to `stats`.
  PlanStatus run(const OccupancyGrid& grid, const LevelRange& levels, const Cell& from,
                 const Cell& to, BudgetWatch& budget, SearchStats& stats);

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
  /// Of the words of a column: places along the inner axis, both ends included.
  struct Extent {
    int low, high;
  };
  /// Where a generation may have added something.
  struct Touched {
    std::size_t column;
    Extent places;
  };

  void begin(const OccupancyGrid& grid, const LevelRange& levels);
  void prepare(const OccupancyGrid& grid, int low, int high);
  void prepare_columns(const OccupancyGrid& grid, int outer);
  void copy_level(const OccupancyGrid& grid);
  void copy_levels(const OccupancyGrid& grid, int ix);
  Pattern pattern(int generation) const;
  void spread(const Pattern& steps);
  std::int64_t settle(int generation);
  /// Columns of words lie by the outer axis, then by word, one more at each border.
  std::size_t column_of(int outer, int word) const {
    return static_cast<std::size_t>(outer + 1) * (words_ + 2) + (word + 1);
  }
  /// A column's first word; before it and after the last lies an empty one.
  std::size_t begin_of(std::size_t column) const { return column * (inner_ + 2) + 1; }
  int outer_of(const Cell& cell) const { return flat_ ? 0 : cell.x(); }
  int inner_of(const Cell& cell) const { return flat_ ? cell.x() : cell.z() - lowest_; }
  std::size_t word_of(const Cell& cell) const {
    return begin_of(column_of(outer_of(cell), cell.y() >> 6)) + inner_of(cell);
  }

  bool flat_ = false;             ///< whether there is a single level
  int lowest_ = 0;                ///< level
  int ny_ = 0;                    ///< cells along y
  int words_ = 0;                 ///< words along y
  int outer_ = 0, inner_ = 0;     ///< cells along these axes
  std::array<double, 3> rate_{};  ///< steps along each axis in a generation
  double pace_ = 0.0;
  int patience_ = 0;  ///< so many generations may add nothing
  int generation_ = 0;
  int planes_ = 0;  ///< bits of a cell's generation that are kept: they tell neighbours apart
  int prepared_low_ = 0, prepared_high_ = -1;  ///< along the outer axis: whose words are valid
  int reached_low_ = 0, reached_high_ = 0;     ///< the same: what the wave has come to
  std::vector<Extent> extents_;                ///< [column] the same along the inner axis
  std::vector<char> full_;                     ///< [column] whether nothing is left to reach
  std::vector<Touched> touched_;
  std::vector<std::uint64_t> free_;  // by `word_of`; beyond the window there are no bits
  std::vector<std::uint64_t> reached_;
  std::vector<std::uint64_t> added_;    ///< by this generation, where it touched
  std::vector<std::uint64_t> numbers_;  ///< [plane][word]
};

}  // namespace ltp::planning
