// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/penalty_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ltp {
PenaltyBound::PenaltyBound(const PenaltyWeights& weights, double direct_length,
                           double most_priority)
    : per_metre_(weights.length / direct_length),
      priority_weight_(weights.priority),
      ratio_(per_metre_ / weights.priority),
      least_length_(direct_length),
      most_priority_(most_priority),
      least_alpha_(most_priority + kReserve) {}

/// No path of this length has a larger mean priority.
double PenaltyBound::mean_priority_at(double length) const {
  double mean = most_priority_;
  for (const Constraint& constraint : constraints_) {
    mean = std::min(mean, constraint.alpha - constraint.least_cost / length);
  }
  return mean;
}

double PenaltyBound::at(double length) const {
  return per_metre_ * length - priority_weight_ * mean_priority_at(length);
}

PenaltyBound::Point PenaltyBound::lowest() const {
  // Each constraint alone, a L - b alpha + b C / L, is convex in L (C >= 0: every step costs
  // something), and so is the largest of them. Beyond `high` the length term alone is worse than
  // the bound at L_least.
  double low = least_length_;
  double high = least_length_;
  if (per_metre_ > 0.0) {
    high = std::max(low, (at(low) + priority_weight_ * most_priority_) / per_metre_);
  } else {
    for (const Constraint& constraint : constraints_) {  // W_L = 0: every constraint falls with L
      high = std::max(high, 1e6 * constraint.least_cost);
    }
  }
  for (int i = 0; i < 200 && high - low > 1e-12 * high; ++i) {
    const double third = (high - low) / 3.0;
    if (at(low + third) <= at(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  // The interval holds the minimum; its ends are within rounding of it.
  const double length = 0.5 * (low + high);
  const double slack = 1e-9 * (1.0 + std::abs(at(length)));
  double value = std::min({at(low), at(length), at(high)}) - slack;
  // For W_L = 0 the bound is approached, not reached, as L grows.
  if (per_metre_ == 0.0) value = -priority_weight_ * most_priority_;
  return {value, length, alpha_at(length, mean_priority_at(length))};
}

}  // namespace ltp
