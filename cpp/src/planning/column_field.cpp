// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/column_field.hpp"

#include <cmath>
#include <limits>

namespace ltp {

void ColumnField::begin(const GridFrame& frame, const ColumnPriority& priority,
                        double length_factor, double priority_factor, int ix, int iy) {
  priority_ = &priority;
  length_factor_ = length_factor;
  priority_factor_ = priority_factor;
  nx_ = frame.nx();
  ny_ = frame.ny();
  step_ = {frame.cell().x(), frame.cell().y()};
  diagonal_ = std::hypot(step_[0], step_[1]);
  // The dearest step must fit into the ring of buckets; columns of one bucket may improve each
  // other.
  width_ = length_factor * diagonal_ / (kBuckets - 2);
  now_ = 0;
  if (columns_.size() < static_cast<std::size_t>(nx_) * ny_) {
    columns_.resize(static_cast<std::size_t>(nx_) * ny_);
  }
  if (stamp_ == std::numeric_limits<std::uint32_t>::max()) {
    for (Column& column : columns_) column.stamp = 0;
    stamp_ = 0;
  }
  ++stamp_;
  for (std::vector<std::uint32_t>& bucket : buckets_) bucket.clear();
  offer(static_cast<std::uint32_t>(ix * ny_ + iy), 0.0);
}

void ColumnField::offer(std::uint32_t column, double cost) {
  Column& mine = columns_[column];
  if (mine.stamp == stamp_ && mine.cost <= cost) return;
  mine = {cost, stamp_};
  buckets_[static_cast<std::int64_t>(cost / width_) % kBuckets].push_back(column);
}

void ColumnField::advance() {
  std::vector<std::uint32_t>& bucket = buckets_[now_ % kBuckets];
  while (!bucket.empty()) {
    emptied_.swap(bucket);
    bucket.clear();
    for (const std::uint32_t index : emptied_) {
      const double cost = columns_[index].cost;
      // Stale: it has moved to an earlier bucket and was spread from there.
      if (static_cast<std::int64_t>(cost / width_) != now_) continue;
      const int ix = static_cast<int>(index) / ny_;
      const int iy = static_cast<int>(index) % ny_;
      const double here = (*priority_)(ix, iy);
      for (int dx = -1; dx <= 1; ++dx) {
        for (int dy = -1; dy <= 1; ++dy) {
          const int jx = ix + dx;
          const int jy = iy + dy;
          if ((dx == 0 && dy == 0) || jx < 0 || jy < 0 || jx >= nx_ || jy >= ny_) continue;
          const double length = dx == 0 ? step_[1] : dy == 0 ? step_[0] : diagonal_;
          const double mean = 0.5 * (here + (*priority_)(jx, jy));
          offer(static_cast<std::uint32_t>(jx * ny_ + jy),
                cost + length * (length_factor_ - priority_factor_ * mean));
        }
      }
    }
    emptied_.clear();
  }
  ++now_;
}

}  // namespace ltp
