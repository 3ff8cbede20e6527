// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cell_walk.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "column_hit.hpp"
#include "ltp/geometry/vectors.hpp"

#define LTP_INLINE __attribute__((always_inline))
// No vector leaves the function that it was made in, whatever the compiler fears.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace ltp::sensing {
namespace {

constexpr int kCells = 4;  // that a ray is followed here; nearly all that hit have hit by then

namespace baseline {
constexpr int kLanes = 1;  // two gain nothing where a choice takes three instructions
#include "cell_walk_lanes.hpp"
}  // namespace baseline

#ifdef __x86_64__
#ifdef __clang__
#pragma clang attribute push([[gnu::target("avx2")]], apply_to = function)
#else
#pragma GCC push_options
#pragma GCC target("avx2")
#endif
namespace avx2 {
constexpr int kLanes = 4;
#include "cell_walk_lanes.hpp"
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
constexpr int kLanes = 8;
#include "cell_walk_lanes.hpp"
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
  return vectors == Vectors::Avx512 ? avx512::glance_and_walk
         : vectors == Vectors::Avx2 ? avx2::glance_and_walk
                                    : baseline::glance_and_walk;
}

}  // namespace

int glance_and_walk(const BundleStart& from, const Panorama& panorama, Panorama::Rays& rays,
                    int count, RayEnds& ends) {
  return compiled_for(vectors())(from, panorama, rays, count, ends);
}

}  // namespace ltp::sensing
