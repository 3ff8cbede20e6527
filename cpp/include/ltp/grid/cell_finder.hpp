// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `CellFinder`: the cells of thousands of points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

#include "ltp/geometry/points_view.hpp"
#include "ltp/geometry/types.hpp"
#include "ltp/grid/frame.hpp"

namespace ltp {

/// Finds at once, two points at a time, nearly all that lie inside a grid and between two balls;
/// says of which it is not sure, and there the caller asks the frame.
class CellFinder {
 public:
  /// The distances from a centre between which points are certain.
  struct Shell {
    Point centre = Point::Zero();
    double inner = -1.0;  ///< farther than this [m]; negative: the centre, too
    double outer = std::numeric_limits<double>::infinity();  ///< nearer than this [m]
  };

  explicit CellFinder(const GridFrame& frame) : CellFinder(frame, Shell{}) {}
  /// @param blur  certain is only what stays certain if a point moves by so much [m]
  CellFinder(const GridFrame& frame, const Shell& shell, double blur = 0.0)
      : axes_(frame.axes_),
        centre_(shell.centre),
        inner_square_(shell.inner < 0.0 ? -1.0 : shell.inner * shell.inner),
        outer_square_(shell.outer * shell.outer) {
    for (GridFrame::Axis& axis : axes_) axis.blur(blur);
  }

  /// Calls `found(i, cell)` for points whose cell is certain, inside the grid and the shell;
  /// `unsure(i)` for all others, a few in a million of which may be inside. In the order of the
  /// points.
  template <typename Found, typename Unsure>
  void for_each(const PointsView& points, Found&& found, Unsure&& unsure) const {
    // The numbers' type is asked once a block: the loop below is compiled only once.
    const bool floats = points.scalar() == PointsView::Scalar::Float;
    const Eigen::Index stride = points.stride();
    Block block;
    for (Eigen::Index begin = 0; begin < points.rows(); begin += kBlock) {
      const Eigen::Index count = std::min(kBlock, points.rows() - begin);
      if (floats) {
        locate(points.data<float>() + begin * stride, stride, count, block);
      } else {
        locate(points.data<double>() + begin * stride, stride, count, block);
      }
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

  template <typename Number>
  void locate(const Number* points, Eigen::Index stride, Eigen::Index count, Block& block) const {
    for (Eigen::Index i = 0; i < count; i += 2) {
      const Number* a = points + i * stride;
      const Number* b = i + 1 < count ? a + stride : a;
      std::array<Reals, 3> point;
      std::array<Integers, 3> cell;
      Reals square{};
      for (int axis = 0; axis < 3; ++axis) {
        point[axis] = Reals{static_cast<double>(a[axis]), static_cast<double>(b[axis])};
        const Reals delta = point[axis] - centre_[axis];
        square += delta * delta;
      }
      // NaN is neither, but `locate` is not sure of it.
      const Integers outside = reinterpret_cast<Integers>(square >= outer_square_) |
                               reinterpret_cast<Integers>(square <= inner_square_);
      const Integers unsure = GridFrame::locate(axes_, point, cell) | outside;
      std::memcpy(&block.unsure[i], &unsure, sizeof(unsure));
      for (int axis = 0; axis < 3; ++axis) {
        std::memcpy(&block.cell[axis][i], &cell[axis], sizeof(cell[axis]));
      }
    }
  }

  std::array<GridFrame::Axis, 3> axes_;
  Point centre_;
  double inner_square_;
  double outer_square_;
};

}  // namespace ltp
