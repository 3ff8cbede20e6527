// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Random mazes and cities larger than any window, and a UAV without inertia that flies in them.
#pragma once

#include <algorithm>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "ltp/geometry/polyline.hpp"
#include "ltp/navigation/navigator.hpp"
#include "ltp/planning/planners.hpp"

namespace ltp::test {

using Random = std::mt19937;

inline constexpr int kLevels = 6;   ///< of a world; the lowest and the highest are free
inline constexpr int kLevel = 2;    ///< that the UAV begins on
inline constexpr int kWindow = 24;  ///< edge of the map's window [cells]
inline constexpr int kSensed = 6;   ///< how far the UAV sees [cells]
inline constexpr int kRing = 4;     ///< free cells round a world
inline const Point kCell(2, 2, 4);

inline int draw(Random& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

struct World {
  OccupancyGrid truth;

  explicit World(int edge)
      : truth(GridFrame({0, 0, 0}, kCell, {edge + 2 * kRing, edge + 2 * kRing, kLevels})) {}
  int edge() const { return truth.frame().nx() - 2 * kRing; }
  /// A cell counted from the corner of what is built on.
  void build(int x, int y, int height, bool blocked = true) {
    if (x < 0 || y < 0 || x >= edge() || y >= edge()) return;
    for (int z = 1; z <= height; ++z) truth.set(Cell(x + kRing, y + kRing, z), blocked);
  }
  bool is_free(const Cell& cell) const { return !truth.blocked(cell); }
};

/// Corridors between walls one cell thick, dug at random; some walls are broken down, some
/// corridors closed.
inline World maze(Random& random, int edge) {
  World world(edge);
  const int width = draw(random, 2, 4);  // of a corridor and its wall
  const int n = (edge - 1) / width;
  const int low = draw(random, 2, kLevels - 2);
  const auto height = [&] { return draw(random, low, kLevels - 2); };
  std::vector<int> heights(static_cast<std::size_t>(n + 1) * (n + 1));
  for (int& one : heights) one = height();
  for (int x = 0; x <= n * width; ++x) {
    for (int y = 0; y <= n * width; ++y) {
      if (x % width != 0 && y % width != 0) continue;
      world.build(x, y, heights[static_cast<std::size_t>(x / width) * (n + 1) + y / width]);
    }
  }
  const auto open = [&](int x, int y, int dx, int dy) {  // the wall between two rooms
    for (int i = 1; i < width; ++i) {
      const int along = dx != 0 ? y * width + i : x * width + i;
      if (dx != 0) world.build((x + (dx > 0 ? 1 : 0)) * width, along, kLevels - 2, false);
      if (dy != 0) world.build(along, (y + (dy > 0 ? 1 : 0)) * width, kLevels - 2, false);
    }
  };
  const int steps[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  std::vector<char> dug(static_cast<std::size_t>(n) * n, 0);
  std::vector<Cell> stack{Cell(n / 2, n / 2, 0)};
  dug[static_cast<std::size_t>(n / 2) * n + n / 2] = 1;
  while (!stack.empty()) {
    const Cell at = stack.back();
    int choices[4];
    int count = 0;
    for (int i = 0; i < 4; ++i) {
      const int x = at.x() + steps[i][0];
      const int y = at.y() + steps[i][1];
      if (x >= 0 && y >= 0 && x < n && y < n && !dug[static_cast<std::size_t>(x) * n + y]) {
        choices[count++] = i;
      }
    }
    if (count == 0) {
      stack.pop_back();
      continue;
    }
    const auto& step = steps[choices[random() % count]];
    if (random() % 50 != 0) open(at.x(), at.y(), step[0], step[1]);
    stack.emplace_back(at.x() + step[0], at.y() + step[1], 0);
    dug[static_cast<std::size_t>(stack.back().x()) * n + stack.back().y()] = 1;
  }
  const int breaches = draw(random, 0, n * n / 8);
  for (int i = 0; i < breaches; ++i) {
    const auto& step = steps[random() % 4];
    open(draw(random, 0, n - 1), draw(random, 0, n - 1), step[0], step[1]);
  }
  return world;
}

/// Houses, courts (some with a gate), and walls that are longer than the window.
inline World city(Random& random, int edge) {
  World world(edge);
  const int count = edge * edge / draw(random, 80, 400);
  for (int i = 0; i < count; ++i) {
    const int kind = draw(random, 0, 5);
    const int across = kind == 0 ? draw(random, 1, 3) : draw(random, 4, edge / 4);
    const int along = kind == 0 ? draw(random, edge / 3, edge / 2) : draw(random, 4, edge / 4);
    const bool turned = random() % 2 == 0;
    const int nx = turned ? across : along;
    const int ny = turned ? along : across;
    const int x0 = draw(random, -2, edge - 3);
    const int y0 = draw(random, -2, edge - 3);
    const int height = draw(random, 1, kLevels - 2);
    const int gate = kind == 1 ? draw(random, 1, nx - 2) : -1;
    for (int x = 0; x < nx; ++x) {
      for (int y = 0; y < ny; ++y) {
        const bool inside = x > 0 && y > 0 && x < nx - 1 && y < ny - 1;
        if (kind <= 2 && kind > 0 && inside) continue;
        if (y == 0 && (x == gate || x == gate + 1)) continue;
        world.build(x0 + x, y0 + y, height);
      }
    }
  }
  return world;
}

/// A window that forgets what it leaves, and a UAV that goes from cell to cell.
class Flight {
 public:
  Flight(const World& world, std::string_view planner, const PlannerOptions& options,
         const NavigationOptions& navigation, const Raster& priority, const Point& start)
      : world_(world),
        position_(start),
        window_(centred(start)),
        navigator_(make_planner(planner, options), navigation, priority, window_.frame(), 0.0,
                   start) {}

  /// Whether it came to an end. It ends where it holds, too: nothing changes any more.
  bool fly(const Path& waypoints, double most) {
    navigator_.set_waypoints(waypoints);
    while (flown_ <= most) {
      look();
      const NavigationStatus status = navigator_.update({window_, window_, version_}, position_);
      const std::size_t legs = navigator_.waypoint_index() + 1;
      begins_.resize(std::max(begins_.size(), legs), position_);
      highest_.resize(std::max(highest_.size(), legs), position_.z());
      if (status == NavigationStatus::Finished || status == NavigationStatus::Holding) return true;
      const Path& path = navigator_.path();
      if (path.rows() == 0) return true;
      if (std::exchange(flown_path_, navigator_.path_id()) != navigator_.path_id()) along_ = 0.0;
      highest_[legs - 1] = std::max(highest_[legs - 1], path.col(2).maxCoeff());
      along_ += kCell.x();
      const Point next = point_at(path, along_);
      flown_ += (next - position_).norm();
      position_ = next;
      crashed_ |= world_.truth.blocked_at(position_);
    }
    return false;
  }

  const Navigator& navigator() const { return navigator_; }
  const Point& position() const { return position_; }
  /// Where the UAV was when a waypoint became the next one [m].
  const Point& begin_of(int waypoint) const { return begins_.at(waypoint); }
  /// The highest point of the paths to a waypoint [m].
  double highest_to(int waypoint) const { return highest_.at(waypoint); }
  double flown() const { return flown_; }
  bool crashed() const { return crashed_; }

 private:
  static GridFrame centred(const Point& position) {
    const GridFrame frame({0, 0, 0}, kCell, {kWindow, kWindow, kLevels + 2});
    return frame.shifted(frame.shift_to_centre(position));
  }

  void look() {
    const Cell shift = window_.frame().shift_to_centre(position_);
    if (!shift.isZero()) {
      navigator_.remember(window_);
      window_.roll(shift);
    }
    const GridFrame& frame = world_.truth.frame();
    const Cell own = frame.cell_of(position_);
    for (int dx = -kSensed; dx <= kSensed; ++dx) {
      for (int dy = -kSensed; dy <= kSensed; ++dy) {
        if (dx * dx + dy * dy > kSensed * kSensed) continue;
        for (int z = 0; z < kLevels; ++z) {
          const Cell cell(own.x() + dx, own.y() + dy, z);
          if (!frame.contains(cell) || !world_.truth.blocked(cell)) continue;
          const Cell here = cell - window_.frame().first();
          if (!window_.frame().contains(here) || window_.blocked(here)) continue;
          window_.set(here);
          ++version_;
        }
      }
    }
  }

  const World& world_;
  Point position_;
  OccupancyGrid window_;
  std::int64_t version_ = 0;
  Navigator navigator_;
  std::int64_t flown_path_ = -1;
  std::vector<Point> begins_;
  std::vector<double> highest_;
  double along_ = 0.0;
  double flown_ = 0.0;
  bool crashed_ = false;
};

inline Cell random_cell(Random& random, const World& world, int level) {
  const int nx = world.truth.frame().nx();
  return Cell(draw(random, 1, nx - 2), draw(random, 1, nx - 2), level);
}

}  // namespace ltp::test
