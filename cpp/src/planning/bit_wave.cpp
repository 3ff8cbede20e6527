// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/bit_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ltp {
namespace {

constexpr int kFar = std::numeric_limits<int>::max() / 2;
constexpr double kDiagonalShare = 0.41421356237309503;  // sqrt(2) - 1

/// Transposes a 64 x 64 matrix of bits, in place (Warren, Hacker's Delight, section 7-3).
void transpose(std::array<std::uint64_t, 64>& rows) {
  std::uint64_t mask = 0x00000000ffffffff;
  for (int half = 32; half > 0; half >>= 1, mask ^= mask << half) {
    for (int k = 0; k < 64; k = (k + half + 1) & ~half) {
      const std::uint64_t swap = (rows[k] >> half ^ rows[k + half]) & mask;
      rows[k] ^= swap << half;
      rows[k + half] ^= swap;
    }
  }
}

/// A row's bits moved by one cell to either side, both or'ed.
std::uint64_t beside(std::uint64_t before, std::uint64_t here, std::uint64_t after) {
  return here << 1 | before >> 63 | here >> 1 | after << 63;
}

bool passes(double rate, int generation) {
  return std::floor(rate * generation) > std::floor(rate * (generation - 1));
}

}  // namespace

void BitWave::begin(const OccupancyGrid& grid, const LevelRange& levels) {
  const GridFrame& frame = grid.frame();
  ny_ = frame.ny();
  lowest_ = levels.lowest;
  const int count = levels.highest - levels.lowest + 1;
  const int words = (ny_ + 63) / 64;
  pace_ = count > 1 ? frame.cell().minCoeff() : frame.cell().head<2>().minCoeff();
  int most = 0;  // generations between two neighbours
  patience_ = 1;
  for (int axis = 0; axis < 3; ++axis) {
    rate_[axis] = std::min(1.0, pace_ / frame.cell()[axis]);
    const int period = static_cast<int>(std::ceil(1.0 / rate_[axis]));
    if (axis < 2 || count > 1) {
      most += period;
      patience_ = std::max(patience_, period);
    }
  }
  planes_ = 1;
  while ((1 << planes_) <= 2 * most) ++planes_;
  const std::size_t size =
      static_cast<std::size_t>(frame.nx() + 2) * (count + 2) * static_cast<std::size_t>(words + 2);
  if (frame.nx() != nx_ || count != levels_ || words != words_) {
    nx_ = frame.nx();
    levels_ = count;
    words_ = words;
    free_.assign(size, 0);
    reached_.assign(size, 0);
    extents_.assign(static_cast<std::size_t>(nx_ + 2) * (count + 2), Extent{kFar, -kFar});
  }
  if (numbers_.size() < size * planes_) numbers_.resize(size * planes_);
  prepared_low_ = 0;
  prepared_high_ = -1;
}

/// Makes the words of x from low to high valid.
void BitWave::prepare(const OccupancyGrid& grid, int x_low, int x_high) {
  x_low = std::max(x_low, 0);
  x_high = std::min(x_high, nx_ - 1);
  if (prepared_high_ < prepared_low_) {
    prepared_low_ = x_low;
    prepared_high_ = x_low - 1;
  }
  while (prepared_low_ > x_low) prepare_row(grid, --prepared_low_);
  while (prepared_high_ < x_high) prepare_row(grid, ++prepared_high_);
}

void BitWave::prepare_row(const OccupancyGrid& grid, int ix) {
  const std::size_t row = row_of(ix, 0);
  const std::size_t first = begin_of(row);
  const std::size_t size = static_cast<std::size_t>(levels_) * (words_ + 2);
  std::fill_n(extents_.begin() + static_cast<std::ptrdiff_t>(row), levels_, Extent{kFar, -kFar});
  std::fill_n(reached_.begin() + static_cast<std::ptrdiff_t>(first), size, 0);
  std::fill_n(numbers_.begin() + static_cast<std::ptrdiff_t>(first * planes_), size * planes_, 0);
  std::array<std::uint64_t, 64> block;
  for (int word = 0; word < words_; ++word) {
    const int lines = std::min(64, ny_ - 64 * word);
    for (int done = 0; done < levels_;) {
      const int level = lowest_ + done;
      const int bit = level & 63;
      const int count = std::min(levels_ - done, 64 - bit);
      for (int line = 0; line < lines; ++line) {
        block[line] = ~grid.column(ix, 64 * word + line)[level >> 6] >> bit;
      }
      if (count == 1) {
        std::uint64_t bits = 0;
        for (int line = 0; line < lines; ++line) bits |= (block[line] & 1u) << line;
        free_[begin_of(row + done) + word] = bits;
      } else {
        std::fill(block.begin() + lines, block.end(), 0);
        transpose(block);
        for (int i = 0; i < count; ++i) free_[begin_of(row + done + i) + word] = block[i];
      }
      done += count;
    }
  }
}

BitWave::Pattern BitWave::pattern(int generation) const {
  Pattern steps{};
  steps.x = passes(rate_[0], generation);
  steps.y = passes(rate_[1], generation);
  steps.z = passes(rate_[2], generation);
  steps.diagonal = steps.x && steps.y && passes(kDiagonalShare, generation);
  return steps;
}

