// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/padded_columns.hpp"

#include "ltp/geometry/check.hpp"

namespace ltp::planning {
namespace {

/// 64 levels of a column from `first` on, which may lie below it; those beyond are set.
std::uint64_t bits_from(const std::uint64_t* column, int words, int first) {
  const auto word = [&](int w) { return w >= 0 && w < words ? column[w] : ~std::uint64_t{0}; };
  const int w = first >= 0 ? first / 64 : -1;
  const int shift = first - 64 * w;
  return shift == 0 ? word(w) : word(w) >> shift | word(w + 1) << (64 - shift);
}

}  // namespace

void PaddedColumns::reset(const OccupancyGrid& grid, const LevelRange& levels) {
  const GridFrame& frame = grid.frame();
  const double size = (frame.nx() + 2.0) * (frame.ny() + 2.0) * frame.nz();
  if (!(size < 0x1p32)) check::fail("grid", size, "fewer than 2^32 cells with those round it");
  row_ = static_cast<std::uint32_t>(frame.ny()) + 2;
  columns_ = (static_cast<std::uint32_t>(frame.nx()) + 2) * row_;
  lowest_ = levels.lowest;
  depth_ = static_cast<std::uint32_t>(levels.count());
  per_column_ = (depth_ - 1) / kLevels + 1;
  words_.assign(std::size_t{columns_} * per_column_, ~std::uint64_t{0});
  for (std::uint32_t w = 0; w < per_column_; ++w) {
    // Bit 0 is the level under the word's first; outside the levels all is blocked.
    std::uint64_t outside = w == 0 ? 1 : 0;
    const std::uint32_t left = depth_ - w * kLevels;
    if (left < 63) outside |= ~std::uint64_t{0} << (left + 1);
    const int first = lowest_ + static_cast<int>(w * kLevels) - 1;
    for (int ix = 0; ix < frame.nx(); ++ix) {
      std::uint64_t* words = words_.data() + (std::size_t{row_} * (ix + 1) + 1) * per_column_ + w;
      for (int iy = 0; iy < frame.ny(); ++iy, words += per_column_) {
        *words = bits_from(grid.column(ix, iy), grid.words_per_column(), first) | outside;
      }
    }
  }
  find_open();
}

void PaddedColumns::find_open() {
  open_.assign(size() / 64 + 2, 0);
  const std::ptrdiff_t across = std::ptrdiff_t{row_} * per_column_;
  for (std::uint32_t column = row_ + 1; column < columns_ - row_ - 1; ++column) {
    const std::uint64_t* middle = words_.data() + std::size_t{column} * per_column_;
    for (std::uint32_t level = 0; level < depth_; level += kLevels, ++middle) {
      std::uint64_t near = 0;
      for (std::ptrdiff_t dx = -across; dx <= across; dx += across) {
        near |= middle[dx - per_column_] | middle[dx] | middle[dx + per_column_];
      }
      near = (near << 1 | near | near >> 1) >> 1;
      const std::uint32_t count = std::min(depth_ - level, kLevels);
      const std::uint64_t open = ~near & ((std::uint64_t{1} << count) - 1);
      const std::uint32_t index = column * depth_ + level;
      open_[index >> 6] |= open << (index & 63);
      if ((index & 63) != 0) open_[(index >> 6) + 1] |= open >> (64 - (index & 63));
    }
  }
}

}  // namespace ltp::planning
