// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ObstacleMemory`: every cell that the map's window has held blocked, wherever it is by now.
#pragma once

#include <cstdint>
#include <memory>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp {

namespace planning {
class Flood;
}

/// The window forgets what it leaves. Whoever plans with the window alone finds a way through the
/// walls that it has just forgotten, again and again, and never sees a block closed that is larger
/// than the window. This keeps the blocked cells, one bit each, over all ground that the window has
/// passed: ways beyond the window are searched here, and proofs are drawn from here.
///
/// All round what is known lies a ring of cells that are free: who comes there can go round.
/// It trusts obstacles to stay where they were, unless the window, well inside of it, shows a cell
/// free that it has shown blocked before.
class ObstacleMemory {
 public:
  /// It is no longer than this along x and y [cells]: 8 km of the default's, in 134 MB.
  static constexpr int kMostCells = 4096;

  /// @param window            the map's window
  /// @param inflation_radius  as the map's [m]: so near to its faces a window does not know all
  ///     that blocks a cell
  ObstacleMemory(const GridFrame& window, double inflation_radius);
  ObstacleMemory(ObstacleMemory&&) noexcept;
  ~ObstacleMemory();

  /// Takes over what a window on the same lattice has blocked. Allocates nothing where there is
  /// room for it.
  void remember(const OccupancyGrid& blocked);

  /// Takes over what is blocked anywhere, by a grid on the same lattice: of an earlier mission. If
  /// there is no room for all of it, none is.
  void add(const OccupancyGrid& blocked);

  /// Grows, in large steps, until a ring of free cells lies round the box of two points [m], too.
  /// False, and nothing happens, if that is more than `kMostCells`.
  bool make_room(const Point& low, const Point& high);

  /// Blocks in a window what is remembered of it.
  void add_to(OccupancyGrid& blocked) const;

  /// Forgets everything.
  void clear();

  /// Whether the goal is walled in: what a flood from it reaches ends neither at the UAV nor at the
  /// edge of what is remembered.
  bool seals(const Query& query);
  /// The same for the UAV: whether a flood from it ends neither at the goal nor at the edge.
  bool encloses(const Query& query);

  const OccupancyGrid& blocked() const { return blocked_; }
  /// Grows with every cell that becomes blocked or free.
  std::int64_t version() const { return version_; }
  /// Whether it had to forget what lay farthest from the window, to have room.
  bool has_forgotten() const { return has_forgotten_; }

 private:
  bool hold(const Cell& low, const Cell& high);
  bool is_closed(const Query& query, const Point& from, const Point& to);

  OccupancyGrid blocked_;
  OccupancyGrid seen_;  ///< what the last window had blocked, as far as it knew all that blocks it
  Cell reach_;          ///< of the inflation, at most
  std::int64_t version_ = 0;
  bool has_forgotten_ = false;
  std::unique_ptr<planning::Flood> flood_;
};

}  // namespace ltp
