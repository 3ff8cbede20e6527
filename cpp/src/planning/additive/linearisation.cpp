// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/linearisation.hpp"

#include <algorithm>

namespace ltp::planning {
namespace {

// A path this much longer than the direct one, over ground this good. On the paper's maps at its
// operating point the exact optima lie near by, and a wrong guess costs little.
constexpr double kLikelyDetour = 1.1;
constexpr double kLikelyPriority = 0.75;
// Where steps over the best ground cost next to nothing a search wanders all over it, and a first
// search cannot be cut short.
constexpr double kLeastFirst = 1.1;

}  // namespace

double first_alpha(const PenaltyBound& bound, double direct_length, double max_priority,
                   double fixed) {
  if (fixed > 0.0) return std::max(fixed, bound.min_alpha());
  const double likely =
      bound.alpha_at(kLikelyDetour * direct_length, kLikelyPriority * max_priority);
  return std::max({likely, kLeastFirst * max_priority, bound.min_alpha()});
}

}  // namespace ltp::planning
