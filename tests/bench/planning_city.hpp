// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The city that searches are measured in: 85 boxes on a window of 200 x 200 x 40 cells, a fifth of
// it blocked; and queries through several of them.
#pragma once

#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/planning/planner.hpp"

namespace ltp::bench {

inline const GridFrame kCityFrame{{0, 0, 0}, {2, 2, 4}, {200, 200, 40}};
inline constexpr int kFlightLevel = 12;  ///< 48 to 52 m

/// Lowest and highest cells, both included.
struct Box {
  Cell low, high;
};

/// An integer from `low` to `high`; the same everywhere, unlike the library's distributions.
inline int draw(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
}

inline std::vector<Box> city_boxes() {
  std::mt19937 random(20240611);
  std::vector<Box> boxes(85);
  for (Box& box : boxes) {
    const Cell size(draw(random, 8, 19), draw(random, 8, 19), draw(random, 8, 36));
    box.low = Cell(draw(random, 0, 200 - size.x()), draw(random, 0, 200 - size.y()), 0);
    box.high = box.low + size - Cell::Ones();
  }
  return boxes;
}

/// Boxes on a ground one cell thick.
/// @param hollow  leave of each only its outermost cells: what a LiDAR would see of it
inline OccupancyGrid city(bool hollow = false) {
  OccupancyGrid grid(kCityFrame);
  const auto fill = [&](const Box& box, bool blocked) {
    for (int x = box.low.x(); x <= box.high.x(); ++x) {
      for (int y = box.low.y(); y <= box.high.y(); ++y) {
        for (int z = box.low.z(); z <= box.high.z(); ++z) grid.set(Cell(x, y, z), blocked);
      }
    }
  };
  const std::vector<Box> boxes = city_boxes();
  for (const Box& box : boxes) fill(box, true);
  if (hollow) {
    for (const Box& box : boxes) fill({box.low + Cell::Ones(), box.high - Cell::Ones()}, false);
  }
  fill({Cell(0, 0, 0), Cell(199, 199, 0)}, true);
  return grid;
}

/// Boxes that lie along the way in flight, as the crow flies.
inline int boxes_between(const OccupancyGrid& grid, const Cell& from, const Cell& to) {
  int count = 0;
  bool inside = false;
  for (int i = 0; i <= 400; ++i) {
    const Cell cell = (from.cast<double>() + (to - from).cast<double>() * (i / 400.0))
                          .array()
                          .round()
                          .cast<int>();
    const bool blocked = grid.blocked(cell);
    count += blocked && !inside;
    inside = blocked;
  }
  return count;
}

/// 50 queries from centre to centre in the open band, 100 to 199 m long, through 2 to 5 boxes.
inline std::vector<Query> city_queries() {
  const OccupancyGrid grid = city();
  std::mt19937 random(50);
  std::vector<Query> queries;
  while (queries.size() < 50) {
    const auto anywhere = [&] {
      return Cell(draw(random, 0, 199), draw(random, 0, 199), kFlightLevel);
    };
    const Cell start = anywhere();
    const Cell goal = anywhere();
    const double length = (kCityFrame.centre(goal) - kCityFrame.centre(start)).norm();
    if (grid.blocked(start) || grid.blocked(goal) || length < 100.0 || length > 199.0) continue;
    const int between = boxes_between(grid, start, goal);
    if (between < 2 || between > 5) continue;
    queries.push_back({kCityFrame.centre(start), kCityFrame.centre(goal), {}});
  }
  return queries;
}

/// The same starts, with goals inside boxes of the hollow city: no way leads there.
inline std::vector<Query> walled_in_queries() {
  std::vector<Query> queries = city_queries();
  const std::vector<Box> boxes = city_boxes();
  const OccupancyGrid grid = city(true);
  std::mt19937 random(51);
  for (Query& query : queries) {
    Cell goal;
    do {
      const Box& box = boxes[random() % boxes.size()];
      goal = Cell((box.low.x() + box.high.x()) / 2, (box.low.y() + box.high.y()) / 2,
                  std::min(kFlightLevel, box.high.z() - 1));
    } while (grid.blocked(goal));
    query.goal = kCityFrame.centre(goal);
  }
  return queries;
}

/// A priority that changes from column to column.
inline Raster city_priority() {
  Raster::Values values(200, 200);
  std::mt19937 random(2);
  for (auto& value : values.reshaped()) value = (random() % 1000) / 999.0;
  return Raster(values, {0, 0}, 2.0);
}

}  // namespace ltp::bench
