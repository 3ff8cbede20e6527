// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The inner loops of `BitWave`, for registers of several widths.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ltp::planning::wave {

/// A stretch of words of a column, and how far it is from each to the next along x, y and z.
struct Words {
  const std::uint64_t* free;
  const std::uint64_t* reached;
  std::ptrdiff_t x, y, z;
  int count;
};

struct Kernels {
  /// A step along each axis whose mask is not 0. Returns what may still be reached, or'ed.
  std::uint64_t (*spread_straight)(const Words& words, std::uint64_t along_x, std::uint64_t along_y,
                                   std::uint64_t along_z, std::uint64_t* added);
  /// Adds a diagonal step of the plane: both cells that it squeezes past must be free.
  void (*spread_diagonally)(const Words& words, std::uint64_t* added);
  /// Marks what was added. Returns how many bits.
  std::int64_t (*take)(const std::uint64_t* added, int count, std::uint64_t* reached);
};

/// Those for the registers in use, see `Vectors`.
const Kernels& kernels();

}  // namespace ltp::planning::wave
