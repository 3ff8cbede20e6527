// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// What the maps of the benchmarks are fed with: a second of flight through the town, ten scans of
// 65,536 rays.
#pragma once

#include <vector>

#include "town.hpp"

namespace ltp::bench {

/// All coordinates are floats, as OctoMap takes them, so that all maps get the very same points.
inline const std::vector<Scan>& flight() {
  static const std::vector<Scan> scans = [] {
    LidarOptions options;
    options.pattern.azimuths = 1024;
    options.pattern.rows = 64;
    options.pattern.elevation_to_deg = 45;
    const HeightSurface town(heights());
    const Lidar lidar(options);
    std::vector<Scan> made(10);
    for (std::size_t i = 0; i < made.size(); ++i) {
      lidar.scan(town, pose(kMiddle + Point(0.3 * static_cast<double>(i) - 0.7, 0.4, 12.3)), 0,
                 made[i]);
      const auto round = [](Point& point) { point = point.cast<float>().cast<double>(); };
      round(made[i].origin);
      for (Point& hit : made[i].hits) round(hit);
      for (Point& miss : made[i].misses) round(miss);
    }
    return made;
  }();
  return scans;
}

}  // namespace ltp::bench
