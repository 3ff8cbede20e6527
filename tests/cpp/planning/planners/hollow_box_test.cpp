// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// Only surfaces are sensed, so buildings are hollow in the map: no flight may get through their
// walls.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "ltp/mapping/obstacle_map.hpp"

namespace ltp {
namespace {

/// Points every 0.25 m on the six faces of a box turned by `yaw` about its centre, edges included.
Path surface_of(const Point& centre, const Point& size, double yaw) {
  std::vector<Point> points;
  const Eigen::AngleAxisd turn(yaw, Point::UnitZ());
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const int nu = static_cast<int>(std::lround(size[u] / 0.25));
    const int nv = static_cast<int>(std::lround(size[v] / 0.25));
    for (int i = 0; i <= nu; ++i) {
      for (int j = 0; j <= nv; ++j) {
        for (const double side : {-0.5, 0.5}) {
          Point local;
          local[axis] = side * size[axis];
          local[u] = (static_cast<double>(i) / nu - 0.5) * size[u];
          local[v] = (static_cast<double>(j) / nv - 0.5) * size[v];
          points.push_back(centre + turn * local);
        }
      }
    }
  }
  return Eigen::Map<const Path>(points.front().data(), points.size(), 3);
}

/// Whether steps to the 26 neighbours, none of which squeezes past a blocked cell, lead from a cell
/// to the edge.
bool leaks(const OccupancyGrid& grid, const Cell& from) {
  const GridFrame& frame = grid.frame();
  std::vector<char> seen(frame.size(), 0);
  std::vector<Cell> open = {from};
  seen[frame.index(from)] = 1;
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dz = -1; dz <= 1; ++dz) {
          const Cell next = cell + Cell(dx, dy, dz);
          if (!frame.contains(next)) return true;
          if (seen[frame.index(next)]) continue;
          // The step's bounding box: the target and all that a diagonal passes.
          bool legal = true;
          for (int x = std::min(cell.x(), next.x()); x <= std::max(cell.x(), next.x()); ++x) {
            for (int y = std::min(cell.y(), next.y()); y <= std::max(cell.y(), next.y()); ++y) {
              for (int z = std::min(cell.z(), next.z()); z <= std::max(cell.z(), next.z()); ++z) {
                legal = legal && !grid.blocked(Cell(x, y, z));
              }
            }
          }
          if (!legal) continue;
          seen[frame.index(next)] = 1;
          open.push_back(next);
        }
      }
    }
  }
  return false;
}

TEST(HollowBox, NoneOf200LetsAFloodOut) {
  std::mt19937_64 random(10);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (const double radius : {0.0, 1.0}) {
    ObstacleMapOptions options;
    options.dims = {24, 24, 16};
    options.inflation_radius = radius;
    ObstacleMap map(options);
    int tight = 0;
    for (int box = 0; box < 200; ++box) {
      const Point centre(1000.0 * unit(random), -1000.0 * unit(random), 100.0 * unit(random));
      const double yaw = 2.0 * M_PI * unit(random);
      map.recentre(centre);
      map.clear();
      const Path hits = surface_of(centre, Point(20, 20, 30), yaw);
      const InsertStatistics statistics = map.insert(centre, hits);
      ASSERT_EQ(statistics.marked, hits.rows());
      const Cell middle = map.blocked().frame().cell_of(centre);
      ASSERT_FALSE(map.blocked().blocked(middle));
      tight += !leaks(map.blocked(), middle);
    }
    EXPECT_EQ(tight, 200) << "inflation " << radius;
  }
}

TEST(HollowBox, WithAHoleTheFloodGetsOut) {
  ObstacleMapOptions options;
  options.dims = {24, 24, 16};
  options.inflation_radius = 0.0;
  ObstacleMap map(options);
  const Path hits = surface_of(Point::Zero(), Point(20, 20, 30), 0.3);
  std::vector<Point> kept;
  for (Eigen::Index i = 0; i < hits.rows(); ++i) {
    if ((hits.row(i).transpose() - Point(9.5, 3, 0)).norm() > 6.0)
      kept.push_back(hits.row(i).transpose());
  }
  map.insert(Point::Zero(), Eigen::Map<const Path>(kept.front().data(), kept.size(), 3));
  EXPECT_TRUE(leaks(map.blocked(), map.blocked().frame().cell_of(Point::Zero())));
}

}  // namespace
}  // namespace ltp
