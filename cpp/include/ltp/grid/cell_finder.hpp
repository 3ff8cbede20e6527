// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CellFinder`: the cells of thousands of points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"

namespace ltp {

/// Finds at once, two points at a time, nearly all that lie inside a grid and a ball; says of which
/// it is not sure, and there the caller asks the frame.
class CellFinder {
 public:
  /// @param blur  certain is only what stays certain if a point moves by so much [m]
  explicit CellFinder(const GridFrame& frame, const Point& centre = Point::Zero(),
                      double radius = std::numeric_limits<double>::infinity(), double blur = 0.0)
      : axes_(frame.axes_), centre_(centre), square_(radius * radius) {
    for (GridFrame::Axis& axis : axes_) axis.blur(blur);
  }

  /// Calls `found(i, cell)` for points whose cell is certain, inside the grid, and whose distance
  /// from the ball's centre is less than its radius; `unsure(i)` for all others, a few in a million
  /// of which may be inside. In the order of the points, shape (N, 3).
  template <typename Found, typename Unsure>
  void for_each(const PathRef& points, Found&& found, Unsure&& unsure) const {
    Block block;
    for (Eigen::Index begin = 0; begin < points.rows(); begin += kBlock) {
      const Eigen::Index count = std::min(kBlock, points.rows() - begin);
      locate(points.data() + begin * points.outerStride(), points.outerStride(), count, block);
      for (Eigen::Index i = 0; i < count; ++i) {
        if (block.unsure[i] >> 63 != 0) {
          unsure(begin + i);
        } else {
          found(begin + i,
                GridFrame::cell_in(block.cell[0][i], block.cell[1][i], block.cell[2][i]));
        }
      }
    }
  }

 private:
  static constexpr Eigen::Index kBlock = 64;
  // Two numbers in one of the registers that every x86-64 and ARM machine has.
  using Reals = double __attribute__((vector_size(16)));
  using Integers = std::uint64_t __attribute__((vector_size(16)));

  struct Block {
    alignas(16) std::array<std::array<std::uint64_t, kBlock>, 3> cell;
    alignas(16) std::array<std::uint64_t, kBlock> unsure;  ///< the highest bit says so
  };

  void locate(const double* points, Eigen::Index stride, Eigen::Index count, Block& block) const {
    for (Eigen::Index i = 0; i < count; i += 2) {
      const double* a = points + i * stride;
      const double* b = i + 1 < count ? a + stride : a;
      std::array<Reals, 3> point;
      std::array<Integers, 3> cell;
      Reals square{};
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = Reals{a[axis], b[axis]};
        const Reals delta = point[axis] - centre_[axis];
        square += delta * delta;
      }
      const Integers outside = reinterpret_cast<Integers>(~(square < square_));
      const Integers unsure = GridFrame::locate(axes_, point, cell) | outside;
      std::memcpy(&block.unsure[i], &unsure, sizeof(unsure));
      for (int axis = 0; axis < 3; ++axis) {
        std::memcpy(&block.cell[axis][i], &cell[axis], sizeof(cell[axis]));
      }
    }
  }

  std::array<GridFrame::Axis, 3> axes_;
  Point centre_;
  double square_;
};

}  // namespace ltp
