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
inline std::uint64_t beside(std::uint64_t before, std::uint64_t here, std::uint64_t after) {
  return here << 1 | before >> 63 | here >> 1 | after << 63;
}

// Compiled for several processors, of which the best is chosen at run time. On integers all of them
// give the same.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define LTP_FOR_WIDE_REGISTERS \
  __attribute__((target_clones("default", "popcnt", "avx2", "arch=x86-64-v4")))
#else
#define LTP_FOR_WIDE_REGISTERS
#endif

/// Of `count` levels, what the words of x - 1, x and x + 1 lend to the middle one. `along` and
/// `across` are the distances to the next word along y and along x.
struct Words {
  const std::uint64_t* free;
  const std::uint64_t* reached;
  std::ptrdiff_t along, across;
  int count;
};

/// A step along each axis whose mask is not 0. Returns what may still be reached, or'ed.
LTP_FOR_WIDE_REGISTERS std::uint64_t spread_straight(const Words& words, std::uint64_t x,
                                                     std::uint64_t y, std::uint64_t z,
                                                     std::uint64_t* added) {
  const std::uint64_t* const at = words.reached;
  const std::ptrdiff_t along = words.along;
  const std::ptrdiff_t across = words.across;
  std::uint64_t any = 0;
  for (int i = 0; i < words.count; ++i) {
    const std::uint64_t grown = (beside(at[i - along], at[i], at[i + along]) & y) |
                                ((at[i - 1] | at[i + 1]) & z) |
                                ((at[i - across] | at[i + across]) & x);
    const std::uint64_t waiting = words.free[i] & ~at[i];
    any |= waiting;
    added[i] = grown & waiting;
  }
  return any;
}

/// A diagonal step of the plane: both cells that it squeezes past must be free.
LTP_FOR_WIDE_REGISTERS void spread_diagonally(const Words& words, std::uint64_t* added) {
  const std::ptrdiff_t along = words.along;
  for (const std::ptrdiff_t across : {-words.across, words.across}) {
    const std::uint64_t* const other = words.reached + across;
    for (int i = 0; i < words.count; ++i) {
      const std::uint64_t* const free = words.free + i;
      const std::uint64_t waiting = *free & ~words.reached[i];
      added[i] |= beside(other[i - along] & free[-along], other[i] & *free,
                         other[i + along] & free[along]) &
                  free[across] & waiting;
    }
  }
}

