// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/cost/penalty.hpp"

#include <cmath>

#include "ltp/geometry/check.hpp"
#include "ltp/geometry/norm.hpp"

namespace ltp {

void PenaltyWeights::check() const {
  check::not_negative("weights.length", length);
  check::not_negative("weights.priority", priority);
  if (length + priority == 0.0) {
    check::fail("weights.length + weights.priority", 0.0, "at least one weight above 0");
  }
}

PathTally tally(const PathRef& path, const Raster& priority) {
  PathTally sum;
  for (Eigen::Index i = 1; i < path.rows(); ++i) {
    const Point a = path.row(i - 1).transpose();
    const Point b = path.row(i).transpose();
    sum.length += norm(b - a);                // Eq. (2)
    sum.priority += priority.integral(a, b);  // Eq. (4), numerator
  }
  if (!std::isfinite(sum.length) || !std::isfinite(sum.priority)) {
    check::fail("length of the path", sum.length, "a finite number, and a finite integral");
  }
  return sum;
}

Penalty::Penalty(const PenaltyWeights& weights, double direct_length)
    : weights_(weights),
      direct_length_(direct_length),
      per_metre_(direct_length > 0.0 ? weights.length / direct_length : 0.0) {
  weights.check();
  check::not_negative("direct_length", direct_length);
}

double Penalty::operator()(double length, double priority_integral, double point_priority) const {
  const double ratio = direct_length_ > 0.0 ? length / direct_length_ : 1.0;       // Eq. (3)
  const double mean = length > 0.0 ? priority_integral / length : point_priority;  // -Eq. (4)
  return weights_.length * ratio - weights_.priority * mean;                       // Eq. (5)
}

}  // namespace ltp
