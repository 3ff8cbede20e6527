// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `IncrementalPlanner`: repairs its last additive search while the goal stands.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "ltp/planning/additive_search.hpp"
#include "ltp/planning/ground_costs.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

/// D* Lite (Koenig and Likhachev, AAAI 2002, the optimised version): a search from the goal whose
/// costs are kept, and repaired where cells have become blocked or free, have entered the window or
/// left it. Its paths cost what a search from scratch (`AdditiveSearch`) with the same alpha finds,
/// at every call.
///
/// A cell carries `cost`, to the goal when it was last settled, and `ahead`, what its neighbours
/// offer now. Where they differ the cell waits in the open list, ordered by the lesser of both plus
/// the least cost over the ground from the start (`GroundCosts::least`). As the start moves,
/// `moved_` keeps old keys lower bounds, so that the list need not be sorted anew.
///
/// The start is a point: its steps are tallied exactly in each call, and the search goes on until
/// no unsettled neighbour can offer less. Where the best way leads back through the centre of the
/// start's own cell - priorities can make that look cheaper - it is no path, and a search from
/// scratch answers.
///
/// It begins anew when the goal, the priority map (by `Raster::id`), the lattice or the size of the
/// window changes. It finds out what is new by comparing the occupancy with its own copy.
class IncrementalPlanner final : public Planner {
 public:
  explicit IncrementalPlanner(const PlannerOptions& options);

  std::string_view name() const override { return "incremental"; }
  bool complete() const override { return true; }
  /// `stats.expanded` counts the cells settled or unsettled in this call.
  Plan plan(const Scene& scene, const Query& query) override;

 private:
  static constexpr Units kNone = std::numeric_limits<Units>::max() / 2;

  struct Node {
    Units cost = kNone;       ///< to the goal, when it was settled
    Units ahead = kNone;      ///< to the goal, through the best neighbour
    std::uint32_t epoch = 0;  ///< of another epoch: never visited
    std::uint32_t seen = 0;   ///< the call that last looked at it for changes
    std::int8_t next = -1;    ///< step to the best neighbour

    Units least() const { return cost < ahead ? cost : ahead; }
  };
  /// Cells on the lattice, both corners included.
  struct Box {
    Cell low = Cell::Zero();
    Cell high = Cell::Constant(-1);

    bool empty() const { return (high.array() < low.array()).any(); }
    bool contains(const Cell& cell) const {
      return (cell.array() >= low.array()).all() && (cell.array() <= high.array()).all();
    }
    Box cut(const Box& other) const { return {low.cwiseMax(other.low), high.cwiseMin(other.high)}; }
    Box grown() const { return {low - Cell::Ones(), high + Cell::Ones()}; }
  };
  /// What must not change if anything is to be kept.
  struct Problem {
    Point goal = Point::Zero();
    std::uint64_t raster = 0;
    Point cell = Point::Zero();
    Point anchor = Point::Zero();
    std::array<int, 3> dims{};

    bool operator==(const Problem& other) const {
      return goal == other.goal && raster == other.raster && cell == other.cell &&
             anchor == other.anchor && dims == other.dims;
    }
  };
  struct Entry {
    Units key = 0;
    Units least = 0;  ///< among equals the cell nearer to the goal goes first
    std::uint32_t node = 0;
  };
  /// A step out of the start.
  struct Exit {
    std::uint32_t node = 0;
    Units cost = 0;        ///< of the step
    Units from_start = 0;  ///< the least cost between their columns
    Cell cell = Cell::Zero();
  };
  /// What one call works on.
  struct Call;

  PlanStatus search(const Call& call, SearchStats& stats, std::vector<Cell>& chain);
  void begin(const Call& call, const Problem& problem);
  void move_start(const Call& call);
  void take_changes(const Call& call, SearchStats& stats);
  void leave(const Call& call, const Box& before, SearchStats& stats);
  void enter(const Call& call, const Box& before, SearchStats& stats);
  void look_round(const Call& call, const Cell& cell, bool freed, SearchStats& stats);
  PlanStatus settle(const Call& call, SearchStats& stats);
  void settle_one(const Call& call, const Cell& cell, std::uint32_t place, SearchStats& stats);
  void offers(const Call& call, const Cell& cell, SearchStats& stats);
  void find_exits(const Call& call);
  const Exit* best_exit() const;
  bool chain_from(const Call& call, const Exit& exit, std::vector<Cell>& chain) const;

  Units step_cost(const Call& call, const Cell& from, int step, const Cell& to) const;
  Node& visit(const Call& call, const Cell& cell, std::uint32_t place);
  void queue(const Cell& cell, std::uint32_t place, SearchStats& stats);
  bool stale(const Entry& entry) const;
  void drop_first();
  void tidy();

  std::uint32_t index(const Cell& cell) const;
  std::uint32_t index_on_lattice(const Cell& cell) const;
  Cell cell_of(std::uint32_t index) const;

  PlannerOptions options_;
  GroundCosts costs_;
  AdditiveCost cost_;
  AdditiveSearch scratch_;
  std::optional<OccupancyGrid> known_;  ///< as of the last call
  Problem problem_;
  Box box_;                     ///< the cells that could be used then
  Box touched_;                 ///< holds all nodes of this epoch
  std::array<int, 2> start_{};  ///< its column on the lattice
  Units moved_ = 0;             ///< how far the start has gone since the epoch began, at least

  // Nodes lie on a torus, so that those of cells that stay in the window stay where they are.
  std::vector<Node> nodes_;
  std::array<int, 3> size_{1, 1, 1};  ///< of the torus
  std::array<int, 3> turn_{};         ///< where the call's first cell and level lie on it
  int lowest_ = 0;
  std::uint32_t epoch_ = 0;
  std::uint32_t call_ = 0;
  std::vector<Entry> open_;  ///< a heap; stale entries are skipped
  std::size_t tidy_at_ = 0;
  std::vector<Exit> exits_;
};

}  // namespace ltp
