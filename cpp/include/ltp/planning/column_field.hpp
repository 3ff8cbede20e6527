// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ColumnField`: the least additive cost over the ground from one column to the others, obstacles
// ignored.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ltp/planning/grid_query.hpp"

namespace ltp {

/// Dijkstra over the columns of a window, in buckets of equal width (delta-stepping), advanced only
/// as far as it is asked. A step to one of the 8 neighbours costs its length times (`length` -
/// `priority` * the mean of both columns' priorities).
class ColumnField {
 public:
  /// Begins at a column. `priority` must outlive the queries. Costs must be positive.
  void begin(const GridFrame& frame, const ColumnPriority& priority, double length_factor,
             double priority_factor, int ix, int iy);

  /// The least cost from the first column to this one.
  double operator()(int ix, int iy) {
    const std::uint32_t column = static_cast<std::uint32_t>(ix * ny_ + iy);
    while (!settled(column)) advance();
    return columns_[column].cost;
  }

 private:
  struct Column {
    double cost = 0.0;
    std::uint32_t stamp = 0;
  };

  // All that costs less than the bucket being emptied begins at is final.
  bool settled(std::uint32_t column) const {
    return columns_[column].stamp == stamp_ && columns_[column].cost < now_ * width_;
  }
  void advance();
  void offer(std::uint32_t column, double cost);

  static constexpr int kBuckets = 128;

  const ColumnPriority* priority_ = nullptr;
  double length_factor_ = 1.0;
  double priority_factor_ = 0.0;
  std::array<double, 2> step_{};  ///< lengths along x and y [m]
  double diagonal_ = 0.0;         ///< [m]
  int nx_ = 0;
  int ny_ = 0;
  double width_ = 1.0;
  std::int64_t now_ = 0;  ///< number of the bucket to be emptied next
  std::uint32_t stamp_ = 0;
  std::vector<Column> columns_;
  std::array<std::vector<std::uint32_t>, kBuckets> buckets_;
  std::vector<std::uint32_t> emptied_;
};

}  // namespace ltp
