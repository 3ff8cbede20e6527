// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `OccupancyGrid`: which cells are blocked, one bit a cell; what every planner reads.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ltp/geometry/points_view.hpp"
#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"

namespace ltp {

/// Bit columns: the cells of one (x, y) column are the bits of one 64-bit word (of several for more
/// than 64 levels), lowest level first; columns lie contiguously, y fastest. 200 x 200 x 40 cells
/// are 320 kB. A cell that was never set is free: what no ray has touched counts as free (the
/// paper, section II-C).
class OccupancyGrid {
 public:
  explicit OccupancyGrid(const GridFrame& frame);

  const GridFrame& frame() const { return frame_; }
  int words_per_column() const { return words_per_column_; }

  /// Eq. (1): a path through a blocked cell has an infinite penalty. The cell must be inside the
  /// frame.
  bool blocked(const Cell& cell) const {
    return column(cell.x(), cell.y())[cell.z() >> 6] >> (cell.z() & 63) & 1u;
  }
  /// Whether the cell that holds a point is blocked; false outside the frame.
  bool blocked_at(const Point& point) const {
    const std::optional<Cell> cell = frame_.find(point);
    return cell && blocked(*cell);
  }
  /// The same for many points; `out` holds an answer a point.
  void blocked_at(const PointsView& points, bool* out) const;
  void set(const Cell& cell, bool blocked = true);
  void clear();
  std::int64_t count() const;  ///< blocked cells

  const std::uint64_t* column(int ix, int iy) const {
    return words_.data() + (std::int64_t{ix} * frame_.ny() + iy) * words_per_column_;
  }
  std::uint64_t* column(int ix, int iy) {
    return words_.data() + (std::int64_t{ix} * frame_.ny() + iy) * words_per_column_;
  }
  const std::vector<std::uint64_t>& words() const { return words_; }

  /// Moves the window by whole cells: what leaves is forgotten, what enters is free. Allocates
  /// nothing.
  void roll(const Cell& shift);

  /// The arc length [m] at which a path first touches a blocked cell, by an exact walk (no
  /// sampling); empty if it touches none. Cells outside the frame count as free. A path of one
  /// point is tested as that point. With `from`, only the part of the path at or beyond that arc
  /// length [m] is looked at. The cell `ignored`, if one is given, counts as free.
  std::optional<double> first_blocked(const PathRef& path, double from = 0.0,
                                      const std::optional<Cell>& ignored = std::nullopt) const;

  bool operator==(const OccupancyGrid& other) const {
    return frame_ == other.frame_ && words_ == other.words_;
  }

 private:
  GridFrame frame_;
  int words_per_column_;
  std::vector<std::uint64_t> words_;
};

}  // namespace ltp
