// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/bit_wave.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planning/search/wave_kernels.hpp"

namespace ltp::planning {
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

bool passes(double rate, int generation) {
  return std::floor(rate * generation) > std::floor(rate * (generation - 1));
}

}  // namespace

void BitWave::begin(const OccupancyGrid& grid, const LevelRange& levels) {
  const GridFrame& frame = grid.frame();
  const int count = levels.count();
  flat_ = count == 1;
  lowest_ = levels.lowest;
  ny_ = frame.ny();
  pace_ = flat_ ? frame.cell().head<2>().minCoeff() : frame.cell().minCoeff();
  int most = 0;  // generations between two neighbours
  patience_ = 1;
  for (int axis = 0; axis < (flat_ ? 2 : 3); ++axis) {
    rate_[axis] = std::min(1.0, pace_ / frame.cell()[axis]);
    const int period = static_cast<int>(std::ceil(1.0 / rate_[axis]));
    most += period;
    patience_ = std::max(patience_, period);
  }
  planes_ = 1;
  while ((1 << planes_) <= 2 * most) ++planes_;
  const std::array<int, 3> dims = {flat_ ? 1 : frame.nx(), (ny_ + 63) / 64,
                                   flat_ ? frame.nx() : count};
  const std::size_t columns = static_cast<std::size_t>(dims[0] + 2) * (dims[1] + 2);
  const std::size_t size = columns * (dims[2] + 2);
  if (dims != std::array<int, 3>{outer_, words_, inner_}) {
    outer_ = dims[0];
    words_ = dims[1];
    inner_ = dims[2];
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

/// Makes the words from low to high along the outer axis valid.
void BitWave::prepare(const OccupancyGrid& grid, int low, int high) {
  low = std::max(low, 0);
  high = std::min(high, outer_ - 1);
  if (prepared_high_ < prepared_low_) {
    prepared_low_ = low;
    prepared_high_ = low - 1;
  }
  while (prepared_low_ > low) prepare_columns(grid, --prepared_low_);
  while (prepared_high_ < high) prepare_columns(grid, ++prepared_high_);
}

void BitWave::prepare_columns(const OccupancyGrid& grid, int outer) {
  const auto at = [](auto& values, std::size_t i) {
    return values.begin() + static_cast<std::ptrdiff_t>(i);
  };
  const std::size_t column = column_of(outer, 0);
  const std::size_t first = begin_of(column) - 1;
  const std::size_t size = static_cast<std::size_t>(words_) * (inner_ + 2);
  std::fill_n(at(extents_, column), words_, Extent{kFar, -kFar});
  std::fill_n(at(full_, column), words_, 0);
  std::fill_n(at(reached_, first), size, 0);
  for (int plane = 0; plane < planes_; ++plane) {
    std::fill_n(at(numbers_, plane * free_.size() + first), size, 0);
  }
  flat_ ? copy_level(grid) : copy_levels(grid, outer);
}

/// The free cells of the single level.
void BitWave::copy_level(const OccupancyGrid& grid) {
  for (int ix = 0; ix < inner_; ++ix) {
    const std::uint64_t* column = grid.column(ix, 0) + (lowest_ >> 6);
    for (int word = 0; word < words_; ++word) {
      const int lines = std::min(64, ny_ - 64 * word);
      std::uint64_t bits = 0;
      for (int line = 0; line < lines; ++line, column += grid.words_per_column()) {
        bits |= (~*column >> (lowest_ & 63) & 1u) << line;
      }
      free_[begin_of(column_of(0, word)) + ix] = bits;
    }
  }
}

/// The free cells of all levels over one x.
void BitWave::copy_levels(const OccupancyGrid& grid, int ix) {
  std::array<std::uint64_t, 64> block;
  for (int word = 0; word < words_; ++word) {
    const int lines = std::min(64, ny_ - 64 * word);
    for (int done = 0; done < inner_;) {
      const int level = lowest_ + done;
      const int count = std::min(inner_ - done, 64 - (level & 63));
      for (int line = 0; line < lines; ++line) {
        block[line] = ~grid.column(ix, 64 * word + line)[level >> 6] >> (level & 63);
      }
      std::fill(block.begin() + lines, block.end(), 0);
      transpose(block);
      std::copy_n(block.begin(), count, free_.data() + begin_of(column_of(ix, word)) + done);
      done += count;
    }
  }
}

BitWave::Pattern BitWave::pattern(int generation) const {
  Pattern steps{};
  steps.x = passes(rate_[0], generation);
  steps.y = passes(rate_[1], generation);
  steps.z = !flat_ && passes(rate_[2], generation);
  steps.diagonal = steps.x && steps.y && passes(kDiagonalShare, generation);
  return steps;
}

/// Collects in `added_` what one generation reaches.
void BitWave::spread(const Pattern& steps) {
  const auto mask = [](bool taken) { return taken ? ~std::uint64_t{0} : 0; };
  const std::size_t next = words_ + 2;  // columns to the next along the outer axis
  const std::ptrdiff_t y = inner_ + 2;
  const std::ptrdiff_t far = static_cast<std::ptrdiff_t>(next) * y;
  const wave::Kernels& kernels = wave::kernels();
  touched_.clear();
  const int last = std::min(reached_high_ + 1, outer_ - 1);
  for (int outer = std::max(reached_low_ - 1, 0); outer <= last; ++outer) {
    for (int word = 0; word < words_; ++word) {
      const std::size_t column = column_of(outer, word);
      if (full_[column]) continue;
      Extent places = extents_[column];
      for (const std::size_t other : {column - 1, column + 1, column - next, column + next}) {
        places.low = std::min(places.low, extents_[other].low);
        places.high = std::max(places.high, extents_[other].high);
      }
      if (places.low > places.high) continue;
      places = {std::max(places.low - 1, 0), std::min(places.high + 1, inner_ - 1)};
      const std::size_t first = begin_of(column) + places.low;
      const wave::Words words{free_.data() + first, reached_.data() + first,     flat_ ? 1 : far, y,
                              flat_ ? far : 1,      places.high - places.low + 1};
      const std::uint64_t waiting = kernels.spread_straight(words, mask(steps.x), mask(steps.y),
                                                            mask(steps.z), added_.data() + first);
      if (waiting == 0) {
        full_[column] = words.count == inner_;
        continue;
      }
      if (steps.diagonal) kernels.spread_diagonally(words, added_.data() + first);
      touched_.push_back({column, places});
    }
  }
}

/// Marks what was added; returns how many cells.
std::int64_t BitWave::settle(int generation) {
  const wave::Kernels& kernels = wave::kernels();
  std::int64_t cells = 0;
  for (const auto& [column, places] : touched_) {
    const std::size_t first = begin_of(column) + places.low;
    const int count = places.high - places.low + 1;
    const std::uint64_t* const added = added_.data() + first;
    const std::int64_t here = kernels.take(added, count, reached_.data() + first);
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
    extent.low = std::min(extent.low, places.low + low);
    extent.high = std::max(extent.high, places.low + high);
    const int outer = static_cast<int>(column / (words_ + 2)) - 1;
    reached_low_ = std::min(reached_low_, outer);
    reached_high_ = std::max(reached_high_, outer);
  }
  return cells;
}

PlanStatus BitWave::run(const OccupancyGrid& grid, const LevelRange& levels, const Cell& from,
                        const Cell& to, BudgetWatch& budget, SearchStats& stats) {
  begin(grid, levels);
  const auto bit_of = [](const Cell& cell) { return std::uint64_t{1} << (cell.y() & 63); };
  const auto reached = [&](const Cell& cell) {
    const int outer = outer_of(cell);
    const bool prepared = outer >= prepared_low_ && outer <= prepared_high_;
    return prepared && (reached_[word_of(cell)] & bit_of(cell)) != 0;
  };
  reached_low_ = reached_high_ = outer_of(from);
  prepare(grid, reached_low_ - 2, reached_high_ + 2);
  added_[word_of(from)] = bit_of(from);
  const int place = inner_of(from);
  touched_.assign(1, {column_of(reached_low_, from.y() >> 6), {place, place}});
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

}  // namespace ltp::planning
