// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The town that the benchmarks fly in: blocks of houses and towers between streets, always the
// same.
#pragma once

#include <algorithm>
#include <random>

#include "ltp/grid/occupancy_grid.hpp"
#include "ltp/grid/raster.hpp"
#include "ltp/mapping/obstacle_map_options.hpp"
#include "ltp/sensing/height_surface.hpp"
#include "ltp/sensing/lidar.hpp"

namespace ltp::bench {

inline constexpr int kEdge = 600;          ///< of the town [m]
inline constexpr double kAltitude = 50.0;  ///< where the UAV flies [m]
inline const Point kMiddle{280, 280, 50};  ///< on a street corner [m]

/// Heights at 1 m: every 40 m a block of 28 m x 28 m, a third of them above 50 m.
inline Raster heights() {
  Raster::Values values = Raster::Values::Zero(kEdge, kEdge);
  std::mt19937 random(1);
  for (int x = 6; x + 28 < kEdge; x += 40) {
    for (int y = 6; y + 28 < kEdge; y += 40) {
      values.block(x, y, 28, 28) = 10.0 + static_cast<double>(random() % 60);
    }
  }
  return Raster(values, {0, 0}, 1.0);
}

/// A priority that changes from cell to cell, at 2 m.
inline Raster priority() {
  Raster::Values values(kEdge / 2, kEdge / 2);
  std::mt19937 random(2);
  for (auto& value : values.reshaped()) value = (random() % 1000) / 999.0;
  return Raster(values, {0, 0}, 2.0);
}

/// What is in the default window round the middle of the town, as a complete sensor would map it.
inline OccupancyGrid window(const HeightSurface& town) {
  const ObstacleMapOptions options;
  GridFrame frame({0, 0, 0}, options.cell, options.dims);
  return town.occupancy(frame.shifted(frame.shift_to_centre(kMiddle)));
}

inline Pose pose(const Point& position) {
  Pose pose;
  pose.position = position;
  return pose;
}

/// The points of a scan as a path's rows, without a copy.
inline Eigen::Map<const Path> rows(const std::vector<Point>& points) {
  return {points.empty() ? nullptr : points.front().data(),
          static_cast<Eigen::Index>(points.size()), 3};
}

}  // namespace ltp::bench
