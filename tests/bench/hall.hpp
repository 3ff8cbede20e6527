// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// The hall that the voxel benchmarks scan: as a sensor at 5 cm leaves it, with a 64-row LiDAR in
// it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "ltp/sensing/lidar.hpp"

namespace ltp::bench {

/// Surfaces only, one voxel thick: floor, walls, pillars and boxes of 16.8 m x 10.4 m x 3.4 m. One
/// voxel in ten lies a step off, one in twenty is missing.
struct Hall {
  static constexpr double kVoxel = 0.05;  ///< [m]
  static constexpr int kX = 336;
  static constexpr int kY = 208;
  static constexpr int kZ = 68;

  Hall() : solid_(kX * kY * kZ, 0) {
    std::mt19937 random(7);
    const auto draw = [&](int low, int high) {
      return low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1));
    };
    for (const std::array<int, 2>& side : {std::array<int, 2>{0, 2}, {kX - 2, kX}}) {
      block(side[0], side[1], 0, kY, 0, kZ);
    }
    for (const std::array<int, 2>& side : {std::array<int, 2>{0, 2}, {kY - 2, kY}}) {
      block(0, kX, side[0], side[1], 0, kZ);
    }
    block(0, kX, 0, kY, 0, 3);
    for (int x = 56; x < kX - 20; x += 72) {
      for (const int y : {56, 144}) block(x, x + 10, y, y + 10, 0, kZ);
    }
    for (int n = 0; n < 42; ++n) {
      const int dx = draw(8, 26), dy = draw(8, 26);
      const int x = draw(4, kX - 4 - dx), y = draw(4, kY - 4 - dy);
      block(x, x + dx, y, y + dy, 0, draw(8, 30));
    }
    skin(random);
  }

  /// The centres of the voxels, shape (N, 3) [m].
  Path points() const {
    Path centres(voxels.size(), 3);
    for (std::size_t n = 0; n < voxels.size(); ++n) {
      centres.row(n) = (kVoxel * (voxels[n].cast<double>().array() + 0.5)).matrix().transpose();
    }
    return centres;
  }

  /// Along the hall at eye level, where nothing is nearer than a third of a metre.
  std::vector<Pose> flight(bool tilted) const {
    std::vector<Pose> poses;
    for (int n = 0; n < 16; ++n) {
      const Point at(1.03 + 0.98 * n, 5.2 + 3.1 * std::sin(0.9 * n),
                     1.61 + 0.2 * std::cos(2.0 * n));
      if (near_something(at)) continue;
      Pose pose;
      pose.position = at;
      pose.world_from_body = Eigen::AngleAxisd(0.1, Point::UnitZ());
      if (tilted) {
        pose.world_from_body = pose.world_from_body * Eigen::AngleAxisd(-0.3, Point::UnitY()) *
                               Eigen::AngleAxisd(0.2, Point::UnitX());
      }
      poses.push_back(pose);
    }
    return poses;
  }

  std::vector<Eigen::Vector3i> voxels;

 private:
  static int index(int x, int y, int z) { return (x * kY + y) * kZ + z; }
  void block(int x0, int x1, int y0, int y1, int z0, int z1) {
    for (int x = x0; x < x1; ++x) {
      for (int y = y0; y < y1; ++y) std::fill_n(&solid_[index(x, y, z0)], z1 - z0, 1);
    }
  }
  bool is_solid(int x, int y, int z) const {
    return x < 0 || y < 0 || z < 0 || x >= kX || y >= kY || (z < kZ && solid_[index(x, y, z)] != 0);
  }
  bool near_something(const Point& at) const {
    const Eigen::Vector3i voxel = (at / kVoxel).array().floor().matrix().cast<int>();
    for (int dx = -7; dx <= 7; ++dx) {
      for (int dy = -7; dy <= 7; ++dy) {
        if (is_solid(voxel.x() + dx, voxel.y() + dy, voxel.z())) return true;
      }
    }
    return false;
  }
  /// What can be seen of the solid, rough and with holes.
  void skin(std::mt19937& random) {
    std::vector<char> seen(solid_.size(), 0);
    for (int x = 0; x < kX; ++x) {
      for (int y = 0; y < kY; ++y) {
        for (int z = 0; z < kZ; ++z) {
          if (!is_solid(x, y, z)) continue;
          const std::array<Eigen::Vector3i, 5> sides{
              {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}}};
          for (const Eigen::Vector3i& side : sides) {
            if (is_solid(x + side.x(), y + side.y(), z + side.z())) continue;
            const unsigned chance = random() % 20;
            const int off = chance == 1 || chance == 2 ? 1 : 0;
            const Eigen::Vector3i at = Eigen::Vector3i(x, y, z) + off * side;
            if (chance > 0 && at.z() < kZ) seen[index(at.x(), at.y(), at.z())] = 1;
            break;
          }
        }
      }
    }
    for (int n = 0; n < static_cast<int>(seen.size()); ++n) {
      if (seen[n] != 0) voxels.emplace_back(n / kZ / kY, n / kZ % kY, n % kZ);
    }
  }

  std::vector<char> solid_;
};

/// 65,536 rays, 50 m; the elevations of the LiDAR that flies by default.
inline LidarOptions hall_lidar() {
  LidarOptions options;
  options.pattern = {1024, -180, 180, 64, -45, 15};
  return options;
}

}  // namespace ltp::bench
