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
  int azimuths = 360;               ///< rays a row, evenly over the azimuth range, >= 1
  double azimuth_from_deg = -180;   ///< first azimuth, counter-clockwise from x [deg]
  double azimuth_to_deg = 180;      ///< last azimuth; a full circle stops one step short [deg]
  int rows = 32;                    ///< rows, evenly over the elevation range, both ends, >= 1
  double elevation_from_deg = -45;  ///< lowest row, and the only one if rows = 1; > -90 [deg]
  double elevation_to_deg = 15;     ///< highest row; < 90 [deg]

  std::int64_t size() const { return std::int64_t{azimuths} * rows; }
  void check() const;  ///< throws `std::invalid_argument` that names the field
};

struct LidarOptions {
  LidarPattern pattern;
  double min_range = 0.0;       ///< a return nearer than it is no return, nor a miss [m]
  double max_range = 50.0;      ///< a return at or beyond it is no return [m]
  double range_noise_sd = 0.0;  ///< standard deviation of a range [m]
  double drop_out = 0.0;        ///< probability that a return is lost, in [0, 1]
  std::uint64_t seed = 0;       ///< of noise and drop-out

  void check() const;  ///< throws `std::invalid_argument` that names the field
};

/// What became of a scan's rays; the counts add up to all of them.
struct ScanStatistics {
  std::int64_t hits = 0;      ///< returns between the minimum and the maximum range
  std::int64_t misses = 0;    ///< no return: +inf, or at or beyond the maximum range
  std::int64_t too_near = 0;  ///< nearer than the minimum range: says nothing about the world
  std::int64_t invalid = 0;   ///< NaN, 0, negative or -inf: says nothing about the world
  std::int64_t dropped = 0;   ///< returns lost to `drop_out`: says nothing about the world
};

/// Whether a scan lists its misses. Only who carves free space needs them.
enum class Misses { Listed, Counted };

/// One revolution, in the world frame. Both lists are in the order of the rays.
struct Scan {
  Point origin = Point::Zero();  ///< of all its rays [m]
  std::vector<Point> hits;       ///< end points of the returns [m]
  std::vector<Point> misses;     ///< where rays without a return end, at the maximum range [m];
                                 ///< empty if only counted
  ScanStatistics statistics;
};

/// Immutable once made: one may serve several threads.
class Lidar {
 public:
  /// Throws `std::invalid_argument` that names the option.
  explicit Lidar(const LidarOptions& options = {});

  const LidarOptions& options() const { return options_; }
  /// Unit vectors in the sensor frame, shape (azimuths * rows, 3): azimuth by azimuth, rows
  /// ascending.
  const Path& directions() const { return directions_; }

  /// Scans a surface. Without noise the hits are `RayHit::inside`, a hair inside the solid; with
  /// noise they lie on the ray, at the noisy range. Noise may turn a return into a miss (at or
  /// beyond the maximum range) or an invalid one (not positive).
  /// @param sequence  numbers the scan: noise differs from scan to scan and repeats from run to run
  /// @param out       overwritten; its memory is reused
  /// @param misses    listing them takes about as long as casting
  /// Throws `std::invalid_argument` for a pose that is not finite or not a rotation.
  void scan(const Surface& surface, const Pose& pose, std::uint64_t sequence, Scan& out,
            Misses misses = Misses::Listed) const;

  /// The scan that a real sensor's ranges mean, one a ray in the order of `directions()` [m]. NaN,
  /// 0, negative and -inf are invalid; what is nearer than the minimum range is too near; +inf and
  /// anything at or beyond the maximum range is a miss. Throws `std::invalid_argument` for another
  /// number of ranges or a bad pose.
  void from_ranges(const Eigen::Ref<const Eigen::VectorXd>& ranges, const Pose& pose,
                   Scan& out) const;
  void from_ranges(const Eigen::Ref<const Eigen::VectorXf>& ranges, const Pose& pose,
                   Scan& out) const;

 private:
  template <typename Ranges>
  void sort_ranges(const Ranges& ranges, const Pose& pose, Scan& out) const;

  LidarOptions options_;
  std::vector<Eigen::Vector2d> headings_;  ///< one an azimuth, sensor frame
  BeamFan fan_;                            ///< one beam a row
  Path directions_;
};

}  // namespace ltp
