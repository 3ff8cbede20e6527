// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// `ColumnCosts`: the least additive cost over the ground from each column to the goal, a lower
// bound in space.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "planning/additive/ellipse.hpp"
#include "planning/search/bucket_ring.hpp"

namespace ltp::planning {

/// The cost of a path of length L and priority integral P: `length` L - `priority` P, both factors
/// >= 0. While `length` > `priority` * (largest priority) every step costs something and the search
/// is exact.
struct AdditiveCost {
  double length = 1.0;
  double priority = 0.0;

  double operator()(double metres, double integral) const {
    return length * metres - priority * integral;
  }
  /// Of a straight line, exactly.
  double along(const Raster& raster, const Point& from, const Point& to) const {
    return (*this)((to - from).norm(), raster.integral(from, to));
  }
  bool operator==(const AdditiveCost& other) const {
    return length == other.length && priority == other.priority;
  }
};

/// Dijkstra over the lattice's columns out from the goal, in buckets of equal width (delta-
/// stepping), advanced only as far as it is asked. A step to one of the 8 neighbours costs its
/// length times (`length` - `priority` * the mean of both columns' priorities); the last one leads
/// to the goal itself and costs exactly what it does. Priority depends on x and y alone, so no path
/// in space costs less.
///
/// Where the query leaves only a few levels open, a column that is blocked in all of them is a wall
/// to the field too, and so is all beyond the window; in planar flight it then is the cost to the
/// goal itself. With more levels hardly any column is blocked, so the field knows no obstacles,
/// covers every window that holds the goal, and stands while goal, cost and priority do, wherever
/// the window moves.
class ColumnCosts {
 public:
  /// Aims at a problem's goal; goes on with what it has if nothing changed. The scene is read as
  /// long as the field is asked. No step may cost less than nothing, and a metre of `length` must
  /// cost something.
  /// @param longest  columns that no path of this length [m] from start to goal can visit are walls
  /// @param few      so many levels are a few
  void aim(const Problem& problem, const AdditiveCost& cost,
           double longest = std::numeric_limits<double>::infinity(), int few = kFewLevels);

  /// Aims at a gate of a problem instead, by its number: at the columns of its region, each of
  /// which costs what the next gate's field says (null: this is the last gate, nothing).
  void aim(const Problem& problem, const AdditiveCost& cost, std::size_t number, ColumnCosts* next,
           double longest = std::numeric_limits<double>::infinity(), int few = kFewLevels);

  /// The least cost from the centre of a column of the window to the goal; infinite if there is no
  /// way.
  double operator()(int ix, int iy) {
    const std::uint32_t column = index(ix + shift_[0], iy + shift_[1]);
    while (!settled(column)) {
      if (waiting_ == 0 && begun_ == sources_.size()) return kFar;
      advance();
    }
    return columns_[column].cost;
  }

  static constexpr int kFewLevels = 8;

  /// Half the cost of a metre over a column of the window; that of a step is its length times those
  /// of both its ends.
  double half_metre(int ix, int iy) {
    return 0.5 * aim_.cost.length - touch(index(ix + shift_[0], iy + shift_[1])).gain;
  }

 private:
  struct Column {
    double cost = kFar;
    double gain = 0.0;  ///< what half its priority takes off a metre
    std::uint32_t stamp = 0;
    bool wall = false;
  };
  /// All that the field depends on.
  struct Aim {
    std::uint64_t raster = 0;  ///< its identity
    AdditiveCost cost;
    Point cell = Point::Zero();
    Point anchor = Point::Zero();  ///< of the lattice [cells]
    std::array<int, 2> goal{};     ///< the goal's column on the lattice
    std::array<int, 2> size{};     ///< of the field [columns], a margin of walls included
    std::array<double, 9> last{};  ///< cost of the last step from the goal's neighbours

    bool operator==(const Aim& other) const;
  };

  std::uint32_t index(int jx, int jy) const {
    return static_cast<std::uint32_t>(jx * aim_.size[1] + jy);
  }
  /// The column; a fresh one if the field has not come to it yet.
  Column& touch(std::uint32_t column) {
    if (columns_[column].stamp != stamp_) open(column);
    return columns_[column];
  }
  std::int64_t bucket(double cost) const { return static_cast<std::int64_t>(cost * per_width_); }
  // All that costs less than the bucket to be emptied next begins at is final.
  bool settled(std::uint32_t column) const {
    const Column& mine = columns_[column];
    return mine.stamp == stamp_ && mine.cost < kFar && bucket(mine.cost) < now_;
  }
  /// A column where ways begin, and what is left from there.
  struct Source {
    double cost;
    std::uint32_t column;
  };

  void look_at(const Problem& problem, bool walled);
  void begin();
  void add_last_point(const Problem& problem, std::size_t number);
  void begin_round(const Cell& goal, bool among_others);
  void advance();
  void open(std::uint32_t column);
  void offer(std::uint32_t column, Column& mine, double cost);

  static constexpr int kBuckets = 128;
  static constexpr double kFar = std::numeric_limits<double>::infinity();

  Aim aim_;
  const Raster* raster_ = nullptr;
  const GridFrame* frame_ = nullptr;        ///< the window's
  std::array<int, 2> start_{};              ///< the start's column
  Ellipse reach_;                           ///< what lies beyond is a wall
  const OccupancyGrid* walls_ = nullptr;    ///< null: the field knows no obstacles
  std::vector<std::uint64_t> open_levels_;  ///< of the query, as one column of `walls_`
  std::array<int, 2> shift_{};              ///< from the window's columns to the field's
  std::vector<int> rows_;                   ///< of the raster, under the field's columns
  std::vector<int> lines_;                  ///< the same along y
  std::array<double, 3> step_{};            ///< lengths along x, along y, along both [m]
  double per_width_ = 1.0;                  ///< buckets per unit of cost
  std::int64_t now_ = 0;                    ///< number of the bucket to be emptied next
  std::uint32_t stamp_ = 0;
  std::vector<Column> columns_;
  BucketRing<std::uint32_t> buckets_;
  std::size_t waiting_ = 0;      ///< entries in all buckets
  bool of_gate_ = false;         ///< aims at a gate; such a field is made anew each time
  std::vector<Source> sources_;  ///< the cheapest first
  std::size_t begun_ = 0;        ///< of the sources
  std::vector<std::uint32_t> emptied_;
};

}  // namespace ltp::planning
