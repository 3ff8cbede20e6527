// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GridFrame`: where a grid of cells lies in the world. The only place that rounds.
#pragma once

#include <array>
#include <cstdint>

#include "ltp/geometry/types.hpp"

namespace ltp {

/// Integer cell coordinates (ix, iy, iz).
using Cell = Eigen::Vector3i;

/// Points so many cells and more from a lattice's anchor are outside of every window on it.
inline constexpr double kFarthestCell = 1e9;

/// A regular grid of boxes: cell (i, j, k) covers [origin + (i, j, k) * cell, + cell), so a point
/// on a face belongs to the upper cell. The lattice is fixed by `anchor`; the window on it moves by
/// whole cells (`first`), so that rolling never accumulates rounding errors.
class GridFrame {
 public:
  /// @param origin  lowest corner of cell (0, 0, 0), world [m]
  /// @param cell    edge lengths of a cell [m], positive
  /// @param dims    cells along x, y, z; positive
  /// Throws `std::invalid_argument` for non-finite or non-positive values, or more than 2^31 cells.
  GridFrame(const Point& origin, const Point& cell, const std::array<int, 3>& dims);

  const Point& cell() const { return cell_; }
  const std::array<int, 3>& dims() const { return dims_; }
  int nx() const { return dims_[0]; }
  int ny() const { return dims_[1]; }
  int nz() const { return dims_[2]; }
  std::int64_t size() const { return std::int64_t{dims_[0]} * dims_[1] * dims_[2]; }

  Point origin() const { return anchor_ + first_.cast<double>().cwiseProduct(cell_); }
  const Cell& first() const { return first_; }  ///< number of cell (0, 0, 0) on the lattice
  Point upper() const;                          ///< highest corner of the last cell, world [m]

  /// The cell that holds a point; may lie outside the grid. Far or non-finite points saturate
  /// outside.
  Cell cell_of(const Point& point) const;
  /// A point in cells from the lattice's anchor. Rounded down, less `first()`, it is `cell_of`.
  Point lattice(const Point& point) const { return (point - anchor_).cwiseQuotient(cell_); }
  Point centre(const Cell& cell) const {
    const Point number = cell.cast<double>() + first_.cast<double>();
    return anchor_ + (number.array() + 0.5).matrix().cwiseProduct(cell_);
  }
  bool contains(const Cell& cell) const {
    return static_cast<unsigned>(cell.x()) < static_cast<unsigned>(dims_[0]) &&
           static_cast<unsigned>(cell.y()) < static_cast<unsigned>(dims_[1]) &&
           static_cast<unsigned>(cell.z()) < static_cast<unsigned>(dims_[2]);
  }
  bool contains(const Point& point) const { return contains(cell_of(point)); }

  /// Linear index, z fastest: (ix * ny + iy) * nz + iz. The cell must be inside.
  std::int64_t index(const Cell& cell) const {
    return (std::int64_t{cell.x()} * dims_[1] + cell.y()) * dims_[2] + cell.z();
  }
  Cell cell_at(std::int64_t index) const;

  /// The same lattice, its window moved by whole cells. Throws `std::invalid_argument` if that is
  /// beyond 10^9 cells from the anchor.
  GridFrame shifted(const Cell& by) const;
  /// The shift that centres the window on a point, to the nearest whole cell.
  Cell shift_to_centre(const Point& point) const;

  bool operator==(const GridFrame& other) const;
  bool operator!=(const GridFrame& other) const { return !(*this == other); }

 private:
  Point anchor_;
  Point cell_;
  std::array<int, 3> dims_;
  Cell first_ = Cell::Zero();  ///< the window's first cell, counted on the lattice from the anchor
};

}  // namespace ltp
