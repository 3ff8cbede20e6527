// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/grid/frame.hpp"

#include <cmath>
#include <limits>

#include "ltp/geometry/check.hpp"

namespace ltp {
namespace {

constexpr const char* kAxis[] = {"x", "y", "z"};

}  // namespace

GridFrame::GridFrame(const Point& origin, const Point& cell, const std::array<int, 3>& dims)
    : anchor_(origin), cell_(cell), dims_(dims) {
  check::finite("origin", origin);
  for (int axis = 0; axis < 3; ++axis) {
    check::positive(std::string("cell.") + kAxis[axis], cell[axis]);
    if (dims[axis] <= 0) {
      check::fail(std::string("dims.") + kAxis[axis], dims[axis], "a positive number of cells");
    }
  }
  // Divided, not multiplied: the product of three ints can overflow 64 bits.
  if (std::int64_t{dims[0]} * dims[1] > std::numeric_limits<std::int32_t>::max() / dims[2]) {
    std::ostringstream text;
    text << dims[0] << " x " << dims[1] << " x " << dims[2];
    check::fail("dims", text.str(), "at most 2^31 - 1 cells in all");
  }
}

Point GridFrame::upper() const { return origin() + Point(nx(), ny(), nz()).cwiseProduct(cell_); }

Cell GridFrame::cell_of(const Point& point) const {
  const Point on_lattice = lattice(point);
  Cell cell;
  for (int axis = 0; axis < 3; ++axis) {
    const double number = std::floor(on_lattice[axis]);
    // Written so that NaN saturates too.
    const bool near = number > -kFarthestCell && number < kFarthestCell;
    cell[axis] = near ? static_cast<int>(number) - first_[axis] : std::numeric_limits<int>::min();
  }
  return cell;
}

Cell GridFrame::cell_at(std::int64_t index) const {
  const std::int64_t column = index / dims_[2];
  return Cell(static_cast<int>(column / dims_[1]), static_cast<int>(column % dims_[1]),
              static_cast<int>(index % dims_[2]));
}

GridFrame GridFrame::shifted(const Cell& by) const {
  GridFrame moved = *this;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int64_t first = std::int64_t{first_[axis]} + by[axis];
    if (!(std::abs(static_cast<double>(first)) < kFarthestCell)) {
      check::fail("by", by.transpose(), "a shift that stays near the map");
    }
    moved.first_[axis] = static_cast<int>(first);
  }
  return moved;
}

Cell GridFrame::shift_to_centre(const Point& point) const {
  check::finite("point", point);
  Cell shift;
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * dims_[axis];
    const double first = std::floor((point[axis] - anchor_[axis]) / cell_[axis] - half + 0.5);
    if (!(std::abs(first) < kFarthestCell))
      check::fail("point", point.transpose(), "a point near the map");
    shift[axis] = static_cast<int>(first) - first_[axis];
  }
  return shift;
}

bool GridFrame::operator==(const GridFrame& other) const {
  return anchor_ == other.anchor_ && cell_ == other.cell_ && dims_ == other.dims_ &&
         first_ == other.first_;
}

}  // namespace ltp
