// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `PenaltyBound`: what additive searches prove about Eq. (5).
#pragma once

#include <vector>

#include "ltp/cost/penalty.hpp"

namespace ltp {

/// After a search with the cost alpha L - P whose least value was C, every path satisfies P <=
/// alpha L - C. With several such constraints, Eq. (5) is nowhere below
///     min over L >= L_direct of  a L - b min(p_max, min_i(alpha_i - C_i / L)),   a = W_L /
///     L_direct, b = W_P.
class PenaltyBound {
 public:
  /// @param most_priority  the largest priority anywhere, >= 0
  PenaltyBound(const PenaltyWeights& weights, double direct_length, double most_priority);

  void add(double alpha, double least_cost) { constraints_.push_back({alpha, least_cost}); }

  /// Where the bound lies, and the slope of the penalty there.
  struct Point {
    double value;   ///< no path has a smaller penalty
    double length;  ///< L at which the bound is taken on [m]
    double alpha;   ///< the factor that linearises Eq. (5) there
  };
  Point lowest() const;

  /// The factor that linearises Eq. (5) at a path.
  double alpha_at(double length, double mean_priority) const {
    return mean_priority + ratio_ * length;
  }
  /// Above it every step costs something.
  double least_alpha() const { return least_alpha_; }

 private:
  struct Constraint {
    double alpha;
    double least_cost;
  };
  double mean_priority_at(double length) const;
  double at(double length) const;

  double per_metre_;        ///< a
  double priority_weight_;  ///< b
  double ratio_;            ///< a / b [1/m]
  double direct_length_;
  double most_priority_;
  double least_alpha_;
  std::vector<Constraint> constraints_;
};

}  // namespace ltp
