// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GridFrame`: where a grid of cells lies in the world. The only place that rounds.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

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
  Cell cell_of(const Point& point) const {
    Cell cell;
    return locate(point, cell) ? cell : round(point);
  }
  /// The same, but nothing for a point outside the grid.
  std::optional<Cell> find(const Point& point) const {
    Cell cell;
    if (locate(point, cell)) return cell;
    cell = round(point);
    if (contains(cell)) return cell;
    return std::nullopt;
  }
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
  bool contains(const Point& point) const { return find(point).has_value(); }

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
  friend class CellFinder;

  static constexpr int kBits = 20;  ///< of the fixed point, behind the point
  static constexpr std::uint64_t kOne = std::uint64_t{1} << kBits;
  static constexpr std::uint64_t kZeroBits = 0x4330000000000000;  ///< of 2^52

  /// What it takes to round along one axis in fixed point: the upper bits are the cell, the lower
  /// ones say how near its faces are.
  struct Axis {
    double origin;        ///< of the window [m]
    double scale;         ///< fixed point units a metre
    double zero;          ///< 2^52 and half the doubt [units]
    std::uint64_t last;   ///< the bits of the window's end
    std::uint64_t doubt;  ///< twice the distance to a face from which on `round` decides [units]

    /// Doubts more: what is sure then is so for any point that is nearer than this [m].
    void blur(double metres) {
      const double more = std::min(0.5 * kOne, std::ceil(metres * scale));  // the former for NaN
      zero += more;
      doubt += 2 * static_cast<std::uint64_t>(more);
    }
  };

  /// The cell of nearly every point in the window, at a third of the price of `round`, for one
  /// point or, with vectors for numbers, for several. The result's highest bit is set where
  /// rounding could matter - next to a face, outside the window, NaN - so that the two never
  /// disagree. `cell` goes to `cell_in`.
  template <typename Integer, typename Real>
  static Integer locate(const std::array<Axis, 3>& axes, const std::array<Real, 3>& point,
                        std::array<Integer, 3>& cell) {
    Integer unsure{};
    for (int i = 0; i < 3; ++i) {
      const Axis& axis = axes[i];
      // A double of 2^52 and more holds one unit a bit.
      const Real units = (point[i] - axis.origin) * axis.scale + axis.zero;
      Integer bits;
      std::memcpy(&bits, &units, sizeof(bits));
      unsure |= (bits - kZeroBits) | (axis.last - bits) | ((bits & (kOne - 1)) - axis.doubt);
      cell[i] = bits;
    }
    return unsure;
  }
  static Cell cell_in(std::uint64_t x, std::uint64_t y, std::uint64_t z) {
    return Cell(static_cast<int>(x >> kBits), static_cast<int>(y >> kBits),
                static_cast<int>(z >> kBits));
  }
  bool locate(const Point& point, Cell& cell) const {
    std::array<std::uint64_t, 3> bits;
    const std::uint64_t unsure =
        locate(axes_, std::array<double, 3>{point.x(), point.y(), point.z()}, bits);
    cell = cell_in(bits[0], bits[1], bits[2]);
    return unsure >> 63 == 0;
  }
  /// Rounds down what was divided: slow, and right by definition.
  Cell round(const Point& point) const;
  void prepare_axes();

  Point anchor_;
  Point cell_;
  std::array<int, 3> dims_;
  Cell first_ = Cell::Zero();  ///< the window's first cell, counted on the lattice from the anchor
  std::array<Axis, 3> axes_;   ///< follows from the others
};

}  // namespace ltp
