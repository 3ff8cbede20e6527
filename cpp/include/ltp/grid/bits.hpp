// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What is done with the words of bit columns.
#pragma once

#include <algorithm>
#include <cstdint>
#include <type_traits>

namespace ltp {

/// The bits of word `w` of a column that are levels in [low, high], both ends included.
inline std::uint64_t bits_between(int w, int low, int high) {
  const int from = std::max(low - 64 * w, 0);
  const int to = std::min(high - 64 * w, 63);
  if (from > to) return 0;
  return (~std::uint64_t{0} >> (63 - (to - from))) << from;
}

/// The same of all words of a column.
inline void fill_between(std::uint64_t* column, int words, int low, int high) {
  for (int w = 0; w < words; ++w) column[w] = bits_between(w, low, high);
}

/// Calls `visit(number)` for every bit of a word that is set, the lowest first.
template <typename Word, typename Visitor>
inline void for_each_bit(Word word, Visitor&& visit) {
  static_assert(std::is_unsigned_v<Word>);
  for (; word != 0; word &= word - 1) visit(__builtin_ctzll(word));
}

/// The number of the highest bit that is set; `value` is not 0.
inline int floor_log2(std::uint64_t value) { return 63 - __builtin_clzll(value); }

/// The first word in [from, to) that is not zero; `to` if there is none. Most of a map is empty.
inline std::int64_t next_in_use(const std::uint64_t* words, std::int64_t from, std::int64_t to) {
  using Pair = std::uint64_t __attribute__((vector_size(16), aligned(8), may_alias));
  for (; from + 8 <= to; from += 8) {
    const Pair* pairs = reinterpret_cast<const Pair*>(words + from);
    const Pair any = pairs[0] | pairs[1] | pairs[2] | pairs[3];
    if ((any[0] | any[1]) != 0) break;
  }
  while (from < to && words[from] == 0) ++from;
  return from;
}

}  // namespace ltp
