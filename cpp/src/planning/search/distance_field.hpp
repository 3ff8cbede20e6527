// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `DistanceField`: the lengths of the shortest paths from one cell to all others.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/bucket_ring.hpp"
#include "planning/search/length_units.hpp"
#include "planning/search/natural_steps.hpp"
#include "planning/search/padded_columns.hpp"

namespace ltp::planning {

/// Dijkstra on the planners' graph, from centre to centre. The open list is a ring of buckets, each
/// as wide as the shortest step: what a bucket holds is final when its turn comes, in any order
/// (Dinitz 1978). Only `NaturalSteps` are taken: in the open, each cell is offered about one way.
class DistanceField {
 public:
  /// From a cell, which counts as free itself, over the free cells of the levels. Adds what it did
  /// to `stats`. Found: complete, or, with `stop_at`, as far as that cell is; Unreachable: that
  /// cell was not reached; OutOfBudget. Throws `std::invalid_argument` if a cell is outside the
  /// frame or the levels, or these are.
  PlanStatus run(const OccupancyGrid& grid, const Cell& source, const LevelRange& levels,
                 BudgetWatch& budget, SearchStats& stats,
                 const std::optional<Cell>& stop_at = std::nullopt);

  /// From the source to a cell of the grid [m]; infinite where none. Where the run was stopped, not
  /// all is final.
  double operator()(const Cell& cell) const;
  /// All distances [m], in the order of `GridFrame::index`.
  void copy_to(double* distances) const;
  /// The cells of the shortest path from a cell that was reached back to the source.
  std::vector<Cell> chain_from(const Cell& cell) const;

 private:
  /// How a cell was reached, the better the less: from the highest bit its distance, the last step
  /// (5 bits), and whether it waits to be expanded.
  using Label = std::uint64_t;
  static constexpr int kTagBits = 64 - LengthUnits::kBits;
  static constexpr Label kTag = (Label{1} << kTagBits) - 1;
  static constexpr Label kBlocked = 0;
  static constexpr Label kNew = ~Label{0};

  static Label label(std::uint64_t length, int step) {
    return length << kTagBits | static_cast<Label>(step) << 1 | 1;
  }
  static int step_of(Label label) { return static_cast<int>(label >> 1 & 31); }
  double metres(Label label) const;

  /// One step as the inner loop wants it.
  struct Move {
    Label add;
    std::int32_t offset;
  };

  void prepare(double longest);
  PlanStatus search(std::uint32_t source, std::uint32_t target, BudgetWatch& budget,
                    SearchStats& stats);

  GridFrame frame_{Point::Zero(), Point::Ones(), {1, 1, 1}};
  PaddedColumns columns_;
  LengthUnits units_{1.0};
  std::optional<NaturalSteps> natural_;
  std::array<Move, kSteps> moves_{};
  std::vector<Label> labels_;
  BucketRing<std::uint32_t> ring_;
  int shift_ = 0;  ///< from a label to the number of its bucket
};

}  // namespace ltp::planning
