// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `StepCosts`: what each step of a query's graph costs, as a length and a loss of priority.
#pragma once

#include <array>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/column_priority.hpp"
#include "planning/search/level_lengths.hpp"

namespace ltp::planning {

/// Of a step or a path; both are never negative.
struct StepCost {
  double length = 0.0;  ///< L [m]
  double loss = 0.0;    ///< R, the integral of (p_max - p) dl [m]
};

inline StepCost operator+(const StepCost& a, const StepCost& b) {
  return {a.length + b.length, a.loss + b.loss};
}

/// The graph is the planners' own: 26 steps between the vertices, with start and goal themselves in
/// place of the centres of their cells; a step at either end is tallied exactly.
///
/// Costs are rounded to a fixed power of two, so that sums do not depend on the order of their
/// terms: of the many paths made of the same steps, none seems better than another.
class StepCosts {
 public:
  /// @param longest  no path of interest is longer [m]; fixes the rounding
  void reset(const Problem& problem, double longest);

  /// Of the step number `step` away from a cell. The cells of both ends must be in the grid.
  StepCost operator()(const Cell& from, int step) const;
  /// Of a chain of neighbouring cells, start ... goal.
  StepCost along(const std::vector<Cell>& chain) const;
  /// Between the centres of two columns.
  StepCost between(double length, double priority_a, double priority_b) const {
    length = rounded(length);
    return {length, rounded(length * (max_priority_ - 0.5 * (priority_a + priority_b)))};
  }

  double priority(int ix, int iy) const { return priority_(ix, iy); }
  /// To a multiple of this all costs are rounded.
  double unit() const { return unit_; }
  /// p_max, the largest mean priority of any step.
  double max_priority() const { return max_priority_; }
  /// Of the steps on the lattice.
  const std::array<double, kSteps>& lengths() const { return lengths_; }
  /// Whether a step between two vertices is as long as on the lattice.
  bool on_lattice(const Cell& from, int step) const {
    return level_lengths_.from(from.z())[step] == lattice_[step];
  }

 private:
  double rounded(double value) const { return (value + magic_) - magic_; }

  Cell start_cell_ = Cell::Zero();
  Cell goal_cell_ = Cell::Zero();
  ColumnPriority priority_;
  double max_priority_ = 0.0;
  double unit_ = 0.0;
  double magic_ = 0.0;
  LevelLengths level_lengths_;
  std::array<double, kSteps> lattice_{};  ///< lengths on the lattice
  std::array<double, kSteps> lengths_{};  ///< the same, rounded
  std::array<StepCost, kSteps> from_start_{};
  std::array<StepCost, kSteps> from_goal_{};
};

}  // namespace ltp::planning
