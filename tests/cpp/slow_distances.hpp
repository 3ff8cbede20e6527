// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Dijkstra as textbooks have it, and random grids to hold fast searches against it.
#pragma once

#include <functional>
#include <limits>
#include <queue>
#include <random>
#include <utility>
#include <vector>

#include "ltp/grid/neighbourhood.hpp"

namespace ltp::test {

/// Lengths [m] of the shortest paths from a cell to all, in the order of `GridFrame::index`.
/// @param place  where a cell's node lies; by default in its centre
inline std::vector<double> slow_distances(const OccupancyGrid& grid, const Cell& source,
                                          const LevelRange& levels,
                                          std::function<Point(const Cell&)> place = nullptr) {
  const GridFrame& frame = grid.frame();
  if (!place) place = [&](const Cell& cell) { return frame.centre(cell); };
  std::vector<double> distances(static_cast<std::size_t>(frame.size()),
                                std::numeric_limits<double>::infinity());
  using Entry = std::pair<double, std::int64_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  distances[frame.index(source)] = 0.0;
  open.push({0.0, frame.index(source)});
  while (!open.empty()) {
    const auto [distance, index] = open.top();
    open.pop();
    if (distance > distances[index]) continue;
    const Cell cell = frame.cell_at(index);
    const std::uint32_t blocked = blocked_surroundings(grid, cell, levels);
    for (const Step& step : steps()) {
      if (blocked & step.box) continue;
      const Cell next = cell + step.offset();
      const double total = distance + (place(next) - place(cell)).norm();
      double& other = distances[frame.index(next)];
      if (total >= other) continue;
      other = total;
      open.push({total, frame.index(next)});
    }
  }
  return distances;
}

/// The longest step is some 10,000 times the shortest.
inline const Point kNeedle(0.001, 0.001, 9.999);

/// Empty to half full; cells of all proportions, one of them needles; over one to three words.
inline OccupancyGrid random_grid(std::mt19937_64& random) {
  const Point edges[] = {{2, 2, 4}, {1, 1, 1}, {1, 2, 3}, {0.5, 3, 1}, {1, 1, 10}, kNeedle};
  const std::array<int, 3> dims[] = {{12, 9, 7},  {8, 7, 4}, {5, 5, 70}, {3, 3, 130},
                                     {20, 20, 1}, {1, 1, 9}, {6, 64, 3}};
  OccupancyGrid grid(GridFrame(Point(-3, 5, 1), edges[random() % 6], dims[random() % 7]));
  const std::size_t percent = std::array<std::size_t, 5>{0, 3, 10, 30, 50}[random() % 5];
  for (std::int64_t i = 0; i < grid.frame().size(); ++i) {
    if (random() % 100 < percent) grid.set(grid.frame().cell_at(i));
  }
  return grid;
}

inline Cell random_cell(std::mt19937_64& random, const GridFrame& frame) {
  return frame.cell_at(static_cast<std::int64_t>(random() % frame.size()));
}

/// A planar maze with one way only, there and back along each row of 1 x `edge` cells.
inline OccupancyGrid serpentine(int edge) {
  OccupancyGrid grid(GridFrame({0, 0, 0}, {2, 2, 4}, {edge, edge, 1}));
  for (int x = 1; x < edge; x += 2) {
    for (int y = 0; y < edge; ++y) grid.set(Cell(x, y, 0), y != (x % 4 == 1 ? edge - 1 : 0));
  }
  return grid;
}

}  // namespace ltp::test
