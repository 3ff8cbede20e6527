// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/geometry/vectors.hpp"

#include <atomic>

namespace ltp {
namespace {

std::atomic<Vectors>& in_use() {
  static std::atomic<Vectors> vectors = supported(Vectors::Avx512) ? Vectors::Avx512
                                        : supported(Vectors::Avx2) ? Vectors::Avx2
                                                                   : Vectors::Baseline;
  return vectors;
}

}  // namespace

bool supported(Vectors vectors) {
#ifdef __x86_64__
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("popcnt");
  if (vectors == Vectors::Avx2) return avx2;
  if (vectors == Vectors::Avx512) {
    return avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
  }
#endif
  return vectors == Vectors::Baseline;
}

Vectors vectors() { return in_use(); }
void use(Vectors vectors) { in_use() = vectors; }

}  // namespace ltp
