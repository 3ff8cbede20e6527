// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `PlanarBug`: one run of Tangent Bug over the cells of one level. See `make_tangent_bug`.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "ltp/grid/occupancy_grid.hpp"

namespace ltp::planning {

class PlanarBug {
 public:
  enum class End { Reached, GaveUp, Stopped };

  /// @param range  how far it sees [m]; a cell's diagonal at least
  /// @param spent  asked whenever it has looked around; `true` stops it
  PlanarBug(const OccupancyGrid& grid, double range, const std::function<bool()>& spent);

  /// From start to goal, both in free cells of one level. The points on the way are added to `way`,
  /// which holds the start already.
  End run(const Point& goal, std::vector<Point>& way);

 private:
  using Column = Eigen::Vector2i;
  /// The face of a free cell behind which a blocked one (or the window's edge) lies.
  struct Wall {
    Column cell = Column::Zero();
    int side = -1;  ///< 0: +x, 1: +y, 2: -x, 3: -y
    bool operator==(const Wall& other) const { return cell == other.cell && side == other.side; }
  };
  /// What the hand on the wall passes.
  struct Trail {
    std::vector<Column> cells;  ///< each a neighbour of the one before
    std::size_t wall_from = 0;  ///< the first of them at the wall
    Wall first;
    Wall now;
    int hand = 1;  ///< 1: the wall on the right, -1: on the left
    bool closed = false;
    std::vector<std::size_t> faces;  ///< of the wall, by number
  };

  bool blocked(const Column& cell) const;
  bool corner(const Column& cell) const;
  bool clear(const Point& a, const Point& b) const;
  bool sees(const Point& b) const;
  bool sees(const Column& cell) const { return sees(centre(cell)); }
  Point centre(const Column& cell) const;
  double to_goal(const Point& point) const { return (goal_ - point).head<2>().norm(); }
  /// Of the goal's cell 0: a goal on a face is as near to the centres beyond it.
  double to_goal(const Column& cell) const {
    return cell == goal_cell_ ? 0.0 : to_goal(centre(cell));
  }
  std::size_t number(const Wall& wall) const;
  template <typename Visitor>
  void each_cell_in_range(Visitor&& visit) const;

  void go(const Point& point);
  bool goal_in_sight() const;
  std::optional<Point> ahead() const;
  std::optional<Column> best_corner() const;
  std::optional<Column> nearer_than(double distance) const;

  /// The cells on the way straight to the goal, up to the wall that blocks it.
  Trail meet_wall() const;
  void extend(Trail& trail) const;
  /// The farthest cell of the trail that is in sight, past index `at`.
  std::size_t look_along(Trail& trail, std::size_t at) const;
  Trail choose_side(const Trail& met) const;
  End follow(Trail trail);

  const OccupancyGrid& grid_;
  const GridFrame& frame_;
  double range_;
  const std::function<bool()>& spent_;
  Point goal_ = Point::Zero();
  Column goal_cell_ = Column::Zero();
  int level_ = 0;
  double z_ = 0.0;  ///< of the flight [m]
  Point here_ = Point::Zero();
  std::vector<Point>* way_ = nullptr;
  /// Per face of a wall that was followed once round: how near to the goal that was [m].
  std::vector<double> rounded_;
};

}  // namespace ltp::planning
