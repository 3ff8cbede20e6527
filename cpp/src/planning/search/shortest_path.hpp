// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ShortestPath`: one exact A* for the shortest path of a query.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/search/bucket_ring.hpp"
#include "planning/search/length_units.hpp"
#include "planning/search/level_lengths.hpp"
#include "planning/search/natural_steps.hpp"
#include "planning/search/octile_distance.hpp"
#include "planning/search/search_space.hpp"
#include "planning/search/unreachable_proof.hpp"

namespace ltp::planning {

/// The graph is the planners' own: the vertices, with start and goal themselves in place of the
/// centres of their cells. It searches from the goal, so that one that is walled in is soon proved
/// so, with `OctileDistance` to the start; only `NaturalSteps` are taken. Open cells wait in narrow
/// buckets, last in, first out: where nothing is in the way all cells of the way are in one bucket,
/// and the search runs straight along it.
class ShortestPath {
 public:
  /// @param patience  expansions before a flood from the start looks for a proof that there is no
  ///     path, which costs what the start can reach; 0: none does
  explicit ShortestPath(std::int64_t patience = kPatience);

  /// Start and goal must lie in two cells. Adds what it did to `stats`. A search that has been told
  /// to stop answers `OutOfBudget`.
  PlanStatus run(const Problem& problem, BudgetWatch& budget, SearchStats& stats);

  /// The cells of the path found, start ... goal.
  const std::vector<Cell>& chain() const { return chain_; }

 private:
  static constexpr std::int64_t kPatience = 16384;

  /// How a cell was reached, the better the less: its distance to the goal, then the last step (6
  /// bits; from `kSteps` on the first from the goal, whose length is its own).
  using Label = std::uint64_t;
  static constexpr int kTagBits = 64 - LengthUnits::kBits;
  struct Node {
    Label label = ~Label{0};
    std::uint32_t stamp = 0;
  };
  struct Entry {
    std::uint64_t estimate;  ///< of the whole path through the cell
    Label label;             ///< of the cell when it was pushed; stale if it has another by now
    Cell cell;
  };

  /// Lengths of the steps from the cells of a level.
  struct ByLevel {
    std::array<std::uint64_t, kSteps> lengths;
    bool even;  ///< they are the lattice's, and so are those between the levels beside
  };

  void prepare(const Problem& problem, double longest);
  void prepare_levels(const Problem& problem);
  PlanStatus search(const Problem& problem, BudgetWatch& budget, SearchStats& stats);
  void push(const Entry& entry);

  LengthUnits units_{1.0};
  std::optional<NaturalSteps> natural_;
  LevelLengths level_lengths_;
  std::vector<ByLevel> by_level_;  ///< from the lowest; none where all are the lattice's
  std::array<std::uint64_t, kSteps> least_{};  ///< no step is shorter
  OctileDistance to_start_;
  std::array<std::uint64_t, kSteps> from_goal_{};  ///< lengths of the first steps
  std::array<std::uint64_t, 27> into_start_{};     ///< of the last, by `neighbour_bit`
  SearchSpace<Node> space_;
  BucketRing<Entry> ring_;
  std::uint64_t first_ = 0;  ///< number of the bucket of the least estimate
  std::uint64_t now_ = 0;    ///< number of the bucket that is being emptied
  std::size_t waiting_ = 0;
  int shift_ = 0;  ///< from an estimate to the number of its bucket
  UnreachableProof proof_;
  std::vector<Cell> chain_;
};

}  // namespace ltp::planning
