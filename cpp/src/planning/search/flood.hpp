// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `Flood`: the set of cells that any planner could reach; the second opinion on a proof of
// unreachability.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"
#include "ltp/grid/occupancy_grid.hpp"
#include "planning/search/zeroed_array.hpp"

namespace ltp::planning {

/// Since a diagonal step needs every cell of its bounding box free, what 26 neighbours reach six
/// reach too: a flood over faces, a whole bit column at a time. It shares nothing with the
/// planners' searches. A small fill costs what it reaches, not the window.
class Flood {
 public:
  /// Fills from a cell, which counts as free itself, over the free cells of the levels. Throws
  /// `std::invalid_argument` if the cell is outside the frame or the levels.
  /// @param until  if given, ends as soon as that cell is reached or the edge touched: then it is
  /// not walled off
  void fill(const OccupancyGrid& grid, const Cell& from, const LevelRange& levels,
            const std::optional<Cell>& until = std::nullopt);

  /// Whether no path leads from one cell to another, as far as a short look tells: false where
  /// that is not proved within `most` visits to columns. The window's edge is a wall. What a search
  /// asks before it sets out: goals lie inside of buildings, whose insides no ray has touched.
  /// Throws as `fill` does.
  bool parts(const OccupancyGrid& grid, const Cell& inside, const Cell& outside,
             const LevelRange& levels, std::size_t most);

  bool reached(const Cell& cell) const;
  /// Whether the fill came to the edge of the window: what lies beyond is unknown, so it proves
  /// nothing.
  bool touched_edge() const { return touched_edge_; }
  std::int64_t count() const;  ///< cells reached

 private:
  enum class State : std::uint8_t {
    Untouched,
    Touched,
    Waiting,  ///< has news to spread
  };

  void begin(const OccupancyGrid& grid);
  /// Until `enough()` says so, asked after each visit to a column; whether it ran dry before.
  template <typename Enough>
  bool spread_from(const OccupancyGrid& grid, const Cell& from, const LevelRange& levels,
                   Enough&& enough);

  ZeroedArray<std::uint64_t> reached_;
  ZeroedArray<State> states_;               ///< of the columns
  std::vector<std::uint32_t> touched_;      ///< columns, each once: what a next fill must clear
  std::vector<std::uint32_t> front_;        ///< columns that are being visited, to spread news
  std::vector<std::uint32_t> next_;         ///< columns with news to spread
  std::vector<std::uint64_t> open_levels_;  ///< the levels that may be used, as one column
  int nx_ = 0;
  int ny_ = 0;
  int words_ = 0;
  bool touched_edge_ = false;
};

}  // namespace ltp::planning
