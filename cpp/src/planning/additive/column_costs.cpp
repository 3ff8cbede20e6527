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
std::array<double, 9> last_steps(const Problem& problem, const AdditiveCost& cost, const Cell& goal,
                                 const Point& point) {
  std::array<double, 9> least;
  least.fill(std::numeric_limits<double>::infinity());
  for (int dx = -1; dx <= 1; ++dx) {
    for (int dy = -1; dy <= 1; ++dy) {
      double& mine = least[(dx + 1) * 3 + dy + 1];
      for (int dz = -1; dz <= 1; ++dz) {
        const Cell from = goal + Cell(dx, dy, dz);
        if (from == goal || !problem.levels.contains(from)) continue;
        mine = std::min(mine, cost.along(problem.scene.priority, problem.vertex(from), point));
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
  next.last = last_steps(problem, cost, goal, problem.query.goal);
  raster_ = &problem.scene.priority;
  start_ = {problem.start.x(), problem.start.y()};
  // The goal lies in the middle of the field.
  shift_ = {frame.nx() - goal.x(), frame.ny() - goal.y()};
  frame_ = &frame;
  const bool stands =
      stamp_ > 0 && !of_gate_ && walls_ == nullptr && reach_.unbounded() && next == aim_;
  const bool walled = problem.levels.count() <= few;
  reach_ = Ellipse(problem, longest);
  if (stands && !walled && reach_.unbounded()) return;
  aim_ = next;
  of_gate_ = false;
  look_at(problem, walled);
  begin();
  begin_round(goal, false);
}

void ColumnCosts::aim(const Problem& problem, const AdditiveCost& cost, std::size_t number,
                      ColumnCosts* next, double longest, int few) {
  const GridFrame& frame = problem.frame();
  const GateRegion& gate = problem.gates[number];
  const Cell most(frame.nx() - 1, frame.ny() - 1, frame.nz() - 1);
  const Cell middle = gate.own().cwiseMax(0).cwiseMin(most);
  raster_ = &problem.scene.priority;
  start_ = {problem.start.x(), problem.start.y()};
  shift_ = {frame.nx() - middle.x(), frame.ny() - middle.y()};
  frame_ = &frame;
  reach_ = Ellipse(problem, longest);
  aim_ = Aim{};
  aim_.cost = cost;
  aim_.size = {2 * frame.nx() + 1, 2 * frame.ny() + 1};
  of_gate_ = true;
  look_at(problem, problem.levels.count() <= few);
  begin();
  const auto column = [&](int ix, int iy) { return index(ix + shift_[0], iy + shift_[1]); };
  const auto add = [&](int ix, int iy) {
    const double left = next == nullptr ? 0.0 : (*next)(ix, iy);
    if (left < kFar) sources_.push_back({left, column(ix, iy)});
  };
  const bool tall = gate.levels().count() > 0;
  for (int ix = gate.first().x(); tall && ix <= gate.last().x(); ++ix) {
    for (int iy = gate.first().y(); iy <= gate.last().y(); ++iy) {
      if (gate.covers(ix, iy)) add(ix, iy);
    }
  }
  if (next != nullptr && frame.contains(gate.own())) add(gate.own().x(), gate.own().y());
  add_last_point(problem, number);
  std::sort(sources_.begin(), sources_.end(), [](const Source& a, const Source& b) {
    return a.cost < b.cost || (a.cost == b.cost && a.column < b.column);
  });
}

/// The last waypoint's very point, where a step to it passes all gates from this one on.
void ColumnCosts::add_last_point(const Problem& problem, std::size_t number) {
  const GateRegion& last = problem.gates.back();
  const Cell& own = last.own();
  if (!problem.frame().contains(own) || problem.grid().blocked(own)) return;
  for (std::size_t i = number; i < problem.gates.size(); ++i) {
    if (!problem.gates[i].contains(own)) return;
  }
  const Point& point = last.gate().point;
  aim_.last = last_steps(problem, aim_.cost, own, point);
  begin_round(own, true);
  const double in_place = aim_.cost.along(problem.scene.priority, problem.vertex(own), point);
  sources_.push_back({in_place, index(own.x() + shift_[0], own.y() + shift_[1])});
}

/// Reads the raster's cells under the columns, and the walls.
void ColumnCosts::look_at(const Problem& problem, bool walled) {
  const GridFrame& frame = problem.frame();
  walls_ = walled ? &problem.grid() : nullptr;
  if (walled) {
    const int words = problem.grid().words_per_column();
    open_levels_.resize(words);
    fill_between(open_levels_.data(), words, problem.levels.lowest, problem.levels.highest);
  }
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<int>& numbers = i == 0 ? rows_ : lines_;
    numbers.resize(aim_.size[i]);
    for (int j = 0; j < aim_.size[i]; ++j) {
      Cell cell = Cell::Zero();
      cell[i] = j - shift_[i];
      numbers[j] = raster_->index_of(static_cast<int>(i), frame.centre(cell)[i]);
    }
  }
  step_ = {frame.cell().x(), frame.cell().y(), frame.cell().head<2>().norm()};
  // The dearest step must fit into the ring of buckets; columns of one bucket may improve each
  // other. The last step leads off a lattice's centre, so it may be half as long again.
  per_width_ = (kBuckets - 2) / (2.0 * aim_.cost.length * frame.cell().norm());
}

void ColumnCosts::begin() {
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
  sources_.clear();
  begun_ = 0;
}

/// The ways begin with the last steps to the goal itself, from the columns round it.
void ColumnCosts::begin_round(const Cell& goal, bool among_others) {
  for (int k = 0; k < 9; ++k) {
    const std::uint32_t column =
        index(goal.x() + shift_[0] + k / 3 - 1, goal.y() + shift_[1] + k % 3 - 1);
    if (!(aim_.last[k] < kFar)) continue;
    if (among_others) {
      sources_.push_back({aim_.last[k], column});
    } else {
      offer(column, touch(column), aim_.last[k]);
    }
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
  if (waiting_ == 0 && begun_ < sources_.size()) {
    now_ = std::max(now_, bucket(sources_[begun_].cost));
  }
  for (; begun_ < sources_.size() && bucket(sources_[begun_].cost) <= now_; ++begun_) {
    const std::uint32_t column = sources_[begun_].column;
    offer(column, touch(column), sources_[begun_].cost);
  }
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
