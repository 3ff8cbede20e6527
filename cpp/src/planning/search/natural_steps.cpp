// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/natural_steps.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>

namespace ltp::planning {
namespace {

bool is_near(const Cell& cell) { return cell.cwiseAbs().maxCoeff() <= 1; }

/// The cells that must be free for a step from one cell round a middle to another, as bits round
/// that middle.
std::uint32_t box_round(const Cell& from, const Cell& to) {
  const Cell low = from.cwiseMin(to);
  const Cell high = from.cwiseMax(to);
  std::uint32_t box = 0;
  for (int x = low.x(); x <= high.x(); ++x) {
    for (int y = low.y(); y <= high.y(); ++y) {
      for (int z = low.z(); z <= high.z(); ++z) {
        if (Cell(x, y, z) != from) box |= 1u << neighbour_bit(x, y, z);
      }
    }
  }
  return box;
}

}  // namespace

NaturalSteps::NaturalSteps(const std::array<std::uint64_t, kSteps>& lengths)
    : lengths_(lengths), known_(std::size_t{1} << kKnownBits) {
  const auto bits = [](std::uint32_t box) { return __builtin_popcount(box); };
  for (int i = 0; i < kSteps; ++i) {
    const Cell from = -steps()[i].offset();
    for (int j = 0; j < kSteps; ++j) {
      const Cell to = steps()[j].offset();
      const std::uint64_t length = lengths[i] + lengths[j];
      const auto is_better = [&](std::uint64_t other, int last) {
        return other < length || (other == length && last < j);
      };
      const std::size_t begin = better_.size();
      const int direct = step_by(to - from);
      if (to == from) better_.push_back(0);  // back again
      if (direct != kNoStep && is_better(lengths[direct], direct)) {
        better_.push_back(box_round(from, to));
      }
      for (int k = 0; k < kSteps; ++k) {
        const Cell middle = from + steps()[k].offset();
        const int last = step_by(to - middle);
        if (!is_near(middle) || last == kNoStep || !is_better(lengths[k] + lengths[last], last)) {
          continue;
        }
        better_.push_back(box_round(from, middle) | box_round(middle, to));
      }
      // Those that need the fewest cells are the likeliest to be there.
      std::sort(better_.begin() + static_cast<std::ptrdiff_t>(begin), better_.end(),
                [&](std::uint32_t a, std::uint32_t b) {
                  return bits(a) != bits(b) ? bits(a) < bits(b) : a < b;
                });
      first_[i * kSteps + j + 1] = static_cast<std::uint32_t>(better_.size());
    }
  }
  for (int i = 0; i <= kSteps; ++i) in_the_open_[i] = find(i, 0);
}

std::uint32_t NaturalSteps::find(int arrived, std::uint32_t blocked) const {
  std::uint32_t natural = 0;
  for (int j = 0; j < kSteps; ++j) {
    if (blocked & steps()[j].box) continue;
    bool better = false;
    if (arrived != kRoot) {
      const std::uint32_t* const pair = first_.data() + arrived * kSteps + j;
      better = std::any_of(better_.begin() + pair[0], better_.begin() + pair[1],
                           [&](std::uint32_t box) { return (blocked & box) == 0; });
    }
    if (!better) natural |= 1u << j;
  }
  return natural;
}

}  // namespace ltp::planning
