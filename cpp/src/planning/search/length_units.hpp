// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `LengthUnits`: lengths as whole numbers, so that sums are exact in any order.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "ltp/grid/frame.hpp"
#include "ltp/grid/neighbourhood.hpp"

namespace ltp::planning {

/// A unit is a power of two of a metre. Of the many paths made of the same steps none seems shorter
/// than another, which is what pruning by ties needs.
class LengthUnits {
 public:
  /// Lengths have so many bits; what is left of 64 holds how a cell was reached.
  static constexpr int kBits = 58;
  static constexpr std::uint64_t kMost = (std::uint64_t{1} << kBits) - 1;

  /// @param longest  that must fit [m]
  explicit LengthUnits(double longest)
      : per_metre_(std::exp2(std::min(std::floor(kBits - 1 - std::log2(longest)), 1000.0))) {}

  /// At least one unit, so that every step costs something.
  std::uint64_t operator()(double metres) const {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(metres * per_metre_ + 0.5));
  }
  double metres(std::uint64_t units) const { return static_cast<double>(units) / per_metre_; }

  std::array<std::uint64_t, kSteps> of_steps(const Point& cell) const {
    std::array<std::uint64_t, kSteps> units{};
    const std::array<double, kSteps> lengths = step_lengths(cell);
    std::transform(lengths.begin(), lengths.end(), units.begin(), *this);
    return units;
  }

  /// Lengths [m] that no path exceeds: in all but a maze (units of some 1e-14 m in a window of some
  /// 100 m), and in any.
  static std::array<double, 2> longest(const GridFrame& frame) {
    const Point extent = Point(frame.nx(), frame.ny(), frame.nz()).cwiseProduct(frame.cell());
    return {4.0 * extent.sum(), static_cast<double>(frame.size()) * frame.cell().norm()};
  }

 private:
  double per_metre_;
};

}  // namespace ltp::planning
