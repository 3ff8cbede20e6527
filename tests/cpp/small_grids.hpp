// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Random grids of few cells, and all their simple paths: the slow, obvious judge of what is exact.
#pragma once

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "ltp/planning/grid_planner.hpp"
#include "scenes.hpp"

namespace ltp::test {

struct SmallGrid {
  OccupancyGrid grid;
  Raster priority;
  Query query;

  Scene scene() const { return {grid, priority}; }
};

/// Start and goal lie anywhere in two free cells, or at the centres of these.
inline SmallGrid random_small_grid(std::mt19937_64& random, const std::array<int, 3>& dims,
                                   double density = 0.2, bool centred = false) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  SmallGrid made{OccupancyGrid(GridFrame({0, 0, 0}, {2, 2, 4}, dims)),
                 Raster(Raster::Values::Zero(dims[0], dims[1]), {0, 0}, 2.0), Query{}};
  Raster::Values values(dims[0], dims[1]);
  const bool binary = unit(random) < 0.5;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double value = unit(random);
    values.data()[i] = binary ? std::round(value) : value;
  }
  made.priority = Raster(values, {0, 0}, 2.0);
  const GridFrame& frame = made.grid.frame();
  const auto point = [&] {
    const Point anywhere(unit(random) * 2 * dims[0], unit(random) * 2 * dims[1],
                         unit(random) * 4 * dims[2]);
    return centred ? frame.centre(frame.cell_of(anywhere)) : anywhere;
  };
  made.query.start = point();
  made.query.goal = point();
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    if (unit(random) < density) made.grid.set(frame.cell_at(i));
  }
  made.grid.set(frame.cell_of(made.query.start), false);
  made.grid.set(frame.cell_of(made.query.goal), false);
  return made;
}

/// Calls `visit(chain, tally)` for every simple path from start to goal; does not go on where
/// `hopeless(tally so far, way left as the crow flies)`.
template <typename Visitor, typename Judge>
void all_simple_paths(const SmallGrid& small, Visitor&& visit, Judge&& hopeless) {
  const GridFrame& frame = small.grid.frame();
  const Cell start = frame.cell_of(small.query.start);
  const Cell goal = frame.cell_of(small.query.goal);
  const auto place = [&](const Cell& cell) -> Point {
    if (cell == start) return small.query.start;
    if (cell == goal) return small.query.goal;
    return slow_vertex(frame, small.query, cell);
  };
  const LevelRange levels = slow_levels(frame, small.query);
  struct Edge {
    Cell to;
    PathTally sums;
  };
  std::vector<std::vector<Edge>> edges(static_cast<std::size_t>(frame.size()));
  for (std::int64_t i = 0; i < frame.size(); ++i) {
    const Cell cell = frame.cell_at(i);
    if (!levels.contains(cell)) continue;
    const std::uint32_t blocked = blocked_surroundings(small.grid, cell, levels);
    for (const Step& step : steps()) {
      if ((blocked & step.box) != 0) continue;
      const Cell next = cell + step.offset();
      Path path(2, 3);
      path << place(cell).transpose(), place(next).transpose();
      edges[i].push_back({next, tally(path, small.priority)});
    }
  }
  std::vector<Cell> chain{start};
  std::vector<char> used(static_cast<std::size_t>(frame.size()), 0);
  const auto extend = [&](const auto& self, const PathTally& sums) -> void {
    const Cell cell = chain.back();
    if (cell == goal) return visit(chain, sums);
    if (hopeless(sums, (small.query.goal - place(cell)).norm())) return;
    used[frame.index(cell)] = 1;
    for (const Edge& edge : edges[frame.index(cell)]) {
      if (used[frame.index(edge.to)] != 0) continue;
      chain.push_back(edge.to);
      self(self, {sums.length + edge.sums.length, sums.priority + edge.sums.priority});
      chain.pop_back();
    }
    used[frame.index(cell)] = 0;
  };
  if (start == goal) {
    return visit(
        chain, tally(path_through(Problem(small.scene(), small.query, {}), chain), small.priority));
  }
  extend(extend, {});
}

template <typename Visitor>
void all_simple_paths(const SmallGrid& small, Visitor&& visit) {
  all_simple_paths(small, visit, [](const PathTally&, double) { return false; });
}

/// The least Eq. (5) of a simple path; infinite if there is none.
inline double exact_optimum(const SmallGrid& small, const PenaltyWeights& weights) {
  const double direct = (small.query.goal - small.query.start).norm();
  const Penalty penalty(weights, direct);
  double best = std::numeric_limits<double>::infinity();
  all_simple_paths(
      small,
      [&](const std::vector<Cell>&, const PathTally& sums) {
        best = std::min(
            best, penalty(sums, small.priority.at(small.query.goal.x(), small.query.goal.y())));
      },
      [&](const PathTally& sums, double left) {
        // Over the best ground from here on, so far that it pays most: a L + b R / L - b p_max.
        const double a = weights.length / direct;
        const double most = small.priority.maximum();
        const double loss = weights.priority * (most * sums.length - sums.priority);
        const double length = std::max(sums.length + left, std::sqrt(std::max(0.0, loss / a)));
        return a * length + loss / length - weights.priority * most >= best;
      });
  return best;
}

}  // namespace ltp::test
