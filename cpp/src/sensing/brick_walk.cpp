// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "brick_walk.hpp"

#include <cmath>
#include <cstring>
#include <limits>

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include "ltp/geometry/vectors.hpp"
#include "ltp/grid/ray_walk.hpp"

#define LTP_INLINE __attribute__((always_inline))
// No vector leaves the function that it was made in, whatever the compiler fears.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace ltp::sensing {
namespace {

namespace baseline {
#define LTP_LANES 1
#include "brick_walk_lanes.hpp"
#undef LTP_LANES
}  // namespace baseline

#ifdef __x86_64__
#ifdef __clang__
#pragma clang attribute push([[gnu::target("avx2")]], apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace avx2 {
#define LTP_LANES 4
#include "brick_walk_lanes.hpp"
#undef LTP_LANES
}  // namespace avx2
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif

#ifdef __clang__
#pragma clang attribute push([[gnu::target("avx512f,avx512dq,avx512vl")]], apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")
#endif
namespace avx512 {
#define LTP_LANES 8
#include "brick_walk_lanes.hpp"
#undef LTP_LANES
}  // namespace avx512
#ifdef __clang__
#pragma clang attribute pop
#else
#pragma GCC pop_options
#endif
#else
namespace avx2 = baseline;
namespace avx512 = baseline;
#endif

auto* compiled_for(Vectors vectors) {
  return vectors == Vectors::Avx512 ? avx512::walk_all
         : vectors == Vectors::Avx2 ? avx2::walk_all
                                    : baseline::walk_all;
}

}  // namespace

void walk_bricks(const BrickStart& start, BrickRays& rays, int count) {
  compiled_for(vectors())(start, rays, count);
}

void walk_bricks_of_one(const BrickStart& start, BrickRays& rays) {
  baseline::walk_all(start, rays, 1);
}

}  // namespace ltp::sensing