/// Collects in `added_` what one generation reaches.
void BitWave::spread(const Pattern& steps) {
  const std::size_t up = words_ + 2;
  const std::size_t along = up * (levels_ + 2);
  added_.clear();
  for (int ix = std::max(box_.x_low - 1, 0); ix <= std::min(box_.x_high + 1, nx_ - 1); ++ix) {
    for (int level = std::max(box_.level_low - 1, 0);
         level <= std::min(box_.level_high + 1, levels_ - 1); ++level) {
      const std::size_t row = row_of(ix, level);
      Extent extent = extents_[row];
      for (const std::size_t other : {row - 1, row + 1, row - levels_ - 2, row + levels_ + 2}) {
        extent.low = std::min(extent.low, extents_[other].low);
        extent.high = std::max(extent.high, extents_[other].high);
      }
      if (extent.low > extent.high) continue;
      const int last = std::min(extent.high + 1, ny_ - 1) >> 6;
      for (int word = std::max(extent.low - 1, 0) >> 6; word <= last; ++word) {
        const std::uint64_t* const free = free_.data() + begin_of(row) + word;
        const std::uint64_t* const at = reached_.data() + begin_of(row) + word;
        const std::uint64_t waiting = *free & ~*at;
        if (waiting == 0) continue;
        std::uint64_t grown = 0;
        if (steps.y) grown |= beside(at[-1], at[0], at[1]);
        if (steps.z) grown |= *(at - up) | *(at + up);
        if (steps.x) grown |= *(at - along) | *(at + along);
        if (steps.diagonal) {
          // From the row beside: both cells that the step squeezes past must be free.
          for (const std::uint64_t* const other : {at - along, at + along}) {
            const std::uint64_t there = *(free + (other - at));
            grown |= beside(other[-1] & free[-1], other[0] & free[0], other[1] & free[1]) & there;
          }
        }
        grown &= waiting;
        if (grown == 0) continue;
        added_.push_back(
            {static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(word), grown});
      }
    }
  }
}

/// Marks what was added; returns how many cells.
std::int64_t BitWave::settle(int generation) {
  std::int64_t cells = 0;
  for (const auto& [row, word, bits] : added_) {
    const std::size_t number = begin_of(row) + word;
    reached_[number] |= bits;
    for (int plane = 0; plane < planes_; ++plane) {
      if (generation >> plane & 1) numbers_[number * planes_ + plane] |= bits;
    }
    cells += __builtin_popcountll(bits);
    Extent& extent = extents_[row];
    const int first = static_cast<int>(64 * word);
    extent.low = std::min(extent.low, first + __builtin_ctzll(bits));
    extent.high = std::max(extent.high, first + 63 - __builtin_clzll(bits));
    const int level = static_cast<int>(row % (levels_ + 2)) - 1;
    const int ix = static_cast<int>(row / (levels_ + 2)) - 1;
    box_ = {std::min(box_.x_low, ix), std::max(box_.x_high, ix), std::min(box_.level_low, level),
            std::max(box_.level_high, level)};
  }
  return cells;
}

PlanStatus BitWave::run(const OccupancyGrid& grid, const LevelRange& levels, const Cell& from,
                        const Cell& to, const Budget& budget, SearchStats& stats) {
  begin(grid, levels);
  const auto bit_of = [](const Cell& cell) { return std::uint64_t{1} << (cell.y() & 63); };
  const auto reached = [&](const Cell& cell) {
    const bool prepared = cell.x() >= prepared_low_ && cell.x() <= prepared_high_;
    return prepared && (reached_[word_of(cell)] & bit_of(cell)) != 0;
  };
  const int level = from.z() - lowest_;
  box_ = {from.x(), from.x(), level, level};
  prepare(grid, from.x() - 2, from.x() + 2);
  added_.assign(1, {static_cast<std::uint32_t>(row_of(from.x(), level)),
                    static_cast<std::uint32_t>(from.y() >> 6), bit_of(from)});
  generation_ = 0;
  for (int idle = 0; idle < patience_;) {
    const std::int64_t before = stats.expanded;
    stats.expanded += settle(generation_);
    const bool spent = budget.spent_since(before, stats.expanded);
    stats.expanded = stats.pushed = budget.capped(stats.expanded);
    if (spent) return PlanStatus::OutOfBudget;
    if (reached(to)) return PlanStatus::Found;
    prepare(grid, box_.x_low - 2, box_.x_high + 2);
    spread(pattern(++generation_));
    idle = added_.empty() ? idle + 1 : 0;
  }
  return PlanStatus::Unreachable;
}

int BitWave::earlier(const Cell& neighbour, int here) const {
  const std::size_t word = word_of(neighbour);
  const int bit = neighbour.y() & 63;
  if (!(reached_[word] >> bit & 1u)) return 0;
  int number = 0;
  for (int plane = 0; plane < planes_; ++plane) {
    number |= static_cast<int>(numbers_[word * planes_ + plane] >> bit & 1u) << plane;
  }
  const int mask = (1 << planes_) - 1;
  const int less = (here - number) & mask;
  return less <= mask / 2 ? less : 0;
}

}  // namespace ltp
