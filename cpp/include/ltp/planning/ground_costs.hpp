// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `GroundCosts`: additive costs of steps towards one goal in whole units, and the least cost over
// the ground.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/planning/additive_search.hpp"
#include "ltp/planning/grid_query.hpp"

namespace ltp {

/// A cost in whole units: sums are exact in any order, so that what was learned from search to
/// search never drifts and equality means equality.
using Units = std::int64_t;

/// Costs on the lattice round one goal. They cover every window that holds the goal and know no
/// obstacles, so they stand while goal, cost and priority do, wherever the window moves. A step to
/// a neighbour costs its length times (`length` - `priority` * the mean of both columns'
/// priorities); a step into the goal leads to the goal itself and costs exactly what it does.
///
/// `least` is Dijkstra over the columns from a root, in buckets (delta-stepping), advanced only as
/// far as it is asked. Priority depends on x and y alone, so no path in space costs less, and it is
/// a metric: consistent with every step between centres, to the unit.
class GroundCosts {
 public:
  /// @param goal_cell  in the frame
  /// @param cells      that a path may have at most: with more of them units are coarser
  void begin(const GridFrame& frame, const Raster& raster, const AdditiveCost& cost,
             const Point& goal, const Cell& goal_cell, std::int64_t cells);

  /// Names the frame and the raster (that of `begin` or a copy) of the queries to come.
  void use(const GridFrame& frame, const Raster& raster);

  /// Of step `number` from a cell of the frame, neither end being the goal; at least 1.
  Units step(const Cell& from, int number) const;
  /// Of the straight line between two points; at least 1.
  Units straight(const Point& from, const Point& to) const;
  /// Of a step into the goal from a cell beside it.
  Units into_goal(const Cell& from) const;
  /// Measures from another column of the frame.
  void root(int ix, int iy);
  /// The least cost between the centres of the root and a column of the frame.
  Units least(int ix, int iy) {
    const Column& column = columns_[index(ix + shift_[0], iy + shift_[1])];
    while (column.stamp != stamp_ || column.cost >= now_ * width_) advance();
    return column.cost;
  }

 private:
  struct Column {
    Units cost = 0;
    std::uint32_t stamp = 0;
  };

  std::uint32_t index(int jx, int jy) const { return static_cast<std::uint32_t>(jx * ny_ + jy); }
  double priority_at(int jx, int jy) const { return (*raster_)(rows_[jx], lines_[jy]); }
  Units units(double cost) const;
  Units between(int jx, int jy, int kx, int ky, double length) const {
    const double sum = priority_at(jx, jy) + priority_at(kx, ky);
    return units(length * (cost_.length - 0.5 * cost_.priority * sum));
  }
  void offer(std::uint32_t column, Units cost);
  void advance();

  static constexpr int kBuckets = 128;

  const Raster* raster_ = nullptr;  ///< of the call
  AdditiveCost cost_;
  double scale_ = 1.0;  ///< units to a cost of 1
  std::array<double, kSteps> lengths_{};
  Point goal_ = Point::Zero();
  std::array<int, 2> goal_column_{};  ///< on the lattice
  std::array<Units, 27> last_{};      ///< into the goal, from round it
  Cell goal_cell_ = Cell::Zero();     ///< in the frame
  int nx_ = 0;                        ///< columns of the area, the goal's in its middle
  int ny_ = 0;
  std::array<int, 2> shift_{};  ///< from the frame's columns to the area's
  std::vector<int> rows_;       ///< of the raster, under the area's columns
  std::vector<int> lines_;      ///< the same along y

  Units width_ = 1;  ///< of a bucket
  Units now_ = 0;    ///< number of the bucket to be emptied next
  std::uint32_t stamp_ = 0;
  std::vector<Column> columns_;
  std::array<std::vector<std::uint32_t>, kBuckets> buckets_;
  std::vector<std::uint32_t> emptied_;
};

}  // namespace ltp
