// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/penalty_bound.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ltp::planning {

PenaltyBound::PenaltyBound(const PenaltyWeights& weights, double direct_length, double max_priority,
                           double least_length)
    : penalty_(weights, direct_length),
      ratio_(penalty_.per_metre() / weights.priority),
      min_length_(least_length),
      max_priority_(max_priority),
      min_alpha_(max_priority + kReserve) {}

/// No path of this length has a larger mean priority.
double PenaltyBound::mean_priority_at(double length) const {
  double mean = max_priority_;
  for (const Constraint& constraint : constraints_) {
    mean = std::min(mean, constraint.alpha - constraint.min_cost / length);
  }
  return mean;
}

double PenaltyBound::at(double length) const {
  return penalty_.at(length, mean_priority_at(length));
}

PenaltyBound::Point PenaltyBound::lowest() const {
  const double per_metre = penalty_.per_metre();
  const double priority_weight = penalty_.weights().priority;
  // Each constraint alone, a L - b alpha + b C / L, is convex in L (C >= 0: every step costs
  // something), and so is the largest of them. Beyond `high` the length term alone is worse than
  // the bound at L_least.
  double low = min_length_;
  double high = min_length_;
  if (per_metre > 0.0) {
    high = std::max(low, (at(low) + priority_weight * max_priority_) / per_metre);
  } else {
    for (const Constraint& constraint : constraints_) {  // W_L = 0: every constraint falls with L
      high = std::max(high, 1e6 * constraint.min_cost);
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
  if (per_metre == 0.0) value = -priority_weight * max_priority_;
  return {value, length, alpha_at(length, mean_priority_at(length))};
}

}  // namespace ltp::planning
