// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `PenaltyBound`: what additive searches prove about Eq. (5).
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "ltp/cost/penalty.hpp"

namespace ltp::planning {

/// After a search with the cost alpha L - P whose least value was C, every path satisfies P <=
/// alpha L - C. With several such constraints, Eq. (5) is nowhere below
///     min over L >= L_least of  a L - b min(p_max, min_i(alpha_i - C_i / L)),   a = W_L /
///     L_direct, b = W_P,
/// L_least being L_direct until a longer one is known.
class PenaltyBound {
 public:
  /// @param max_priority  the largest priority anywhere, >= 0
  PenaltyBound(const PenaltyWeights& weights, double direct_length, double max_priority)
      : PenaltyBound(weights, direct_length, max_priority, direct_length) {}
  /// @param least_length  no path is shorter [m]: less than L_direct where the goal is a region
  PenaltyBound(const PenaltyWeights& weights, double direct_length, double max_priority,
               double least_length);

  void add(double alpha, double min_cost) { constraints_.push_back({alpha, min_cost}); }
  /// No path is shorter [m].
  void add_min_length(double length) { min_length_ = std::max(min_length_, length); }
  /// No path has a larger mean priority, and none leads over ground of a larger one.
  void set_max_priority(double most) {
    max_priority_ = most;
    min_alpha_ = most + kReserve;
  }
  double max_priority() const { return max_priority_; }
  /// No path with a penalty below this one is longer [m].
  double longest_below(double penalty) const {
    if (penalty_.per_metre() == 0.0) return std::numeric_limits<double>::infinity();
    return (penalty + penalty_.weights().priority * max_priority_) / penalty_.per_metre();
  }

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
  double min_alpha() const { return min_alpha_; }

 private:
  static constexpr double kReserve = 1e-3;  ///< steps over the best ground still cost this a metre

  struct Constraint {
    double alpha;
    double min_cost;
  };
  double mean_priority_at(double length) const;
  double at(double length) const;

  Penalty penalty_;
  double ratio_;       ///< a / b [1/m]
  double min_length_;  ///< [m]
  double max_priority_;
  double min_alpha_;
  std::vector<Constraint> constraints_;
};

}  // namespace ltp::planning
