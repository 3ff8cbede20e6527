// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Random numbers by counting: a ray's noise depends on its number only, not on who asked before.
#pragma once

#include <cmath>
#include <cstdint>

namespace ltp::sensing {

/// Finaliser of SplitMix64 (Steele, Lea, Flood: "Fast splittable pseudorandom number generators",
/// OOPSLA 2014): every input bit reaches every output bit.
inline std::uint64_t mix(std::uint64_t word) {
  word = (word ^ (word >> 30)) * 0xbf58476d1ce4e5b9u;
  word = (word ^ (word >> 27)) * 0x94d049bb133111ebu;
  return word ^ (word >> 31);
}

/// The random numbers of one ray of one scan.
class RayNoise {
 public:
  RayNoise(std::uint64_t seed, std::uint64_t sequence, std::uint64_t ray)
      : key_(mix(mix(mix(seed + kStep) ^ (sequence + kStep)) ^ (ray + kStep))) {}

  /// Uniform in [0, 1).
  double uniform(std::uint64_t which) const {
    return static_cast<double>(mix(key_ + which * kStep) >> 11) * 0x1p-53;
  }

  /// Standard normal, by Box and Muller: unlike `std::normal_distribution`, the same in every
  /// standard library.
  double normal(std::uint64_t which) const {
    constexpr double kTurn = 6.283185307179586;
    return std::sqrt(-2.0 * std::log1p(-uniform(2 * which))) *
           std::cos(kTurn * uniform(2 * which + 1));
  }

 private:
  static constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15u;  // the golden ratio
  std::uint64_t key_;
};

}  // namespace ltp::sensing
