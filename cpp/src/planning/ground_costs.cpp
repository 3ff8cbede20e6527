// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ltp/planning/ground_costs.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace ltp {

void GroundCosts::begin(const GridFrame& frame, const Raster& raster, const AdditiveCost& cost,
                        const Point& goal, const Cell& goal_cell, std::int64_t cells) {
  cost_ = cost;
  goal_ = goal;
  lengths_ = step_lengths(frame.cell());
  nx_ = 2 * frame.nx() - 1;
  ny_ = 2 * frame.ny() - 1;
  goal_column_ = {goal_cell.x() + frame.first().x(), goal_cell.y() + frame.first().y()};

  // The dearest step: an end of it may lie anywhere in its cell. The longest path must fit.
  const double dearest =
      2.0 * frame.cell().norm() * (cost.length - cost.priority * std::min(raster.minimum(), 0.0));
  const double most = static_cast<double>(cells) + static_cast<double>(nx_) * ny_ + 4.0;
  scale_ = std::exp2(std::floor(61.0 - std::log2(most) - std::log2(dearest)));
  width_ = static_cast<Units>(dearest * scale_) / (kBuckets - 2) + 1;

  rows_.resize(nx_);
  lines_.resize(ny_);
  use(frame, raster);
  for (int jx = 0; jx < nx_; ++jx) {
    rows_[jx] = raster.index_of(0, frame.centre(Cell(jx - shift_[0], 0, 0)).x());
  }
  for (int jy = 0; jy < ny_; ++jy) {
    lines_[jy] = raster.index_of(1, frame.centre(Cell(0, jy - shift_[1], 0)).y());
  }
  for (const Step& step : steps()) {
    const Cell from = goal_cell + Cell(step.dx, step.dy, step.dz);
    last_[neighbour_bit(step.dx, step.dy, step.dz)] = straight(frame.centre(from), goal);
  }
}

void GroundCosts::root(int ix, int iy) {
  const std::size_t size = static_cast<std::size_t>(nx_) * ny_;
  if (columns_.size() < size) columns_.resize(size);
  if (stamp_ == std::numeric_limits<std::uint32_t>::max()) {
    for (Column& column : columns_) column.stamp = 0;
    stamp_ = 0;
  }
  ++stamp_;
  now_ = 0;
  for (std::vector<std::uint32_t>& bucket : buckets_) bucket.clear();
  offer(index(ix + shift_[0], iy + shift_[1]), 0);
}

void GroundCosts::use(const GridFrame& frame, const Raster& raster) {
  raster_ = &raster;
  shift_ = {frame.first().x() - goal_column_[0] + nx_ / 2,
            frame.first().y() - goal_column_[1] + ny_ / 2};
  goal_cell_ = frame.cell_of(goal_);
}

Units GroundCosts::units(double cost) const {
  return std::max<Units>(1, static_cast<Units>(cost * scale_ + 0.5));
}

Units GroundCosts::step(const Cell& from, int number) const {
  const Step& by = steps()[number];
  const int jx = from.x() + shift_[0];
  const int jy = from.y() + shift_[1];
  return between(jx, jy, jx + by.dx, jy + by.dy, lengths_[number]);
}

Units GroundCosts::straight(const Point& from, const Point& to) const {
  return units(cost_((to - from).norm(), raster_->integral(from, to)));
}

Units GroundCosts::into_goal(const Cell& from) const {
  const Cell by = from - goal_cell_;
  return last_[neighbour_bit(by.x(), by.y(), by.z())];
}

void GroundCosts::offer(std::uint32_t column, Units cost) {
  Column& mine = columns_[column];
  if (mine.stamp == stamp_ && mine.cost <= cost) return;
  mine = {cost, stamp_};
  buckets_[(cost / width_) % kBuckets].push_back(column);
}

void GroundCosts::advance() {
  std::vector<std::uint32_t>& bucket = buckets_[now_ % kBuckets];
  while (!bucket.empty()) {
    emptied_.swap(bucket);
    bucket.clear();
    for (const std::uint32_t column : emptied_) {
      const Units cost = columns_[column].cost;
      // Stale: it has moved to an earlier bucket and was spread from there.
      if (cost / width_ != now_) continue;
      const int jx = static_cast<int>(column) / ny_;
      const int jy = static_cast<int>(column) % ny_;
      for (int i = 0; i < kSteps; ++i) {
        const Step& by = steps()[i];
        const int kx = jx + by.dx;
        const int ky = jy + by.dy;
        if (by.dz != 0 || kx < 0 || ky < 0 || kx >= nx_ || ky >= ny_) continue;
        offer(index(kx, ky), cost + between(jx, jy, kx, ky, lengths_[i]));
      }
    }
    emptied_.clear();
  }
  ++now_;
}

}  // namespace ltp
