// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning/search/planar_bug.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ltp/grid/ray_walk.hpp"

namespace ltp::planning {
namespace {

constexpr double kNearer = 1e-9;  // [m] less is rounding
constexpr std::size_t kNowhere = std::numeric_limits<std::size_t>::max();

Eigen::Vector2i direction(int side) {
  constexpr int kX[] = {1, 0, -1, 0};
  constexpr int kY[] = {0, 1, 0, -1};
  return {kX[side & 3], kY[side & 3]};
}

}  // namespace

PlanarBug::PlanarBug(const OccupancyGrid& grid, double range, const std::function<bool()>& spent)
    : grid_(grid),
      frame_(grid.frame()),
      // The neighbours of a cell are felt, however short the range.
      range_(std::max(range, (1.0 + 1e-9) * grid.frame().cell().head<2>().norm())),
      spent_(spent) {}

PlanarBug::End PlanarBug::run(const Point& goal, std::vector<Point>& way) {
  way_ = &way;
  here_ = way.back();
  goal_ = goal;
  z_ = here_.z();
  level_ = frame_.cell_of(here_).z();
  goal_cell_ = frame_.cell_of(goal).head<2>();
  rounded_.clear();
  while (true) {
    if (spent_()) return End::Stopped;
    if (goal_in_sight()) {
      go(goal_);
      return End::Reached;
    }
    // Motion to the goal.
    if (const std::optional<Point> point = ahead()) {
      go(*point);
      continue;
    }
    if (const std::optional<Column> cell = best_corner()) {
      go(centre(*cell));
      continue;
    }
    const Trail met = meet_wall();
    if (met.first.side < 0) return End::GaveUp;  // in sight but for rounding
    // Nearer to the goal than the wall that is met: the way slides along it.
    const double reached = std::min(to_goal(here_), to_goal(met.first.cell));
    if (const std::optional<Column> cell = nearer_than(reached)) {
      go(centre(*cell));
      continue;
    }
    // Once round this wall: only from nearer to the goal is it worth another try.
    if (!rounded_.empty() && reached >= rounded_[number(met.first)] - kNearer) return End::GaveUp;
    const End end = follow(choose_side(met));
    if (end != End::GaveUp) return end;
  }
}

bool PlanarBug::blocked(const Column& cell) const {
  const Cell full(cell.x(), cell.y(), level_);
  return !frame_.contains(full) || grid_.blocked(full);
}

/// Whether an obstacle's corner juts out towards a cell.
bool PlanarBug::corner(const Column& cell) const {
  for (int side = 0; side < 4; ++side) {
    const Column a = direction(side);
    const Column b = direction(side + 1);
    if (blocked(cell + a + b) && !blocked(cell + a) && !blocked(cell + b)) return true;
  }
  return false;
}

bool PlanarBug::clear(const Point& a, const Point& b) const {
  Eigen::Matrix<double, 2, 3, Eigen::RowMajor> ends;
  ends << a.transpose(), b.transpose();
  return !grid_.first_blocked(ends);
}

bool PlanarBug::sees(const Point& point) const {
  return (point - here_).head<2>().norm() <= range_ && clear(here_, point);
}

Point PlanarBug::centre(const Column& cell) const {
  Point point = frame_.centre(Cell(cell.x(), cell.y(), level_));
  point.z() = z_;
  return point;
}

std::size_t PlanarBug::number(const Wall& wall) const {
  return (static_cast<std::size_t>(wall.cell.x()) * frame_.ny() + wall.cell.y()) * 4 + wall.side;
}

template <typename Visitor>
void PlanarBug::each_cell_in_range(Visitor&& visit) const {
  const auto radius = [&](int axis) {
    return static_cast<int>(
        std::min<double>(std::ceil(range_ / frame_.cell()[axis]), frame_.dims()[axis]));
  };
  const Cell middle = frame_.cell_of(here_);
  const int rx = radius(0);
  const int ry = radius(1);
  for (int ix = std::max(0, middle.x() - rx); ix <= std::min(frame_.nx() - 1, middle.x() + rx);
       ++ix) {
    for (int iy = std::max(0, middle.y() - ry); iy <= std::min(frame_.ny() - 1, middle.y() + ry);
         ++iy) {
      const Column cell(ix, iy);
      if (!blocked(cell)) visit(cell);
    }
  }
}

void PlanarBug::go(const Point& point) {
  if (point != way_->back()) way_->push_back(point);
  here_ = point;
}

bool PlanarBug::goal_in_sight() const { return sees(goal_); }

/// As far as it sees towards the goal, if that is free. For a goal in range: none.
std::optional<Point> PlanarBug::ahead() const {
  const double distance = to_goal(here_);
  if (distance <= range_) return std::nullopt;
  Point point = here_ + range_ / distance * (goal_ - here_);
  point.z() = z_;
  if (!clear(here_, point)) return std::nullopt;
  return point;
}

/// The corner in sight, nearer to the goal than the robot, by which the way seems shortest.
std::optional<PlanarBug::Column> PlanarBug::best_corner() const {
  std::optional<Column> best;
  double shortest = std::numeric_limits<double>::infinity();
  const double distance = to_goal(here_);
  each_cell_in_range([&](const Column& cell) {
    const Point point = centre(cell);
    const double rest = to_goal(point);
    const double way = (point - here_).head<2>().norm() + rest;
    if (rest >= distance - kNearer || way >= shortest || !corner(cell) || !sees(point)) return;
    shortest = way;
    best = cell;
  });
  return best;
}

/// The cell in sight that is nearest to the goal, if it is nearer than `distance` (d_reach).
std::optional<PlanarBug::Column> PlanarBug::nearer_than(double distance) const {
  std::optional<Column> best;
  double nearest = distance - kNearer;
  each_cell_in_range([&](const Column& cell) {
    if (to_goal(cell) >= nearest || !sees(cell)) return;
    nearest = to_goal(cell);
    best = cell;
  });
  return best;
}

PlanarBug::Trail PlanarBug::meet_wall() const {
  Trail trail;
  const auto lattice = [&](const Point& point) -> Eigen::Vector2d {
    return frame_.lattice(point).head<2>();
  };
  const Column shift = frame_.first().head<2>();
  walk_segment<2>(lattice(here_), lattice(goal_), [&](const Column& number, double, double) {
    const Column cell = number - shift;
    if (!blocked(cell)) {
      // Of two cells touched at a corner one is enough.
      std::vector<Column>& cells = trail.cells;
      while (!cells.empty() && (cells.back() - cell).cwiseAbs().sum() > 1) cells.pop_back();
      cells.push_back(cell);
      return true;
    }
    while ((trail.cells.back() - cell).cwiseAbs().sum() > 1) trail.cells.pop_back();
    const Column towards = cell - trail.cells.back();
    for (int side = 0; side < 4; ++side) {
      if (direction(side) == towards) trail.first = {trail.cells.back(), side};
    }
    return false;
  });
  trail.now = trail.first;
  trail.wall_from = trail.cells.size() - 1;
  return trail;
}

/// One step of the hand on the wall, from face to face. It goes round every wall in a ring.
void PlanarBug::extend(Trail& trail) const {
  trail.faces.push_back(number(trail.now));
  const Column wall = direction(trail.now.side);
  const int along = (trail.now.side + trail.hand) & 3;
  const Column next = trail.now.cell + direction(along);
  if (blocked(next)) {
    trail.now.side = along;
  } else if (blocked(next + wall)) {
    trail.cells.push_back(next);
    trail.now.cell = next;
  } else {  // round an outer corner
    trail.cells.push_back(next);
    trail.cells.push_back(next + wall);
    trail.now = {next + wall, (along + 2) & 3};
  }
  trail.closed = trail.now == trail.first;
}

std::size_t PlanarBug::look_along(Trail& trail, std::size_t at) const {
  std::size_t seen = kNowhere;
  double length = 0.0;
  for (std::size_t i = at + 1; length <= range_; ++i) {
    while (i >= trail.cells.size() && !trail.closed) extend(trail);
    if (i >= trail.cells.size()) break;
    if (i > 0) length += (centre(trail.cells[i]) - centre(trail.cells[i - 1])).norm();
    if (!sees(trail.cells[i])) continue;
    seen = i;
    if (trail.cells[i] == goal_cell_) break;
  }
  return seen;
}

PlanarBug::Trail PlanarBug::choose_side(const Trail& met) const {
  Trail best;
  double shortest = std::numeric_limits<double>::infinity();
  for (const int hand : {1, -1}) {
    Trail trail = met;
    trail.hand = hand;
    const std::size_t seen = look_along(trail, kNowhere);
    const Point point = centre(trail.cells[seen]);
    const double way = (point - here_).head<2>().norm() + to_goal(point);
    if (way >= shortest - kNearer) continue;
    shortest = way;
    best = std::move(trail);
  }
  return best;
}

/// Boundary following. `GaveUp`: it was left, or gone round and its nearest cell is reached again.
PlanarBug::End PlanarBug::follow(Trail trail) {
  struct Stop {
    std::size_t at;  ///< on the trail
    std::size_t way;
  };
  std::vector<Stop> stops;
  const std::size_t way_before = way_->size();
  std::size_t at = kNowhere;  // before the trail's first cell; one more is 0
  std::size_t nearest = trail.wall_from;
  double followed = std::min(to_goal(here_), to_goal(trail.cells[nearest]));  // d_followed
  while (true) {
    const std::size_t next = look_along(trail, at);
    if (next == kNowhere) break;  // once round
    for (std::size_t i = at + 1; i <= next; ++i) {
      if (i < trail.wall_from) continue;
      const double distance = to_goal(trail.cells[i]);
      if (distance < to_goal(trail.cells[nearest])) nearest = i;
      followed = std::min(followed, distance);
    }
    at = next;
    go(centre(trail.cells[at]));
    stops.push_back({at, way_->size()});
    if (spent_()) return End::Stopped;
    if (goal_in_sight()) {
      go(goal_);
      return End::Reached;
    }
    if (const std::optional<Column> cell = nearer_than(followed)) {  // d_reach < d_followed
      go(centre(*cell));
      return End::GaveUp;
    }
  }
  rounded_.resize(static_cast<std::size_t>(frame_.nx()) * frame_.ny() * 4,
                  std::numeric_limits<double>::infinity());
  for (const std::size_t face : trail.faces) rounded_[face] = followed;
  // Back to the nearest cell: a plan need not fly the rest of the round at all.
  while (!stops.empty() && stops.back().at > nearest) stops.pop_back();
  way_->resize(stops.empty() ? way_before : stops.back().way);
  at = stops.empty() ? kNowhere : stops.back().at;
  here_ = way_->back();
  while (at != nearest) {
    std::size_t seen = at + 1;
    for (std::size_t i = at + 1; i <= nearest; ++i) {
      if (sees(trail.cells[i])) seen = i;
    }
    at = seen;
    go(centre(trail.cells[at]));
  }
  return End::GaveUp;
}

}  // namespace ltp::planning
