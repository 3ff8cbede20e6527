// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ObstacleMemory`: what has left the map's window, too far to plan with, good enough to prove
// with.
#pragma once

#include <cstdint>
#include <memory>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/mapping/inflation.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

namespace planning {
class Flood;
}

/// A block larger than the window can never be seen closed inside it: the UAV would circle it for
/// ever, always finding a way through the walls that it has just forgotten. So cells that were ever
/// occupied are kept over a few windows' width, one bit a cell, for proofs of unreachability only.
/// It trusts obstacles to stay where they were.
class ObstacleMemory {
 public:
  /// @param window  the map's window
  /// @param widths  how many windows wide and long the memory is, >= 1; 1: no more than the window
  /// itself
  /// @param inflation_radius  as the map's [m]
  ObstacleMemory(const GridFrame& window, int widths, double inflation_radius);
  ObstacleMemory(ObstacleMemory&&) noexcept;
  ~ObstacleMemory();

  /// Adds what a window on the same lattice holds; moves along with it. Allocates nothing.
  void remember(const OccupancyGrid& occupied);

  /// Forgets everything.
  void clear();

  /// Whether the goal is walled in: what a flood from it reaches, obstacles inflated, ends neither
  /// at the UAV nor at the edge of what is remembered.
  bool seals(const Query& query);

  const OccupancyGrid& occupied() const { return occupied_; }

 private:
  void inflate(int ix, int iy, int word, std::uint64_t bits);

  OccupancyGrid occupied_;
  OccupancyGrid blocked_;  ///< the same, inflated, if `inflated_`
  Inflation inflation_;
  bool inflated_ = false;  ///< from the first proof on, until the memory moves
  std::unique_ptr<planning::Flood> flood_;
};

}  // namespace ltp
