// SPDX-FileCopyrightText: 2026 The ltp authors
// SPDX-License-Identifier: BSD-3-Clause
// A scanning LiDAR: which rays, how far, how well; and the scan that comes of it.
#pragma once

#include <cstdint>
#include <vector>

#include "ltp/geometry/types.hpp"
#include "ltp/sensing/surface.hpp"

namespace ltp {

/// The rays of one revolution, in the sensor's frame (x forward, y left, z up).
struct LidarPattern {
  int azimuths = 360;              ///< rays a row, evenly over the azimuth range, >= 1
  double azimuth_from_deg = -180;  ///< first azimuth, counter-clockwise from x [deg]
  double azimuth_to_deg = 180;     ///< end of the range, itself not sampled for a full circle [deg]
  int rows = 32;                   ///< rows, evenly over the elevation range with both ends, >= 1
  double elevation_from_deg = -45;  ///< lowest row [deg], > -90
  double elevation_to_deg = 15;     ///< highest row [deg], < 90

  void check() const;
};

struct LidarOptions {
  LidarPattern pattern;
  double max_range = 50.0;      ///< a return at or beyond it is no return [m]
  double range_noise_sd = 0.0;  ///< standard deviation of a range [m]
  double drop_out = 0.0;        ///< probability that a return is lost, in [0, 1]
  std::uint64_t seed = 0;       ///< of noise and drop-out

  void check() const;
};

/// What became of a scan's rays.
struct ScanStatistics {
  std::int64_t hits = 0;     ///< returns nearer than the maximum range
  std::int64_t misses = 0;   ///< no return: +inf, or at or beyond the maximum range
  std::int64_t invalid = 0;  ///< NaN, negative or -inf: says nothing about the world
  std::int64_t dropped = 0;  ///< returns lost to `drop_out`: says nothing about the world
};

/// One revolution, in the world frame.
struct Scan {
  Point origin = Point::Zero();  ///< of all its rays [m]
  std::vector<Point> hits;       ///< end points of the returns [m]
  std::vector<Point>
      misses;  ///< free end points of the rays without a return, at the maximum range [m]
  ScanStatistics statistics;
};

class Lidar {
 public:
  explicit Lidar(const LidarOptions& options = {});

  const LidarOptions& options() const { return options_; }
  /// Unit vectors in the sensor frame, shape (azimuths * rows, 3): azimuth by azimuth, rows
  /// ascending.
  const Path& directions() const { return directions_; }

  /// Scans a surface. `sequence` numbers the scan, so that noise differs from scan to scan and
  /// repeats from run to run. `out` is overwritten; its memory is reused.
  void scan(const Surface& surface, const Pose& pose, std::uint64_t sequence, Scan& out) const;

  /// The scan that a real sensor's ranges mean, one a ray in the order of `directions()` [m]. NaN,
  /// negative and -inf are invalid; +inf and anything at or beyond the maximum range is a miss.
  void from_ranges(const Eigen::Ref<const Eigen::VectorXd>& ranges, const Pose& pose,
                   Scan& out) const;

 private:
  LidarOptions options_;
  Path directions_;
  std::vector<double> elevations_;  ///< [rad], ascending
};

}  // namespace ltp
