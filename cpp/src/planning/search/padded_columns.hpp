// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `PaddedColumns`: a window's blocked cells with a margin round them, for a search that asks often.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/grid/occupancy_grid.hpp"

namespace ltp::planning {

/// A copy of the levels that a search may use, with one blocked cell round it on all sides: nobody
/// has to ask where the window ends. A cell's number counts the levels first, then the columns of
/// the padded window, y before x.
class PaddedColumns {
 public:
  void reset(const OccupancyGrid& grid, const LevelRange& levels);

  std::uint32_t size() const { return columns_ * depth_; }
  std::uint32_t index(const Cell& cell) const {
    return (static_cast<std::uint32_t>(cell.x() + 1) * row_ +
            static_cast<std::uint32_t>(cell.y() + 1)) *
               depth_ +
           static_cast<std::uint32_t>(cell.z() - lowest_);
  }
  /// What a step adds to a cell's number.
  std::int32_t offset(const Step& step) const {
    return (step.dx * static_cast<std::int32_t>(row_) + step.dy) *
               static_cast<std::int32_t>(depth_) +
           step.dz;
  }
  bool contains(const Cell& cell) const {
    return cell.z() >= lowest_ && cell.z() < lowest_ + static_cast<int>(depth_);
  }
  std::uint32_t depth() const { return depth_; }  ///< levels

  /// Whether the cell and the 26 round it are free.
  bool in_the_open(std::uint32_t index) const { return open_[index >> 6] >> (index & 63) & 1u; }
  /// As `blocked_surroundings`.
  std::uint32_t surroundings(std::uint32_t index) const {
    const std::uint32_t column = index / depth_;
    const std::uint32_t level = index - column * depth_;
    const std::uint64_t* word = words_.data() + std::size_t{column} * per_column_ + level / kLevels;
    const std::uint32_t shift = level % kLevels;
    std::uint32_t mask = 0;
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const std::ptrdiff_t by = (dx * std::ptrdiff_t{row_} + dy) * per_column_;
        mask |= static_cast<std::uint32_t>(word[by] >> shift & 7u) << neighbour_bit(dx, dy, -1);
      }
    }
    return mask;
  }
  /// Calls `visit(number of the lowest cell, blocked, levels)` for every word of every column.
  template <typename Visitor>
  void each_word(Visitor&& visit) const {
    const std::uint64_t* word = words_.data();
    for (std::uint32_t column = 0; column < columns_; ++column) {
      for (std::uint32_t level = 0; level < depth_; level += kLevels) {
        visit(column * depth_ + level, *word++ >> 1, std::min(depth_ - level, kLevels));
      }
    }
  }

 private:
  static constexpr std::uint32_t kLevels = 62;  ///< of a word; its outer bits belong to the next

  void find_open();

  std::uint32_t row_ = 0;      ///< columns of one x
  std::uint32_t columns_ = 0;  ///< in all
  std::uint32_t depth_ = 1;
  std::uint32_t per_column_ = 1;
  int lowest_ = 0;
  std::vector<std::uint64_t> words_;
  std::vector<std::uint64_t> open_;  ///< by number
};

}  // namespace ltp::planning