/// Returns how many bits were added.
LTP_FOR_WIDE_REGISTERS std::int64_t take(const std::uint64_t* added, int count,
                                         std::uint64_t* reached) {
  std::int64_t bits = 0;
  for (int i = 0; i < count; ++i) {
    reached[i] |= added[i];
    bits += __builtin_popcountll(added[i]);
  }
  return bits;
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
  const std::size_t columns = static_cast<std::size_t>(frame.nx() + 2) * (words + 2);
  const std::size_t size = columns * (count + 2);
  if (frame.nx() != nx_ || count != levels_ || words != words_) {
    nx_ = frame.nx();
    levels_ = count;
    words_ = words;
    free_.assign(size, 0);
    reached_.assign(size, 0);
    added_.resize(size);
    extents_.assign(columns, {kFar, -kFar});
    full_.assign(columns, 0);
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
  const auto at = [](auto& values, std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const std::size_t column = column_of(ix, 0);
  const std::size_t first = begin_of(column) - 1;
  const std::size_t size = static_cast<std::size_t>(words_) * (levels_ + 2);
  std::fill_n(at(extents_, column), words_, Extent{kFar, -kFar});
  std::fill_n(at(full_, column), words_, 0);
  std::fill_n(at(reached_, first), size, 0);
  for (int plane = 0; plane < planes_; ++plane) {
    std::fill_n(at(numbers_, plane * free_.size() + first), size, 0);
  }
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
        free_[begin_of(column + word) + done] = bits;
      } else {
        std::fill(block.begin() + lines, block.end(), 0);
        transpose(block);
        std::copy_n(block.begin(), count, at(free_, begin_of(column + word) + done));
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
  const auto mask = [](bool taken) { return taken ? ~std::uint64_t{0} : 0; };
  const std::size_t across = words_ + 2;  // columns to the next x
  touched_.clear();
  for (int ix = std::max(reached_low_ - 1, 0); ix <= std::min(reached_high_ + 1, nx_ - 1); ++ix) {
    for (int word = 0; word < words_; ++word) {
      const std::size_t column = column_of(ix, word);
      if (full_[column]) continue;
      Extent levels = extents_[column];
      for (const std::size_t other : {column - 1, column + 1, column - across, column + across}) {
        levels.low = std::min(levels.low, extents_[other].low);
        levels.high = std::max(levels.high, extents_[other].high);
      }
      if (levels.low > levels.high) continue;
      levels = {std::max(levels.low - 1, 0), std::min(levels.high + 1, levels_ - 1)};
      const std::size_t first = begin_of(column) + levels.low;
      const Words words{free_.data() + first, reached_.data() + first, levels_ + 2,
                        static_cast<std::ptrdiff_t>(across) * (levels_ + 2),
                        levels.high - levels.low + 1};
      const std::uint64_t waiting = spread_straight(words, mask(steps.x), mask(steps.y),
                                                    mask(steps.z), added_.data() + first);
      if (waiting == 0) {
        full_[column] = words.count == levels_;
        continue;
      }
      if (steps.diagonal) spread_diagonally(words, added_.data() + first);
      touched_.push_back({column, levels});
    }
  }
}

/// Marks what was added; returns how many cells.
std::int64_t BitWave::settle(int generation) {
  std::int64_t cells = 0;
  for (const auto& [column, levels] : touched_) {
    const std::size_t first = begin_of(column) + levels.low;
    const int count = levels.high - levels.low + 1;
    const std::uint64_t* const added = added_.data() + first;
    const std::int64_t here = take(added, count, reached_.data() + first);
    if (here == 0) continue;
    cells += here;
    for (int plane = 0; plane < planes_; ++plane) {
      if (!(generation >> plane & 1)) continue;
      std::uint64_t* const numbers = numbers_.data() + plane * free_.size() + first;
      for (int i = 0; i < count; ++i) numbers[i] |= added[i];
    }
    Extent& extent = extents_[column];
    int low = 0;
    int high = count - 1;
    while (added[low] == 0) ++low;
    while (added[high] == 0) --high;
    extent.low = std::min(extent.low, levels.low + low);
    extent.high = std::max(extent.high, levels.low + high);
    const int ix = static_cast<int>(column / (words_ + 2)) - 1;
    reached_low_ = std::min(reached_low_, ix);
    reached_high_ = std::max(reached_high_, ix);
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
  prepare(grid, from.x() - 2, from.x() + 2);
  reached_low_ = reached_high_ = from.x();
  added_[word_of(from)] = bit_of(from);
  const int level = from.z() - lowest_;
  touched_.assign(1, {column_of(from.x(), from.y() >> 6), {level, level}});
  generation_ = 0;
  for (int idle = 0; idle < patience_;) {
    const std::int64_t before = stats.expanded;
    const std::int64_t cells = settle(generation_);
    idle = cells == 0 ? idle + 1 : 0;
    stats.expanded += cells;
    const bool spent = budget.spent_since(before, stats.expanded);
    stats.expanded = stats.pushed = budget.capped(stats.expanded);
    if (spent) return PlanStatus::OutOfBudget;
    if (reached(to)) return PlanStatus::Found;
    prepare(grid, reached_low_ - 2, reached_high_ + 2);
    spread(pattern(++generation_));
  }
  return PlanStatus::Unreachable;
}

int BitWave::earlier(const Cell& neighbour, int here) const {
  const std::size_t word = word_of(neighbour);
  const int bit = neighbour.y() & 63;
  if (!(reached_[word] >> bit & 1u)) return 0;
  int number = 0;
  for (int plane = 0; plane < planes_; ++plane) {
    number |= static_cast<int>(numbers_[plane * free_.size() + word] >> bit & 1u) << plane;
  }
  const int mask = (1 << planes_) - 1;
  const int less = (here - number) & mask;
  return less <= mask / 2 ? less : 0;
}

}  // namespace ltp
