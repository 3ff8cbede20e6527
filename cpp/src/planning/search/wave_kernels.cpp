// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/wave_kernels.hpp"

#include <initializer_list>

#include "ltp/geometry/vectors.hpp"

namespace ltp::planning::wave {
namespace {

// Inlined into a function for wide registers, a loop is compiled for these.
#define LTP_INLINE inline __attribute__((always_inline))

/// A row's bits moved by one cell to either side, both or'ed.
LTP_INLINE std::uint64_t beside(std::uint64_t before, std::uint64_t here, std::uint64_t after) {
  return here << 1 | before >> 63 | here >> 1 | after << 63;
}

LTP_INLINE std::uint64_t straight(const Words& words, std::uint64_t along_x, std::uint64_t along_y,
                                  std::uint64_t along_z, std::uint64_t* added) {
  const auto [free, at, x, y, z, count] = words;
  std::uint64_t any = 0;
  for (int i = 0; i < count; ++i) {
    const std::uint64_t grown = (beside(at[i - y], at[i], at[i + y]) & along_y) |
                                ((at[i - z] | at[i + z]) & along_z) |
                                ((at[i - x] | at[i + x]) & along_x);
    const std::uint64_t waiting = free[i] & ~at[i];
    any |= waiting;
    added[i] = grown & waiting;
  }
  return any;
}

LTP_INLINE void diagonally(const Words& words, std::uint64_t* added) {
  const std::uint64_t* const free = words.free;
  const std::ptrdiff_t y = words.y;
  for (const std::ptrdiff_t x : {-words.x, words.x}) {
    const std::uint64_t* const other = words.reached + x;
    for (int i = 0; i < words.count; ++i) {
      const std::uint64_t waiting = free[i] & ~words.reached[i];
      added[i] |=
          beside(other[i - y] & free[i - y], other[i] & free[i], other[i + y] & free[i + y]) &
          free[i + x] & waiting;
    }
  }
}

LTP_INLINE std::int64_t mark(const std::uint64_t* added, int count, std::uint64_t* reached) {
  std::int64_t bits = 0;
  for (int i = 0; i < count; ++i) {
    reached[i] |= added[i];
    bits += __builtin_popcountll(added[i]);
  }
  return bits;
}

/// A struct of the three loops, compiled with an attribute.
#define LTP_VARIANT(NAME, ATTRIBUTE)                                                    \
  struct NAME {                                                                         \
    ATTRIBUTE static std::uint64_t spread_straight(const Words& words, std::uint64_t x, \
                                                   std::uint64_t y, std::uint64_t z,    \
                                                   std::uint64_t* added) {              \
      return straight(words, x, y, z, added);                                           \
    }                                                                                   \
    ATTRIBUTE static void spread_diagonally(const Words& words, std::uint64_t* added) { \
      diagonally(words, added);                                                         \
    }                                                                                   \
    ATTRIBUTE static std::int64_t take(const std::uint64_t* added, int count,           \
                                       std::uint64_t* reached) {                        \
      return mark(added, count, reached);                                               \
    }                                                                                   \
    static constexpr Kernels kernels{spread_straight, spread_diagonally, take};         \
  }

LTP_VARIANT(Baseline, );
#ifdef __x86_64__
LTP_VARIANT(Avx2, __attribute__((target("avx2,popcnt"))));
LTP_VARIANT(Avx512, __attribute__((target("avx512f,popcnt"))));
#endif

}  // namespace

const Kernels& kernels() {
#ifdef __x86_64__
  if (vectors() == Vectors::Avx512) return Avx512::kernels;
  if (vectors() == Vectors::Avx2) return Avx2::kernels;
#endif
  return Baseline::kernels;
}

}  // namespace ltp::planning::wave
