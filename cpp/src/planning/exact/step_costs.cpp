// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/exact/step_costs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ltp::planning {

void StepCosts::reset(const Problem& problem, double longest) {
  const GridFrame& frame = problem.frame();
  start_cell_ = problem.start;
  goal_cell_ = problem.goal;
  priority_.reset(frame, problem.scene.priority);
  level_lengths_.reset(problem);
  lattice_ = step_lengths(frame.cell());
  lengths_ = lattice_;
  max_priority_ = priority_(0, 0);
  double least_priority = max_priority_;
  for (int ix = 0; ix < frame.nx(); ++ix) {
    for (int iy = 0; iy < frame.ny(); ++iy) {
      max_priority_ = std::max(max_priority_, priority_(ix, iy));
      least_priority = std::min(least_priority, priority_(ix, iy));
    }
  }
  // First length and priority integral of the steps at the ends, then their loss.
  for (const bool at_start : {true, false}) {
    const Cell from = at_start ? problem.start : problem.goal;
    const Point here = problem.point_of(from);
    for (int i = 0; i < kSteps; ++i) {
      const Cell to = from + steps()[i].offset();
      const Point there = problem.point_of(to);
      StepCost& cost = (at_start ? from_start_ : from_goal_)[i];
      cost = {(there - here).norm(), problem.scene.priority.integral(here, there)};
      if (cost.length > 0.0 && frame.contains(to)) {
        max_priority_ = std::max(max_priority_, cost.loss / cost.length);
      }
    }
  }
  // Adding and taking off 1.5 * 2^k rounds to multiples of 2^(k - 52): sums below 2^k are exact.
  const double largest = longest * std::max(1.0, max_priority_ - least_priority);
  const double magnitude = std::exp2(std::ilogb(std::max(largest, 1e-100)) + 2);
  magic_ = 1.5 * magnitude;
  unit_ = magnitude * std::numeric_limits<double>::epsilon();
  for (double& length : lengths_) length = rounded(length);
  for (auto* ends : {&from_start_, &from_goal_}) {
    for (StepCost& cost : *ends) {
      const double length = rounded(cost.length);
      cost = {length, std::max(0.0, rounded(max_priority_ * cost.length - cost.loss))};
    }
  }
}

StepCost StepCosts::operator()(const Cell& from, int step) const {
  const Step& by = steps()[step];
  const Cell to = from + by.offset();
  if (from == start_cell_) return from_start_[step];
  if (to == start_cell_) return from_start_[by.opposite];
  if (from == goal_cell_) return from_goal_[step];
  if (to == goal_cell_) return from_goal_[by.opposite];
  return between(level_lengths_.from(from.z())[step], priority_(from.x(), from.y()),
                 priority_(to.x(), to.y()));
}

StepCost StepCosts::along(const std::vector<Cell>& chain) const {
  StepCost sum;
  for (std::size_t i = 1; i < chain.size(); ++i) {
    sum = sum + (*this)(chain[i - 1], step_between(chain[i - 1], chain[i]));
  }
  return sum;
}

}  // namespace ltp::planning
