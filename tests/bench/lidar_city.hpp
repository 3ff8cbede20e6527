// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The city that the LiDAR benchmarks scan: 1 km x 1 km of boxes, a flight through it, a 64-row
// LiDAR.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

#include "ltp/grid/raster.hpp"
#include "ltp/sensing/lidar.hpp"

namespace ltp::bench {

/// A building on whole metres, from the ground at 0 up.
struct Building {
  int x;
  int y;
  int dx;
  int dy;
  double height;  ///< [m]
};

/// About 760 boxes of 10-80 m that nowhere overlap and cover a third of the ground.
struct City {
  static constexpr int kEdge = 1000;  ///< [m]; a height a metre

  City() : values(Raster::Values::Zero(kEdge, kEdge)) {
    std::mt19937 random(3);
    const auto draw = [&](int low, int high) {
      return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    for (int attempt = 0; attempt < 3000; ++attempt) {
      const int dx = draw(12, 32);
      const int dy = draw(12, 32);
      const Building box{draw(0, kEdge - dx), draw(0, kEdge - dy), dx, dy, draw(100, 800) / 10.0};
      if ((values.block(box.x, box.y, dx, dy) > 0.0).any()) continue;
      values.block(box.x, box.y, dx, dy) = box.height;
      boxes.push_back(box);
    }
  }

  Raster heights() const { return Raster(values, {0, 0}, 1.0); }

  Raster::Values values;
  std::vector<Building> boxes;
};

/// 65,536 rays, 50 m.
inline LidarOptions city_lidar() {
  LidarOptions options;
  options.pattern = {1024, -180, 180, 64, -45, 45};
  return options;
}

/// A straight flight of 500 m at 50 m, 5.7 degrees off the raster's axis; only where it is free.
inline std::vector<Pose> city_flight(const City& city, bool tilted) {
  constexpr double kYaw = 0.1;
  constexpr double kRoll = 0.2;
  constexpr double kPitch = -0.3;
  constexpr double kClear = 3.0;  // so far from any wall [m]
  std::vector<Pose> poses;
  for (int n = 0; n < 24; ++n) {
    const Point at(250.3 + n * 20.8 * std::cos(kYaw), 460.7 + n * 20.8 * std::sin(kYaw), 50.0);
    const int i = static_cast<int>(at.x() - kClear);
    const int j = static_cast<int>(at.y() - kClear);
    const int edge = static_cast<int>(2 * kClear) + 1;
    if ((city.values.block(i, j, edge, edge) >= at.z()).any()) continue;
    Pose pose;
    pose.position = at;
    pose.world_from_body = Eigen::AngleAxisd(kYaw, Point::UnitZ());
    if (tilted) {
      pose.world_from_body = pose.world_from_body * Eigen::AngleAxisd(kPitch, Point::UnitY()) *
                             Eigen::AngleAxisd(kRoll, Point::UnitX());
    }
    poses.push_back(pose);
  }
  return poses;
}

}  // namespace ltp::bench
