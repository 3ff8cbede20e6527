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
  for (int axis = 0; axis < 3; ++axis) {
    if (std::isfinite(origin[axis] + dims[axis] * cell[axis])) continue;
    check::fail(std::string("cell.") + kAxis[axis], cell[axis],
                "an edge by which all cells lie at finite coordinates");
  }
  prepare_axes();
}

void GridFrame::prepare_axes() {
  const Point low = origin();
  for (int axis = 0; axis < 3; ++axis) {
    const double scale = kOne / cell_[axis];
    // Inside the window, `round` and `locate` are within 2^-53 (3 * 2^30 + 3 * 2^31 + 4 |origin| /
    // edge) cells of the truth: lattice coordinates are below 2^30, a window at most 2^31 cells
    // long. That is 1.1 units of the fixed point, half a one that `to_fixed` rounds, and what the
    // origin's distance adds.
    const double doubt = 4.0 + 1e-15 * std::abs(low[axis]) * scale;
    // Where lattice coordinates saturate inside the window, and for edges that have no inverse,
    // every point is in doubt.
    const double farthest = std::abs<double>(first_[axis]) + dims_[axis];
    const bool usable = farthest < kFarthestCell && doubt < 0.5 * kOne;
    const std::uint64_t half = usable ? static_cast<std::uint64_t>(doubt) : kOne / 2;
    axes_[axis] = {low[axis], scale, 0x1p52 + static_cast<double>(half),
                   kZeroBits + dims_[axis] * kOne - 1, 2 * half};
  }
}

Point GridFrame::upper() const { return origin() + Point(nx(), ny(), nz()).cwiseProduct(cell_); }

Cell GridFrame::round(const Point& point) const {
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
  moved.prepare_axes();
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
