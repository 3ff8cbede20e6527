// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `NaturalSteps`: which steps from a cell a search for shortest paths need not take.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"

namespace ltp::planning {

/// Canonical ordering (Sturtevant and Rabin 2016; jump point search, Harabor and Grastien 2011) for
/// cells of any edges and any obstacles. A cell p was reached from a by step i. Its step j to n is
/// dropped where another way from a to n, of one or two steps among the cells round p, is shorter,
/// or as long and ends with a lower step.
///
/// No cell's distance suffers: of all shortest paths to it take the one whose last step is lowest,
/// then whose step before is, and so on. If it had a dropped step, the other way would give a
/// better one. A search must therefore keep, of the steps that reach a cell at the same length, the
/// lowest, and lengths must be exact.
class NaturalSteps {
 public:
  /// No step led to the cell: all legal ones are taken.
  static constexpr int kRoot = kSteps;

  /// @param lengths  of the steps in any unit
  explicit NaturalSteps(const std::array<std::uint64_t, kSteps>& lengths);

  const std::array<std::uint64_t, kSteps>& lengths() const { return lengths_; }

  /// One bit a step: those to take from a cell that `arrived` led to.
  /// @param blocked  the cells round it, see `blocked_surroundings`
  std::uint32_t after(int arrived, std::uint32_t blocked) {
    blocked &= ~(1u << neighbour_bit(0, 0, 0));
    if (blocked == 0) return in_the_open_[arrived];
    const std::uint32_t key = blocked | static_cast<std::uint32_t>(arrived) << 27;
    Known& known = known_[key * 0x9e3779b1u >> (32 - kKnownBits)];
    if (known.key != key) known = {key, find(arrived, blocked)};
    return known.steps;
  }
  std::uint32_t in_the_open(int arrived) const { return in_the_open_[arrived]; }

 private:
  struct Known {
    std::uint32_t key = 0;  ///< none has this key: nothing would be blocked
    std::uint32_t steps = 0;
  };
  static constexpr int kKnownBits = 13;

  std::uint32_t find(int arrived, std::uint32_t blocked) const;

  std::array<std::uint64_t, kSteps> lengths_;
  /// For each pair of steps, the cells that each better way needs free: [first, next pair's first).
  std::array<std::uint32_t, kSteps * kSteps + 1> first_{};
  std::vector<std::uint32_t> better_;
  std::array<std::uint32_t, kSteps + 1> in_the_open_{};
  std::vector<Known> known_;  ///< by hash; the last one stays
};

}  // namespace ltp::planning
