// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `LevelLengths`: how long the 26 steps are from each level of a query.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "ltp/planning/grid_planner.hpp"

namespace ltp::planning {

/// Between the vertices of a problem. They are those of the lattice but where the band ends within
/// the lowest or the highest level: vertices there keep to the band, so steps up and down are
/// shorter. None is longer than the lattice's.
class LevelLengths {
 public:
  using Lengths = std::array<double, kSteps>;

  void reset(const Problem& problem) {
    lowest_ = problem.levels.lowest;
    stride_ = problem.even() ? 0 : 1;
    const Lengths lattice = step_lengths(problem.frame().cell());
    rows_.assign(stride_ == 0 ? 1 : problem.levels.count(), lattice);
    if (stride_ == 0) return;
    const auto between = [&](int level, int other) {
      return level == other
                 ? 0.0
                 : problem.vertex(Cell(0, 0, other)).z() - problem.vertex(Cell(0, 0, level)).z();
    };
    for (int level = lowest_; level <= problem.levels.highest; ++level) {
      if (is_even_at(problem, level)) continue;
      for (int i = 0; i < kSteps; ++i) {
        const Step& step = steps()[i];
        if (step.dz == 0 || !problem.levels.contains(Cell(0, 0, level + step.dz))) continue;
        const Point by(step.dx * problem.frame().cell().x(), step.dy * problem.frame().cell().y(),
                       between(level, level + step.dz));
        rows_[level - lowest_][i] = by.norm();
      }
    }
  }

  /// Of the steps from the cells of a level [m].
  const Lengths& from(int level) const { return rows_[(level - lowest_) * stride_]; }

  /// Whether all steps from a level, and between its neighbours, are as long as the lattice's.
  static bool is_even_at(const Problem& problem, int level) {
    for (int near = level - 1; near <= level + 1; ++near) {
      if (problem.levels.contains(Cell(0, 0, near)) && !problem.central(near)) return false;
    }
    return true;
  }

 private:
  int lowest_ = 0;
  int stride_ = 0;  ///< 0: all levels are alike
  std::vector<Lengths> rows_;
};

}  // namespace ltp::planning
