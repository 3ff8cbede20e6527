// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/additive/column_costs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ltp/grid/bits.hpp"

namespace ltp::planning {
namespace {

/// The least cost of a step into the goal from each of the 3 x 3 columns round it, its own in the
/// middle, over the levels that the query leaves open.
std::array<double, 9> last_steps(const Problem& problem, const AdditiveCost& cost) {
  std::array<double, 9> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      double& mine = least[(dx + 1) * 3 + dy + 1];
      for (int dz = -1; dz <= 1; ++dz) {
        const Cell from = problem.goal + Cell(dx, dy, dz);
        if (from == problem.goal || !problem.levels.contains(from)) continue;
        mine = std::min(
            mine, cost.along(problem.scene.priority, problem.vertex(from), problem.query.goal));
      }
    }
  }
  return least;
}

}  // namespace

bool ColumnCosts::Aim::operator==(const Aim& other) const {
  return raster == other.raster && cost == other.cost && cell == other.cell &&
         anchor == other.anchor && goal == other.goal && size == other.size && last == other.last;
}

void ColumnCosts::aim(const Problem& problem, const AdditiveCost& cost, double longest, int few) {
  const GridFrame& frame = problem.frame();
  const Cell& goal = problem.goal;
  Aim next;
  next.raster = problem.scene.priority.id();
  next.cost = cost;
  next.cell = frame.cell();
  next.anchor = frame.lattice(Point::Zero());
  next.goal = {goal.x() + frame.first().x(), goal.y() + frame.first().y()};
  next.size = {2 * frame.nx() + 1, 2 * frame.ny() + 1};
  next.last = last_steps(problem, cost);
  raster_ = &problem.scene.priority;
  start_ = {problem.start.x(), problem.start.y()};
  // The goal lies in the middle of the field.
  shift_ = {frame.nx() - goal.x(), frame.ny() - goal.y()};
  frame_ = &frame;
  const bool stands = stamp_ > 0 && walls_ == nullptr && reach_.unbounded() && next == aim_;
  const bool walled = problem.levels.count() <= few;
  reach_ = Ellipse(problem.query, longest);
  if (stands && !walled && reach_.unbounded()) return;
  aim_ = next;
  walls_ = walled ? &problem.grid() : nullptr;
  if (walled) {
    const int words = problem.grid().words_per_column();
    open_levels_.resize(words);
    fill_between(open_levels_.data(), words, problem.levels.lowest, problem.levels.highest);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<int>& numbers = i == 0 ? rows_ : lines_;
    numbers.resize(next.size[i]);
    for (int j = 0; j < next.size[i]; ++j) {
      Cell cell = Cell::Zero();
      cell[i] = j - shift_[i];
      numbers[j] = raster_->index_of(static_cast<int>(i), frame.centre(cell)[i]);
    }
  }
  step_ = {frame.cell().x(), frame.cell().y(), frame.cell().head<2>().norm()};
  // The dearest step must fit into the ring of buckets; columns of one bucket may improve each
  // other. The last step leads off a lattice's centre, so it may be half as long again.
  per_width_ = (kBuckets - 2) / (2.0 * cost.length * frame.cell().norm());
  begin(goal);
}

void ColumnCosts::begin(const Cell& goal) {
  now_ = 0;
  const std::size_t size = static_cast<std::size_t>(aim_.size[0]) * aim_.size[1];
  if (columns_.size() < size) columns_.resize(size);
  if (stamp_ == std::numeric_limits<std::uint32_t>::max()) {
    for (Column& column : columns_) column.stamp = 0;
    stamp_ = 0;
  }
  ++stamp_;
  buckets_.begin(kBuckets);
  waiting_ = 0;
  for (int k = 0; k < 9; ++k) {
    const std::uint32_t column =
        index(goal.x() + shift_[0] + k / 3 - 1, goal.y() + shift_[1] + k % 3 - 1);
    if (aim_.last[k] < kFar) offer(column, touch(column), aim_.last[k]);
  }
}

void ColumnCosts::open(std::uint32_t column) {
  const int jx = static_cast<int>(column) / aim_.size[1];
  const int jy = static_cast<int>(column) % aim_.size[1];
  Column& mine = columns_[column];
  mine = Column{};
  mine.stamp = stamp_;
  mine.gain = 0.5 * aim_.cost.priority * (*raster_)(rows_[jx], lines_[jy]);
  mine.wall = jx == 0 || jy == 0 || jx == aim_.size[0] - 1 || jy == aim_.size[1] - 1;
  const int ix = jx - shift_[0];
  const int iy = jy - shift_[1];
  // Paths begin at the start itself, so the centre of its column need not be within reach.
  if (!reach_.unbounded() && !(ix == start_[0] && iy == start_[1])) {
    mine.wall |= !reach_.contains(frame_->centre(Cell(ix, iy, 0)).head<2>());
  }
  if (mine.wall || walls_ == nullptr) return;
  mine.wall = true;
  if (ix < 0 || iy < 0 || ix >= frame_->nx() || iy >= frame_->ny()) return;
  const std::uint64_t* blocked = walls_->column(ix, iy);
  for (std::size_t w = 0; w < open_levels_.size(); ++w) {
    mine.wall &= (open_levels_[w] & ~blocked[w]) == 0;
  }
}

void ColumnCosts::offer(std::uint32_t column, Column& mine, double cost) {
  if (mine.wall || mine.cost <= cost) return;
  mine.cost = cost;
  buckets_[bucket(cost)].push_back(column);
  ++waiting_;
}

void ColumnCosts::advance() {
  const int row = aim_.size[1];
  const double length = aim_.cost.length;
  std::vector<std::uint32_t>& here = buckets_[now_];
  while (!here.empty()) {
    emptied_.swap(here);
    here.clear();
    waiting_ -= emptied_.size();
    for (const std::uint32_t column : emptied_) {
      const double cost = columns_[column].cost;
      // Stale: it has moved to an earlier bucket and was spread from there.
      if (bucket(cost) != now_) continue;
      const double factor = length - columns_[column].gain;
      bool wall[3][3] = {};
      const auto step = [&](int dx, int dy, double metres) {
        const std::uint32_t next = column + static_cast<std::uint32_t>(dx * row + dy);
        Column& other = touch(next);
        wall[dx + 1][dy + 1] = other.wall;
        offer(next, other, cost + metres * (factor - other.gain));
      };
      step(-1, 0, step_[0]);
      step(1, 0, step_[0]);
      step(0, -1, step_[1]);
      step(0, 1, step_[1]);
      for (int dx = -1; dx <= 1; dx += 2) {
        for (int dy = -1; dy <= 1; dy += 2) {
          if (wall[dx + 1][1] || wall[1][dy + 1]) continue;  // no squeezing past walls
          step(dx, dy, step_[2]);
        }
      }
    }
    emptied_.clear();
  }
  ++now_;
}

}  // namespace ltp::planning
